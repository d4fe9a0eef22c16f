#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/region.hpp"
#include "delaunay/segment_list.hpp"
#include "stripack/triangulation.hpp"

namespace delone::stripack {

using delaunay::ClosedMesh;
using delaunay::Crossings;
using delaunay::Domain;
using delaunay::DomainRegion;
using delaunay::HalfEdge;
using delaunay::SegmentReport;

/// A part of the sphere, named by a point in it.
struct SphereRegionSeed {
  Direction point{};
  double attribute = 0;
};

/// Points and the great-circle arcs between them: coastlines, plate boundaries, grids of
/// arcs. Arcs are pairs of rows of `points`, and each is the shorter one (less than pi).
struct SphereGraph {
  std::vector<Direction> points{};
  std::vector<std::array<Node, 2>> arcs{};
  std::vector<Direction> holes{};  ///< a point in each hole
  std::vector<SphereRegionSeed> regions{};
};

/// A sphere has no outside of its own. What remains:
///   - Domain::hull: everything that is triangulated;
///   - Domain::enclosed: all but the region that holds `outside`, the region beyond the
///     hull of points in a hemisphere, and the holes;
///   - Domain::even_odd: what an odd number of rings part from `outside`. Without it, the
///     left of the first arc (of some length) is inside: a ring that goes
///     counter-clockwise, seen from above, round its region, be that larger than a
///     hemisphere or hold a pole.
struct SphereConstraintOptions {
  Domain domain = Domain::even_odd;
  Crossings crossings = Crossings::error;
  std::optional<Direction> outside{};
};

/// The constrained Delaunay triangulation of points and arcs on the sphere, and the
/// domain that the arcs enclose: an immutable value. Exact and canonical, with the same
/// reading interface and the same meaning as tripack::ConstrainedTriangulation.
///
/// Poles, the date line and regions larger than a hemisphere are nothing special, since
/// nothing is ever projected. But only what the points surround can be triangulated: if
/// all lie in a hemisphere, a domain that reaches beyond their hull is an error; add
/// points in it.
///
/// Arcs that cross between their ends are an error that names both, or
/// (Crossings::split) both go through an added vertex at the crossing, rounded to
/// doubles; or through an end of one of them within 2^-50 radians of the other.
///
/// Thread-safe for reading. Cost: that of the triangulation, then for each arc the number
/// of edges that it crosses.
class ConstrainedTriangulation {
 public:
  using Segment = std::array<Node, 2>;

  ConstrainedTriangulation() = default;

  /// Throws Error: an arc without its point, an arc between antipodes, arcs that cross
  /// (Crossings::error), arcs that do not form rings (Domain::even_odd), a domain beyond
  /// the hull, too many points or segments.
  explicit ConstrainedTriangulation(const SphereGraph& graph,
                                    const SphereConstraintOptions& options = {},
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
  [[nodiscard]] std::span<const Direction> points() const noexcept { return points_; }
  [[nodiscard]] const Direction& point(Node row) const noexcept {
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
  [[nodiscard]] Location locate(const Direction& p, Node hint = delaunay::none) const;

  // The arcs.

  [[nodiscard]] std::int64_t num_segments() const noexcept {
    return static_cast<std::int64_t>(segments_.size());
  }
  /// Rows from one end of arc `i` of the input to the other.
  [[nodiscard]] std::vector<Node> path(std::int64_t i) const;
  /// All pieces of arcs, each once: smaller row first, sorted.
  [[nodiscard]] std::vector<Segment> constraint_edges() const;
  /// What was not clean.
  [[nodiscard]] const SegmentReport& report() const noexcept { return report_; }

  // Topology in site numbers.

  /// Everything that is triangulated, with faces to the node `ghost()` in the place of
  /// what lies beyond the hull of points in a hemisphere. No faces if all points are on
  /// one great circle.
  [[nodiscard]] const ClosedMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] Site ghost() const noexcept { return num_sites(); }
  /// The index of the face's region; none if the face is not in the domain.
  [[nodiscard]] std::int32_t region_of(std::int32_t face) const noexcept {
    return region_of_face_[static_cast<std::size_t>(face)];
  }

 private:
  friend class ConstraintBuilder;

  delaunay::Buffer<Direction> points_;
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

}  // namespace delone::stripack
