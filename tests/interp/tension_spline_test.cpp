#include "interp/tension_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "support/random.hpp"

namespace delone::interp {
namespace {

using support::SplitMix64;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The curve from its equation in 64 bits of mantissa: a + b u + c cosh s u + d sinh s u,
/// u = part - 1/2, found by Gauss's elimination; by a polynomial without tension.
class Oracle {
 public:
  Oracle(const HermiteArc& arc, double tension) : length_(arc.length), tension_(tension) {
    const std::array<std::array<long double, 5>, 4> rows{
        row(-0.5L, 0, arc.start), row(0.5L, 0, arc.end),
        row(-0.5L, 1, static_cast<long double>(arc.start_slope) * arc.length),
        row(0.5L, 1, static_cast<long double>(arc.end_slope) * arc.length)};
    solve(rows);
  }
  [[nodiscard]] long double at(long double part, int derivative) const {
    long double sum = 0;
    for (int k = 0; k < 4; ++k)
      sum +=
          coefficients_[static_cast<std::size_t>(k)] * term(k, part - 0.5L, derivative);
    return sum / std::pow(static_cast<long double>(length_), derivative);
  }

 private:
  // Of exponentials above a tension of 4, of hyperbolic functions below.
  [[nodiscard]] long double term(int k, long double u, int derivative) const {
    const long double s = tension_;
    if (k == 0) return derivative == 0 ? 1 : 0;
    if (k == 1) return derivative == 0 ? u : derivative == 1 ? 1 : 0;
    if (s == 0) return power(k, u, derivative);
    const long double scale = std::pow(s, derivative);
    if (s > 4) {
      const long double sign = k == 2 ? 1 : (derivative % 2 == 0 ? 1 : -1);
      return sign * scale * std::exp((k == 2 ? u : -u) * s - s / 2);
    }
    const bool is_even = (k == 2) == (derivative % 2 == 0);
    return scale * (is_even ? std::cosh(s * u) : std::sinh(s * u));
  }
  static long double power(int k, long double u, int derivative) {
    if (k == 2) return derivative == 0 ? u * u : derivative == 1 ? 2 * u : 2;
    return derivative == 0 ? u * u * u : derivative == 1 ? 3 * u * u : 6 * u;
  }
  [[nodiscard]] std::array<long double, 5> row(long double u, int derivative,
                                               long double right) const {
    std::array<long double, 5> result{};
    for (int k = 0; k < 4; ++k)
      result[static_cast<std::size_t>(k)] = term(k, u, derivative);
    result[4] = right;
    return result;
  }
  void solve(std::array<std::array<long double, 5>, 4> m) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < 4; ++i)
        if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
      std::swap(m[k], m[pivot]);
      for (std::size_t i = k + 1; i < 4; ++i) {
        const long double factor = m[i][k] / m[k][k];
        for (std::size_t j = k; j < 5; ++j) m[i][j] -= factor * m[k][j];
      }
    }
    for (std::size_t k = 4; k-- > 0;) {
      long double right = m[k][4];
      for (std::size_t j = k + 1; j < 4; ++j) right -= m[k][j] * coefficients_[j];
      coefficients_[k] = right / m[k][k];
    }
  }

  long double length_, tension_;
  std::array<long double, 4> coefficients_{};
};

/// Arcs of many kinds: level, straight but for a little, steep at one end, long and
/// short.
HermiteArc random_arc(SplitMix64& random) {
  HermiteArc arc;
  arc.start = random.between(-1, 1);
  arc.end = random.uniform() < 0.1 ? arc.start : random.between(-1, 1);
  arc.length = std::exp2(random.between(-10, 10));
  const double mean = (arc.end - arc.start) / arc.length;
  const auto slope = [&] {
    const double kind = random.uniform();
    if (kind < 0.1) return 0.0;
    if (kind < 0.2) return mean;
    if (kind < 0.5) return mean * (1 + random.between(-0.1, 0.1));
    return random.between(-1, 1) * std::exp2(random.between(-4, 8)) / arc.length;
  };
  arc.start_slope = slope();
  arc.end_slope = slope();
  return arc;
}
double size_of(const HermiteArc& a) {
  return std::max({std::abs(a.start), std::abs(a.end), std::abs(a.start_slope) * a.length,
                   std::abs(a.end_slope) * a.length});
}

