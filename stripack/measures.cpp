#include "stripack/measures.hpp"

#include <cmath>

#include "delaunay/double_double.hpp"
#include "delaunay/error.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/local_frame.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using delaunay::DoubleDouble;
using delaunay::two_product;

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

DoubleDouble cosine(const Direction& a, const Direction& b, double longer) {
  const DoubleDouble dot =
      two_product(a.x(), b.x()) + two_product(a.y(), b.y()) + two_product(a.z(), b.z());
  return dot + dot * longer;
}

// 1 + cos(a, b) + cos(b, c) + cos(c, a), which cancels where corners are almost opposite.
double one_and_cosines(const Direction& a, const Direction& b, const Direction& c) {
  const double u = stretch(a), v = stretch(b), w = stretch(c);
  return (cosine(a, b, u + v) + cosine(b, c, v + w) + cosine(c, a, w + u) +
          DoubleDouble{1, 0})
      .rounded();
}

}  // namespace

double signed_area(const Direction& a, const Direction& b, const Direction& c) noexcept {
  const int side = orientation(a, b, c);
  if (side == 0) return 0;
  const double det = std::abs(LocalFrame(a).determinant(b, c));
  return 2 * side * std::atan2(det, one_and_cosines(a, b, c));
}

std::array<double, 3> angles(const Direction& a, const Direction& b,
                             const Direction& c) noexcept {
  return {angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)};
}

Cap circumcircle(const Direction& a, const Direction& b, const Direction& c) {
  if (is_same_direction(a, b) || is_same_direction(b, c) || is_same_direction(c, a))
    throw Error("a circle needs three different directions");
  const LocalFrame frame(a);
  const LocalVector center = frame.circumcenter_wide(b, c);
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
