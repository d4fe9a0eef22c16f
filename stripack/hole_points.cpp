#include "stripack/hole_points.hpp"

#include "delaunay/hole_faces.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

bool is_strictly_inside(const Direction& p, const std::array<Direction, 3>& corner) {
  for (std::size_t k = 0; k < 3; ++k)
    if (orientation(corner[k], corner[(k + 1) % 3], p) <= 0) return false;
  return true;
}

/// Twice the area of the plane triangle, squared.
double size_of(const std::array<Direction, 3>& corner) {
  const auto& [a, b, c] = corner;
  const double ux = b.x() - a.x(), uy = b.y() - a.y(), uz = b.z() - a.z();
  const double vx = c.x() - a.x(), vy = c.y() - a.y(), vz = c.z() - a.z();
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  return x * x + y * y + z * z;
}

/// The sum of the corners lies inside but where all but its rounding cancels: a face as
/// large as a hemisphere. There, as for slivers, the exact question says no.
std::optional<delaunay::InnerPoint> inner_point(const std::array<Direction, 3>& corner) {
  const auto& [a, b, c] = corner;
  const double x = a.x() + b.x() + c.x(), y = a.y() + b.y() + c.y(),
               z = a.z() + b.z() + c.z();
  if (x == 0 && y == 0 && z == 0) return std::nullopt;
  const LonLat p = lonlat(Direction::from(x, y, z));
  if (!is_strictly_inside(Direction::from(p), corner)) return std::nullopt;
  return delaunay::InnerPoint{size_of(corner), {p.lon_deg, p.lat_deg}};
}

}  // namespace

std::vector<LonLat> hole_points(const ConstrainedTriangulation& t) {
  const auto inner = [&](std::int32_t f) {
    std::array<Direction, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = t.points()[static_cast<std::size_t>(t.mesh().face(f).node[k])];
    return inner_point(corner);
  };
  std::vector<LonLat> points;
  for (const auto& [lon, lat] : delaunay::find_hole_points(t, t.ghost(), inner))
    points.push_back({lon, lat});
  return points;
}

}  // namespace delone::stripack
