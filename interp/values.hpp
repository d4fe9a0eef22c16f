#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"

namespace delone::interp {

/// What becomes of the values of rows that share a position.
enum class Duplicates : std::uint8_t { mean, first, last, median, min, max, error };

/// Values beyond this magnitude are refused: differences and products with coordinates
/// must not overflow.
inline constexpr double value_max = 0x1p500;

/// One value a site from one value a row. `sites[row]` is the row's site
/// (Triangulation::sites()).
///
/// Independent of the order of rows except for `first` and `last` (a mean is summed in
/// sorted order). The mean of equal values is that value; no mean or median leaves the
/// range of its values. Throws Error if the sizes differ, if a value is NaN, infinite or
/// beyond value_max (naming the row), and for Duplicates::error on the first row that
/// repeats an earlier row's position with a different value (naming both rows). O(n).
[[nodiscard]] std::vector<double> values_at_sites(std::span<const delaunay::Site> sites,
                                                  delaunay::Site num_sites,
                                                  std::span<const double> row_values,
                                                  Duplicates policy = Duplicates::mean);

/// The rows of every site: those of site s are rows[offsets[s]] .. rows[offsets[s + 1] -
/// 1], ascending.
struct RowsOfSites {
  std::vector<std::int32_t> offsets;
  std::vector<delaunay::Node> rows;
  [[nodiscard]] std::span<const delaunay::Node> of(delaunay::Site s) const noexcept {
    const auto i = static_cast<std::size_t>(s);
    return std::span(rows).subspan(static_cast<std::size_t>(offsets[i]),
                                   static_cast<std::size_t>(offsets[i + 1] - offsets[i]));
  }
};
[[nodiscard]] RowsOfSites rows_of_sites(std::span<const delaunay::Site> sites,
                                        delaunay::Site num_sites);

}  // namespace delone::interp