/// Extremes of a function over the arc by brute force: 200 places, and golden section
/// about the extreme ones.
struct Extremes {
  double least, most;
};
template <class F>
double brute_most(F f) {
  constexpr int count = 200;
  int best = 0;
  double most = -infinity;
  for (int i = 0; i <= count; ++i) {
    const double v = f(static_cast<double>(i) / count);
    if (v > most) most = v, best = i;
  }
  double from = std::max(0.0, (best - 1.0) / count),
         to = std::min(1.0, (best + 1.0) / count);
  for (int step = 0; step < 60; ++step) {
    const double a = from + (to - from) / 3, b = to - (to - from) / 3;
    const bool is_left = f(a) > f(b);
    (is_left ? to : from) = is_left ? b : a;
  }
  return std::max(most, f(0.5 * (from + to)));
}
template <class F>
Extremes brute_extremes(F f) {
  return {-brute_most([&](double t) { return -f(t); }), brute_most(f)};
}

TEST(TensionSpline, SolvesItsEquationForEveryTension) {
  SplitMix64 random(1);
  for (int i = 0; i < 3000; ++i) {
    const HermiteArc arc = random_arc(random);
    const double tension = i % 10 == 0   ? 0
                           : i % 10 == 1 ? random.between(1.9, 2.1)
                                         : std::exp2(random.between(-1, 6.41));
    const TensionSpline spline(arc, tension);
    const Oracle oracle(arc, tension);
    const double part =
        i % 3 == 0 ? std::exp2(random.between(-20, -1)) : random.uniform();
    const double size = size_of(arc), stiff = 4 + tension;
    EXPECT_NEAR(spline.value(part), static_cast<double>(oracle.at(part, 0)), 3e-15 * size)
        << tension << " " << part;
    EXPECT_NEAR(spline.slope(part) * arc.length,
                static_cast<double>(oracle.at(part, 1)) * arc.length, 2e-14 * size)
        << tension << " " << part;
    EXPECT_NEAR(spline.second(part) * arc.length * arc.length,
                static_cast<double>(oracle.at(part, 2)) * arc.length * arc.length,
                1e-14 * stiff * size)
        << tension << " " << part;
  }
}

TEST(TensionSpline, NearsTheCubicByTheSquareOfSmallTensions) {
  const HermiteArc arc{0.3, -0.2, 1.5, 2.5, 2};
  const TensionSpline cubic(arc, 0);
  for (const double tension : {1e-1, 1e-3, 1e-6, 1e-12, 1e-160, 5e-324}) {
    const TensionSpline spline(arc, tension);
    for (const double part : {0.1, 0.5, 0.8})
      EXPECT_NEAR(spline.value(part), cubic.value(part), tension * tension + 1e-15);
  }
}

TEST(TensionSpline, NearsTheStraightLineWithGrowingTension) {
  const HermiteArc arc{0.3, -0.2, 1.5, 2.5, 2};
  for (const double tension : {85.0, 1e3, 1e6, 1e12, 1e300}) {
    const TensionSpline spline(arc, tension);
    for (const double part : {1e-3, 0.1, 0.5, 0.8})
      EXPECT_NEAR(spline.value(part), 0.3 - 0.5 * part, 8 / tension + 1e-15);
  }
}

TEST(TensionSpline, MeetsItsEndsBitForBit) {
  SplitMix64 random(2);
  for (int i = 0; i < 100; ++i) {
    const HermiteArc arc = random_arc(random);
    const TensionSpline spline(arc, random.between(0, 85));
    EXPECT_EQ(spline.value(0), arc.start);
    EXPECT_EQ(spline.value(1), arc.end);
    EXPECT_EQ(spline.slope(0), arc.start_slope);
    EXPECT_EQ(spline.slope(1), arc.end_slope);
  }
}

TEST(TensionSpline, KeepsDigitsOfTheDistanceFromBothEnds) {
  for (const double tension : {0.0, 0.5, 1.99, 2.01, 20.0, 85.0}) {
    const TensionBasis<double> basis(tension);
    const double near = 0x1p-60;
    EXPECT_NEAR(basis.even(near, 1) / near, 1, 1e-14) << tension;
    EXPECT_NEAR(basis.even(1, near) / near, 1, 1e-14) << tension;
    EXPECT_NEAR(basis.odd(near, 1) / near, 1, 1e-14) << tension;
    EXPECT_NEAR(basis.odd(1, near) / near, -1, 1e-14) << tension;
  }
}

