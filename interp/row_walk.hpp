#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/axis_table.hpp"
#include "interp/cursor.hpp"
#include "interp/fresh_values.hpp"
#include "interp/globe_table.hpp"
#include "interp/grid.hpp"
#include "interp/index.hpp"

namespace delone::interp {

/// `evaluate(column, row, cursor)` for every node of a grid, row-major: for surfaces that
/// are read point by point. Rows in parallel, each chunk of rows walked from its first
/// node on.
template <class Evaluate>
[[nodiscard]] std::vector<double> walk_rows(std::int64_t num_rows,
                                            std::int64_t num_columns,
                                            const RunOptions& run, Evaluate evaluate) {
  constexpr std::int64_t chunk = 16;
  std::vector<double> out = fresh_values<double>(at(num_rows * num_columns));
  delaunay::parallel_chunks(num_rows, chunk, run,
                            [&](std::int64_t first, std::int64_t last) {
                              Cursor cursor;
                              for (std::int64_t j = first; j < last; ++j) {
                                for (std::int64_t i = 0; i < num_columns; ++i)
                                  out[at(j * num_columns + i)] = evaluate(i, j, cursor);
                              }
                            });
  return out;
}

/// `evaluate(point, cursor)` at the nodes of a plane grid. Throws Error as check(Grid).
template <class Evaluate>
[[nodiscard]] Field walk_plane_grid(const Grid& grid, const RunOptions& run,
                                    Evaluate evaluate) {
  check(grid);
  const AxisTable x(grid.x), y(grid.y);
  return {grid, walk_rows(y.size(), x.size(), run,
                          [&](std::int64_t i, std::int64_t j, Cursor& cursor) {
                            return evaluate(tripack::Point2{x[i], y[j]}, cursor);
                          })};
}

/// The same at the nodes of a longitude-latitude grid. Throws Error as check_globe.
template <class Evaluate>
[[nodiscard]] Field walk_globe_grid(const Grid& lonlat_grid, const RunOptions& run,
                                    Evaluate evaluate) {
  check_globe(lonlat_grid);
  const GlobeTable table(lonlat_grid);
  return {lonlat_grid, walk_rows(table.rows(), table.columns(), run,
                                 [&](std::int64_t i, std::int64_t j, Cursor& cursor) {
                                   return evaluate(table.node(i, j), cursor);
                                 })};
}

}  // namespace delone::interp
