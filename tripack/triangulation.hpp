#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/options.hpp"
#include "tripack/point.hpp"

namespace delone::delaunay {
struct EdgeRings;
struct SiteOrder;
}  // namespace delone::delaunay

namespace delone::tripack {

using delaunay::Adjacency;
using delaunay::Arc;
using delaunay::Location;
using delaunay::Node;
using delaunay::Site;

/// The Delaunay triangulation of a finite set of points in the plane: an immutable value.
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
/// Degenerate sets are values: no point, one position, all collinear (`dimension()` -1,
/// 0, 1) give a triangulation without triangles in which collinear sites form a chain of
/// neighbours.
///
/// Thread-safe for reading: no hidden state. Cost: O(n log n) expected.
class Triangulation {
 public:
  Triangulation() = default;
  /// Throws Error naming the row if a coordinate is NaN or infinite, or if there are too
  /// many points (2^28).
  explicit Triangulation(std::span<const Point2> points, const RunOptions& options = {});

  [[nodiscard]] Node num_rows() const noexcept {
    return static_cast<Node>(sites_.size());
  }
  [[nodiscard]] Site num_sites() const noexcept {
    return static_cast<Site>(rows_.size());
  }
  [[nodiscard]] std::int64_t num_triangles() const noexcept { return num_triangles_; }
  /// -1 no point, 0 one position, 1 all collinear, 2 otherwise.
  [[nodiscard]] int dimension() const noexcept { return dimension_; }

  /// For every site the first row with that position.
  [[nodiscard]] std::span<const Node> rows() const noexcept { return rows_; }
  /// For every row its site; repeated rows share one.
  [[nodiscard]] std::span<const Site> sites() const noexcept { return sites_; }
  /// Positions in site order.
  [[nodiscard]] std::span<const Point2> points() const noexcept { return points_; }
  /// Topology in site numbers.
  [[nodiscard]] const Adjacency& adjacency() const noexcept { return adjacency_; }

  /// The triangle, edge or node that holds `p`. Exact. `hint`: a row near p, or none.
  [[nodiscard]] Location locate(Point2 p, Node hint = delaunay::none) const;
  /// The row of the node nearest to `p` (of repeated rows the first); none if there is no
  /// node.
  [[nodiscard]] Node nearest(Point2 p, Node hint = delaunay::none) const;
  /// Triangles in rows: counter-clockwise, smallest row first, sorted.
  [[nodiscard]] std::vector<std::array<Node, 3>> triangles() const;
  /// Rows along the convex hull, counter-clockwise, points on hull edges included,
  /// beginning at the smallest row. Collinear sets: the chain from one end to the other.
  [[nodiscard]] std::vector<Node> boundary() const;
  /// Rows of the neighbours, counter-clockwise (boundary: from one boundary neighbour to
  /// the other). A repeated row answers for its position.
  [[nodiscard]] std::vector<Node> neighbors(Node row) const;

  // For loops over many points, in site numbers.

  /// Walks from `start` (any arc; {} for the first) to an arc `a` such that either a
  /// triangle lies on the left of `a` and holds p (edges and corners included), or `a` is
  /// a boundary arc with the outside on its left and p strictly there. Exact. Returns {}
  /// if dimension() < 2.
  [[nodiscard]] Arc find(Point2 p, Arc start = {}) const;
  /// The nearest site, walking from site `start`; none if there is no site.
  [[nodiscard]] Site nearest_site(Point2 p, Site start = 0) const;

 private:
  friend class ConstraintBuilder;
  friend class Editor;
  /// Makes the topology, once points() and the order are known, unless points are in
  /// line.
  using TopologyOf =
      std::function<Adjacency(const Triangulation&, const delaunay::SiteOrder&)>;
  Triangulation(std::span<const Point2> points, const RunOptions& options,
                const TopologyOf& topology);
  /// The topology before its lists are made.
  [[nodiscard]] static delaunay::EdgeRings build_rings(std::span<const Point2> points,
                                                       const delaunay::SiteOrder& order,
                                                       const RunOptions& run);
  void make_chain();
  [[nodiscard]] Location locate_in_chain(Point2 p) const;

  delaunay::Buffer<Point2> points_;
  delaunay::Buffer<Node> rows_;
  delaunay::Buffer<Site> sites_;
  Adjacency adjacency_;
  std::int64_t num_triangles_ = 0;
  int dimension_ = -1;
};

}  // namespace delone::tripack