TEST(TensionSpline, BasisCarriesItsOwnDerivatives) {
  SplitMix64 random(3);
  for (int i = 0; i < 300; ++i) {
    const double tension = std::exp2(random.between(-3, 6.4)), part = random.uniform();
    // By the part, and by the tension.
    const SecondOrder t(part, 1, 0), s(tension, 0, 1);
    const TensionBasis<SecondOrder> jets(s);
    const TensionBasis<double> plain(tension);
    const SecondOrder rest = SecondOrder(1) - t;
    const SecondOrder even = jets.even(t, rest), odd = jets.odd(t, rest);
    EXPECT_NEAR(even.x, plain.even_slope(part, 1 - part), 1e-13);
    EXPECT_NEAR(odd.x, plain.odd_slope(part, 1 - part), 1e-13);
    EXPECT_NEAR(even.xx, plain.even_second(part, 1 - part), 1e-12 * (1 + tension));
    EXPECT_NEAR(odd.xx, plain.odd_second(part, 1 - part), 1e-12 * (1 + tension));
    const SecondOrder even_slope = jets.even_slope(t, rest),
                      odd_slope = jets.odd_slope(t, rest);
    EXPECT_NEAR(even_slope.value, even.x, 1e-13);
    EXPECT_NEAR(odd_slope.value, odd.x, 1e-13);
    EXPECT_NEAR(even_slope.y, even.xy, 1e-12);
    EXPECT_NEAR(odd_slope.y, odd.xy, 1e-12);
    const double step = 1e-5 * tension;
    const TensionBasis<double> above(tension + step), below(tension - step);
    EXPECT_NEAR(even.y,
                (above.even(part, 1 - part) - below.even(part, 1 - part)) / (2 * step),
                1e-9);
    EXPECT_NEAR(odd.y,
                (above.odd(part, 1 - part) - below.odd(part, 1 - part)) / (2 * step),
                1e-9);
  }
}

TEST(TensionSpline, FindsTheExtremesOfSlopesAndValues) {
  SplitMix64 random(4);
  for (int i = 0; i < 300; ++i) {
    const HermiteArc arc = random_arc(random);
    const double tension = i % 4 == 0 ? 0 : std::exp2(random.between(-2, 7));
    const TensionSpline spline(arc, tension);
    const Extremes slopes = brute_extremes([&](double t) { return spline.slope(t); });
    const Extremes values =
        brute_extremes([&](double t) { return spline.above_start(t); });
    const double size = size_of(arc);
    EXPECT_NEAR(spline.slopes().least * arc.length, slopes.least * arc.length,
                1e-12 * size);
    EXPECT_NEAR(spline.slopes().most * arc.length, slopes.most * arc.length,
                1e-12 * size);
    EXPECT_NEAR(spline.rises().least, std::min(values.least, arc.end - arc.start),
                1e-12 * size);
    EXPECT_NEAR(spline.rises().most, std::max(values.most, arc.end - arc.start),
                1e-12 * size);
  }
}

/// With the least tension the shape is kept, with somewhat less it is not, with more it
/// is; `defect(spline)` is positive where the shape is missed.
template <class Defect>
void expect_least(const HermiteArc& arc, double least, double tolerance, Defect defect) {
  if (least == infinity) {
    for (const double tension : {1.0, 85.0, 1e4})
      EXPECT_GT(defect(TensionSpline(arc, tension)), 0) << tension;
    return;
  }
  for (const double factor : {1.0, 1.5, 10.0})
    EXPECT_LE(defect(TensionSpline(arc, least * factor)), tolerance) << least;
  if (least == 0) return;
  EXPECT_GT(least, 0);
  EXPECT_GT(defect(TensionSpline(arc, least * (1 - 1e-3))), 0) << least;
}

TEST(LeastTension, BelowABoundIsTheLeastThatStaysThere) {
  SplitMix64 random(5);
  int num_tightened = 0;
  for (int i = 0; i < 200; ++i) {
    const HermiteArc arc = random_arc(random);
    const double upper = std::max(arc.start, arc.end) +
                         (i % 3 == 0 ? 0 : std::exp2(random.between(-8, 1)));
    const double least = least_tension_below(arc, upper);
    num_tightened += least > 0 && least < infinity ? 1 : 0;
    if (least == infinity) {
      EXPECT_TRUE((upper == arc.start && arc.start_slope > 0) ||
                  (upper == arc.end && arc.end_slope < 0));
      continue;
    }
    expect_least(arc, least, 4e-15 * size_of(arc), [&](const TensionSpline& spline) {
      const Extremes values = brute_extremes([&](double t) { return spline.value(t); });
      return values.most - upper;
    });
  }
  EXPECT_GT(num_tightened, 20);
}

