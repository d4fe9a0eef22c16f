#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/nearest_first.hpp"

namespace delone::delaunay {

/// The k sites nearest to a point for small k: what NearestFirst gives first, up to twice
/// as fast.
///
/// Two ways, one answer. Where every two consecutive distances differ by more than
/// rounding can hide, the order of the rounded ones is exact, and no more is looked at:
/// all neighbours of the sites found so far lie in a pool, whose least entry beyond the
/// last found is the next. Nothing there depends on the outcome of a comparison, for a
/// mispredicted jump costs more than the arithmetic. At the first doubt (ties, lattices)
/// the exact way begins: a sorted array of the best k so far, and what does not fit into
/// it is forgotten. That loses nothing: a site of rank i is joined to one of a smaller
/// rank, which is in the array when its turn comes.
///
/// Beyond QueryGeometry, `surely_nearer_than(squared)` gives a bound: a site whose
/// rounded squared distance is below it is nearer than one at `squared`.
template <QueryGeometry G>
class NearestFew {
 public:
  /// The largest k.
  static constexpr std::size_t capacity = 24;

  explicit NearestFew(const Adjacency& adjacency) : adjacency_(adjacency) {}

  /// The k nearest in order; valid until the next call. 1 <= k <= capacity, and no more
  /// than there are sites. `near`: where the walk begins.
  [[nodiscard]] std::span<const Candidate> find(const G& geometry, Site near,
                                                std::size_t k) {
    const Candidate first = descend_rounded(geometry, near);
    if (!find_rounded(geometry, first, k)) find_exactly(geometry, first.site, k);
    return std::span(best_).first(k);
  }

 private:
  // Squared distances are not negative, so that their bits are in the same order, and the
  // next beyond `bits` is the least of the differences, which wrap for what is not
  // beyond.
  struct Entry {
    std::uint64_t bits;
    Site site;
  };

  [[nodiscard]] Candidate descend_rounded(const G& geometry, Site near) const {
    Candidate best{geometry.squared(near), near};
    for (Site from = none; from != best.site;) {
      from = best.site;
      for (const Site w : adjacency_.neighbors(from)) {
        const double squared = geometry.squared(w);
        const bool is_nearer = squared < best.squared;
        best.squared = is_nearer ? squared : best.squared;
        best.site = is_nearer ? w : best.site;
      }
    }
    return best;
  }

  // False if rounding leaves the order open; then the array means nothing.
  [[nodiscard]] bool find_rounded(const G& geometry, Candidate current, std::size_t k) {
    pool_size_ = 0;
    for (std::size_t i = 0; i < k; ++i) {
      best_[i] = current;
      // One alone must be compared with its neighbours, the last of several has been.
      if ((i + 1 < k || k == 1) && !pool_neighbors(geometry, current)) return false;
      const Next next = next_beyond(current);
      if (next.is_tied || geometry.hides(current)) return false;
      if (next.site == none) return i + 1 == k;
      if (!(current.squared < geometry.surely_nearer_than(next.squared))) return false;
      current = {next.squared, next.site};
    }
    return true;
  }

  // False if some neighbour may be as far as `current`. Those that are nearer have had
  // their turn.
  [[nodiscard]] bool pool_neighbors(const G& geometry, const Candidate& current) {
    const double nearer = geometry.surely_nearer_than(current.squared);
    const auto around = adjacency_.neighbors(current.site);
    if (pool_.size() < pool_size_ + around.size())
      pool_.resize(2 * (pool_size_ + around.size()));
    Entry* end = pool_.data() + pool_size_;
    bool is_open = false;
    for (const Site w : around) {
      const double squared = geometry.squared(w);
      const bool is_farther = squared > current.squared;
      *end = {std::bit_cast<std::uint64_t>(squared), w};
      end += static_cast<std::ptrdiff_t>(is_farther);
      is_open |= !is_farther & !(squared < nearer);
    }
    pool_size_ = static_cast<std::size_t>(end - pool_.data());
    return !is_open;
  }

  struct Next {
    double squared;
    Site site;
    bool is_tied;  ///< another site has the same rounded distance as the current one
  };
  [[nodiscard]] Next next_beyond(const Candidate& current) const {
    const auto bits = std::bit_cast<std::uint64_t>(current.squared);
    std::uint64_t least = ~std::uint64_t{0} >> 1;
    Site site = none;
    bool is_tied = false;
    for (const Entry& e : std::span(pool_).first(pool_size_)) {
      const std::uint64_t excess = e.bits - bits - 1;
      const bool is_less = excess < least;
      least = is_less ? excess : least;
      site = is_less ? e.site : site;
      is_tied |= (e.bits == bits) & (e.site != current.site);
    }
    return {std::bit_cast<double>(least + bits + 1), site, is_tied};
  }

  void find_exactly(const G& geometry, Site near, std::size_t k) {
    size_ = 0;
    limit_ = k;
    add(geometry, descend_exactly(adjacency_, geometry, near).site);
    add_ties(geometry);
    bool has_hidden = false;
    for (std::size_t i = 0; i < size_; ++i) {
      if (!has_hidden && geometry.hides(best_[i])) {
        has_hidden = true;
        for (const Site s : geometry.hidden()) add(geometry, s);
      }
      if (i + 1 < limit_) add_neighbors(geometry, best_[i].site);
    }
  }

  [[nodiscard]] bool holds(Site s) const {
    return std::any_of(best_.begin(), best_.begin() + static_cast<std::ptrdiff_t>(size_),
                       [s](const Candidate& c) { return c.site == s; });
  }

  void add(const G& geometry, Site s) {
    const Candidate c{geometry.squared(s), s};
    if (size_ == limit_) {
      const Candidate& worst = best_[size_ - 1];
      if (s == worst.site || comes_after(geometry, c, worst)) return;
    }
    if (holds(s)) return;
    std::size_t i = size_ < limit_ ? size_++ : limit_ - 1;
    for (; i > 0 && comes_after(geometry, best_[i - 1], c); --i) best_[i] = best_[i - 1];
    best_[i] = c;
  }

  void add_neighbors(const G& geometry, Site s) {
    for (const Site w : adjacency_.neighbors(s)) add(geometry, w);
  }

  // Of several nearest sites the descent found any one; the others are joined to it, but
  // perhaps only through some that the array forgets.
  void add_ties(const G& geometry) {
    const Candidate first = best_[0];
    const auto is_tied = [&](Site w) {
      return geometry.compare({geometry.squared(w), w}, first) == 0;
    };
    const auto around = adjacency_.neighbors(first.site);
    if (std::none_of(around.begin(), around.end(), is_tied)) return;
    SiteSet seen;
    seen.insert(first.site);
    std::vector<Site> open{first.site};
    while (!open.empty()) {
      const Site s = open.back();
      open.pop_back();
      for (const Site w : adjacency_.neighbors(s)) {
        if (!seen.insert(w) || !is_tied(w)) continue;
        add(geometry, w);
        open.push_back(w);
      }
    }
  }

  const Adjacency& adjacency_;
  std::array<Candidate, capacity> best_;
  std::size_t size_ = 0, limit_ = 0;
  std::vector<Entry> pool_;  // the first pool_size_ are set
  std::size_t pool_size_ = 0;
};

}  // namespace delone::delaunay
