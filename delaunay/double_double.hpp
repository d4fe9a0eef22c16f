#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0
#error "sums of two doubles need IEEE doubles: no -ffast-math, no extended precision"
#endif

namespace delone::delaunay {

/// A number as the unevaluated sum of two doubles: 106 bits.
///
/// Sums and products are accurate to 2^-102 of the operands' magnitudes. Products need
/// magnitudes within 2^-400 .. 2^400. Contraction-safe: every rounding that matters is of
/// a single operation. Source: T. J. Dekker, Numer. Math. 18 (1971) 224-242.
struct DoubleDouble {
  double high = 0, low = 0;
  [[nodiscard]] double rounded() const noexcept { return high + low; }
};

/// a + b exactly (Knuth).
[[nodiscard]] inline DoubleDouble two_sum(double a, double b) noexcept {
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a - b exactly.
[[nodiscard]] inline DoubleDouble two_difference(double a, double b) noexcept {
  return two_sum(a, -b);
}

/// a * b exactly (Veltkamp's splitting: no dependence on hardware fused multiply-add).
[[nodiscard]] inline DoubleDouble two_product(double a, double b) noexcept {
  const double ca = 134217729.0 * a, cb = 134217729.0 * b;
  const double a1 = ca - (ca - a), a2 = a - a1, b1 = cb - (cb - b), b2 = b - b1;
  const double p = a * b;
  return {p, a2 * b2 - (((p - a1 * b1) - a2 * b1) - a1 * b2)};
}

[[nodiscard]] inline DoubleDouble operator-(DoubleDouble a) noexcept {
  return {-a.high, -a.low};
}

[[nodiscard]] inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) noexcept {
  const DoubleDouble high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const DoubleDouble sum = two_sum(high.high, high.low + low.high);
  return two_sum(sum.high, sum.low + low.low);
}

[[nodiscard]] inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) noexcept {
  return a + -b;
}

[[nodiscard]] inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) noexcept {
  const DoubleDouble p = two_product(a.high, b.high);
  return two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

[[nodiscard]] inline DoubleDouble operator*(DoubleDouble a, double b) noexcept {
  return a * DoubleDouble{b, 0};
}

[[nodiscard]] inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) noexcept {
  const double q1 = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble{q1, 0};
  const double q2 = rest.high / b.high;
  const DoubleDouble last = rest - b * DoubleDouble{q2, 0};
  return two_sum(q1, q2) + DoubleDouble{last.high / b.high, 0};
}

[[nodiscard]] inline DoubleDouble sqrt(DoubleDouble a) noexcept {
  if (!(a.high > 0)) return {};
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - two_product(root, root);
  return two_sum(root, rest.high / (2 * root));
}

/// A sum of at most `Capacity` doubles, without any rounding until it is asked for.
/// Source: J. R. Shewchuk, Discrete Comput. Geom. 18 (1997) 305-363.
template <std::size_t Capacity>
class ExactSum {
 public:
  void add(double value) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const DoubleDouble sum = two_sum(value, terms_[i]);
      value = sum.high;
      if (sum.low != 0) terms_[kept++] = sum.low;
    }
    if (value != 0) terms_[kept++] = value;
    size_ = kept;
  }
  void add(DoubleDouble value) noexcept {
    add(value.low);
    add(value.high);
  }
  /// To 2^-100 of the sum, not of its terms.
  [[nodiscard]] DoubleDouble rounded() const noexcept {
    DoubleDouble sum;
    for (std::size_t i = size_; i-- > 0;) sum = sum + DoubleDouble{terms_[i], 0};
    return sum;
  }

 private:
  std::array<double, Capacity> terms_{};  // of growing magnitude, not overlapping
  std::size_t size_ = 0;
};

/// a d - b c, to 2^-90 of the result however much cancels, and 0 exactly where it is 0;
/// where the products of the parts neither overflow nor underflow.
[[nodiscard]] inline DoubleDouble determinant(DoubleDouble a, DoubleDouble b,
                                              DoubleDouble c, DoubleDouble d) noexcept {
  const DoubleDouble left = a * d, right = b * c, det = left - right;
  if (std::abs(det.high) > 0x1p-10 * (std::abs(left.high) + std::abs(right.high)))
    return det;
  ExactSum<16> sum;
  for (const double u : {a.low, a.high}) {
    for (const double v : {d.low, d.high}) sum.add(two_product(u, v));
  }
  for (const double u : {-b.low, -b.high}) {
    for (const double v : {c.low, c.high}) sum.add(two_product(u, v));
  }
  return sum.rounded();
}

}  // namespace delone::delaunay
