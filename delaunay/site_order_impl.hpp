#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "delaunay/parallel.hpp"
#include "delaunay/site_order.hpp"

namespace delone::delaunay {

/// Rows to be left out of a part of the order, and the site (counted within the part)
/// that stands for them.
struct Repeat {
  Node row;
  Site site;
};

/// A part of the order, settled on its own: its sites stand at the front of its items.
struct SettledPart {
  std::span<KeyedRow> items;
  Site num_sites = 0;
  std::vector<Repeat> repeats;
  std::vector<CellKeys> cells;  // counted within the part
};

template <ChartedPoints Points>
class PartSettler {
 public:
  PartSettler(const Points& points, std::span<KeyedRow> items)
      : points_(points), part_{items, 0, {}, {}} {}

  SettledPart settle() {
    settle_runs(part_.items);
    return std::move(part_);
  }

 private:
  static constexpr std::size_t few = 24;

  static Node row_of(KeyedRow item) { return static_cast<Node>(item & 0xffffffffu); }

  void settle_runs(std::span<KeyedRow> items) {
    for (std::size_t begin = 0; begin < items.size();) {
      std::size_t end = begin + 1;
      while (end < items.size() && items[end] >> 32 == items[begin] >> 32) ++end;
      if (end - begin == 1) {
        add_site(items[begin]);
      } else {
        settle_run(items.subspan(begin, end - begin));
      }
      begin = end;
    }
  }

  void settle_run(std::span<KeyedRow> run) {
    if (run.size() <= few) return settle_by_chart(run);
    Buffer<KeyedRow> inner(run.begin(), run.end());
    if (!rekey(inner)) return settle_by_chart(run);
    // Keys are relative to this run's box now. Each level looks at 16 more bits of the
    // coordinates, so the recursion ends after at most 2100 / 16 levels.
    const KeyedRow key = run[0] >> 32 << 32;
    const Site begin = part_.num_sites;
    sort_by_key(inner);
    settle_runs(inner);
    keep_cell(begin, key);
  }

  // The sites from `begin` on have inner keys: these become a cell.
  void keep_cell(Site begin, KeyedRow key) {
    CellKeys cell{begin, part_.num_sites, {}};
    for (Site s = begin; s < part_.num_sites; ++s) {
      KeyedRow& item = part_.items[static_cast<std::size_t>(s)];
      cell.keys.push_back(static_cast<std::uint32_t>(item >> 32));
      item = key | (item & 0xffffffffu);
    }
    part_.cells.push_back(std::move(cell));
  }

  /// False if all points of the run agree in both chart coordinates.
  bool rekey(std::span<KeyedRow> run) const {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Chart low{inf, inf}, high{-inf, -inf};
    for (const KeyedRow item : run) {
      const Chart p = points_.chart(row_of(item));
      low = {std::min(low[0], p[0]), std::min(low[1], p[1])};
      high = {std::max(high[0], p[0]), std::max(high[1], p[1])};
    }
    if (low == high) return false;
    const double half =
        std::max(half_extent(low[0], high[0]), half_extent(low[1], high[1]));
    const CellScale u(low[0], half, 65536), v(low[1], half, 65536);
    for (KeyedRow& item : run) {
      const Chart p = points_.chart(row_of(item));
      const std::uint32_t key = hilbert_key(u.cell(p[0]), v.cell(p[1]));
      item = KeyedRow{key} << 32 | (item & 0xffffffffu);
    }
    return true;
  }

  void settle_by_chart(std::span<KeyedRow> run) {
    std::sort(run.begin(), run.end(), [this](KeyedRow a, KeyedRow b) {
      const Node p = row_of(a), q = row_of(b);
      if (points_.less(p, q)) return true;
      return !points_.less(q, p) && p < q;
    });
    // Sites are written over items that have been read.
    for (std::size_t i = 0; i < run.size(); ++i) {
      const KeyedRow item = run[i];
      if (i > 0 && !points_.less(last_row(), row_of(item))) {
        part_.repeats.push_back({row_of(item), part_.num_sites - 1});
      } else {
        add_site(item);
      }
    }
  }

  [[nodiscard]] Node last_row() const {
    return row_of(part_.items[static_cast<std::size_t>(part_.num_sites) - 1]);
  }
  void add_site(KeyedRow item) {
    part_.items[static_cast<std::size_t>(part_.num_sites++)] = item;
  }

  const Points& points_;
  SettledPart part_;
};

/// Writes settled parts one after the other.
class OrderWriter {
 public:
  OrderWriter(std::span<const SettledPart> parts, std::size_t num_rows);
  /// Part k of the parts; different parts may be written at the same time.
  void write(std::size_t k);
  [[nodiscard]] SiteOrder finish() &&;

 private:
  std::span<const SettledPart> parts_;
  std::vector<Site> begins_;
  SiteOrder order_;
};

/// Cuts items into about `num_parts` spans; rows of one key stay together.
[[nodiscard]] std::vector<std::span<KeyedRow>> cut_between_keys(std::span<KeyedRow> items,
                                                                std::size_t num_parts);

template <ChartedPoints Points>
SiteOrder order_sites(Buffer<KeyedRow> items, const Points& points,
                      const RunOptions& run) {
  constexpr std::size_t grain = 1u << 15;
  const auto spans = cut_between_keys(items, items.size() / grain + 1);
  std::vector<SettledPart> parts(spans.size());
  const RunOptions quietly{.num_threads = run.num_threads, .progress = {}};
  const auto for_each_part = [&](auto body) {
    parallel_chunks(
        static_cast<std::int64_t>(spans.size()), 1, quietly,
        [&](std::int64_t k, std::int64_t) { body(static_cast<std::size_t>(k)); });
  };
  for_each_part(
      [&](std::size_t k) { parts[k] = PartSettler<Points>(points, spans[k]).settle(); });
  OrderWriter writer(parts, items.size());
  for_each_part([&](std::size_t k) { writer.write(k); });
  return std::move(writer).finish();
}

}  // namespace delone::delaunay
