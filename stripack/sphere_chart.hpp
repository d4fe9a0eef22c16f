#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "stripack/direction.hpp"

namespace delone::stripack {

/// Eight charts of the sphere: four lunes between the meridian planes x = y and x = -y,
/// each cut at the equator.
///
/// In the lune round X (one of x, y, -x, -y) with Y a quarter turn on, the chart is u = Y
/// / X in [-1, 1] and v = z / X, beyond 1 continued as 2 - X / z. Lines of constant u and
/// of constant v are great circles, so cells of the chart are parted by great circles,
/// and quotients are rounded monotonically, so points are in the cell they belong to.
///
/// The lunes of the half +-: x + y >= 0 come first. Points on a cutting plane go to the
/// side to which the plane would turn if tilted a little, so that no two opposite points
/// share a half, whatever the set: the half is strictly on one side of a tilted great
/// circle, and all that holds for plane sets holds inside it.
struct Octant {
  std::uint32_t half, lune, is_north;
};
/// Of a direction on one of the cutting planes x = y and x = -y.
[[nodiscard]] Octant octant_on_cut(const Direction& d) noexcept;
/// Without a branch that depends on where the direction is: nothing foretells it.
[[nodiscard]] inline Octant octant_of(const Direction& d) noexcept {
  if (std::abs(d.x()) == std::abs(d.y())) [[unlikely]]
    return octant_on_cut(d);
  const bool is_first = d.x() > -d.y();
  const bool is_x_lune = (d.x() > d.y()) == is_first;
  return {is_first ? 0u : 1u, is_x_lune ? 0u : 1u, d.z() >= 0 ? 1u : 0u};
}

/// |X| of the lune: the larger of |x| and |y|.
[[nodiscard]] inline double axis_part(const Direction& d) noexcept {
  const double x = std::abs(d.x()), y = std::abs(d.y());
  return x < y ? y : x;
}

/// (u, v) on the chart of the direction's own octant, rounded monotonically. All
/// meridians meet in the poles: the north pole counts as the last of them, the south pole
/// as the first, so that the order by (u, v) is that along any great circle through them.
[[nodiscard]] inline std::array<double, 2> chart_of(const Direction& d,
                                                    const Octant& octant) noexcept {
  const double axis = axis_part(d), height = std::abs(d.z());
  if (axis == 0) [[unlikely]]
    return d.z() > 0 ? std::array{1.0, 2.0} : std::array{-1.0, -2.0};
  const double across[2] = {d.y(), -d.x()}, along[2] = {d.x(), d.y()};
  const double u = across[octant.lune] / along[octant.lune];
  const bool is_beyond = height > axis;
  constexpr double first[2] = {0, 2}, slope[2] = {1, -1};
  const double v = first[is_beyond] +
                   slope[is_beyond] * (std::min(height, axis) / std::max(height, axis));
  return {u, std::copysign(v, d.z())};
}
[[nodiscard]] inline std::array<double, 2> chart_of(const Direction& d) noexcept {
  return chart_of(d, octant_of(d));
}

/// Exact order by u of directions of one half, and by v of those of one lune; used where
/// rounded products agree.
[[nodiscard]] bool is_less_u_exactly(const Direction& a, const Direction& b) noexcept;
[[nodiscard]] bool is_less_v_exactly(const Direction& a, const Direction& b) noexcept;

[[nodiscard, gnu::always_inline]] inline bool is_less_u(const Direction& a,
                                                        const Direction& b) noexcept {
  const double left = a.x() * b.y(), right = a.y() * b.x();
  return left != right ? left > right : is_less_u_exactly(a, b);
}
[[nodiscard, gnu::always_inline]] inline bool is_less_v(const Direction& a,
                                                        const Direction& b) noexcept {
  const double left = a.z() * axis_part(b), right = b.z() * axis_part(a);
  return left != right ? left < right : is_less_v_exactly(a, b);
}

}  // namespace delone::stripack
