#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "delaunay/adjacency.hpp"

namespace delone::delaunay {

/// Which rows stand for which after near repeats are merged.
struct MergedRows {
  std::vector<Node> stands_for;  ///< for every row the row that stands for it
  Node num_kept = 0;             ///< positions that stand for themselves
};

/// Throws Error unless the distance is finite and not negative.
void check_merge_distance(double distance);

/// What the merging needs to know about rows:
///   cell(row)             coordinates divided by the cell size, rounded down; rows
///   within
///                         the distance of one another are at most reach(row) cells apart
///   is_within(p, q)       are two rows at most the distance apart?
///   is_nearer(p, a, b)    is a nearer to p than b, ties by coordinates?
template <class G>
concept MergeGeometry = requires(const G& g, Node row) {
  {g.cell(row)};
  { g.reach(row) } -> std::same_as<int>;
  { g.is_within(row, row) } -> std::same_as<bool>;
  { g.is_nearer(row, row, row) } -> std::same_as<bool>;
};

/// Merges positions greedily: in the given order one is kept if none kept before is
/// within the distance, and every other one then goes to the nearest one kept.
///
/// `order`: one row for each different position, in an order that depends on positions
/// only; so does the result then. The number kept within reach of a point is bounded,
/// hence O(n).
template <MergeGeometry G>
class NearMerger {
 public:
  explicit NearMerger(const G& geometry) : geometry_(geometry) {}

  /// For every entry of `order` the row that stands for it.
  [[nodiscard]] std::vector<Node> merge(std::span<const Node> order) {
    std::vector<Node> result(order.begin(), order.end());
    std::vector<bool> is_kept(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      is_kept[i] = nearest_kept(order[i]) == none;
      if (is_kept[i]) kept_[key(geometry_.cell(order[i]))].push_back(order[i]);
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (!is_kept[i]) result[i] = nearest_kept(order[i]);
    }
    return result;
  }

 private:
  // Cells are told apart by a hash of their corner; two with one hash share a list, which
  // costs a comparison and changes nothing.
  template <std::size_t Size>
  static std::uint64_t key(const std::array<double, Size>& cell) {
    std::uint64_t hash = 0;
    for (const double c : cell) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(c + 0.0)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }

  [[nodiscard]] Node nearest_kept(Node row) const {
    Node best = none;
    auto cell = geometry_.cell(row);
    visit(row, cell, 0, best);
    return best;
  }

  // Every cell around, one coordinate after the other; as deep as there are coordinates.
  template <std::size_t Size>
  void visit(Node row, std::array<double, Size>& cell, std::size_t k, Node& best) const {
    if (k == Size) return look_into(row, key(cell), best);
    const double middle = cell[k];
    const int reach = geometry_.reach(row);
    for (int step = -reach; step <= reach; ++step) {
      cell[k] = middle + step;
      visit(row, cell, k + 1, best);
    }
    cell[k] = middle;
  }

  void look_into(Node row, std::uint64_t cell_key, Node& best) const {
    const auto cell = kept_.find(cell_key);
    if (cell == kept_.end()) return;
    for (const Node other : cell->second) {
      if (other != best && geometry_.is_within(row, other) &&
          (best == none || geometry_.is_nearer(row, other, best)))
        best = other;
    }
  }

  const G& geometry_;
  std::unordered_map<std::uint64_t, std::vector<Node>> kept_;
};

/// How many cells apart rows within a distance can be whose coordinates are `cell` cells
/// of slightly more than that distance: quotients are rounded, by half a cell at most.
template <std::size_t Size>
[[nodiscard]] int cell_reach(const std::array<double, Size>& cell) {
  for (const double c : cell) {
    if (!(std::abs(c) < 0x1p32)) return 2;
  }
  return 1;
}

/// The result for all rows, from that for one row of each position. `sites[row]`: the
/// entry of `order` that row belongs to.
[[nodiscard]] MergedRows spread_to_rows(std::span<const Node> stands_for,
                                        std::span<const Site> sites);

}  // namespace delone::delaunay
