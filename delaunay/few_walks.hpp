#pragma once

#include <cstddef>
#include <cstdint>

#include "delaunay/edge_rings.hpp"

namespace delone::delaunay {

/// Of the half-edges in the ring of `start`, the one to the smallest site.
[[nodiscard]] inline std::int32_t to_smallest(const RingEdge* edges, std::int32_t start) {
  std::int32_t best = start;
  for (std::int32_t e = edges[start].next; e != start; e = edges[e].next)
    if (edges[e].target < edges[best].target) best = e;
  return best;
}

/// The first steps around a few sites side by side: walks around one site after the other
/// would wait for memory at every step.
class FewWalks {
 public:
  static constexpr Site num_walks = 16;
  static constexpr std::int32_t num_steps = 8;

  /// Around the sites begin .. begin + 15. Walks go on where they began, so they come
  /// past some neighbours again.
  FewWalks(const RingEdge* edges, const std::int32_t* first, Site begin) {
    for (Site j = 0; j < num_walks; ++j) edge_[0][j] = first[begin + j];
    for (std::int32_t i = 0; i < num_steps; ++i) {
      for (Site j = 0; j < num_walks; ++j) {
        const RingEdge& e = edges[edge_[i][j]];
        target_[i][j] = e.target;
        edge_[i + 1][j] = e.next;
      }
    }
    for (Site j = 0; j < num_walks; j += 4) find_places(j);
  }

  /// The half-edges of a site lie anywhere in its block, which is fetched as a whole, a
  /// piece with every few sites of the block before.
  static void fetch_ahead(const RingEdge* edges, std::size_t num_edges, Site begin) {
    constexpr std::size_t line = 64 / sizeof(RingEdge), few = num_walks;
    const std::size_t first =
        6 * (static_cast<std::size_t>(begin) + static_cast<std::size_t>(ring_block_size));
    if (first + 6 * few > num_edges) return;
    for (std::size_t e = first; e < first + 6 * few; e += line)
      __builtin_prefetch(&edges[e]);
  }

  /// Is all of walk j known: 4 to 8 neighbours, each passed at most twice?
  [[nodiscard]] bool is_whole(Site j) const {
    return degree_[j] >= num_steps / 2 && degree_[j] <= num_steps;
  }
  [[nodiscard]] std::int32_t degree(Site j) const { return degree_[j]; }
  /// The first step to the smallest neighbour.
  [[nodiscard]] std::int32_t smallest(Site j) const { return start_[j]; }
  /// Step i of walk j: its half-edge, its target and its place in the list, which begins
  /// with the smallest.
  [[nodiscard]] std::int32_t edge(std::int32_t i, Site j) const { return edge_[i][j]; }
  [[nodiscard]] Site target(std::int32_t i, Site j) const { return target_[i][j]; }
  [[nodiscard]] std::int32_t place(std::int32_t i, Site j) const { return place_[i][j]; }

 private:
  using Int4 [[gnu::may_alias]] = std::int32_t __attribute__((vector_size(16)));

  static Int4 load(const std::int32_t* p) { return *reinterpret_cast<const Int4*>(p); }
  static void store(std::int32_t* p, Int4 v) { *reinterpret_cast<Int4*>(p) = v; }
  static Int4 four(std::int32_t v) { return Int4{v, v, v, v}; }
  static Int4 choose(Int4 mask, Int4 a, Int4 b) { return (mask & a) | (~mask & b); }

  // Of walks j .. j + 3: degrees, and places in the lists.
  void find_places(Site j) {
    Int4 degree = four(num_steps + 1), smallest = load(&target_[0][j]), start{};
    for (std::int32_t i = num_steps; i > 0; --i)
      degree = choose(load(&edge_[i][j]) == load(&edge_[0][j]), four(i), degree);
    for (std::int32_t i = 1; i < num_steps; ++i) {
      const Int4 target = load(&target_[i][j]), is_smaller = target < smallest;
      smallest = choose(is_smaller, target, smallest);
      start = choose(is_smaller, four(i), start);
    }
    for (std::int32_t i = 0; i < num_steps; ++i) {
      Int4 place = four(i) - start;
      place += degree & (place < 0);
      store(&place_[i][j], place - (degree & (place >= degree)));
    }
    store(&degree_[j], degree);
    store(&start_[j], start);
  }

  alignas(64) std::int32_t edge_[num_steps + 1][num_walks];
  alignas(64) std::int32_t place_[num_steps][num_walks];
  alignas(64) Site target_[num_steps][num_walks];
  alignas(64) std::int32_t degree_[num_walks];
  alignas(64) std::int32_t start_[num_walks];
};

}  // namespace delone::delaunay
