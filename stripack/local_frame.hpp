#pragma once

#include <cmath>

#include "stripack/direction.hpp"

/// The sphere as a site sees it. Internal: use stripack/voronoi.hpp and
/// stripack/measures.hpp.
///
/// In the tangent plane at a site v every direction c is (up, x, y), c = up v + x e1 +
/// y e2, of any length; (x / up, y / up) is its central projection. With (x, y) the
/// tangential part of another site w and rise = 1 - v . w, what is as far from v as from
/// w is the line
///   x X + y Y = rise Up,
/// exactly as in the plane, where rise is half the squared distance. So circumcentres and
/// cells keep all digits however small a triangle is: nothing is subtracted but w - v.
namespace delone::stripack {

/// A vector of space.
struct SpaceVector {
  double x = 0, y = 0, z = 0;
};
[[nodiscard]] inline SpaceVector operator-(const Direction& a,
                                           const Direction& b) noexcept {
  return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
}
[[nodiscard]] inline SpaceVector operator+(const Direction& a,
                                           const Direction& b) noexcept {
  return {a.x() + b.x(), a.y() + b.y(), a.z() + b.z()};
}
[[nodiscard]] inline double dot(const SpaceVector& a, const SpaceVector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline SpaceVector cross(const SpaceVector& a,
                                       const SpaceVector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline SpaceVector vector(const Direction& d) noexcept {
  return {d.x(), d.y(), d.z()};
}

/// Another site as seen from v.
struct Spoke {
  double x = 0, y = 0;
  double square = 0;  ///< x^2 + y^2
  double rise = 0;    ///< 1 - cosine of the distance
};

/// A direction as seen from v, of any length.
struct LocalVector {
  double up = 0, x = 0, y = 0;
};

/// Tangential axes: right-handed with v.
///
/// Source: T. Duff et al., Building an Orthonormal Basis, Revisited, J. Comput. Graph.
/// Tech. 6 (2017) 1-8.
class LocalFrame {
 public:
  explicit LocalFrame(const Direction& v) noexcept : up_(v) {
    const double sign = std::copysign(1.0, v.z()), a = -1 / (sign + v.z());
    const double b = v.x() * v.y() * a;
    first_ = {1 + sign * v.x() * v.x() * a, sign * b, -sign * v.x()};
    second_ = {b, sign + v.y() * v.y() * a, -v.y()};
  }

  /// Coordinates to a few units of rounding of the distance.
  [[nodiscard]] Spoke spoke(const Direction& w) const noexcept {
    constexpr double near = 0.5;
    // Closer sites are found beside the axes only: there lengths differ by more than
    // that.
    constexpr double closest = 0x1p-100;
    const SpaceVector d = w - up_;
    const double x = dot(d, first_), y = dot(d, second_);
    const double square = x * x + y * y, chord2 = dot(d, d);
    if (square < closest && chord2 < near) return spoke_of_close_site(w);
    // The chord of close sites is spoilt by their lengths, which are 1 to rounding only.
    const double rise = chord2 < near ? square / (1 + std::sqrt(1 - square)) : chord2 / 2;
    return {x, y, square, rise};
  }

  /// The axis of the circle through v and two sites: the outward normal of the face
  /// (v, b, c) of the polyhedron. `up` is positive if the face is seen by the centre from
  /// inside.
  [[nodiscard]] LocalVector circumcenter(const Direction& b, const Direction& c,
                                         const Spoke& to_b,
                                         const Spoke& to_c) const noexcept {
    // Below 7 degrees rounded coordinates no longer tell the angle at v.
    constexpr double squared_sine = 1.0 / 64;
    const double up = to_b.x * to_c.y - to_b.y * to_c.x;
    if (up * up >= squared_sine * (to_b.square * to_c.square) && up * up > 0x1p-900) {
      return {up, to_b.rise * to_c.y - to_c.rise * to_b.y,
              to_b.x * to_c.rise - to_c.x * to_b.rise};
    }
    return circumcenter_wide(b, c);
  }
  /// The same in twice the precision.
  [[nodiscard]] LocalVector circumcenter_wide(const Direction& b,
                                              const Direction& c) const noexcept;

  /// That of the directions v, b and c to a few units of rounding, slivers included.
  [[nodiscard]] double determinant(const Direction& b, const Direction& c) const noexcept;

  [[nodiscard]] LocalVector local(const Direction& d) const noexcept {
    const SpaceVector v = vector(d);
    return {dot(v, vector(up_)), dot(v, first_), dot(v, second_)};
  }
  /// Throws Error on the zero vector.
  [[nodiscard]] Direction direction(const LocalVector& c) const {
    return Direction::from(c.up * up_.x() + c.x * first_.x + c.y * second_.x,
                           c.up * up_.y() + c.x * first_.y + c.y * second_.y,
                           c.up * up_.z() + c.x * first_.z + c.y * second_.z);
  }

 private:
  [[nodiscard]] Spoke spoke_of_close_site(const Direction& w) const noexcept;
  [[nodiscard]] LocalVector circumcenter_here(const Direction& b,
                                              const Direction& c) const noexcept;

  Direction up_;
  SpaceVector first_, second_;
};

}  // namespace delone::stripack
