#include "stripack/constrained_triangulation.hpp"

#include "delaunay/mesh_walk.hpp"
#include "delaunay/region_queries.hpp"
#include "stripack/constrained_builder.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

ConstrainedTriangulation::ConstrainedTriangulation(const SphereGraph& graph,
                                                   const SphereConstraintOptions& options,
                                                   const RunOptions& run)
    : ConstrainedTriangulation(ConstraintBuilder(graph, options, run).finish()) {}

std::vector<std::array<Node, 3>> ConstrainedTriangulation::triangles() const {
  std::vector<std::array<Node, 3>> result;
  result.reserve(static_cast<std::size_t>(num_triangles_));
  for (const auto& [triangle, region] :
       delaunay::list_domain_triangles(mesh_, rows_, region_of_face_))
    result.push_back(triangle);
  return result;
}

std::vector<std::int32_t> ConstrainedTriangulation::triangle_regions() const {
  std::vector<std::int32_t> result;
  result.reserve(static_cast<std::size_t>(num_triangles_));
  for (const auto& [triangle, region] :
       delaunay::list_domain_triangles(mesh_, rows_, region_of_face_))
    result.push_back(region);
  return result;
}

Location ConstrainedTriangulation::locate(const Direction& p, Node hint) const {
  if (mesh_.num_faces() == 0) return {};
  const Site near = hint == none ? 0 : sites_[at(hint)];
  const auto place = delaunay::walk(
      mesh_, ghost(), delaunay::real_edge_at(mesh_, near, ghost()),
      [&](Site u, Site v) { return orientation(points_[at(u)], points_[at(v)], p); });
  return delaunay::locate_in_domain(mesh_, rows_, region_of_face_, place);
}

std::vector<Node> ConstrainedTriangulation::path(std::int64_t i) const {
  const Segment& ends = segments_[static_cast<std::size_t>(i)];
  const Site a = sites_[at(ends[0])], b = sites_[at(ends[1])];
  if (a == b) return {rows_[at(a)]};
  std::vector<Node> path = paths_.path(a, b);
  for (Node& node : path) node = rows_[at(node)];
  return path;
}

std::vector<ConstrainedTriangulation::Segment>
ConstrainedTriangulation::constraint_edges() const {
  return delaunay::list_constraints(mesh_, rows_);
}

}  // namespace delone::stripack
