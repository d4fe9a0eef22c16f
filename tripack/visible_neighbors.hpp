#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "delaunay/path_neighbor.hpp"
#include "tripack/constrained_triangulation.hpp"

/// The nodes nearest to a node where segments are walls: GETNP within constraints.
///
/// The distance of two nodes is the length of the shortest path between them that crosses
/// no segment. A path may run along segments and touch them, on either side, and turn at
/// their ends, but it does not change sides at a node where walls leave no gap: between a
/// node's segments, in angular order, are sectors, and a path leaves a node in the sector
/// in which it came. So what a closed curve encloses is out of reach from outside, though
/// not from the curve's own nodes. A node that is no end of a piece of a segment hides
/// nothing. Regions and the domain do not count, only segments.
///
/// Which paths there are is exact: sight is decided by exact orientations, never by
/// lengths. Lengths are sums of rounded distances, within 2 units in the last place for
/// each piece of the path, and nodes come in the order of these; equal ones in that of
/// their coordinates.
///
/// Cost: a node that is a turning point is looked round from only when its turn comes,
/// and no farther than needed. For k nodes in a set without segments O(k^1.5 log k)
/// expected, for what is seen between two of them goes on through its own triangles; with
/// segments at worst the number of turning points times what each of them sees.
///
/// Sources: D. T. Lee, Proximity and reachability in the plane, thesis, University of
/// Illinois (1978); the walk of a sector of sight over triangles: F. Bungiu, M. Hemmer,
/// J. Hershberger, K. Huang, A. Kroeller, arXiv:1403.3905 (2014).
namespace delone::tripack {

using delaunay::PathNeighbor;

/// The k nodes nearest to the position of `row`, that one left out; fewer if no more can
/// be reached. Repeated rows are one node, and its first row is named. Throws Error for a
/// row that is not there, or k below 1.
[[nodiscard]] std::vector<PathNeighbor> nearest_k_visible(
    const ConstrainedTriangulation& t, Node row, std::int32_t k);

/// The nodes in the order of their distances along paths, one at a time.
///
/// Keeps a reference to the triangulation, which must outlive it. For one thread.
class VisibleNodes {
 public:
  explicit VisibleNodes(const ConstrainedTriangulation& t);
  ~VisibleNodes();
  VisibleNodes(VisibleNodes&&) noexcept;
  VisibleNodes& operator=(VisibleNodes&&) noexcept;

  /// Begins at the position of `row`. Throws Error if it is not there.
  void start(Node row);
  /// The next node; nothing once no more can be reached, and before `start`.
  [[nodiscard]] std::optional<PathNeighbor> next();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delone::tripack
