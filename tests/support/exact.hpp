#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stripack/direction.hpp"
#include "tripack/point.hpp"

/// An independent judge: exact integers of any size (GMP), straight from the definitions.
/// Shares no code with the library's predicates and none with find_defect, and is slow.
namespace delone::support {

using Triangle = std::array<std::int32_t, 3>;

[[nodiscard]] int exact_orientation(tripack::Point2 a, tripack::Point2 b,
                                    tripack::Point2 c);
[[nodiscard]] int exact_in_circle(tripack::Point2 a, tripack::Point2 b, tripack::Point2 c,
                                  tripack::Point2 p);
[[nodiscard]] int exact_orientation(const stripack::Direction& a,
                                    const stripack::Direction& b,
                                    const stripack::Direction& c);
/// The sign of det[v, |v|] over the four rows, negated: the four unit vectors v/|v| are
/// compared.
[[nodiscard]] int exact_in_circle(const stripack::Direction& a,
                                  const stripack::Direction& b,
                                  const stripack::Direction& c,
                                  const stripack::Direction& p);

/// Nothing if `triangles` (counter-clockwise, in rows) are a Delaunay triangulation, ties
/// either way, of the points. Plane: every triangle turns left, every edge has two sides
/// but those of the convex hull, which is found separately from all points; every
/// position is used; no edge has its opposite corner in the circle. Sphere: the same,
/// where all points must lie on the left of each boundary edge, and a random direction
/// and its opposite are each in one triangle, or one of them in none.
[[nodiscard]] std::optional<std::string> exact_defect(
    std::span<const tripack::Point2> points, std::span<const Triangle> triangles);
[[nodiscard]] std::optional<std::string> exact_defect(
    std::span<const stripack::Direction> points, std::span<const Triangle> triangles);

/// All triangles (a < b, c; counter-clockwise, smallest first, sorted) of different
/// positions with no point strictly inside their circle. With ties these overlap. O(n^4).
[[nodiscard]] std::vector<Triangle> empty_circle_triangles(
    std::span<const tripack::Point2> points);
[[nodiscard]] std::vector<Triangle> empty_circle_triangles(
    std::span<const stripack::Direction> points);

/// Twice the area of the convex hull, as the nearest double.
[[nodiscard]] double exact_hull_area2(std::span<const tripack::Point2> points);

}  // namespace delone::support
