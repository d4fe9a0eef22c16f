#pragma once

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/closed_hull.hpp"

namespace delone::delaunay {

/// The neighbour lists of sites 0 .. num_sites - 1 over the front faces of a closed hull.
///
/// A site is on the boundary if one of its faces is outside; its list then begins right
/// after the outside.
///
/// One walk around each site, in the order of sites. The faces remember where each arc
/// stands in its list, so the reverse of an arc to an earlier site is known when the arc
/// is written.
template <class Hull, class IsFront>
class HullLists {
 public:
  HullLists(Hull& hull, Site num_sites, IsFront is_front)
      : hull_(hull), is_front_(is_front), num_sites_(num_sites), spokes_(64) {}

  [[nodiscard]] Adjacency::Lists build() {
    // Until a site's list is written, its offset holds one of its corners.
    lists_.offsets = hull_.take_corners();
    lists_.offsets.resize(at(num_sites_) + 1);
    lists_.is_boundary.assign(at(num_sites_), false);
    lists_.neighbors.resize(
        3 * static_cast<std::size_t>(hull_.num_faces()));  // twice the edges
    lists_.reverse.resize(lists_.neighbors.size());
    std::int32_t offset = 0;
    for (Site v = 0; v < num_sites_; ++v) {
      fetch_ahead(v);
      const std::span<const Spoke> spokes = walk_around(v);
      lists_.offsets[at(v)] = offset;
      for (const Spoke spoke : spokes) write_arc(v, spoke, offset++);
    }
    lists_.offsets.back() = offset;
    lists_.neighbors.resize(at(offset));
    lists_.reverse.resize(at(offset));
    return std::move(lists_);
  }

 private:
  struct Spoke {
    std::int32_t corner;  // 4 * face + k, the face on the left of the arc
    Site target;
  };

  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  static std::int32_t next(std::int32_t k) { return k == 2 ? 0 : k + 1; }
  static std::int32_t previous(std::int32_t k) { return k == 0 ? 2 : k - 1; }
  [[nodiscard]] const Face& face(std::int32_t f) const {
    return std::as_const(hull_).face(f);
  }

  // Faces were numbered, two a site, as sites were inserted: in the order of sites to
  // within a block of the insertion order. Walks around sites jump about in that block,
  // so it is fetched ahead.
  void fetch_ahead(Site v) const {
    const std::int32_t f = 2 * (v + insertion_block);
    if (f + 1 >= hull_.num_faces()) return;
    __builtin_prefetch(&face(f));
    __builtin_prefetch(&face(f + 1));
  }

  /// The spokes of a site in counter-clockwise order: from the smallest target, or from
  /// the first after the outside to the one after which the outside begins.
  [[nodiscard]] std::span<const Spoke> walk_around(Site v) {
    const std::int32_t start = lists_.offsets[at(v)];
    std::size_t size = 0, smallest = 0, num_outside = 0;
    std::int32_t corner = start;
    do {
      const Face& f = face(corner >> 2);
      const Site target = f.node[at(next(corner & 3))];
      if (size == spokes_.size()) spokes_.resize(2 * size);
      spokes_[size] = {corner, target};
      if (target < spokes_[smallest].target) smallest = size;
      if (!is_front_(f)) ++num_outside;
      ++size;
      corner = f.link[at(previous(corner & 3))];
    } while (corner != start);
    const std::span<Spoke> ring(spokes_.data(), size);
    if (num_outside > 0) {
      lists_.is_boundary[at(v)] = true;
      smallest = first_after_outside(ring);
      size -= num_outside - 1;
    }
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(smallest),
                ring.end());
    return ring.first(size);
  }

  [[nodiscard]] std::size_t first_after_outside(std::span<const Spoke> ring) const {
    const auto is_outside = [&](std::size_t i) {
      return !is_front_(face(ring[i].corner >> 2));
    };
    std::size_t i = 0;
    while (is_outside(i) || !is_outside(i == 0 ? ring.size() - 1 : i - 1)) ++i;
    return i;
  }

  void write_arc(Site v, Spoke spoke, std::int32_t arc) {
    const std::int32_t position = arc - lists_.offsets[at(v)];
    const auto noted =
        static_cast<std::uint8_t>(std::min(position, Adjacency::far_reverse));
    lists_.neighbors[at(arc)] = spoke.target;
    hull_.set_position(spoke.corner >> 2, spoke.corner & 3, noted);
    if (spoke.target > v) return;
    const std::int32_t beyond = face(spoke.corner >> 2).link[at(spoke.corner & 3)];
    const std::uint8_t reverse = face(beyond >> 2).position[at(beyond & 3)];
    lists_.reverse[at(arc)] = reverse;
    const std::int32_t reverse_arc = reverse < Adjacency::far_reverse
                                         ? lists_.offsets[at(spoke.target)] + reverse
                                         : find(spoke.target, v);
    lists_.reverse[at(reverse_arc)] = noted;
  }

  // A hub's corners do not know their places. Spokes ask in the order of the curve, which
  // is not the order of the hub's list, so the hub is searched through a table made once.
  [[nodiscard]] std::int32_t find(Site hub, Site v) {
    auto& places = hubs_[hub];
    if (places.empty()) {
      for (std::int32_t i = lists_.offsets[at(hub)]; i < lists_.offsets[at(hub) + 1];
           ++i) {
        places.emplace(lists_.neighbors[at(i)], i);
      }
    }
    return places.at(v);
  }

  Hull& hull_;
  IsFront is_front_;
  Site num_sites_;
  std::vector<Spoke> spokes_;
  std::unordered_map<Site, std::unordered_map<Site, std::int32_t>> hubs_;
  Adjacency::Lists lists_;
};

}  // namespace delone::delaunay
