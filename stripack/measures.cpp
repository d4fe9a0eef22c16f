#include "stripack/measures.hpp"

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

}  // namespace

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
