#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"

namespace delone::delaunay {

/// Which sites a segment goes through between its ends.
///
/// A segment a-b that was divided at a site remembers that site; its halves may have been
/// divided in turn. Segments that share a piece share what is known about it. The pieces
/// that are not divided are edges of the triangulation.
class SegmentPaths {
 public:
  /// The site at which a-b was divided, or none.
  [[nodiscard]] Site between(Site a, Site b) const {
    if (divided_.empty()) return none;
    const auto found = divided_.find(key(a, b));
    return found == divided_.end() ? none : found->second;
  }
  /// `at` is neither a nor b. The first division stands.
  void divide(Site a, Site b, Site at) { divided_.try_emplace(key(a, b), at); }

  /// Notes that segments meet at a site that need not be exactly on them.
  void note_meeting(Site at) { meetings_.push_back(at); }
  /// Sites noted, in no order, perhaps repeated.
  [[nodiscard]] const std::vector<Site>& meetings() const noexcept { return meetings_; }

  [[nodiscard]] bool has_divisions() const noexcept { return !divided_.empty(); }

  /// Calls every site v `number(v)` from now on.
  template <class Number>
  void renumber(Number number) {
    std::unordered_map<std::uint64_t, Site> renumbered;
    for (const auto& [ends, at] : divided_) {
      const auto a = static_cast<Site>(ends >> 32);
      const auto b = static_cast<Site>(ends & 0xFFFFFFFFu);
      renumbered.emplace(key(number(a), number(b)), number(at));
    }
    divided_ = std::move(renumbered);
    for (Site& at : meetings_) at = number(at);
  }

  /// All sites from a to b, ends included.
  [[nodiscard]] std::vector<Site> path(Site a, Site b) const;

 private:
  static std::uint64_t key(Site a, Site b) noexcept {
    const auto low = static_cast<std::uint32_t>(a < b ? a : b);
    const auto high = static_cast<std::uint32_t>(a < b ? b : a);
    return std::uint64_t{low} << 32 | high;
  }

  std::unordered_map<std::uint64_t, Site> divided_;
  std::vector<Site> meetings_;
};

}  // namespace delone::delaunay
