#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "delaunay/curve_order.hpp"
#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"

namespace delone::delaunay {

/// Two coordinates of a query on a chart of the surface.
using QueryChart = std::array<double, 2>;

/// Most points that one call answers: what 32 bits number.
inline constexpr std::size_t max_queries = std::size_t{1} << 31;

/// Throws Error if there are more than max_queries.
void check_num_queries(std::size_t num_queries);

/// Indices of points (at most 2^31) with keys along a space-filling curve, sorted, so
/// that a walk from one to the next is a step or two. `chart(i)`: two coordinates of
/// point i; `low`, `high`: their bounding box. O(n).
template <class ChartOf>
[[nodiscard]] Buffer<KeyedRow> order_along_curve(std::size_t num_points, QueryChart low,
                                                 QueryChart high, ChartOf chart) {
  constexpr double cells = 65536;
  const double half =
      std::max(half_extent(low[0], high[0]), half_extent(low[1], high[1]));
  const CellScale u(low[0], half, cells), v(low[1], half, cells);
  Buffer<KeyedRow> items(num_points);
  for (std::size_t i = 0; i < num_points; ++i) {
    const QueryChart p = chart(i);
    items[i] = KeyedRow{hilbert_key(u.cell(p[0]), v.cell(p[1]))} << 32 | i;
  }
  sort_by_key(items);
  return items;
}

/// The index of a sorted item.
[[nodiscard]] inline std::size_t index_of(KeyedRow item) noexcept {
  return static_cast<std::size_t>(item & 0xffffffffu);
}

/// Queries answered together by one thread.
inline constexpr std::int64_t query_chunk = 4096;

/// Where a walk for the query at `fraction` (0..1) of its curve may begin: the site at
/// that part of the sites' own curve. There must be a site.
[[nodiscard]] inline Site site_along_curve(Site num_sites, double fraction) noexcept {
  return static_cast<Site>(fraction * static_cast<double>(num_sites - 1));
}

/// The bounding box of chart coordinates; of no points the box of one at the origin.
template <class ChartOf>
[[nodiscard]] std::pair<QueryChart, QueryChart> bounding_box(std::size_t num_points,
                                                             ChartOf chart) {
  if (num_points == 0) return {};
  constexpr double inf = std::numeric_limits<double>::infinity();
  QueryChart low{inf, inf}, high{-inf, -inf};
  for (std::size_t i = 0; i < num_points; ++i) {
    const QueryChart p = chart(i);
    low = {std::min(low[0], p[0]), std::min(low[1], p[1])};
    high = {std::max(high[0], p[0]), std::max(high[1], p[1])};
  }
  return {low, high};
}

}  // namespace delone::delaunay
