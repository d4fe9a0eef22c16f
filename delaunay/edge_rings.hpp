#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/buffer.hpp"
#include "delaunay/options.hpp"

namespace delone::delaunay {

/// A half-edge; its reverse stands at the index with the lowest bit flipped. `next` and
/// `previous` are its neighbours counter-clockwise and clockwise around its origin.
struct RingEdge {
  std::int32_t next, previous;
  Site target;
};

/// Pairs of half-edges for the taking: indices never used, and freed ones in a list that
/// runs through RingEdge::next.
struct EdgeSupply {
  std::int32_t unused, end;
  std::int32_t freed = none;
};

/// Sites whose half-edges lie together: 6 a site, in the order of blocks.
inline constexpr Site ring_block_size = 1 << 12;

/// A triangulation as rings of half-edges: what blocks are merged in.
struct EdgeRings {
  Buffer<RingEdge> edges;
  Buffer<std::int32_t> first;  ///< site -> one of the half-edges that leave it
  /// Ranges of half-edges that have been in use, those freed again with target -1.
  std::vector<std::pair<std::int32_t, std::int32_t>> used;
  std::int32_t hull = none;  ///< a hull edge, the outside on its right; or none
};

/// The neighbour lists of the rings, which are used up: `previous` then holds the place
/// of a half-edge in its list. O(n), in parallel.
[[nodiscard]] Adjacency::Lists take_lists(EdgeRings rings, const RunOptions& run);

}  // namespace delone::delaunay
