#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay/adjacency.hpp"

namespace delone::delaunay {

/// A set of sites that is emptied in constant time: what a search has seen. Open
/// addressing; memory follows the largest set held, 16 bytes a site, not the
/// triangulation.
class SiteSet {
 public:
  SiteSet() : slots_(std::size_t{1} << 7) {}

  void clear() {
    size_ = 0;
    // After 2^32 - 1 rounds old marks would come to life again.
    if (++round_ == 0) {
      slots_.assign(slots_.size(), {});
      round_ = 1;
    }
  }

  /// True if `s` was not in the set.
  bool insert(Site s) {
    if (2 * size_ >= slots_.size()) grow();
    Slot& slot = find(s);
    if (slot.round == round_) return false;
    slot = {s, round_};
    ++size_;
    return true;
  }

 private:
  struct Slot {
    Site site = none;
    std::uint32_t round = 0;
  };

  // Where s is, or the free slot where it belongs. Multiplication by the golden ratio
  // (D. E. Knuth, The Art of Computer Programming 3, 6.4) spreads neighbours in number.
  [[nodiscard]] Slot& find(Site s) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i =
        (static_cast<std::uint32_t>(s) * std::uint64_t{0x9E3779B97F4A7C15u} >> 32) & mask;
    while (slots_[i].round == round_ && slots_[i].site != s) i = (i + 1) & mask;
    return slots_[i];
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.round == round_) find(slot.site) = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
  std::uint32_t round_ = 1;
};

}  // namespace delone::delaunay
