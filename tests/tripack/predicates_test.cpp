#include "tripack/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <vector>

#include "delaunay/wide_integer.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "tripack/predicate_rungs.hpp"

namespace delone::tripack {

void PrintTo(const Point2& p, std::ostream* out) {
  *out << std::hexfloat << '(' << p.x << ", " << p.y << ')' << std::defaultfloat;
}

namespace {

using delaunay::Int128;
using delaunay::product;
using support::SplitMix64;
using Quadruple = std::array<Point2, 4>;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 0x1p-1074;

// The judges for integer coordinates up to 2^29: everything fits into 128 bits.
int integer_orientation(const Quadruple& q) {
  const auto at = [&q](std::size_t i) {
    return std::array{static_cast<std::int64_t>(q[i].x),
                      static_cast<std::int64_t>(q[i].y)};
  };
  const auto [ax, ay] = at(0);
  const auto [bx, by] = at(1);
  const auto [cx, cy] = at(2);
  return delaunay::sign(product(ax - cx, by - cy) - product(ay - cy, bx - cx));
}

int integer_in_circle(const Quadruple& q) {
  std::array<std::int64_t, 3> x{}, y{};
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = static_cast<std::int64_t>(q[i].x - q[3].x);
    y[i] = static_cast<std::int64_t>(q[i].y - q[3].y);
  }
  Int128 det = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    det += (product(x[i], x[i]) + product(y[i], y[i])) *
           (product(x[j], y[k]) - product(y[j], x[k]));
  }
  return delaunay::sign(det);
}

// Every rung that answers gives this answer.
void expect_all_rungs(const Quadruple& q, int turn, int inside) {
  const auto& [a, b, c, p] = q;
  const auto text = [&q] { return ::testing::PrintToString(q); };
  if (const int sign = orientation_filter(a, b, c)) {
    EXPECT_EQ(sign, turn) << text();
  }
  if (const auto sign = orientation_integer(a, b, c)) {
    EXPECT_EQ(*sign, turn) << text();
  }
  EXPECT_EQ(orientation_exact(a, b, c), turn) << text();
  EXPECT_EQ(orientation(a, b, c), turn) << text();
  if (const int sign = in_circle_filter(a, b, c, p)) {
    EXPECT_EQ(sign, inside) << text();
  }
  if (const auto sign = in_circle_integer(a, b, c, p)) {
    EXPECT_EQ(*sign, inside) << text();
  }
  EXPECT_EQ(in_circle_exact(a, b, c, p), inside) << text();
  EXPECT_EQ(in_circle(a, b, c, p), inside) << text();
}

void expect_exact(const Quadruple& q) {
  const auto& [a, b, c, p] = q;
  expect_all_rungs(q, support::exact_orientation(a, b, c),
                   support::exact_in_circle(a, b, c, p));
}

int permutation_sign(const std::array<int, 4>& order) {
  int sign = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) sign = order[i] > order[j] ? -sign : sign;
  }
  return sign;
}

// All 24 orders of the four points agree up to the sign of the permutation.
template <class Predicate>
void expect_antisymmetric(const Quadruple& q, Predicate predicate) {
  std::array order{0, 1, 2, 3};
  const int first = predicate(q[0], q[1], q[2], q[3]);
  do {
    const auto at = [&](std::size_t i) { return q[static_cast<std::size_t>(order[i])]; };
    EXPECT_EQ(predicate(at(0), at(1), at(2), at(3)), permutation_sign(order) * first)
        << ::testing::PrintToString(q);
  } while (std::next_permutation(order.begin(), order.end()));
}

std::vector<Point2> points_on_integer_circle() {
  // 1105 = 5 * 13 * 17, hence 4 * 3 * 3 * 3 points.
  std::vector<Point2> points;
  for (int x = -1105; x <= 1105; ++x) {
    const int y = static_cast<int>(std::lround(std::sqrt(1105.0 * 1105.0 - x * x)));
    if (x * x + y * y != 1105 * 1105) continue;
    points.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (y != 0) points.push_back({static_cast<double>(x), static_cast<double>(-y)});
  }
  return points;
}