TEST(LeastTension, AboveABoundIsThatBelowItOfTheReflectedArc) {
  SplitMix64 random(6);
  for (int i = 0; i < 100; ++i) {
    const HermiteArc arc = random_arc(random);
    const HermiteArc reflected{-arc.start, -arc.end, -arc.start_slope, -arc.end_slope,
                               arc.length};
    const double lower = std::min(arc.start, arc.end) - random.uniform();
    EXPECT_EQ(least_tension_above(arc, lower), least_tension_below(reflected, -lower));
  }
}

TEST(LeastTension, OfABoundOnSlopesIsTheLeastThatKeepsIt) {
  SplitMix64 random(7);
  int num_tightened = 0;
  for (int i = 0; i < 200; ++i) {
    const HermiteArc arc = random_arc(random);
    const double mean = (arc.end - arc.start) / arc.length;
    const double least_slope =
        std::min({arc.start_slope, arc.end_slope, mean}) -
        (i % 3 == 0 ? 0 : std::exp2(random.between(-8, 1)) / arc.length);
    const double least = least_tension_slope_above(arc, least_slope);
    num_tightened += least > 0 && least < infinity ? 1 : 0;
    if (least == infinity) {
      EXPECT_GE(least_slope, mean - 1e-12 * size_of(arc) / arc.length);
      continue;
    }
    expect_least(arc, least, 1e-13 * size_of(arc), [&](const TensionSpline& spline) {
      const Extremes slopes = brute_extremes([&](double t) { return spline.slope(t); });
      return (least_slope - slopes.least) * arc.length;
    });
    const HermiteArc reflected{-arc.start, -arc.end, -arc.start_slope, -arc.end_slope,
                               arc.length};
    EXPECT_EQ(least_tension_slope_below(reflected, -least_slope), least);
  }
  EXPECT_GT(num_tightened, 10);
}

TEST(LeastTension, MonotoneIsTheLeastThatTurnsNowhere) {
  SplitMix64 random(8);
  int num_tightened = 0;
  for (int i = 0; i < 600; ++i) {
    HermiteArc arc = random_arc(random);
    const double sign = arc.end > arc.start ? 1 : -1;
    arc.start_slope = sign * std::abs(arc.start_slope);
    arc.end_slope = sign * std::abs(arc.end_slope);
    const double least = least_tension_monotone(arc);
    if (arc.end == arc.start) {
      EXPECT_EQ(least, arc.start_slope == 0 && arc.end_slope == 0 ? 0 : infinity);
      continue;
    }
    ASSERT_LT(least, infinity);
    if (least == 0 && i % 8 != 0) continue;
    num_tightened += least > 0 ? 1 : 0;
    expect_least(arc, least, 1e-13 * size_of(arc), [&](const TensionSpline& spline) {
      const Extremes slopes =
          brute_extremes([&](double t) { return sign * spline.slope(t); });
      return -slopes.least * arc.length;
    });
  }
  EXPECT_GT(num_tightened, 50);
}

TEST(LeastTension, ConvexIsTheLeastThatBendsOneWay) {
  SplitMix64 random(9);
  int num_tightened = 0;
  for (int i = 0; i < 2000; ++i) {
    const HermiteArc arc = random_arc(random);
    const double mean = (arc.end - arc.start) / arc.length;
    const double a = mean - arc.start_slope, b = arc.end_slope - mean;
    const double least = least_tension_convex(arc);
    if (!(a * b > 0)) {
      if (a * b < 0) {
        EXPECT_EQ(least, infinity);
      }
      continue;
    }
    const double sign = a > 0 ? 1 : -1;
    if (least > 1e6) continue;
    num_tightened += least > 0 ? 1 : 0;
    const auto bend = [&](double tension) {
      const TensionSpline spline(arc, tension);
      double result = infinity;
      for (int k = 0; k <= 20; ++k)
        result = std::min(result, sign * spline.second(k / 20.0));
      return result * arc.length * arc.length;
    };
    const double tolerance = 1e-12 * (1 + least) * size_of(arc);
    EXPECT_GE(bend(least), -tolerance);
    EXPECT_GE(bend(1.5 * least), -tolerance);
    if (least > 1e-2) {
      EXPECT_LT(bend(least * (1 - 1e-4)), tolerance) << least;
    }
  }
  EXPECT_GT(num_tightened, 100);
}

