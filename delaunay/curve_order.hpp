#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/parallel.hpp"

namespace delone::delaunay {

/// Position of the cell (x, y) of a 2^16 x 2^16 square along Hilbert's curve, 0 .. 2^32
/// - 1. Source: D. Hilbert, Math. Ann. 38 (1891) 459-460; here a state machine over 4-bit
/// digits.
[[nodiscard]] std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) noexcept;

/// An item to sort: key in the high half, row in the low half.
using KeyedRow = std::uint64_t;

/// Sorts by key, rows of equal keys staying in order. Radix sort, O(n), in parallel.
void sort_by_key(Buffer<KeyedRow>& items,
                 const RunOptions& run = {.num_threads = 1, .progress = {}});

/// Rows 0 .. num_rows - 1 sorted by `key(row)`.
template <class Key>
[[nodiscard]] Buffer<KeyedRow> sorted_by_key(std::size_t num_rows, Key key,
                                             const RunOptions& run) {
  Buffer<KeyedRow> items(num_rows);
  const RunOptions quietly{.num_threads = run.num_threads, .progress = {}};
  parallel_chunks(static_cast<std::int64_t>(num_rows), 1 << 16, quietly,
                  [&](std::int64_t begin, std::int64_t end) {
                    for (auto i = static_cast<std::size_t>(begin);
                         i < static_cast<std::size_t>(end); ++i)
                      items[i] = KeyedRow{key(i)} << 32 | i;
                  });
  sort_by_key(items, quietly);
  return items;
}

/// Calls `use(i, where(rows[i]))` for every i, in parallel, and fetches `where` some
/// steps ahead: rows are in the order of the curve, what they stand for is not.
template <class Where, class Use>
void for_each_ahead(const Buffer<Node>& rows, Where where, Use use,
                    const RunOptions& run) {
  constexpr std::size_t ahead = 24;
  const RunOptions quietly{.num_threads = run.num_threads, .progress = {}};
  parallel_chunks(static_cast<std::int64_t>(rows.size()), 1 << 16, quietly,
                  [&](std::int64_t begin, std::int64_t end) {
                    const auto last = static_cast<std::size_t>(end);
                    for (auto i = static_cast<std::size_t>(begin); i < last; ++i) {
                      if (i + ahead < last) __builtin_prefetch(where(rows[i + ahead]));
                      use(i, where(rows[i]));
                    }
                  });
}

/// Throws Error if there are more points than 32-bit arcs and faces can number (2^28).
void check_num_points(std::size_t num_points);

/// Renumbers sites: the new site i is the old site order[i].
template <class Point>
void renumber_sites(Buffer<Node>& rows, Buffer<Site>& sites, Buffer<Point>& points,
                    std::span<const Site> order) {
  const auto at = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  Buffer<Site> rank(order.size());
  Buffer<Node> new_rows;
  Buffer<Point> new_points;
  for (const Site old : order) {
    rank[at(old)] = static_cast<Site>(new_rows.size());
    new_rows.push_back(rows[at(old)]);
    new_points.push_back(points[at(old)]);
  }
  for (Site& s : sites) s = rank[at(s)];
  rows = std::move(new_rows);
  points = std::move(new_points);
}

/// Sites that are inserted together, and whose faces therefore lie together in memory.
inline constexpr Site insertion_block = 4096;

/// The order in which sites numbered along a curve are inserted: first every 8^k-th of
/// the whole curve, k falling, then blocks of 4096 neighbours with strides 512, 64, 8, 1.
/// Each new site then falls among settled ones (few flips), near the last one (short
/// walk, warm cache), and no order of the input makes it slow. Calls `f(site)` once a
/// site.
template <class F>
void for_each_in_insertion_order(Site num_sites, F f) {
  constexpr std::int64_t block = insertion_block, ratio = 8;
  const std::int64_t n = num_sites;
  std::int64_t stride = block;
  while (stride * ratio < n) stride *= ratio;
  const std::int64_t coarsest = stride;
  const auto level = [&](std::int64_t begin, std::int64_t end, std::int64_t step,
                         bool all) {
    for (std::int64_t i = begin, k = 0; i < end; i += step, ++k) {
      if (all || k % ratio != 0) f(static_cast<Site>(i));
    }
  };
  for (; stride >= block; stride /= ratio) level(0, n, stride, stride == coarsest);
  for (std::int64_t begin = 0; begin < n; begin += block) {
    const std::int64_t end = begin + block < n ? begin + block : n;
    for (std::int64_t step = block / ratio; step >= 1; step /= ratio)
      level(begin, end, step, false);
  }
}

}  // namespace delone::delaunay

#include "delaunay/curve_order_impl.hpp"
