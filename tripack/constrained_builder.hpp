#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/region_queries.hpp"
#include "delaunay/segment_mesh.hpp"
#include "tripack/constrained_geometry.hpp"
#include "tripack/constrained_triangulation.hpp"

namespace delone::tripack {

/// A ConstrainedTriangulation in the making. Internal.
///
/// While it is built the node at infinity is the site after those of the points, and
/// added vertices come after it; `finish` puts it last.
class ConstraintBuilder {
 public:
  using Mesh = delaunay::SegmentMesh<SitePlane>;

  /// Triangulates the points and inserts the segments.
  ConstraintBuilder(const PlanarGraph& graph, const ConstraintOptions& options,
                    const RunOptions& run);
  /// `t`: the points triangulated, with or without the segments.
  ConstraintBuilder(const PlanarGraph& graph, const ConstraintOptions& options,
                    const Triangulation& t);
  ConstraintBuilder(const ConstraintBuilder&) = delete;
  ConstraintBuilder& operator=(const ConstraintBuilder&) = delete;

  [[nodiscard]] ConstrainedTriangulation finish() &&;

  // For refinement.

  [[nodiscard]] Mesh& mesh() noexcept { return mesh_; }
  [[nodiscard]] Point2 position(Site v) const noexcept { return plane_.at(v); }
  /// A number for a new site at `p`, to be inserted; given back by `drop_site`.
  Site add_site(Point2 p);
  void drop_site() { points_.pop_back(); }
  /// Called where a piece crosses a constraint.
  void cross(const Mesh::Edge& piece, HalfEdge crossed);
  [[nodiscard]] delaunay::DomainFaces classify() const;

 private:
  /// The points without the segments.
  struct Start {
    delaunay::Buffer<Point2> points;
    delaunay::Buffer<Node> rows;
    delaunay::Buffer<Site> sites;
    ClosedMesh mesh;
    int dimension;
  };
  static Start triangulate(std::span<const Point2> points, const RunOptions& run);
  static Start copy(const Triangulation& t);
  ConstraintBuilder(const PlanarGraph& graph, const ConstraintOptions& options,
                    Start start);

  void insert_segments();
  void divide_chain();
  [[noreturn]] void refuse_crossing(const Mesh::Edge& piece, const Mesh::Edge& crossed);
  [[nodiscard]] std::optional<std::int32_t> region_at(
      std::span<const std::int32_t> region_of_face, Point2 p, const char* what,
      std::size_t number) const;
  [[nodiscard]] std::vector<bool> find_removed(
      const delaunay::FaceRegions& regions) const;

  const PlanarGraph& graph_;
  ConstraintOptions options_;
  int dimension_;
  delaunay::Buffer<Point2> points_;  // where sites were added, one unused, at infinity
  double reach_;
  delaunay::Buffer<Node> rows_;
  delaunay::Buffer<Site> sites_;
  SitePlane plane_;
  Mesh mesh_;
  delaunay::SegmentList list_;
};

}  // namespace delone::tripack
