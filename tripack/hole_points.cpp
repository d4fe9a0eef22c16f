#include "tripack/hole_points.hpp"

#include <cmath>

#include "delaunay/hole_faces.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

bool is_strictly_inside(Point2 p, const std::array<Point2, 3>& corner) {
  for (std::size_t k = 0; k < 3; ++k)
    if (orientation(corner[k], corner[(k + 1) % 3], p) <= 0) return false;
  return true;
}

/// Sides are halved and thirds summed, so that nothing overflows before the area does.
std::optional<delaunay::InnerPoint> inner_point(const std::array<Point2, 3>& corner) {
  const auto [a, b, c] = corner;
  const Point2 p{a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3};
  if (!is_strictly_inside(p, corner)) return std::nullopt;
  const double area = (b.x / 2 - a.x / 2) * (c.y / 2 - a.y / 2) -
                      (b.y / 2 - a.y / 2) * (c.x / 2 - a.x / 2);
  return delaunay::InnerPoint{std::isnan(area) ? 0 : area, {p.x, p.y}};
}

}  // namespace

std::vector<Point2> hole_points(const ConstrainedTriangulation& t) {
  const auto inner = [&](std::int32_t f) {
    std::array<Point2, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = t.points()[static_cast<std::size_t>(t.mesh().face(f).node[k])];
    return inner_point(corner);
  };
  std::vector<Point2> points;
  for (const auto& [x, y] : delaunay::find_hole_points(t, t.infinity(), inner))
    points.push_back({x, y});
  return points;
}

}  // namespace delone::tripack