// Numbers of every magnitude, from a few kinds that are mixed freely.
double wild_number(SplitMix64& random, std::size_t kind) {
  constexpr std::array edge{0.0,    smallest, 3 * smallest, 0x1p-1022, 1e-300,
                            1e-170, 1.0,      1e38,         1e300,     largest};
  const double sign = random.below(2) == 0 ? 1 : -1;
  switch (kind) {
    case 0:
      return sign * edge[random.below(edge.size())];
    case 1:
      return sign *
             std::ldexp(random.uniform(), static_cast<int>(random.below(2098)) - 1073);
    case 2:
      return sign * std::ldexp(random.uniform(), static_cast<int>(random.below(80)) - 40);
    case 3:
      return 0.1 * static_cast<double>(random.below(30));
    case 4:
      return sign * smallest * static_cast<double>(random.below(4));
    default:
      return 45802.27 + 0x1p-37 * static_cast<double>(random.below(4));
  }
}

TEST(Orientation, IsPositiveToTheLeft) {
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, -1}), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {7, 0}), 0);
}

TEST(InCircle, IsPositiveInsideOfCounterClockwiseTriangles) {
  EXPECT_EQ(in_circle({1, 0}, {0, 1}, {-1, 0}, {0, 0}), 1);
  EXPECT_EQ(in_circle({1, 0}, {0, 1}, {-1, 0}, {0, -2}), -1);
  EXPECT_EQ(in_circle({0, 1}, {1, 0}, {-1, 0}, {0, 0}), -1);
}

TEST(InCircle, IsZeroForFourCornersOfASquare) {
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {1, 1}, {0, 1}), 0);
}

TEST(PlanePredicates, AgreeWith128BitsOnRandomIntegers) {
  SplitMix64 random(31);
  for (int i = 0; i < 20000; ++i) {
    const double side = std::ldexp(1, 1 + static_cast<int>(random.below(29)));
    Quadruple q;
    for (Point2& p : q)
      p = {std::round(random.between(-side, side)),
           std::round(random.between(-side, side))};
    expect_all_rungs(q, integer_orientation(q), integer_in_circle(q));
  }
}

TEST(PlanePredicates, AgreeWith128BitsOnSmallLattices) {
  SplitMix64 random(32);
  int num_ties = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto shift = static_cast<double>(random.below(1 << 28));
    Quadruple q;
    for (Point2& p : q)
      p = {shift + static_cast<double>(random.below(4)),
           static_cast<double>(random.below(4))};
    const int inside = integer_in_circle(q);
    num_ties += static_cast<int>(inside == 0);
    expect_all_rungs(q, integer_orientation(q), inside);
  }
  EXPECT_GT(num_ties, 2000);
}

TEST(InCircle, IsZeroForAllPointsOfAnIntegerCircleAndChangesByOneUnit) {
  const std::vector<Point2> circle = points_on_integer_circle();
  ASSERT_EQ(circle.size(), 108u);
  SplitMix64 random(33);
  for (int i = 0; i < 5000; ++i) {
    Quadruple q;
    for (Point2& p : q) p = circle[random.below(circle.size())];
    expect_all_rungs(q, integer_orientation(q), 0);
    q[random.below(4)].x += 0x1p-30;
    expect_exact(q);
  }
}

TEST(PlanePredicates, AgreeWithTheJudgeOnNumbersOfEveryMagnitude) {
  SplitMix64 random(34);
  for (int i = 0; i < 20000; ++i) {
    const std::size_t kind = random.below(6),
                      other = random.below(4) == 0 ? random.below(6) : kind;
    Quadruple q;
    for (Point2& p : q) p = {wild_number(random, kind), wild_number(random, other)};
    expect_exact(q);
  }
}

