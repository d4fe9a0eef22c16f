#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/PolygonArea.hpp>
#include <cstddef>

#include "delaunay/parallel.hpp"
#include "stripack/polygon.hpp"
#include "stripack/voronoi.hpp"

namespace delone::stripack {

// Edges longer than this get points of the bisector in between: geodesics between points
// almost opposite to each other are not unique, and both cells must take the same one.
constexpr double longest_geodesic = 1.5;

std::vector<double> voronoi_areas_km2_wgs84(const Voronoi& voronoi,
                                            const RunOptions& options) {
  constexpr std::int64_t chunk = 512;
  const Triangulation& t = voronoi.triangulation();
  std::vector<double> areas(static_cast<std::size_t>(t.num_sites()));
  delaunay::parallel_chunks(
      t.num_sites(), chunk, options, [&](std::int64_t first, std::int64_t last) {
        for (auto s = static_cast<Site>(first); s < static_cast<Site>(last); ++s) {
          const std::vector<Direction> outline = voronoi.outline(s, longest_geodesic);
          areas[static_cast<std::size_t>(s)] =
              outline.empty() ? wgs84_area_km2() : polygon_area_km2_wgs84(outline);
        }
      });
  return areas;
}

}  // namespace delone::stripack
