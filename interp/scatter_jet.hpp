#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

namespace delone::interp {

/// A number with its derivatives by D coordinates. Formulas written once for a type T
/// give a value with T = double and the exact gradient besides with T = ScatterJet, by
/// the same operations on the value.
template <std::size_t D>
struct ScatterJet {
  double value = 0;
  std::array<double, D> slope{};

  ScatterJet() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a constant is a number like any other
  ScatterJet(double v) : value(v) {}
  ScatterJet(double v, const std::array<double, D>& s) : value(v), slope(s) {}

  /// f(value), whose derivative there is `rate`.
  [[nodiscard]] ScatterJet mapped(double f, double rate) const noexcept {
    ScatterJet result(f);
    for (std::size_t i = 0; i < D; ++i) result.slope[i] = rate * slope[i];
    return result;
  }
  ScatterJet& operator+=(const ScatterJet& b) noexcept {
    value += b.value;
    for (std::size_t i = 0; i < D; ++i) slope[i] += b.slope[i];
    return *this;
  }
};

template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator+(ScatterJet<D> a, const ScatterJet<D>& b) noexcept {
  return a += b;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator+(ScatterJet<D> a, double b) noexcept {
  a.value += b;
  return a;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator-(const ScatterJet<D>& a) noexcept {
  return a.mapped(-a.value, -1);
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator-(const ScatterJet<D>& a,
                                      const ScatterJet<D>& b) noexcept {
  return a + -b;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator-(const ScatterJet<D>& a, double b) noexcept {
  return a + -b;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator-(double a, const ScatterJet<D>& b) noexcept {
  return -b + a;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator*(const ScatterJet<D>& a,
                                      const ScatterJet<D>& b) noexcept {
  ScatterJet<D> result(a.value * b.value);
  for (std::size_t i = 0; i < D; ++i)
    result.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
  return result;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator*(double a, const ScatterJet<D>& b) noexcept {
  return b.mapped(a * b.value, a);
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator*(const ScatterJet<D>& a, double b) noexcept {
  return b * a;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator/(const ScatterJet<D>& a,
                                      const ScatterJet<D>& b) noexcept {
  ScatterJet<D> result(a.value / b.value);
  for (std::size_t i = 0; i < D; ++i)
    result.slope[i] = (a.slope[i] - result.value * b.slope[i]) / b.value;
  return result;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator/(double a, const ScatterJet<D>& b) noexcept {
  return ScatterJet<D>(a) / b;
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> operator/(const ScatterJet<D>& a, double b) noexcept {
  return a.mapped(a.value / b, 1 / b);
}
/// The root of zero has no derivative: 0 is given.
template <std::size_t D>
[[nodiscard]] ScatterJet<D> sqrt(const ScatterJet<D>& a) noexcept {
  const double root = std::sqrt(a.value);
  return a.mapped(root, root > 0 ? 0.5 / root : 0);
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> asin(const ScatterJet<D>& a) noexcept {
  return a.mapped(std::asin(a.value), 1 / std::sqrt(1 - a.value * a.value));
}
template <std::size_t D>
[[nodiscard]] ScatterJet<D> pow(const ScatterJet<D>& a, double power) noexcept {
  const double lower = std::pow(a.value, power - 1);
  return a.mapped(std::pow(a.value, power), power * lower);
}

[[nodiscard]] inline double value_of(double a) noexcept { return a; }
template <std::size_t D>
[[nodiscard]] double value_of(const ScatterJet<D>& a) noexcept {
  return a.value;
}

/// The number moved to a value close by, its derivatives kept.
[[nodiscard]] inline double with_value(double, double v) noexcept { return v; }
template <std::size_t D>
[[nodiscard]] ScatterJet<D> with_value(ScatterJet<D> a, double v) noexcept {
  a.value = v;
  return a;
}

/// What a meshless surface's formulas are written for: double and ScatterJet.
template <class T>
concept Number = requires(T a) {
  { value_of(a) } -> std::same_as<double>;
};

/// The coordinates as numbers of type T: constants, or variables to derive by.
template <Number T, std::size_t D>
[[nodiscard]] std::array<T, D> variables(const std::array<double, D>& p) noexcept {
  std::array<T, D> result{};
  for (std::size_t i = 0; i < D; ++i) {
    result[i] = T(p[i]);
    if constexpr (!std::same_as<T, double>) result[i].slope[i] = 1;
  }
  return result;
}

}  // namespace delone::interp
