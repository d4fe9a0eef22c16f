#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

#include "interp/second_order.hpp"

namespace delone::interp {

[[nodiscard]] inline double exponential(double a) noexcept { return std::exp(a); }
[[nodiscard]] inline double exponential_minus_one(double a) noexcept {
  return std::expm1(a);
}
[[nodiscard]] inline double root(double a) noexcept { return std::sqrt(a); }
[[nodiscard]] inline double angle_of(double sine, double cosine) noexcept {
  return std::atan2(sine, cosine);
}

/// f(a), whose first and second derivatives there are `first` and `second`.
[[nodiscard]] inline SecondOrder mapped(const SecondOrder& a, double f, double first,
                                        double second) noexcept {
  return {f,
          first * a.x,
          first * a.y,
          first * a.xx + second * a.x * a.x,
          first * a.xy + second * a.x * a.y,
          first * a.yy + second * a.y * a.y};
}
[[nodiscard]] inline SecondOrder exponential(const SecondOrder& a) noexcept {
  const double e = std::exp(a.value);
  return mapped(a, e, e, e);
}
[[nodiscard]] inline SecondOrder exponential_minus_one(const SecondOrder& a) noexcept {
  const double e = std::exp(a.value);
  return mapped(a, std::expm1(a.value), e, e);
}
[[nodiscard]] inline SecondOrder root(const SecondOrder& a) noexcept {
  const double r = std::sqrt(a.value);
  return mapped(a, r, 0.5 / r, -0.25 / (a.value * r));
}
/// Of a vector that is not zero.
[[nodiscard]] inline SecondOrder angle_of(const SecondOrder& sine,
                                          const SecondOrder& cosine) noexcept {
  const double square = sine.value * sine.value + cosine.value * cosine.value;
  // d angle = (cosine d sine - sine d cosine) / square, derived once more.
  const double s = sine.value / square, c = cosine.value / square;
  const double x = c * sine.x - s * cosine.x, y = c * sine.y - s * cosine.y;
  const double dx = 2 * (s * sine.x + c * cosine.x), dy = 2 * (s * sine.y + c * cosine.y);
  const auto cross = [&](double u, double v, double w, double z) {
    return (u * z - v * w) / square;
  };
  return {
      std::atan2(sine.value, cosine.value),
      x,
      y,
      c * sine.xx - s * cosine.xx - x * dx,
      c * sine.xy - s * cosine.xy - y * dx + cross(cosine.x, sine.x, cosine.y, sine.y),
      c * sine.yy - s * cosine.yy - y * dy};
}

/// The two curves that make Hermite tension splines on 0 .. 1: with the tension s they
/// solve f'''' = s^2 f'', vanish at both ends, and have there the slopes 1, -1 (even, a
/// hump) and 1, 1 (odd):
///
///   even = (cosh x - cosh x w) / (2 x sinh x),      x = s / 2, w = 2 t - 1,
///   odd  = (sinh x w - w sinh x) / (2 (x cosh x - sinh x)).
///
/// Without tension t (1 - t) and t (1 - t) (1 - 2 t). Series below a tension of 2 and
/// exponentials of negative numbers above keep all digits for every tension, near the
/// ends those of the distance from the end. `t` and `rest` = 1 - t are given both. S: a
/// number, or one with its derivatives.
template <class S>
class TensionBasis {
 public:
  explicit TensionBasis(const S& tension) noexcept : tension_(tension) {
    if (is_cubic()) {
      per_even_ = S(1.0), per_odd_ = S(1 / odd_terms[0]);
      return;
    }
    const S x = 0.5 * tension;
    if (is_small()) {
      square_ = x * x;
      per_even_ = S(1.0) / sum(sinh_terms, square_);
      per_odd_ = S(1.0) / sum(odd_terms, square_);
      return;
    }
    decay_ = exponential(S(0.0) - tension);
    tangent_ = (S(1.0) - decay_) / (S(1.0) + decay_);
    per_even_ = S(1.0) / (S(1.0) - decay_);
    per_odd_ = S(1.0) / (x - tangent_);
  }

  [[nodiscard]] const S& tension() const noexcept { return tension_; }

  [[nodiscard]] S even(const S& t, const S& rest) const noexcept {
    if (is_cubic()) return t * rest;
    if (is_small()) {
      return t * rest * sum(sinh_terms, square_ * t * t) *
             sum(sinh_terms, square_ * rest * rest) * per_even_;
    }
    return exponential_minus_one(S(0.0) - tension_ * t) *
           exponential_minus_one(S(0.0) - tension_ * rest) * per_even_ / tension_;
  }
  [[nodiscard]] S odd(const S& t, const S& rest) const noexcept {
    if (is_cubic()) return t * rest * (rest - t);
    if (is_small()) {
      const S w = t - rest;
      return -2.0 * w * t * rest * inner_sum(w * w) * per_odd_;
    }
    const Side side = nearer(t, rest);
    const S y = tension_ * side.distance;
    const S n = exponential_minus_one(S(0.0) - y) * (S(1.0) + exponential(y - tension_)) /
                    (S(1.0) + decay_) +
                2.0 * side.distance * tangent_;
    return (0.5 * side.sign) * n * per_odd_;
  }

