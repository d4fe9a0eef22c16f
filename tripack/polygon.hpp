#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tripack/point.hpp"

namespace delone::tripack {

/// Corners in order around; the last is joined to the first, which is not repeated.
using Polygon = std::vector<Point2>;

/// The area enclosed, positive if the corners run counter-clockwise; fewer than three
/// corners have none. Correctly rounded but for the last digit, where coordinates lie
/// within 2^-200 .. 2^200: the cyclic formula, 1/2 sum x_i (y_{i+1} - y_{i-1}), is
/// summed in twice the precision. O(n).
[[nodiscard]] double signed_area(std::span<const Point2> corners) noexcept;

/// Centre of gravity of the area enclosed; of the corners' mean if there is no area; NaN
/// without corners. O(n).
[[nodiscard]] Point2 centroid(std::span<const Point2> corners) noexcept;

[[nodiscard]] double perimeter(std::span<const Point2> corners) noexcept;

enum class Containment : std::uint8_t { outside, boundary, inside };

/// Where is p? Exact for the doubles given. A polygon that crosses itself encloses what
/// an odd number of its windings go round. O(n).
[[nodiscard]] Containment locate(std::span<const Point2> corners, Point2 p) noexcept;
/// Inside, or on the boundary.
[[nodiscard]] bool contains(std::span<const Point2> corners, Point2 p) noexcept;

/// Two sides (by their first corners) that meet where they should not: sides that cross,
/// touch, overlap or have no length. Nothing if the polygon is simple. Exact. O(n log n)
/// for sides that are short beside the whole.
[[nodiscard]] std::optional<std::array<std::int32_t, 2>> find_self_intersection(
    std::span<const Point2> corners);

/// Is the polygon convex (straight angles allowed), and counter-clockwise? Exact for
/// simple polygons. O(n).
[[nodiscard]] bool is_convex(std::span<const Point2> corners) noexcept;

}  // namespace delone::tripack
