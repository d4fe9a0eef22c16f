#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/cursor.hpp"
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
  std::vector<double> out(at(num_rows * num_columns));
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

}  // namespace delone::interp
