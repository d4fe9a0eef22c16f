#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delaunay/adjacency.hpp"
#include "delaunay/buffer.hpp"

namespace delone::delaunay {

/// A point on a chart of the surface, 32 bits a coordinate.
struct Place {
  std::uint32_t u = 0, v = 0;
};

/// For every place a node that is probably near it, so that a search in a large
/// triangulation begins next to its end.
///
/// A tree of cells, each cut into 4 x 4, that grows where it is asked to: it counts
/// nothing and knows no coordinates. A part of a cell either is cut again or names a
/// node. That node may be gone by now, or be far away; it is the caller who finds out and
/// gives a better one. So the index needs next to no upkeep when nodes come and go, and
/// adapts to any density down to 2^-32 of the chart. A lookup touches one cache line a
/// level, log16(n) levels if places are spread evenly. Memory: 64 bytes a cut cell.
class PlaceIndex {
 public:
  PlaceIndex() { clear(); }
  /// Forgets everything.
  void clear();

  /// A node near `p` that `accept(node, reach)` agrees to, or none. A node of the same
  /// cell is within `reach` in u and v. Asks first for the one named for the part that
  /// holds p; if that will not do, for those of the parts around it, smallest cells
  /// first, and notes the one accepted in its place.
  template <class Accept>
  [[nodiscard]] Site near(Place p, Accept accept);
  /// A search for `p` that began at near(p) was long, and ended at `node`. The part with
  /// p gets this node; if it has been given one before, it is cut.
  void improve(Place p, Site node);
  /// If the part with `p` names `node`, which is about to go, it names `other` from now
  /// on.
  void replace(Place p, Site node, Site other) noexcept;

  [[nodiscard]] std::size_t num_cells() const noexcept { return cells_.size(); }

 private:
  // An entry: 2 * node + (1 if the node was given to this part, 0 if it comes from the
  // cell before it was cut), -1 if unknown, ~child (-2 and below) if cut.
  using Cell = std::array<std::int32_t, 16>;
  static constexpr std::int32_t unknown = -1;
  static constexpr int num_levels = 16;
  struct Slot {
    std::size_t cell, k;
    int level;
  };

  static std::size_t digit(Place p, int level) noexcept {
    const int shift = 30 - 2 * level;
    return ((p.u >> shift) & 3U) << 2U | ((p.v >> shift) & 3U);
  }
  /// Twice the width of a cell.
  static std::uint64_t reach(int level) noexcept {
    return std::uint64_t{1} << (33 - 2 * level);
  }
  [[nodiscard]] Slot find(Place p, int lowest = num_levels) const noexcept {
    Slot slot{0, digit(p, 0), 0};
    for (std::int32_t entry = cells_[0][slot.k]; entry < unknown && slot.level < lowest;
         entry = cells_[slot.cell][slot.k]) {
      ++slot.level;
      slot.cell = static_cast<std::size_t>(~entry);
      slot.k = digit(p, slot.level);
    }
    return slot;
  }

  Buffer<Cell> cells_;
};

template <class Accept>
Site PlaceIndex::near(Place p, Accept accept) {
  const Slot slot = find(p);
  std::int32_t& named = cells_[slot.cell][slot.k];
  if (named >= 0 && accept(named >> 1, reach(slot.level))) return named >> 1;
  for (int level = slot.level; level >= 0; --level) {
    for (const std::int32_t entry : cells_[find(p, level).cell]) {
      if (entry < 0 || !accept(entry >> 1, reach(level))) continue;
      named = entry & ~1;
      return entry >> 1;
    }
  }
  return none;
}

}  // namespace delone::delaunay
