#include "tripack/constrained_triangulation.hpp"

#include "delaunay/mesh_walk.hpp"
#include "delaunay/region_queries.hpp"
#include "tripack/constrained_builder.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

using delaunay::MeshPlace;
using delaunay::none;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

MeshPlace find_place(const ConstrainedTriangulation& t, Point2 p, Site start) {
  const auto points = t.points();
  return delaunay::walk(
      t.mesh(), t.infinity(), delaunay::real_edge_at(t.mesh(), start, t.infinity()),
      [&](Site u, Site v) { return orientation(points[at(u)], points[at(v)], p); });
}

bool has_faces(const ClosedMesh& mesh) { return mesh.num_faces() > 0; }

}  // namespace

ConstrainedTriangulation::ConstrainedTriangulation(const PlanarGraph& graph,
                                                   const ConstraintOptions& options,
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

Location ConstrainedTriangulation::locate(Point2 p, Node hint) const {
  if (!has_faces(mesh_)) return {};
  const MeshPlace place = find_place(*this, p, hint == none ? 0 : sites_[at(hint)]);
  return delaunay::locate_in_domain(mesh_, rows_, region_of_face_, place);
}

std::int32_t ConstrainedTriangulation::find_face(Point2 p, Site start) const {
  if (!has_faces(mesh_)) return none;
  const MeshPlace place = find_place(*this, p, start);
  const HalfEdge e = place.kind == MeshPlace::Kind::site
                         ? delaunay::real_edge_at(mesh_, place.site, infinity())
                         : place.at;
  return is_real(mesh_, e, infinity()) ? ClosedMesh::face_of(e) : none;
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

}  // namespace delone::tripack
