#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/options.hpp"
#include "stripack/direction.hpp"

namespace delone::delaunay {
struct EdgeRings;
struct SiteOrder;
}  // namespace delone::delaunay

namespace delone::stripack {

using delaunay::Adjacency;
using delaunay::Arc;
using delaunay::Location;
using delaunay::Node;
using delaunay::Site;

/// The Delaunay triangulation of a finite set of directions on the sphere: an immutable
/// value.
///
/// Exact for the doubles given: no tolerance. Ties (cocircular points) are broken by a
/// symbolic perturbation that depends on coordinates only, so the triangulation is
/// unique: the same for every order of the input and every number of threads. Repeated
/// positions are merged.
///
/// Two numberings. A *row* (Node) is an index into the caller's array. A *site* is a
/// different position, numbered along a space-filling curve; topology and points are kept
/// in site order because a walk then stays in cache. Functions of single queries speak of
/// rows.
///
/// Sites that lie in a hemisphere have a boundary on the sphere; others have none (2n - 4
/// triangles).
///
/// Degenerate sets are values: no point, one position, all on one great circle
/// (`dimension()` -1, 0, 1) give a triangulation without triangles in which the sites
/// form a chain of neighbours, closed if they go round.
///
/// Thread-safe for reading: no hidden state. Cost: O(n log n) expected.
class Triangulation {
 public:
  Triangulation() = default;
  /// Throws Error if there are too many points (2^28).
  explicit Triangulation(std::span<const Direction> points,
                         const RunOptions& options = {});

  [[nodiscard]] Node num_rows() const noexcept {
    return static_cast<Node>(sites_.size());
  }
  [[nodiscard]] Site num_sites() const noexcept {
    return static_cast<Site>(rows_.size());
  }
  [[nodiscard]] std::int64_t num_triangles() const noexcept { return num_triangles_; }
  /// -1 no point, 0 one position, 1 all on one great circle, 2 otherwise.
  [[nodiscard]] int dimension() const noexcept { return dimension_; }

  /// For every site the first row with that position.
  [[nodiscard]] std::span<const Node> rows() const noexcept { return rows_; }
  /// For every row its site; repeated rows share one.
  [[nodiscard]] std::span<const Site> sites() const noexcept { return sites_; }
  /// Positions in site order.
  [[nodiscard]] std::span<const Direction> points() const noexcept { return points_; }
  /// Topology in site numbers.
  [[nodiscard]] const Adjacency& adjacency() const noexcept { return adjacency_; }

  /// The triangle, edge or node that holds `p`. Exact. `hint`: a row near p, or none.
  [[nodiscard]] Location locate(const Direction& p, Node hint = delaunay::none) const;
  /// The row of the node nearest to `p` (of repeated rows the first); none if there is no
  /// node.
  [[nodiscard]] Node nearest(const Direction& p, Node hint = delaunay::none) const;
  /// Triangles in rows: counter-clockwise, smallest row first, sorted.
  [[nodiscard]] std::vector<std::array<Node, 3>> triangles() const;
  /// Rows along the boundary of a hemispherical set, the region on the left, beginning at
  /// the smallest row; empty if the triangulation covers the sphere. Great circles: the
  /// chain.
  [[nodiscard]] std::vector<Node> boundary() const;
  /// Rows of the neighbours, counter-clockwise (boundary: from one boundary neighbour to
  /// the other). A repeated row answers for its position.
  [[nodiscard]] std::vector<Node> neighbors(Node row) const;

  // For loops over many points, in site numbers.

  /// Walks from `start` (any arc; {} for the first) to an arc `a` such that either a
  /// triangle lies on the left of `a` and holds p (edges and corners included), or `a` is
  /// a boundary arc with the outside on its left and p strictly there. Exact. Returns {}
  /// if dimension() < 2.
  [[nodiscard]] Arc find(const Direction& p, Arc start = {}) const;
  /// The nearest site, walking from site `start`; none if there is no site.
  [[nodiscard]] Site nearest_site(const Direction& p, Site start = 0) const;

 private:
  friend class ConstraintBuilder;
  friend class Editor;
  /// Lists of the sites whose first rows are given, for points whose triangulation is
  /// known already. Not asked for if there are no triangles.
  using KnownTopology = std::function<Adjacency(std::span<const Node> rows)>;
  Triangulation(std::span<const Direction> points, const RunOptions& options,
                const KnownTopology& topology);
  /// Makes the topology, once points() and the order are known, from three sites that are
  /// not on one great circle, counter-clockwise. Not asked for if there are none.
  using TopologyOf = std::function<Adjacency(
      const Triangulation&, const delaunay::SiteOrder&, const std::vector<Site>& first)>;
  Triangulation(std::span<const Direction> points, const RunOptions& options,
                const TopologyOf& topology);
  /// The topology before its lists are made; nothing if rounded numbers could not tell
  /// where to begin.
  [[nodiscard]] static std::optional<delaunay::EdgeRings> build_rings(
      std::span<const Direction> points, const delaunay::SiteOrder& order,
      const RunOptions& run);
  [[nodiscard]] static Adjacency build(std::span<const Direction> points,
                                       const std::vector<Site>& first,
                                       const delaunay::SiteOrder& order,
                                       const RunOptions& run);
  delaunay::SiteOrder number_sites(std::span<const Direction> points,
                                   const RunOptions& options);
  void settle_lengths(std::span<const Direction> points);
  void make_chain();
  [[nodiscard]] Site nearest_beyond_90_degrees(const Direction& p, Site start) const;
  [[nodiscard]] Location locate_in_chain(const Direction& p) const;

  delaunay::Buffer<Direction> points_;
  delaunay::Buffer<Node> rows_;
  delaunay::Buffer<Site> sites_;
  Adjacency adjacency_;
  std::int64_t num_triangles_ = 0;
  int dimension_ = -1;
};

}  // namespace delone::stripack
