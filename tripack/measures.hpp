#pragma once

#include <array>

#include "delaunay/triangle_quality.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

using delaunay::TriangleQuality;

/// Edge lengths in the unit of the coordinates, angles and shapes of all triangles.
/// O(n).
[[nodiscard]] TriangleQuality triangle_quality(const Triangulation& t);

/// Area of a triangle, positive if a, b, c run counter-clockwise and 0 exactly if they
/// lie on a line. Within 2 units in the last place, slivers included, for coordinates
/// whose exponents differ by less than 2^200.
[[nodiscard]] double signed_area(Point2 a, Point2 b, Point2 c) noexcept;

struct Circle {
  Point2 center;
  double radius = 0;
};

/// The circle through three points, to 2 units in the last place of the centre's
/// coordinates and the radius, slivers included; for points on a line the centre is NaN
/// and the radius infinite.
[[nodiscard]] Circle circumcircle(Point2 a, Point2 b, Point2 c) noexcept;
/// The largest circle inside a triangle.
[[nodiscard]] Circle incircle(Point2 a, Point2 b, Point2 c) noexcept;

/// Angles at a, b and c in radians, small ones as accurate as large ones.
[[nodiscard]] std::array<double, 3> angles(Point2 a, Point2 b, Point2 c) noexcept;

/// Radius of the inscribed circle over that of the circumscribed one: 1/2 for an
/// equilateral triangle, 0 for a flat one.
[[nodiscard]] double aspect_ratio(Point2 a, Point2 b, Point2 c) noexcept;

}  // namespace delone::tripack