  [[nodiscard]] S even_slope(const S& t, const S& rest) const noexcept {
    if (is_cubic()) return rest - t;
    return S(0.0) - sinh_ratio(t, rest);
  }
  [[nodiscard]] S odd_slope(const S& t, const S& rest) const noexcept {
    if (is_cubic()) return 1.5 * (t - rest) * (t - rest) - 0.5;
    if (is_small()) {
      const S w = t - rest;
      return slope_sum(w * w) * per_odd_;
    }
    return (0.5 * tension_ * cosh_ratio(t, rest) - tangent_) * per_odd_;
  }

  [[nodiscard]] S even_second(const S& t, const S& rest) const noexcept {
    if (is_small()) {
      const S w = t - rest;
      return -2.0 * sum(cosh_terms, square_ * w * w) * per_even_;
    }
    return (S(0.0) - tension_) * cosh_ratio(t, rest) / tangent_;
  }
  [[nodiscard]] S odd_second(const S& t, const S& rest) const noexcept {
    if (is_small()) {
      const S w = t - rest;
      return 2.0 * w * sum(sinh_terms, square_ * w * w) * per_odd_;
    }
    return 0.5 * tension_ * tension_ * tangent_ * sinh_ratio(t, rest) * per_odd_;
  }

 private:
  static constexpr std::size_t num_terms = 10;
  using Terms = std::array<double, num_terms>;
  struct Side {
    S distance;
    double sign;  ///< of w
  };

  /// 1 / (first + 2 k)!
  static constexpr Terms inverse_factorials(int first) {
    Terms terms{};
    double factorial = 1;
    int last = 1;
    for (std::size_t k = 0; k < num_terms; ++k) {
      const int n = first + 2 * static_cast<int>(k);
      while (last < n) factorial *= ++last;
      terms[k] = 1 / factorial;
    }
    return terms;
  }
  /// 2 k / (2 k + 1)! for k from 1: (x cosh x - sinh x) / x^3.
  static constexpr Terms odd_denominators() {
    Terms terms = inverse_factorials(3);
    for (std::size_t k = 0; k < num_terms; ++k)
      terms[k] *= 2.0 * static_cast<double>(k + 1);
    return terms;
  }
  static constexpr Terms sinh_terms = inverse_factorials(1);  ///< sinh x / x
  static constexpr Terms cosh_terms = inverse_factorials(0);
  static constexpr Terms inner_terms = inverse_factorials(3);  ///< (sinh x - x) / x^3
  static constexpr Terms odd_terms = odd_denominators();

  [[nodiscard]] static S sum(const Terms& terms, const S& square) noexcept {
    S result(terms[num_terms - 1]);
    for (std::size_t k = num_terms - 1; k-- > 0;) result = S(terms[k]) + square * result;
    return result;
  }
  /// (w sinh x - sinh x w) / (x^3 w (1 - w^2)): no term is negative.
  [[nodiscard]] S inner_sum(const S& w_squared) const noexcept {
    S geometric(1.0), power(1.0), result(inner_terms[0]);
    for (std::size_t k = 1; k < num_terms; ++k) {
      geometric = S(1.0) + w_squared * geometric;
      power = power * square_;
      result = result + inner_terms[k] * (power * geometric);
    }
    return result;
  }
  /// (x cosh x w - sinh x) / x^3
  [[nodiscard]] S slope_sum(const S& w_squared) const noexcept {
    S w_power(1.0), power(1.0), result(0.0);
    for (std::size_t k = 0; k < num_terms; ++k) {
      w_power = w_power * w_squared;
      const double order = 2.0 * static_cast<double>(k) + 3;
      result = result + inner_terms[k] * (power * (order * w_power - S(1.0)));
      power = power * square_;
    }
    return result;
  }

  /// A short way for the usual case. Derivatives by the tension are not 0 there.
  [[nodiscard]] bool is_cubic() const noexcept {
    if constexpr (std::same_as<S, double>) return tension_ == 0;
    return false;
  }
  [[nodiscard]] bool is_small() const noexcept { return value_of(tension_) < 2; }
  [[nodiscard]] static Side nearer(const S& t, const S& rest) noexcept {
    return value_of(t) > value_of(rest) ? Side{rest, 1} : Side{t, -1};
  }
  /// sinh x w / sinh x
  [[nodiscard]] S sinh_ratio(const S& t, const S& rest) const noexcept {
    if (is_small()) {
      const S w = t - rest;
      return w * sum(sinh_terms, square_ * w * w) * per_even_;
    }
    const Side side = nearer(t, rest);
    const S y = tension_ * side.distance;
    return side.sign * (exponential(S(0.0) - y) - exponential(y - tension_)) * per_even_;
  }
  /// cosh x w / cosh x
  [[nodiscard]] S cosh_ratio(const S& t, const S& rest) const noexcept {
    const S y = tension_ * nearer(t, rest).distance;
    return (exponential(S(0.0) - y) + exponential(y - tension_)) / (S(1.0) + decay_);
  }

  S tension_, square_{}, decay_{}, tangent_{}, per_even_{}, per_odd_{};
};

}  // namespace delone::interp