TEST(PlanePredicates, AgreeWithTheJudgeOnRectanglesAndTheirNeighbours) {
  SplitMix64 random(35);
  for (int i = 0; i < 10000; ++i) {
    const std::size_t kind = random.below(6), other = random.below(6);
    const double x0 = wild_number(random, kind), x1 = wild_number(random, kind);
    const double y0 = wild_number(random, other), y1 = wild_number(random, other);
    Quadruple q{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
    EXPECT_EQ(in_circle(q[0], q[1], q[2], q[3]), 0) << ::testing::PrintToString(q);
    q[random.below(4)].x = std::nextafter(x0, x1);
    expect_exact(q);
  }
}

TEST(Orientation, SeesOneUlpOffALineThroughDecimals) {
  // On a line in decimals, off it in binary or the other way round.
  const std::array values{0.1, 0.2, 0.3, 0.7, 1.1, 12.5, 24.0};
  for (const double a : values) {
    for (const double b : values) {
      for (const double c : values) {
        expect_exact({{{a, a}, {b, b}, {c, c}, {a, c}}});
        EXPECT_EQ(orientation({a, a}, {b, b}, {c, c}), 0);
        expect_exact({{{a, a}, {b, b}, {c, std::nextafter(c, 99)}, {b, a}}});
        expect_exact({{{a, 3 * a}, {b, 3 * b}, {c, 3 * c}, {0, 0}}});
      }
    }
  }
}

TEST(Orientation, IsNotZeroWhereTheAreaRoundsToZero) {
  expect_exact({{{.5, .5}, {.2, .8}, {0, 1}, {1, 1}}});
  EXPECT_EQ(orientation({.5, .5}, {.2, .8}, {0, 1}),
            support::exact_orientation({.5, .5}, {.2, .8}, {0, 1}));
  EXPECT_NE(orientation({.5, .5}, {.2, .8}, {0, 1}), 0);
}

TEST(PlanePredicates, HoldAtTheEndsOfTheRange) {
  EXPECT_EQ(orientation({0, 0}, {0, smallest}, {smallest, 0}), -1);
  EXPECT_EQ(in_circle({0, 0}, {smallest, 0}, {0, smallest}, {smallest, smallest}), 0);
  EXPECT_EQ(in_circle({0, 0}, {2 * smallest, 0}, {0, 2 * smallest}, {smallest, smallest}),
            1);
  EXPECT_EQ(orientation({-largest, -largest}, {largest, largest}, {0, smallest}), 1);
  EXPECT_EQ(in_circle({-largest, -largest}, {largest, -largest}, {largest, largest},
                      {-largest, largest}),
            0);
  EXPECT_EQ(in_circle({-largest, -largest}, {largest, -largest}, {largest, largest},
                      {0, smallest}),
            1);
  EXPECT_EQ(orientation({0, 1e38}, {1, 1e38}, {0.5, 1e38}), 0);
  EXPECT_EQ(orientation({1e300, 1e-300}, {-1e300, -1e-300}, {0, smallest}), -1);
  EXPECT_EQ(orientation({1e-170, 0}, {0, 1e-170}, {1e-170, 1e-170}), -1);
}

TEST(PlanePredicates, TellPointsAFewUlpsApart) {
  const double x = 45802.27, y = 169208.54;
  const auto up = [](double v, int ulps) {
    for (; ulps > 0; --ulps) v = std::nextafter(v, largest);
    return v;
  };
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      for (int k = 0; k < 5; ++k) {
        expect_exact(
            {{{x, y}, {up(x, i), up(y, 4)}, {up(x, j), up(y, k)}, {up(x, k), up(y, i)}}});
      }
    }
  }
  expect_exact(
      {{{399.999779, 0}, {399.999780, 0}, {399.9997795, 1e-9}, {399.99977951, 1e-9}}});
}

TEST(InCircle, AgreesWithTheJudgeOnRotatedLattices) {
  for (const double degrees : {25.0, 45.0, 302.328, 0.001}) {
    const double c = std::cos(degrees * 0.017453292519943295),
                 s = std::sin(degrees * 0.017453292519943295);
    for (int i = 0; i < 30; ++i) {
      const auto corner = [&](int x, int y) {
        return Point2{c * x - s * y, s * x + c * y};
      };
      expect_exact({{corner(i, 3 * i), corner(i + 1, 3 * i), corner(i + 1, 3 * i + 1),
                     corner(i, 3 * i + 1)}});
    }
  }
}

TEST(PlanePredicates, DoNotChangeUnderScalingByPowersOfTwo) {
  SplitMix64 random(36);
  for (int i = 0; i < 2000; ++i) {
    Quadruple q;
    for (Point2& p : q)
      p = {0.1 * static_cast<double>(random.below(12)),
           0.3 * static_cast<double>(random.below(4))};
    const auto& [a, b, c, p] = q;
    for (const int exponent : {-960, -500, -200, 200, 500, 1000}) {
      Quadruple s = q;
      for (Point2& v : s) v = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent)};
      ASSERT_EQ(orientation(s[0], s[1], s[2]), orientation(a, b, c))
          << ::testing::PrintToString(s);
      ASSERT_EQ(in_circle(s[0], s[1], s[2], s[3]), in_circle(a, b, c, p))
          << ::testing::PrintToString(s);
    }
  }
}

TEST(PlanePredicates, AreAntisymmetric) {
  SplitMix64 random(37);
  for (int i = 0; i < 1000; ++i) {
    const std::size_t kind = random.below(6);
    Quadruple q;
    for (Point2& p : q) p = {wild_number(random, kind), wild_number(random, kind)};
    expect_antisymmetric(q, in_circle);
    EXPECT_EQ(orientation(q[0], q[1], q[2]), orientation(q[1], q[2], q[0]));
    EXPECT_EQ(orientation(q[0], q[1], q[2]), -orientation(q[1], q[0], q[2]));
  }
}

