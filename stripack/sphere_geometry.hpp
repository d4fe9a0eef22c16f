#pragma once

#include <array>
#include <cmath>
#include <span>

#include "delaunay/closed_hull.hpp"
#include "stripack/direction.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

/// The sphere as a closed polyhedron: the convex hull of the sites. Faces that the centre
/// sees from behind or edge-on (orientation <= 0) are the outside of a set that lies in a
/// hemisphere.
class SphereGeometry {
 public:
  using Face = delaunay::Face;
  using Site = delaunay::Site;
  using Vector3 = delaunay::Vector3;

  explicit SphereGeometry(std::span<const Direction> points) : points_(points) {}

  [[nodiscard]] Vector3 point(Site s) const noexcept {
    const Direction& d = direction(s);
    return {d.x(), d.y(), d.z()};
  }

  /// Bound on the error of normal . q - offset, and of offset alone, for a face with
  /// sides B, C from its first corner, against the exact unit vectors: each stored point
  /// is off by at most 4 u (u = 2^-53), which moves the sixfold volume by at most 20 u
  /// (|B| + |C|), the largest distance being 2; rounding of the two products adds 22 u
  /// (|B| + |C|). 48 u leaves room for second-order terms.
  static constexpr double plane_error = 48 * 0x1p-53;

  [[nodiscard]] bool is_front(const Face& f) const noexcept {
    if (f.offset > f.error) return true;
    if (f.offset < -f.error) return false;
    return orientation(direction(f.node[0]), direction(f.node[1]), direction(f.node[2])) >
           0;
  }

  [[nodiscard]] bool sees(const std::array<Site, 3>& node, Site q) const noexcept {
    return in_circle_perturbed(direction(node[0]), direction(node[1]), direction(node[2]),
                               direction(q)) > 0;
  }

  [[nodiscard]] double side(Site a, Site b, Site q) const noexcept {
    const Vector3 u = point(a), v = point(b), p = point(q);
    return p.x * (u.y * v.z - u.z * v.y) + p.y * (u.z * v.x - u.x * v.z) +
           p.z * (u.x * v.y - u.y * v.x);
  }

  [[nodiscard]] int exact_side(Site a, Site b, Site q) const noexcept {
    return orientation(direction(a), direction(b), direction(q));
  }

 private:
  [[nodiscard]] const Direction& direction(Site s) const noexcept {
    return points_[static_cast<std::size_t>(s)];
  }

  std::span<const Direction> points_;
};

}  // namespace delone::stripack
