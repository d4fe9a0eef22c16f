#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "interp/index.hpp"

namespace delone::interp {

/// A box with sides along the axes, sides included.
template <std::size_t D>
struct Box {
  std::array<double, D> low, high;

  [[nodiscard]] bool holds(const std::array<double, D>& p) const noexcept {
    // Counted, not asked one by one: what nothing foretells costs a mispredicted jump.
    int num_inside = 0;
    for (std::size_t i = 0; i < D; ++i)
      num_inside += int{low[i] <= p[i]} * int{p[i] <= high[i]};
    return num_inside == static_cast<int>(D);
  }
  [[nodiscard]] double squared_distance(const std::array<double, D>& p) const noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < D; ++i) {
      const double d = std::max({low[i] - p[i], p[i] - high[i], 0.0});
      sum += d * d;
    }
    return sum;
  }
  void cover(const Box& other) noexcept {
    for (std::size_t i = 0; i < D; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
};

/// An index of boxes (discs, points) that are numbered along a space-filling curve, as
/// sites are: eight consecutive ones make a box of the level above, and so on up to one.
/// It fits itself to clusters and tracks, and answers depend on the boxes alone.
///
/// Building is O(n); a query that finds k costs O(k + log n) for boxes that overlap
/// little.
template <std::size_t D>
class BoxTree {
 public:
  using Point = std::array<double, D>;
  struct Found {
    double squared = 0;
    std::int32_t item = 0;
    friend auto operator<=>(const Found&, const Found&) = default;
  };

  BoxTree() = default;
  explicit BoxTree(std::vector<Box<D>> items) {
    if (items.empty()) return;
    levels_.push_back(std::move(items));
    while (levels_.back().size() > 1) levels_.push_back(level_above(levels_.back()));
  }

  [[nodiscard]] std::size_t size() const noexcept {
    return levels_.empty() ? 0 : levels_.front().size();
  }

  /// Calls f(item) for every box that holds p, in the order of their numbers.
  template <class F>
  void for_each_holding(const Point& p, F f) const {
    if (!levels_.empty()) descend(levels_.size() - 1, 0, p, f);
  }

  /// The k nearest boxes (fewer if there are not as many), nearest first, equally near
  /// ones by number.
  [[nodiscard]] std::vector<Found> nearest(const Point& p, std::size_t k) const {
    std::vector<Found> best;
    best.reserve(k + 1);
    if (!levels_.empty() && k > 0) search(levels_.size() - 1, 0, p, k, best);
    return best;
  }

 private:
  static constexpr std::size_t fan = 8;

  static std::vector<Box<D>> level_above(std::span<const Box<D>> below) {
    std::vector<Box<D>> above;
    above.reserve(below.size() / fan + 1);
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (i % fan == 0) {
        above.push_back(below[i]);
      } else {
        above.back().cover(below[i]);
      }
    }
    return above;
  }

  template <class F>
  void descend(std::size_t level, std::size_t i, const Point& p, F& f) const {
    if (level == 0) {
      if (levels_[0][i].holds(p)) f(static_cast<std::int32_t>(i));
      return;
    }
    const std::vector<Box<D>>& below = levels_[level - 1];
    const std::size_t end = std::min((i + 1) * fan, below.size());
    for (std::size_t k = i * fan; k < end; ++k) {
      if (below[k].holds(p)) {
        if (level == 1) {
          f(static_cast<std::int32_t>(k));
        } else {
          descend(level - 1, k, p, f);
        }
      }
    }
  }

  void search(std::size_t level, std::size_t i, const Point& p, std::size_t k,
              std::vector<Found>& best) const {
    if (level == 0) return add({levels_[0][i].squared_distance(p), number(i)}, k, best);
    const std::vector<Box<D>>& below = levels_[level - 1];
    const std::size_t begin = i * fan, count = std::min(fan, below.size() - begin);
    std::array<Found, fan> order;
    for (std::size_t j = 0; j < count; ++j)
      order[j] = {below[begin + j].squared_distance(p), number(begin + j)};
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t j = 0; j < count; ++j) {
      if (best.size() == k && order[j].squared > best.back().squared) return;
      if (level == 1) {
        add(order[j], k, best);
      } else {
        search(level - 1, at(order[j].item), p, k, best);
      }
    }
  }

  static std::int32_t number(std::size_t i) { return static_cast<std::int32_t>(i); }

  static void add(const Found& found, std::size_t k, std::vector<Found>& best) {
    if (best.size() == k && !(found < best.back())) return;
    best.insert(std::upper_bound(best.begin(), best.end(), found), found);
    if (best.size() > k) best.pop_back();
  }

  std::vector<std::vector<Box<D>>> levels_;  // the items, then each level above
};

}  // namespace delone::interp
