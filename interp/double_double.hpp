#pragma once

#include <cmath>

namespace delone::interp {

/// A number as the unevaluated sum of two doubles: 106 bits, enough to keep interpolation
/// on thin triangles as accurate as on good ones.
///
/// Sums and products are accurate to 2^-102 of the operands' magnitudes. Products need
/// magnitudes within 2^-400 .. 2^400. Contraction-safe: every rounding that matters is of
/// a single operation. Source: T. J. Dekker, Numer. Math. 18 (1971) 224-242.
struct DoubleDouble {
  double high = 0, low = 0;
  [[nodiscard]] double rounded() const noexcept { return high + low; }
};

/// a + b exactly (Knuth's two-sum).
[[nodiscard]] inline DoubleDouble exact_sum(double a, double b) noexcept {
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

[[nodiscard]] inline DoubleDouble exact_difference(double a, double b) noexcept {
  return exact_sum(a, -b);
}

/// a * b exactly (Veltkamp's splitting: no dependence on hardware fused multiply-add).
[[nodiscard]] inline DoubleDouble exact_product(double a, double b) noexcept {
  const double ca = 134217729.0 * a, cb = 134217729.0 * b;
  const double a1 = ca - (ca - a), a2 = a - a1, b1 = cb - (cb - b), b2 = b - b1;
  const double p = a * b;
  return {p, a2 * b2 - (((p - a1 * b1) - a2 * b1) - a1 * b2)};
}

[[nodiscard]] inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) noexcept {
  const DoubleDouble high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
  const DoubleDouble sum = exact_sum(high.high, high.low + low.high);
  return exact_sum(sum.high, sum.low + low.low);
}

[[nodiscard]] inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) noexcept {
  return a + DoubleDouble{-b.high, -b.low};
}

[[nodiscard]] inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) noexcept {
  const DoubleDouble p = exact_product(a.high, b.high);
  return exact_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

[[nodiscard]] inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) noexcept {
  const double q1 = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble{q1, 0};
  return exact_sum(q1, rest.high / b.high);
}

}  // namespace delone::interp
