#include "tripack/measures.hpp"

#include <cmath>

namespace delone::tripack {

TriangleQuality triangle_quality(const Triangulation& t) {
  const auto point = [&](Site s) { return t.points()[static_cast<std::size_t>(s)]; };
  return delaunay::measure_triangles(
      t.adjacency(),
      [&](Site s) {
        return delaunay::Position{point(s).x, point(s).y, 0};
      },
      [&](Site a, Site b) {
        return std::hypot(point(a).x - point(b).x, point(a).y - point(b).y);
      });
}

}  // namespace delone::tripack
