#include "stripack/measures.hpp"

#include <cmath>

#include "delaunay/error.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/local_frame.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

template <class Length>
TriangleQuality measure(const Triangulation& t, Length length) {
  const auto point = [&](Site s) -> const Direction& {
    return t.points()[static_cast<std::size_t>(s)];
  };
  return delaunay::measure_triangles(
      t.adjacency(),
      [&](Site s) {
        return delaunay::Position{point(s).x(), point(s).y(), point(s).z()};
      },
      [&](Site a, Site b) { return length(point(a), point(b)); });
}

double flat_angle(const Direction& at, const Direction& b, const Direction& c) {
  const auto position = [](const Direction& d) {
    return delaunay::Position{d.x(), d.y(), d.z()};
  };
  return delaunay::corner_angle(position(at), position(b), position(c));
}

double angle_at(const Direction& a, const Direction& b, const Direction& c) {
  const LocalFrame frame(a);
  const Spoke to_b = frame.spoke(b), to_c = frame.spoke(c);
  return std::atan2(std::abs(frame.determinant(b, c)), to_b.x * to_c.x + to_b.y * to_c.y);
}

}  // namespace

double signed_area(const Direction& a, const Direction& b, const Direction& c) noexcept {
  const int side = orientation(a, b, c);
  if (side == 0) return 0;
  const LocalFrame frame(a);
  const Spoke to_b = frame.spoke(b), to_c = frame.spoke(c);
  const double b_to_c = LocalFrame(b).spoke(c).rise;
  const double det = std::abs(frame.determinant(b, c));
  return 2 * side * std::atan2(det, 4 - to_b.rise - to_c.rise - b_to_c);
}

std::array<double, 3> angles(const Direction& a, const Direction& b,
                             const Direction& c) noexcept {
  return {angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)};
}

Cap circumcircle(const Direction& a, const Direction& b, const Direction& c) {
  if (is_same_direction(a, b) || is_same_direction(b, c) || is_same_direction(c, a))
    throw Error("a circle needs three different directions");
  const LocalFrame frame(a);
  const LocalVector center = frame.circumcenter(b, c, frame.spoke(b), frame.spoke(c));
  return {frame.direction(center), std::atan2(std::hypot(center.x, center.y), center.up)};
}

double aspect_ratio(const Direction& a, const Direction& b, const Direction& c) noexcept {
  return delaunay::aspect_ratio(
      {flat_angle(a, b, c), flat_angle(b, c, a), flat_angle(c, a, b)});
}

TriangleQuality triangle_quality(const Triangulation& t) {
  return measure(t, [](const Direction& a, const Direction& b) {
    return angle(a, b) * earth_radius_km;
  });
}

TriangleQuality triangle_quality_wgs84(const Triangulation& t) {
  return measure(t, [](const Direction& a, const Direction& b) {
    return geodesic_km(lonlat(a), lonlat(b));
  });
}

}  // namespace delone::stripack
