#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/region.hpp"
#include "delaunay/segment_list.hpp"
#include "tripack/planar_graph.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

using delaunay::ClosedMesh;
using delaunay::ConstraintOptions;
using delaunay::Crossings;
using delaunay::Domain;
using delaunay::DomainRegion;
using delaunay::HalfEdge;
using delaunay::SegmentReport;

/// The constrained Delaunay triangulation of a planar straight-line graph, and the
/// domain that its segments enclose: an immutable value.
///
/// Every segment is a chain of edges, and no triangle has a point in its circle that it
/// sees past the segments. Exact for the doubles given and canonical: the same for every
/// order of points and segments.
///
/// Segments need not be clean. Points on a segment divide it; zero-length, repeated and
/// overlapping segments are taken for what they cover; `report()` lists them. Segments
/// that cross between their ends are an error that names both, or (Crossings::split) both
/// go through an added vertex at the crossing, rounded to doubles; or through an end of
/// one of them that is within 2^-50 of the largest coordinate from the other. So pieces
/// may be off their segments by as much and may then cross others; these are divided in
/// turn, until nothing crosses: the result is exact for the added vertices as they are.
/// It ends, since a piece's bounding box is smaller than that of what it is a piece of.
///
/// All of the convex hull is triangulated; what does not belong to the domain stays in
/// the mesh, marked, since walks need it. Collinear points have no triangles; then
/// segments are still divided.
///
/// Rows: those of the points, then the added vertices. Sites: see Triangulation; those of
/// added vertices come last.
///
/// Thread-safe for reading. Cost: that of the triangulation, then for each segment the
/// number of edges that it crosses.
class ConstrainedTriangulation {
 public:
  using Segment = std::array<Node, 2>;

  ConstrainedTriangulation() = default;

  /// Throws Error: a coordinate that is not finite, a segment without its point,
  /// segments that cross (Crossings::error), segments that do not form rings
  /// (Domain::even_odd), too many points or segments.
  explicit ConstrainedTriangulation(const PlanarGraph& graph,
                                    const ConstraintOptions& options = {},
                                    const RunOptions& run = {});

  [[nodiscard]] Node num_rows() const noexcept {
    return static_cast<Node>(sites_.size());
  }
  /// Rows from num_input_rows() on are added vertices.
  [[nodiscard]] Node num_input_rows() const noexcept { return num_input_rows_; }
  [[nodiscard]] Site num_sites() const noexcept {
    return static_cast<Site>(rows_.size());
  }
  /// For every site the first row with that position.
  [[nodiscard]] std::span<const Node> rows() const noexcept { return rows_; }
  /// For every row its site.
  [[nodiscard]] std::span<const Site> sites() const noexcept { return sites_; }
  /// Positions in site order.
  [[nodiscard]] std::span<const Point2> points() const noexcept { return points_; }
  [[nodiscard]] Point2 point(Node row) const noexcept {
    return points_[static_cast<std::size_t>(sites_[static_cast<std::size_t>(row)])];
  }

  // The domain.

  [[nodiscard]] std::int64_t num_triangles() const noexcept { return num_triangles_; }
  /// Triangles of the domain in rows: counter-clockwise, smallest row first, sorted.
  [[nodiscard]] std::vector<std::array<Node, 3>> triangles() const;
  /// For each of `triangles()` the index of its region.
  [[nodiscard]] std::vector<std::int32_t> triangle_regions() const;
  [[nodiscard]] std::span<const DomainRegion> regions() const noexcept {
    return regions_;
  }
  /// The triangle of the domain, its edge or node that holds `p`, or outside. Exact.
  /// `hint`: a row near p, or none.
  [[nodiscard]] Location locate(Point2 p, Node hint = delaunay::none) const;

  // The segments.

  /// Segments of the input.
  [[nodiscard]] std::int64_t num_segments() const noexcept {
    return static_cast<std::int64_t>(segments_.size());
  }
  /// Rows from one end of segment `i` of the input to the other.
  [[nodiscard]] std::vector<Node> path(std::int64_t i) const;
  /// All pieces of segments, each once: smaller row first, sorted. Also those that are
  /// not at the domain.
  [[nodiscard]] std::vector<Segment> constraint_edges() const;
  /// What was not clean.
  [[nodiscard]] const SegmentReport& report() const noexcept { return report_; }

  // Topology in site numbers.

  /// Everything in the hull, closed by faces to the node `infinity()`. Constraints are
  /// marked. No faces if all points are collinear.
  [[nodiscard]] const ClosedMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] Site infinity() const noexcept { return num_sites(); }
  /// The index of the face's region; none if the face is not in the domain.
  [[nodiscard]] std::int32_t region_of(std::int32_t face) const noexcept {
    return region_of_face_[static_cast<std::size_t>(face)];
  }
  /// The face of `mesh()` that holds `p` (one of them, if it is on an edge), in the
  /// domain or not; none outside the hull.
  [[nodiscard]] std::int32_t find_face(Point2 p, Site start = 0) const;

 private:
  friend class ConstraintBuilder;

  delaunay::Buffer<Point2> points_;
  delaunay::Buffer<Node> rows_;
  delaunay::Buffer<Site> sites_;
  Node num_input_rows_ = 0;
  ClosedMesh mesh_;
  delaunay::Buffer<std::int32_t> region_of_face_;
  std::vector<DomainRegion> regions_;
  std::int64_t num_triangles_ = 0;
  std::vector<Segment> segments_;  // of the input, in rows
  delaunay::SegmentPaths paths_;
  SegmentReport report_;
};

}  // namespace delone::tripack
