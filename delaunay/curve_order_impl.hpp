#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "delaunay/curve_order.hpp"

namespace delone::delaunay {

/// Half the length of an interval, or all of it where halves underflow. Never overflows.
[[nodiscard]] inline double half_extent(double low, double high) noexcept {
  const double half = high / 2 - low / 2;
  return half >= 0x1p-1000 ? half : high - low;
}

/// Spreads an interval of length 2 `half` from `low` on over integer cells 0 .. num_cells
/// - 1, its ends in different cells. A square takes the same `half` for both coordinates:
/// cells must be square, or neighbours on the curve are no neighbours in space.
///
/// Coordinates are first scaled by a power of two, so that neither the difference of the
/// ends overflows (+-1e308) nor its inverse (denormal extents).
class CellScale {
 public:
  CellScale(double low, double half, double num_cells) : last_(num_cells - 1) {
    if (!(half > 0)) return;
    power_ = std::ldexp(1.0, std::clamp(-std::ilogb(half), -1000, 1000));
    low_ = low * power_;
    scale_ = num_cells / (2 * (half * power_));  // 2 half may overflow
  }
  [[nodiscard]] std::uint32_t cell(double v) const noexcept {
    const double t = (v * power_ - low_) * scale_;
    return static_cast<std::uint32_t>(std::min(std::max(t, 0.0), last_));
  }

 private:
  double power_ = 0, low_ = 0, scale_ = 0, last_;
};

template <class ChartOf, class Compare>
class SiteOrderBuilder {
 public:
  SiteOrderBuilder(ChartOf chart, Compare compare) : chart_(chart), compare_(compare) {}

  SiteOrder build(Buffer<KeyedRow>& items) {
    order_.rows.reserve(items.size());
    order_.sites.resize(items.size());
    settle(items);
    return std::move(order_);
  }

 private:
  static constexpr std::size_t few = 24;

  static Node row_of(KeyedRow item) { return static_cast<Node>(item & 0xffffffffu); }

  void settle(std::span<KeyedRow> items) {
    for (std::size_t begin = 0; begin < items.size();) {
      std::size_t end = begin + 1;
      while (end < items.size() && items[end] >> 32 == items[begin] >> 32) ++end;
      settle_run(items.subspan(begin, end - begin));
      begin = end;
    }
  }

  void settle_run(std::span<KeyedRow> run) {
    if (run.size() == 1) return add_site(row_of(run[0]));
    if (run.size() <= few || !rekey(run)) return settle_by_chart(run);
    // Keys are relative to this run's box now. Each level looks at 16 more bits of the
    // coordinates, so the recursion ends after at most 2100 / 16 levels.
    Buffer<KeyedRow> sorted(run.begin(), run.end());
    sort_by_key(sorted);
    settle(sorted);
  }

  /// False if all points of the run agree in both chart coordinates.
  bool rekey(std::span<KeyedRow> run) const {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Chart low{inf, inf}, high{-inf, -inf};
    for (const KeyedRow item : run) {
      const Chart p = chart_(row_of(item));
      low = {std::min(low[0], p[0]), std::min(low[1], p[1])};
      high = {std::max(high[0], p[0]), std::max(high[1], p[1])};
    }
    if (low == high) return false;
    const double half =
        std::max(half_extent(low[0], high[0]), half_extent(low[1], high[1]));
    const CellScale u(low[0], half, 65536), v(low[1], half, 65536);
    for (KeyedRow& item : run) {
      const Chart p = chart_(row_of(item));
      const std::uint32_t key = hilbert_key(u.cell(p[0]), v.cell(p[1]));
      item = KeyedRow{key} << 32 | (item & 0xffffffffu);
    }
    return true;
  }

  void settle_by_chart(std::span<KeyedRow> run) {
    std::sort(run.begin(), run.end(), [this](KeyedRow a, KeyedRow b) {
      const Chart p = chart_(row_of(a)), q = chart_(row_of(b));
      if (p != q) return p < q;
      const bool before = compare_.less(row_of(a), row_of(b)),
                 after = compare_.less(row_of(b), row_of(a));
      return before != after ? before : row_of(a) < row_of(b);
    });
    std::size_t first_site =
        order_.rows.size();  // first site with the chart coordinates at hand
    for (std::size_t i = 0; i < run.size(); ++i) {
      const Node row = row_of(run[i]);
      if (i > 0 && chart_(row) != chart_(row_of(run[i - 1])))
        first_site = order_.rows.size();
      add_site_unless_repeated(row, first_site);
    }
  }

  void add_site_unless_repeated(Node row, std::size_t first_site) {
    const auto begin = order_.rows.begin() + static_cast<std::ptrdiff_t>(first_site);
    const auto same = std::find_if(begin, order_.rows.end(),
                                   [&](Node r) { return compare_.is_same(r, row); });
    if (same == order_.rows.end()) return add_site(row);
    order_.sites[static_cast<std::size_t>(row)] =
        static_cast<Site>(same - order_.rows.begin());
    *same = std::min(*same, row);
  }

  void add_site(Node row) {
    order_.sites[static_cast<std::size_t>(row)] = static_cast<Site>(order_.rows.size());
    order_.rows.push_back(row);
  }

  ChartOf chart_;
  Compare compare_;
  SiteOrder order_;
};

template <class ChartOf, class Compare>
SiteOrder site_order(Buffer<KeyedRow>& items, ChartOf chart, Compare compare) {
  return SiteOrderBuilder<ChartOf, Compare>(chart, compare).build(items);
}

}  // namespace delone::delaunay
