#pragma once

#include <cmath>

#include "delaunay/double_double.hpp"

namespace delone::interp {

using delaunay::DoubleDouble;

/// A number that carries its derivatives by two variables.
template <class T>
struct Dual {
  T value{}, x{}, y{};

  friend Dual operator-(const Dual& a) noexcept { return {-a.value, -a.x, -a.y}; }
  friend Dual operator+(const Dual& a, const Dual& b) noexcept {
    return {a.value + b.value, a.x + b.x, a.y + b.y};
  }
  friend Dual operator-(const Dual& a, const Dual& b) noexcept {
    return {a.value - b.value, a.x - b.x, a.y - b.y};
  }
  friend Dual operator*(const Dual& a, const Dual& b) noexcept {
    return {a.value * b.value, a.x * b.value + a.value * b.x,
            a.y * b.value + a.value * b.y};
  }
  friend Dual operator/(const Dual& a, const Dual& b) noexcept {
    const T quotient = a.value / b.value;
    return {quotient, (a.x - quotient * b.x) / b.value, (a.y - quotient * b.y) / b.value};
  }
};

/// A constant as a number of a kind.
template <class T>
struct Constant {
  [[nodiscard]] static T of(double a) noexcept { return T{a}; }
};
template <class T>
struct Constant<Dual<T>> {
  [[nodiscard]] static Dual<T> of(double a) noexcept {
    return {Constant<T>::of(a), {}, {}};
  }
};

/// Two numbers of a plane.
template <class T>
struct Pair {
  T x{}, y{};
  friend Pair operator-(const Pair& a, const Pair& b) noexcept {
    return {a.x - b.x, a.y - b.y};
  }
  friend Pair operator+(const Pair& a, const Pair& b) noexcept {
    return {a.x + b.x, a.y + b.y};
  }
  friend Pair operator*(const T& s, const Pair& a) noexcept { return {s * a.x, s * a.y}; }
};
template <class T>
[[nodiscard]] T cross(const Pair<T>& a, const Pair<T>& b) noexcept {
  return a.x * b.y - a.y * b.x;
}
template <class T>
[[nodiscard]] T dot(const Pair<T>& a, const Pair<T>& b) noexcept {
  return a.x * b.x + a.y * b.y;
}

[[nodiscard]] inline double rounded(double a) noexcept { return a; }
[[nodiscard]] inline double rounded(const DoubleDouble& a) noexcept {
  return a.rounded();
}
template <class T>
[[nodiscard]] Dual<double> rounded(const Dual<T>& a) noexcept {
  return {rounded(a.value), rounded(a.x), rounded(a.y)};
}
[[nodiscard]] inline double value_of(double a) noexcept { return a; }
[[nodiscard]] inline double value_of(const DoubleDouble& a) noexcept { return a.high; }
template <class T>
[[nodiscard]] double value_of(const Dual<T>& a) noexcept {
  return value_of(a.value);
}

[[nodiscard]] inline Dual<double> square_root(const Dual<double>& a) noexcept {
  const double root = std::sqrt(a.value), slope = 0.5 / root;
  return {root, slope * a.x, slope * a.y};
}
[[nodiscard]] inline double square_root(double a) noexcept { return std::sqrt(a); }

/// To a unit or two in the last place.
[[nodiscard]] inline double arc_tangent(double t) noexcept {
  const double s = t * t;
  if (!(s < 0x1p-10)) return std::atan(t);
  return t - t * s * (1.0 / 3 - s * (1.0 / 5 - s * (1.0 / 7 - s * (1.0 / 9))));
}
[[nodiscard]] inline Dual<double> arc_tangent(const Dual<double>& t) noexcept {
  const double slope = 1 / (1 + t.value * t.value);
  return {arc_tangent(t.value), slope * t.x, slope * t.y};
}

/// The angle of a vector with its two components.
[[nodiscard]] inline double arc_tangent(double sine, double cosine) noexcept {
  return std::atan2(sine, cosine);
}
[[nodiscard]] inline Dual<double> arc_tangent(const Dual<double>& sine,
                                              const Dual<double>& cosine) noexcept {
  const double square = sine.value * sine.value + cosine.value * cosine.value;
  const double s = sine.value / square, c = cosine.value / square;
  return {std::atan2(sine.value, cosine.value), c * sine.x - s * cosine.x,
          c * sine.y - s * cosine.y};
}

}  // namespace delone::interp
