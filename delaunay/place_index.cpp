#include "delaunay/place_index.hpp"

namespace delone::delaunay {

void PlaceIndex::clear() {
  Cell root;
  root.fill(unknown);
  cells_.assign(1, root);
}

void PlaceIndex::improve(Place p, Site node) {
  const Slot slot = find(p);
  std::int32_t& entry = cells_[slot.cell][slot.k];
  const bool is_own = entry != unknown && (entry & 1) != 0;
  if (!is_own || slot.level + 1 == num_levels) {
    entry = 2 * node + 1;
    return;
  }
  Cell parts;
  parts.fill(entry & ~1);
  parts[digit(p, slot.level + 1)] = 2 * node + 1;
  entry = ~static_cast<std::int32_t>(cells_.size());
  cells_.push_back(parts);
}

void PlaceIndex::replace(Place p, Site node, Site other) noexcept {
  const Slot slot = find(p);
  std::int32_t& entry = cells_[slot.cell][slot.k];
  if (entry >> 1 == node) entry = 2 * other + (entry & 1);
}

}  // namespace delone::delaunay
