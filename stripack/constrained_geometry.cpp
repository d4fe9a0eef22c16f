#include "stripack/constrained_geometry.hpp"

#include <vector>

#include "stripack/triangulation.hpp"

namespace delone::stripack {

delaunay::PartialTriangulation SiteSphere::triangulate(
    std::span<const Site> sites) const {
  std::vector<Direction> points;
  points.reserve(sites.size());
  for (const Site v : sites) points.push_back(at(v));
  const Triangulation t(points, RunOptions{.num_threads = 1, .progress = {}});
  delaunay::PartialTriangulation part{t.adjacency(), {}};
  part.sites.reserve(sites.size());
  for (const Node row : t.rows())
    part.sites.push_back(sites[static_cast<std::size_t>(row)]);
  return part;
}

}  // namespace delone::stripack