TEST(InCirclePerturbed, IsTheExactSignWhereThereIsOne) {
  SplitMix64 random(38);
  for (int i = 0; i < 2000; ++i) {
    Quadruple q;
    for (Point2& p : q)
      p = {static_cast<double>(random.below(6)), static_cast<double>(random.below(6))};
    const auto& [a, b, c, p] = q;
    const int exact = in_circle(a, b, c, p);
    if (exact != 0) {
      EXPECT_EQ(in_circle_perturbed(a, b, c, p), exact);
    }
  }
}

TEST(InCirclePerturbed, IsAntisymmetricAndNeverZeroOnACircle) {
  const std::vector<Point2> circle = points_on_integer_circle();
  SplitMix64 random(39);
  for (int i = 0; i < 500; ++i) {
    std::vector<Point2> four = support::shuffled(circle, random.next());
    const Quadruple q{four[0], four[1], four[2], four[3]};
    expect_antisymmetric(q, in_circle_perturbed);
    EXPECT_NE(in_circle_perturbed(q[0], q[1], q[2], q[3]), 0);
  }
}

TEST(InCirclePerturbed, PutsTheFirstOfFourByCoordinatesOutside) {
  const std::vector<Point2> circle = points_on_integer_circle();
  SplitMix64 random(40);
  for (int i = 0; i < 500; ++i) {
    std::vector<Point2> four = support::shuffled(circle, random.next());
    four.resize(4);
    const Point2 first = *std::min_element(
        four.begin(), four.end(),
        [](Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::erase(four, first);
    if (orientation(four[0], four[1], four[2]) < 0) std::swap(four[0], four[1]);
    EXPECT_EQ(in_circle_perturbed(four[0], four[1], four[2], first), -1);
  }
}

// Triangles of a convex polygon whose perturbed circle is empty: a triangulation
// has n - 2.
TEST(InCirclePerturbed, TriangulatesCocircularPointsInOneWay) {
  const std::vector<Point2> circle = points_on_integer_circle();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<Point2> points = support::shuffled(circle, seed);
    points.resize(9);
    const auto is_empty = [&points](Point2 a, Point2 b, Point2 c) {
      return std::none_of(points.begin(), points.end(), [&](Point2 p) {
        return p != a && p != b && p != c && in_circle_perturbed(a, b, c, p) > 0;
      });
    };
    int num_triangles = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t j = i + 1; j < 9; ++j) {
        for (std::size_t k = i + 1; k < 9; ++k) {
          if (orientation(points[i], points[j], points[k]) <= 0) continue;
          num_triangles += static_cast<int>(is_empty(points[i], points[j], points[k]));
        }
      }
    }
    EXPECT_EQ(num_triangles, 7) << "seed " << seed;
  }
}

TEST(InCircleFilter, DecidesUniformPointsNearlyAlways) {
  SplitMix64 random(41);
  int num_undecided = 0;
  for (int i = 0; i < 100000; ++i) {
    Quadruple q;
    for (Point2& p : q) p = {random.uniform(), random.uniform()};
    num_undecided += static_cast<int>(in_circle_filter(q[0], q[1], q[2], q[3]) == 0);
  }
  EXPECT_LE(num_undecided, 2);
}

TEST(InCircleInteger, DecidesWhatTheFilterLeavesOfLattices) {
  for (int i = 0; i < 100; ++i) {
    const double x0 = 0.1 * i, x1 = 0.1 * (i + 1), y0 = 0.25 * i, y1 = 0.25 * (i + 1);
    EXPECT_EQ(in_circle_filter({x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}), 0);
    EXPECT_EQ(in_circle_integer({x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}), 0);
    EXPECT_EQ(orientation_integer({x0, y0}, {x1, y1}, {x0, y0}), 0);
  }
}

TEST(PlaneFilters, DecideNothingWhereNumbersOverflowOrVanish) {
  EXPECT_EQ(
      orientation_filter({-largest, -largest}, {largest, largest}, {-largest, largest}),
      0);
  EXPECT_EQ(in_circle_filter({1e200, 0}, {0, 1e200}, {-1e200, 0}, {0, 0}), 0);
  EXPECT_EQ(orientation_filter({0, 0}, {1e-170, 0}, {0, 1e-170}), 0);
  EXPECT_EQ(in_circle_filter({1e-100, 0}, {0, 1e-100}, {-1e-100, 0}, {0, 0}), 0);
}

}  // namespace
}  // namespace delone::tripack
