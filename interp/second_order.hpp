#pragma once

namespace delone::interp {

/// A number with its first and second derivatives by two variables: a formula written for
/// numbers, read with these, gives its own exact derivatives.
///
/// Source: A. Griewank, A. Walther, Evaluating Derivatives (2008), chapter 13.
struct SecondOrder {
  double value = 0;
  double x = 0, y = 0;            ///< first derivatives
  double xx = 0, xy = 0, yy = 0;  ///< second derivatives

  constexpr SecondOrder() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a constant is a number like any other
  constexpr SecondOrder(double constant) : value(constant) {}
  constexpr SecondOrder(double v, double dx, double dy, double dxx = 0, double dxy = 0,
                        double dyy = 0)
      : value(v), x(dx), y(dy), xx(dxx), xy(dxy), yy(dyy) {}
};

[[nodiscard]] constexpr SecondOrder operator+(const SecondOrder& a,
                                              const SecondOrder& b) noexcept {
  return {a.value + b.value, a.x + b.x, a.y + b.y, a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}
[[nodiscard]] constexpr SecondOrder operator-(const SecondOrder& a,
                                              const SecondOrder& b) noexcept {
  return {a.value - b.value, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}
[[nodiscard]] constexpr SecondOrder operator*(const SecondOrder& a,
                                              const SecondOrder& b) noexcept {
  return {a.value * b.value,
          a.x * b.value + a.value * b.x,
          a.y * b.value + a.value * b.y,
          a.xx * b.value + 2 * a.x * b.x + a.value * b.xx,
          a.xy * b.value + a.x * b.y + a.y * b.x + a.value * b.xy,
          a.yy * b.value + 2 * a.y * b.y + a.value * b.yy};
}
[[nodiscard]] constexpr SecondOrder operator*(double s, const SecondOrder& a) noexcept {
  return {s * a.value, s * a.x, s * a.y, s * a.xx, s * a.xy, s * a.yy};
}
[[nodiscard]] constexpr SecondOrder operator*(const SecondOrder& a, double s) noexcept {
  return s * a;
}
[[nodiscard]] constexpr SecondOrder operator/(const SecondOrder& a,
                                              const SecondOrder& b) noexcept {
  const double q = a.value / b.value;
  const double x = (a.x - q * b.x) / b.value, y = (a.y - q * b.y) / b.value;
  return {q,
          x,
          y,
          (a.xx - 2 * x * b.x - q * b.xx) / b.value,
          (a.xy - x * b.y - y * b.x - q * b.xy) / b.value,
          (a.yy - 2 * y * b.y - q * b.yy) / b.value};
}

/// max(a, 0); where a is not positive, 0 with all its derivatives.
[[nodiscard]] constexpr double positive_part(double a) noexcept { return a > 0 ? a : 0; }
[[nodiscard]] constexpr SecondOrder positive_part(const SecondOrder& a) noexcept {
  return a.value > 0 ? a : SecondOrder();
}

[[nodiscard]] constexpr double value_of(double a) noexcept { return a; }
[[nodiscard]] constexpr double value_of(const SecondOrder& a) noexcept { return a.value; }

}  // namespace delone::interp
