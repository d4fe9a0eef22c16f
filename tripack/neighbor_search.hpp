#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/neighbor_table.hpp"
#include "delaunay/options.hpp"
#include "tripack/triangulation.hpp"

/// The nodes near a point: the nearest k, all within a radius, one after the other.
///
/// The order is exact, for every finite double: no rounding decides which of two nodes is
/// nearer, and nodes exactly as far as one another come in the order of their coordinates
/// (x, then y), so that answers depend neither on the order of rows nor on threads.
/// Distances are Euclidean, within 2 units in the last place, and never decrease along a
/// list. A node is a position: repeated rows are one, and its first row is named.
///
/// Every Delaunay triangulation will do, of collinear points too. Cost of k nodes after
/// the walk: the sum of their degrees, times log k; 0.9 microseconds for k = 8. All throw
/// Error for a query that is not finite (naming its row), a k below 1, a radius that is
/// negative or NaN.
///
/// Source: the i + 1 nearest sites are connected in the Delaunay triangulation; F. P.
/// Preparata, M. I. Shamos, Computational Geometry (1985), 5.6.
namespace delone::tripack {

using delaunay::Neighbor;
using delaunay::NeighborTable;

/// The row of the node nearest to `p`; none if there is no node. `hint`: a row near p.
[[nodiscard]] Node nearest_exact(const Triangulation& t, Point2 p,
                                 Node hint = delaunay::none);

/// The k nodes nearest to `p`, or all if there are fewer.
[[nodiscard]] std::vector<Neighbor> nearest_k(const Triangulation& t, Point2 p,
                                              std::int32_t k, Node hint = delaunay::none);

/// All nodes at most `radius` away from `p`, exactly; the circle is closed.
[[nodiscard]] std::vector<Neighbor> nodes_within(const Triangulation& t, Point2 p,
                                                 double radius,
                                                 Node hint = delaunay::none);

/// nearest_k of many points. They are visited along a curve and answered in their order.
[[nodiscard]] NeighborTable nearest_k(const Triangulation& t,
                                      std::span<const Point2> queries, std::int32_t k,
                                      const RunOptions& run = {});

/// nodes_within of many points.
[[nodiscard]] NeighborTable nodes_within(const Triangulation& t,
                                         std::span<const Point2> queries, double radius,
                                         const RunOptions& run = {});

/// For every row of the triangulation the k nearest other nodes.
[[nodiscard]] NeighborTable nearest_k_of_nodes(const Triangulation& t, std::int32_t k,
                                               const RunOptions& run = {});

/// The nodes in the order of their distances from a point, one at a time: GETNP.
///
/// Keeps a reference to the triangulation, which must outlive it. For one thread.
class NearestNodes {
 public:
  explicit NearestNodes(const Triangulation& t);
  ~NearestNodes();
  NearestNodes(NearestNodes&&) noexcept;
  NearestNodes& operator=(NearestNodes&&) noexcept;

  /// Begins at the node nearest to `p`.
  void start(Point2 p, Node hint = delaunay::none);
  /// The next node; nothing after the last, and before `start`.
  [[nodiscard]] std::optional<Neighbor> next();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delone::tripack