// With the slopes 0 and r over a rise of 1 it solves (s cosh s - sinh s) = (r - 1)
// (sinh s - s); without tension the cubic is convex up to r = 3.
TEST(LeastTension, ConvexSolvesItsKnownEquation) {
  for (const double slope : {2.0, 2.9, 3.0}) {
    EXPECT_EQ(least_tension_convex({0, 1, 0, slope, 1}), 0) << slope;
  }
  for (const double slope : {3.1, 4.0, 10.0, 30.0, 80.0}) {
    const auto s = static_cast<long double>(least_tension_convex({0, 1, 0, slope, 1}));
    const long double left = s * std::cosh(s) - std::sinh(s),
                      right = (static_cast<long double>(slope) - 1) * (std::sinh(s) - s);
    EXPECT_NEAR(static_cast<double>(left / right), 1, 1e-8) << slope;
  }
}

// A cubic with rise 1 and slopes 0 and r is monotone up to r = 3 (F. N. Fritsch, R. E.
// Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246).
TEST(LeastTension, MonotoneBeginsWhereTheCubicTurns) {
  EXPECT_EQ(least_tension_monotone({0, 1, 0, 2.999999, 1}), 0);
  EXPECT_GT(least_tension_monotone({0, 1, 0, 3.001, 1}), 0);
  EXPECT_EQ(least_tension_monotone({0, 1, 3, 3, 1}), 0);
  EXPECT_GT(least_tension_monotone({0, 1, 4, 4, 1}), 0);
}

TEST(LeastTension, ScalesWithNothing) {
  const HermiteArc arc{0.25, 1, 5, 0.125, 2};
  const HermiteArc scaled{0.25 * 0x1p300, 0x1p300, 5 * 0x1p350, 0.125 * 0x1p350, 0x1p-49};
  EXPECT_EQ(least_tension_monotone(arc), least_tension_monotone(scaled));
  EXPECT_GT(least_tension_monotone(arc), 1);
  EXPECT_EQ(least_tension_below(arc, 1.25), least_tension_below(scaled, 0x1.4p300));
  EXPECT_GT(least_tension_below(arc, 1.25), 1);
  EXPECT_EQ(least_tension_convex(arc), least_tension_convex(scaled));
}

TEST(LeastTension, IsInfiniteWhereNoSplineKeepsTheShape) {
  EXPECT_EQ(least_tension_below({0, 1, 0, 0, 1}, 0.5), infinity);
  EXPECT_EQ(least_tension_below({0, 1, 0, -1, 1}, 1), infinity);
  EXPECT_EQ(least_tension_above({0, 1, -1, 1, 1}, 0), infinity);
  EXPECT_EQ(least_tension_slope_above({0, 1, 1, 2, 1}, 1.0), infinity);
  EXPECT_EQ(least_tension_slope_above({0, 1, 0.5, 2, 1}, 0.75), infinity);
  EXPECT_EQ(least_tension_monotone({0, 0, 1, 1, 1}), infinity);
  EXPECT_EQ(least_tension_monotone({0, 1, -1, 1, 1}), infinity);
  EXPECT_EQ(least_tension_convex({0, 1, 1, 2, 1}), infinity);
  EXPECT_EQ(least_tension_convex({0, 1, 0, 0, 1}), infinity);
  EXPECT_EQ(least_tension_below({0, 1, 0, 0, 1}, std::nan("")), infinity);
}

TEST(LeastTension, IsZeroForStraightArcs) {
  const HermiteArc arc{1, 3, 2, 2, 1};
  EXPECT_EQ(least_tension_monotone(arc), 0);
  EXPECT_EQ(least_tension_convex(arc), 0);
  EXPECT_EQ(least_tension_slope_above(arc, 2), 0);
  EXPECT_EQ(least_tension_slope_below(arc, 2), 0);
  EXPECT_EQ(least_tension_below(arc, 3), 0);
  EXPECT_EQ(least_tension_above(arc, 1), 0);
}

}  // namespace
}  // namespace delone::interp
