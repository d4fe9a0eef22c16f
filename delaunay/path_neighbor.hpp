#pragma once

#include "delaunay/adjacency.hpp"

namespace delone::delaunay {

/// A node that can be reached from another: its row (of repeated rows the first), and the
/// shortest path to it.
struct PathNeighbor {
  Node node = none;
  double distance = 0;  ///< the length of the path
  Node from = none;     ///< the last node where the path turns, or its beginning
  friend bool operator==(const PathNeighbor&, const PathNeighbor&) = default;
};

}  // namespace delone::delaunay
