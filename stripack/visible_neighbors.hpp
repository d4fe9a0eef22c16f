#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "delaunay/path_neighbor.hpp"
#include "stripack/constrained_triangulation.hpp"

/// The nodes nearest to a node of the sphere where arcs are walls: GETNP within
/// constraints.
///
/// The distance of two nodes is the length, in radians, of the shortest path between them
/// that crosses no arc of the constraints. Paths are of great-circle arcs; what they may
/// touch, where they may turn, and that they do not change sides at a node where walls
/// leave no gap, is as in the plane (tripack/visible_neighbors.hpp). Every straight piece
/// is shorter than pi but one between opposite nodes: these see each other at pi if one
/// of the half circles between them is free. Without walls the distance is the angle, for
/// all nodes of the sphere.
///
/// Poles, the date line and regions larger than a hemisphere are nothing special: a path
/// goes round the far side where that is the shorter way. Of points in a hemisphere no
/// path leaves the hull, for an arc that does so does not come back before pi.
///
/// Which paths there are is exact: sight is decided by exact orientations of the stored
/// directions, never by lengths. Lengths are sums of rounded angles, each to 4 units in
/// the last place and 2^-51, and nodes come in the order of these; equal ones in that of
/// their coordinates (x, y, z).
///
/// Cost: as in the plane; of 100 000 random nodes the nearest 10 in 50 microseconds, 1000
/// in 6 milliseconds.
///
/// Source: tripack/visible_neighbors.hpp; on the sphere what is seen through an edge is
/// cut out by two half great circles that meet opposite to the source, and ends there.
namespace delone::stripack {

using delaunay::PathNeighbor;

/// The k nodes nearest to the position of `row`, that one left out; fewer if no more can
/// be reached. Repeated rows are one node, and its first row is named. Distances in
/// radians (times earth_radius_km: great-circle kilometres). Throws Error for a row that
/// is not there, or k below 1.
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

}  // namespace delone::stripack
