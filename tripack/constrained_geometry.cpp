#include "tripack/constrained_geometry.hpp"

#include <vector>

#include "tripack/triangulation.hpp"

namespace delone::tripack {

delaunay::PartialTriangulation SitePlane::triangulate(std::span<const Site> sites) const {
  std::vector<Point2> points;
  points.reserve(sites.size());
  for (const Site v : sites) points.push_back(at(v));
  const Triangulation t(points, RunOptions{.num_threads = 1, .progress = {}});
  delaunay::PartialTriangulation part{t.adjacency(), {}};
  part.sites.reserve(sites.size());
  for (const Node row : t.rows())
    part.sites.push_back(sites[static_cast<std::size_t>(row)]);
  return part;
}

}  // namespace delone::tripack
