#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/region_queries.hpp"
#include "delaunay/segment_mesh.hpp"
#include "stripack/constrained_geometry.hpp"
#include "stripack/constrained_triangulation.hpp"

namespace delone::stripack {

/// A ConstrainedTriangulation in the making. Internal.
///
/// While it is built the ghost is the site after those of the points, and added vertices
/// come after it; `finish` puts it last.
class ConstraintBuilder {
 public:
  using Mesh = delaunay::SegmentMesh<SiteSphere>;

  /// Triangulates the points and inserts the arcs.
  ConstraintBuilder(const SphereGraph& graph, const SphereConstraintOptions& options,
                    const RunOptions& run);
  /// `t`: the points triangulated, with or without the arcs.
  ConstraintBuilder(const SphereGraph& graph, const SphereConstraintOptions& options,
                    const Triangulation& t);
  ConstraintBuilder(const ConstraintBuilder&) = delete;
  ConstraintBuilder& operator=(const ConstraintBuilder&) = delete;

  [[nodiscard]] ConstrainedTriangulation finish() &&;

 private:
  /// The points without the arcs.
  struct Start {
    delaunay::Buffer<Direction> points;
    delaunay::Buffer<Node> rows;
    delaunay::Buffer<Site> sites;
    ClosedMesh mesh;
    int dimension;
  };
  static Start triangulate(std::span<const Direction> points, const RunOptions& run);
  static Start copy(const Triangulation& t);
  ConstraintBuilder(const SphereGraph& graph, const SphereConstraintOptions& options,
                    Start start);

  void check_arcs() const;
  void insert_arcs();
  void divide_chain(Site a, Site b);
  Site add_site(const Direction& p);
  void cross(const Mesh::Edge& piece, HalfEdge crossed);
  [[noreturn]] void refuse_crossing(const Mesh::Edge& piece, const Mesh::Edge& crossed);
  [[nodiscard]] delaunay::MeshPlace place_of(const Direction& p) const;
  [[nodiscard]] std::int32_t first_left_region(
      const delaunay::FaceRegions& regions) const;
  [[nodiscard]] std::vector<bool> removed_by_parity(
      const delaunay::FaceRegions& regions) const;
  [[nodiscard]] std::vector<bool> find_removed(
      const delaunay::FaceRegions& regions) const;
  [[nodiscard]] delaunay::DomainFaces classify() const;

  const SphereGraph& graph_;
  SphereConstraintOptions options_;
  int dimension_;
  // Where sites were added, one unused, for the ghost.
  delaunay::Buffer<Direction> points_;
  delaunay::Buffer<Node> rows_;
  delaunay::Buffer<Site> sites_;
  SiteSphere sphere_;
  Mesh mesh_;
  delaunay::SegmentList list_;
  std::int64_t num_crossings_ = 0;
};

}  // namespace delone::stripack
