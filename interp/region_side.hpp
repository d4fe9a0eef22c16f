#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "delaunay/big_integer.hpp"
#include "interp/blend_space.hpp"
#include "interp/spot.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"
#include "tripack/predicates.hpp"

/// Sides of nodes and of a region's corners, without ties.
///
/// The region is moved by an infinitesimal: in the plane by (e, e^2), on the sphere by a
/// rotation about (1, s, s^2), s infinitesimal too. So no node is on its boundary and no
/// corner on an edge, and what is decided one by one fits together. Source of the idea:
/// H. Edelsbrunner, E. P. Muecke, ACM Trans. Graph. 9 (1990) 66-104.
namespace delone::interp {

using stripack::Direction;
using tripack::Point2;

/// On which side of the edge from u to v is the corner p of the region? +1 left, -1
/// right.
[[nodiscard]] inline int side_of_corner(Point2 u, Point2 v, Point2 p) noexcept {
  if (const int side = orientation(u, v, p); side != 0) return side;
  if (v.y != u.y) return v.y < u.y ? 1 : -1;
  return v.x > u.x ? 1 : -1;
}

/// On which side of the line through corners a and b of the region is the node v?
[[nodiscard]] inline int side_of_node(Point2 a, Point2 b, Point2 v) noexcept {
  if (const int side = orientation(a, b, v); side != 0) return side;
  if (b.y != a.y) return b.y > a.y ? 1 : -1;
  return b.x < a.x ? 1 : -1;
}

/// det(u, v, axis x p) for the first axis that gives a sign. For u, v, p on one great
/// circle.
[[nodiscard]] inline int side_after_rotation(const Direction& u, const Direction& v,
                                             const Direction& p) noexcept {
  using Exact = delaunay::BigInteger<18>;
  const std::array<double, 9> values{u.x(), u.y(), u.z(), v.x(), v.y(),
                                     v.z(), p.x(), p.y(), p.z()};
  const int exponent = delaunay::common_exponent(values);
  const auto exact = [&](std::size_t vector, std::size_t k) {
    return Exact(values[3 * vector + k % 3], exponent);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const auto along_p = [&](std::size_t w) {  // the part of w . p without component k
      return exact(w, k + 1) * exact(2, k + 1) + exact(w, k + 2) * exact(2, k + 2);
    };
    const int side = (exact(0, k) * along_p(1) - exact(1, k) * along_p(0)).sign();
    if (side != 0) return side;
  }
  return 1;  // never: u and v are neither the same nor opposite
}

[[nodiscard]] inline int side_of_corner(const Direction& u, const Direction& v,
                                        const Direction& p) noexcept {
  const int side = orientation(u, v, p);
  return side != 0 ? side : side_after_rotation(u, v, p);
}

// The node is turned back: the derivative of det(a, b, v) has the other sign.
[[nodiscard]] inline int side_of_node(const Direction& a, const Direction& b,
                                      const Direction& v) noexcept {
  const int side = orientation(a, b, v);
  return side != 0 ? side : -side_after_rotation(a, b, v);
}

/// Is there no shortest arc between them?
[[nodiscard]] inline bool are_opposite(Point2, Point2) noexcept { return false; }
[[nodiscard]] inline bool are_opposite(const Direction& a, const Direction& b) {
  return stripack::is_same_direction(a, Direction::from(-b.x(), -b.y(), -b.z()));
}

/// Where the edge from u to v is crossed by the line through a and b: 0 at u, 1 at v. In
/// long doubles, since regions may reach much further than data.
[[nodiscard]] inline double place_of_crossing(long double at_u, long double at_v) {
  const long double place = at_u / (at_u - at_v);
  if (!(place == place)) return 0.5;  // along the edge: any place serves
  return static_cast<double>(std::clamp(place, 0.0L, 1.0L));
}

[[nodiscard]] inline double place_of_crossing(Point2 a, Point2 b, Point2 u, Point2 v) {
  using Real = long double;
  const Real dx = Real{b.x} - a.x, dy = Real{b.y} - a.y;
  const auto height = [&](Point2 p) {
    return dx * (Real{p.y} - a.y) - dy * (Real{p.x} - a.x);
  };
  return place_of_crossing(height(u), height(v));
}

/// a x b, from their difference: as good for directions a millimetre apart.
[[nodiscard]] inline std::array<long double, 3> normal_of(const Direction& a,
                                                          const Direction& b) noexcept {
  using Real = long double;
  const Real dx = Real{b.x()} - a.x(), dy = Real{b.y()} - a.y(), dz = Real{b.z()} - a.z();
  return {a.y() * dz - a.z() * dy, a.z() * dx - a.x() * dz, a.x() * dy - a.y() * dx};
}

[[nodiscard]] inline double place_of_crossing(const Direction& a, const Direction& b,
                                              const Direction& u, const Direction& v) {
  using Real = long double;
  const std::array<Real, 3> n = normal_of(a, b);
  const auto height = [&](const Direction& p) {
    return n[0] * (Real{p.x()} - a.x()) + n[1] * (Real{p.y()} - a.y()) +
           n[2] * (Real{p.z()} - a.z());
  };
  return place_of_crossing(height(u), height(v));
}

/// A box that holds edges of the hull (on the sphere their chords).
struct HullBox {
  std::array<double, 3> low{0, 0, 0}, high{0, 0, 0};
};

[[nodiscard]] inline std::array<double, 3> coordinates(Point2 p) noexcept {
  return {p.x, p.y, 0};
}
[[nodiscard]] inline std::array<double, 3> coordinates(const Direction& p) noexcept {
  return {p.x(), p.y(), p.z()};
}

/// Can the plane normal . (p - origin) = 0 meet the box? No means no.
[[nodiscard]] inline bool may_meet_plane(const HullBox& box,
                                         const std::array<long double, 3>& normal,
                                         const std::array<double, 3>& origin) noexcept {
  long double middle = 0, reach = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const long double low = box.low[k] - static_cast<long double>(origin[k]),
                      high = box.high[k] - static_cast<long double>(origin[k]);
    middle += normal[k] * ((low + high) / 2);
    reach += std::abs(normal[k]) * ((high - low) / 2);
    size += std::abs(normal[k]) * (std::abs(low) + std::abs(high));
  }
  return !(std::abs(middle) > reach + 0x1p-40L * size);
}

/// Can the segment, or the arc, from a to b meet edges in the box? No means no.
[[nodiscard]] inline bool may_meet(const HullBox& box, Point2 a, Point2 b) noexcept {
  if (std::max(a.x, b.x) < box.low[0] || std::min(a.x, b.x) > box.high[0] ||
      std::max(a.y, b.y) < box.low[1] || std::min(a.y, b.y) > box.high[1])
    return false;
  return may_meet_plane(
      box,
      {static_cast<long double>(a.y) - b.y, static_cast<long double>(b.x) - a.x, 0.0L},
      coordinates(a));
}
[[nodiscard]] inline bool may_meet(const HullBox& box, const Direction& a,
                                   const Direction& b) noexcept {
  return may_meet_plane(box, normal_of(a, b), coordinates(a));
}

}  // namespace delone::interp
