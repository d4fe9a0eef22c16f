#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/curve_order.hpp"
#include "delaunay/options.hpp"

namespace delone::delaunay {

/// Keys of the sites begin .. end - 1 within one cell of the curve: many sites shared its
/// key, so the cell has a curve of its own, inside the bounding box of its points.
struct CellKeys {
  Site begin, end;
  Buffer<std::uint32_t> keys;
};

/// The different positions of a point set in the order of a space-filling curve.
///
/// Sites whose keys agree in their leading bits fill a cell of the curve, a rectangle on
/// the chart; the next bit halves it by a line along one of the axes. Sites of equal keys
/// that have no curve of their own are ordered along the chart's first coordinate, then
/// the second, exactly. Either way a range of sites can be cut so that a straight line
/// (turned a little, where points lie on it) separates the parts: see `middle_of`.
struct SiteOrder {
  Buffer<Node> rows;           ///< site -> first row with that position
  Buffer<Site> sites;          ///< row -> site
  Buffer<std::uint32_t> keys;  ///< site -> key
  std::vector<CellKeys> cells;
};

/// Keys of a range of sites as the cut of blocks wants them: `keys[site]`, from the
/// innermost curve that orders the range.
class BlockKeys {
 public:
  explicit BlockKeys(const SiteOrder& order) noexcept
      : order_(&order), keys_(order.keys.data()) {}

  /// For a range whose first and last key agree: its own curve, if it has one.
  [[nodiscard]] BlockKeys inside(Site begin, Site end) const noexcept;
  [[nodiscard, gnu::always_inline]] std::uint32_t operator[](Site s) const noexcept {
    return keys_[s];
  }
  [[nodiscard]] bool has_cells() const noexcept { return !order_->cells.empty(); }

 private:
  const SiteOrder* order_;
  const std::uint32_t* keys_;  // of site 0, which may be far outside of the cell
};

/// Where to cut the sites begin .. end - 1 (at least two): the first site of the second
/// part. At the highest bit in which keys differ, or in the middle.
[[nodiscard, gnu::always_inline]] inline Site middle_of(BlockKeys keys, Site begin,
                                                        Site end) noexcept {
  const std::uint32_t low = keys[begin], high = keys[end - 1];
  if (low == high) return begin + (end - begin) / 2;
  const int bit = 31 - __builtin_clz(low ^ high);
  const std::uint32_t pivot = high >> bit << bit;
  // No branch depends on keys: nothing would foretell it.
  if (end - begin <= 8) {
    Site num_below = 0;
    for (Site i = 0; i < 8; ++i) {
      const Site s = begin + i < end ? begin + i : end - 1;
      num_below += static_cast<Site>(keys[s] < pivot);
    }
    return begin + num_below;
  }
  // The first key that is not below the pivot is among `left` from b on.
  Site b = begin + 1, left = end - begin - 1;
  while (left > 1) {
    const Site half = left / 2;
    b += keys[b + half - 1] < pivot ? half : 0;
    left -= half;
  }
  return b;
}

/// Two coordinates on a chart of the surface.
using Chart = std::array<double, 2>;

/// What the order needs to know: `chart(row)`, coordinates rounded monotonically, and
/// `less(row, row)`, the exact order by the first, then the second. Rows of which neither
/// is less share a position.
template <class P>
concept ChartedPoints = requires(const P& p, Node row) {
  { p.chart(row) } -> std::same_as<Chart>;
  { p.less(row, row) } -> std::same_as<bool>;
};

/// Puts rows, sorted by key, into their final order and merges repeats. Depends on the
/// set of positions only.
template <ChartedPoints Points>
[[nodiscard]] SiteOrder order_sites(Buffer<KeyedRow> items, const Points& points,
                                    const RunOptions& run);

}  // namespace delone::delaunay

#include "delaunay/site_order_impl.hpp"
