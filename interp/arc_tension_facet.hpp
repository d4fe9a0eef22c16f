#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

#include "interp/blend_space.hpp"
#include "interp/plane_facet.hpp"
#include "interp/sphere_facet.hpp"
#include "interp/tension_basis.hpp"
#include "interp/tension_spline.hpp"

namespace delone::interp {

/// A corner of a facet of Hermite tension splines.
template <BlendSpace Space>
struct ArcCorner {
  typename Space::Vector p{};
  double value = 0;
  typename Space::Vector gradient{};
};

/// The arc between two corners over unit length: its slopes are those by length times the
/// length.
template <BlendSpace Space>
[[nodiscard]] HermiteArc hermite_arc(const ArcCorner<Space>& a,
                                     const ArcCorner<Space>& b) noexcept;

// What the plane and the sphere are to the facet. Between two corners j, k of a triangle
// there is a side; from the third corner i a ray leads to a place of the side, which
// divides its chord in the ratio `to_k` : `to_j` (sum one).

/// A side as the rays that end on it see it.
template <BlendSpace Space>
struct ArcSide {
  typename Space::Vector along{};     ///< of the plane; unit, from j to k
  typename Space::Vector outward{};   ///< unit, normal to the side at all its places
  double length = 0, per_length = 0;  ///< none by lengths below 2^-500
  double sine = 0, bend = 0;          ///< of the length, cosine - 1; sphere only
};

/// A triangle of Nielson's side-vertex method with Hermite tension splines.
///
/// Over every side there is the Hermite tension spline of its ends; across a side the
/// normal derivative is linear in the length along it. Over the ray from a corner through
/// a point to the opposite side there is the Hermite tension spline from the corner to
/// what the side has there, whose tension factor is linear between those of the sides
/// that bound it. The three splines of a point are averaged with the weights b2 b3, b3
/// b1, b1 b2 over their sum, b being the point's weights in the triangle (on the sphere
/// in the flat one). Values and gradients on a side are then those of the side alone,
/// which the triangle beyond shares.
///
/// Where a short side is steep beside the whole triangle, long rays that graze it would
/// overshoot by as much as they are longer. They get tension besides: none at the ends of
/// the side, and so much between that their overshoot is of the size of the values and
/// slopes along the sides. What neighbours share does not depend on it, and smooth data
/// never need it.
///
/// On the sphere sides and rays are great circles and lengths are angles.
///
/// Source: G. M. Nielson, The side-vertex method for interpolation in triangles, J.
/// Approx. Theory 25 (1979) 318-336.
template <BlendSpace Space>
class ArcTensionFacet {
 public:
  using Vector = typename Space::Vector;
  using Corners = std::array<ArcCorner<Space>, 3>;
  template <class S>
  using Weights = std::array<S, 3>;

  /// `factors[k]`: of the side from corner k to the next.
  ArcTensionFacet(const Corners& corners, const std::array<double, 3>& factors) noexcept;

  [[nodiscard]] double operator()(Vector p) const noexcept;
  /// By two lengths from p (blend_variable.hpp). Finite.
  [[nodiscard]] SecondOrder derivatives(
      const typename Space::template Position<SecondOrder>& p) const noexcept;
  /// Next to a corner (2^-20 of the way) towards the middle of the triangle: at the
  /// corner second derivatives depend on the direction from which it is reached. `p`: the
  /// corner.
  [[nodiscard]] SecondOrder derivatives_beside(
      std::size_t corner,
      const typename Space::template Position<SecondOrder>& p) const noexcept;

 private:
  /// The side opposite to a corner with its spline, and the ray's constants.
  struct Opposite {
    ArcSide<Space> side;
    double factor = 0;
    double extra = 0;                    ///< tension of rays to the middle
    double rise = 0, even = 0, odd = 0;  ///< of the side's spline
    double normal_j = 0, normal_k = 0;   ///< derivatives across the side at its ends
    double slope_j = 0, slope_k = 0;     ///< gradient at the corner . (p_j - p)
    double along_j = 0, along_k = 0;     ///< along . (p_j - p)
    double height = 0;                   ///< outward . (p_j - p)
    double squared_j = 0, product = 0, squared_k = 0;  ///< of p_j - p and p_k - p
  };

  [[nodiscard]] Opposite opposite(std::size_t corner) const noexcept;
  /// How much values vary along the sides: the largest rise and the largest slope.
  [[nodiscard]] double variation() const noexcept;
  /// Where a ray ends: value, derivatives along the side (by its whole length) and
  /// across.
  template <class S>
  struct End {
    S value, slope, normal;
  };
  template <class S>
  [[nodiscard]] S at_weights(const Weights<S>& b) const noexcept;
  template <class S>
  [[nodiscard]] End<S> end_of_ray(std::size_t corner, const S& to_j, const S& to_k,
                                  double base) const noexcept;
  /// Above `base`.
  template <class S>
  [[nodiscard]] S along_ray(std::size_t corner, const Weights<S>& b,
                            double base) const noexcept;
  [[nodiscard]] Weights<SecondOrder> weights(
      const typename Space::template Position<SecondOrder>& p,
      const std::array<double, 3>& values) const noexcept;
  [[nodiscard]] SecondOrder sound(
      const SecondOrder& f, const Weights<SecondOrder>& b,
      const typename Space::template Position<SecondOrder>& p) const noexcept;

  Corners corners_;
  std::array<double, 3> factors_;
  std::array<Opposite, 3> opposites_;
};

}  // namespace delone::interp
