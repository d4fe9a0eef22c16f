#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "interp/blend_space.hpp"

namespace delone::interp {

/// Terms of a nodal polynomial of a degree, the constant not counted.
[[nodiscard]] constexpr std::size_t num_blend_terms(int degree) noexcept {
  return static_cast<std::size_t>((degree + 1) * (degree + 2) / 2 - 1);
}

/// The terms, by degree: u, v | w, uv, (u^2 - v^2)/2 | uw, vw, and the two cubic
/// harmonics | w^2, uvw, (u^2 - v^2) w, and the two quartic harmonics.
///
/// In the plane these span the polynomials of the degree without constant. On the sphere
/// 1, u, v, w span constants and first-degree harmonics exactly; each degree spans a
/// space that does not depend on the choice of axes.
template <int Degree, class S>
[[nodiscard, gnu::always_inline]] inline std::array<S, num_blend_terms(Degree)>
model_terms(const LocalPosition<S>& p) noexcept {
  const S uu = p.u * p.u, vv = p.v * p.v, uv = p.u * p.v, half = 0.5 * (uu - vv);
  std::array<S, num_blend_terms(Degree)> t;
  t[0] = p.u, t[1] = p.v;
  if constexpr (Degree >= 2) t[2] = p.w, t[3] = uv, t[4] = half;
  if constexpr (Degree >= 3) {
    t[5] = p.u * p.w, t[6] = p.v * p.w;
    t[7] = p.u * (uu - 3.0 * vv) * (1.0 / 6), t[8] = p.v * (3.0 * uu - vv) * (1.0 / 6);
  }
  if constexpr (Degree >= 4) {
    t[9] = p.w * p.w, t[10] = uv * p.w, t[11] = 2.0 * half * p.w;
    t[12] = 2.0 * uv * half, t[13] = half * half - uv * uv;
  }
  return t;
}

/// How a surface rises from a node's value: a polynomial in coordinates about the node
/// and the bounds it is kept in.
template <int Degree>
struct BlendModel {
  double value = 0;       ///< at the node
  double per_radius = 0;  ///< one over the unit of the coordinates
  /// What the rise is kept in: least <= 0 <= most.
  double least = 0, most = 0;
  /// 0: the polynomial alone; towards 1 the surface nears the linear interpolant.
  double tension = 0;
  std::array<double, num_blend_terms(Degree)> coefficients{};
};

template <int Degree, class S>
[[nodiscard, gnu::always_inline]] inline S polynomial_rise(
    const BlendModel<Degree>& model, const LocalPosition<S>& p) noexcept {
  const std::array<S, num_blend_terms(Degree)> terms = model_terms<Degree>(p);
  S sum = model.coefficients[0] * terms[0];
  for (std::size_t k = 1; k < terms.size(); ++k)
    sum = sum + model.coefficients[k] * terms[k];
  return sum;
}

/// Of the way to a bound, the part on which a rise is left as it is.
inline constexpr double free_part = 0.5;

/// A rise kept between `least` and `most`: itself up to half the way to a bound, from
/// there on levelling off towards it; twice continuously differentiable in the rise.
template <class S>
[[nodiscard]] S softened(const S& rise, double least, double most) noexcept {
  if (value_of(rise) >= free_part * least && value_of(rise) <= free_part * most)
    return rise;
  const double bound = value_of(rise) > 0 ? most : least, knee = free_part * bound,
               room = bound - knee;
  if (room == 0) return S(0.0);
  const S x = (rise - S(knee)) * (1 / room);
  // Far out the quotient is 1, also where x is infinite.
  if (!(value_of(x) < 0x1p100)) return S(bound);
  const S part = x * (S(1.0) + x);
  return S(knee) + room * (part / (S(1.0) + part));
}

}  // namespace delone::interp
