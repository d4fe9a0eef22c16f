#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "delaunay/defect.hpp"
#include "delaunay/triangle_list.hpp"

namespace delone::delaunay {

/// What is wrong with foreign neighbour lists whatever the positions: a neighbour that is
/// no node, a node in its own list or twice in one, an arc without its reverse. O(n log
/// n).
[[nodiscard]] Defect find_list_entry_defect(const NeighborRings& rings);

/// An arc of the lists that is a side of none of the triangles, as a sentence. O(n log
/// n).
[[nodiscard]] Defect find_bare_arc(const NeighborRings& rings,
                                   std::span<const Triple> triangles);

/// The triangles of foreign neighbour lists, or why there are none.
struct RingTriangles {
  std::vector<Triple> triangles;
  Defect defect;
};

/// Lists that pass find_list_entry_defect as triangles. `orientation(v, w, x)`: exact.
///
/// Lists go round counter-clockwise, or clockwise throughout, from anywhere on. They do
/// not say where the outside is: of what they enclose, triangles are what turns the way
/// most of it does; what has no area is the outside of a half sphere. Every arc must be a
/// side of one, unless there is none.
template <class Orientation>
[[nodiscard]] RingTriangles triangles_of_lists(const NeighborRings& rings,
                                               Orientation orientation) {
  std::vector<Triple> left, right;
  for (const Triple& t : triangles_of_rings(rings)) {
    const int turn = orientation(t[0], t[1], t[2]);
    if (turn != 0) (turn > 0 ? left : right).push_back(t);
  }
  std::vector<Triple>& triangles = right.size() > left.size() ? right : left;
  if (!triangles.empty()) {
    if (auto defect = find_bare_arc(rings, triangles)) return {{}, defect};
  }
  return {std::move(triangles), {}};
}

}  // namespace delone::delaunay
