#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "interp/index.hpp"
#include "interp/sphere_vector.hpp"
#include "interp/thin_triangle.hpp"
#include "stripack/direction.hpp"

namespace delone::interp {

class GlobeTable;
using stripack::Direction;

/// A corner of a facet: direction and value.
struct SphereCorner {
  Vector3 p;
  double value = 0;
};

/// Is the triangle's height below thin_ratio (plane_facet.hpp) of its longest side, or is
/// it that nearly seen edge-on from the centre (its corners near one great circle)?
[[nodiscard]] bool is_thin(Vector3 a, Vector3 b, Vector3 c) noexcept;

/// The function that is linear on the flat triangle through three directions a, b, c
/// (counter-clockwise), at the point where the ray through p meets it:  f(p) = f(a) + h .
/// (p - a) / n . p  with n = (b - a) x (c - a)  and  h = (f(b) - f(a)) (c - a) x a +
/// (f(c) - f(a)) a x (b - a);  h . a = 0.
///
/// With differences from a nothing cancels, however small the triangle. Kept within the
/// range of the corner values. For triangles that are not thin.
struct PlainSphereFacet {
  Vector3 origin, slope, normal;
  double value = 0, low = 0, high = 0;

  [[nodiscard]] double operator()(Vector3 p) const noexcept {
    const double rise = (slope.z * (p.z - origin.z) + slope.x * (p.x - origin.x)) +
                        slope.y * (p.y - origin.y);
    const double height = (normal.z * p.z + normal.x * p.x) + normal.y * p.y;
    // min and max in this order also turn NaN into a bound.
    return std::max(low, std::min(high, value + rise / height));
  }
};

/// The same for all triangles, thin ones in double-double arithmetic.
class SphereFacet {
 public:
  SphereFacet(const SphereCorner& a, const SphereCorner& b,
              const SphereCorner& c) noexcept;

  [[nodiscard]] bool is_thin() const noexcept { return is_thin_; }
  /// The function as it is evaluated; none for thin triangles.
  [[nodiscard]] std::optional<PlainSphereFacet> formula() const noexcept {
    if (is_thin_) return {};
    return plain_;
  }
  [[nodiscard]] double operator()(Vector3 p) const noexcept {
    return is_thin_ ? thin_value(p) : plain_(p);
  }
  /// At the nodes of row j in the given columns, into the same places of `row`.
  void fill_row(double* row, const GlobeTable& table, IndexRange columns,
                std::int64_t j) const noexcept;
  /// Tangent to the unit sphere at the unit vector p, per radian.
  [[nodiscard]] Vector3 gradient(Vector3 p) const noexcept;

 private:
  [[nodiscard]] double thin_value(Vector3 p) const noexcept;

  PlainSphereFacet plain_;
  bool is_thin_;
  ThinTriangle thin_;  // if it is
  double rise_b_, rise_c_;
};

/// Weights of the corners at a direction in their closed triangle: not negative, sum one
/// up to rounding.
[[nodiscard]] std::array<double, 3> corner_weights(Vector3 a, Vector3 b, Vector3 c,
                                                   Vector3 p) noexcept;

/// The weight of b at a direction on the arc from a to b, linear along the chord, 0 .. 1.
[[nodiscard]] double edge_weight(Vector3 a, Vector3 b, Vector3 p) noexcept;

/// Value and gradient on the arc from a to b, linear along the chord.
[[nodiscard]] double edge_value(const SphereCorner& a, const SphereCorner& b,
                                Vector3 p) noexcept;
[[nodiscard]] Vector3 edge_gradient(const SphereCorner& a, const SphereCorner& b,
                                    Vector3 p) noexcept;

}  // namespace delone::interp
