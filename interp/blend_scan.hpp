#pragma once

#include <vector>

#include "interp/blend_cells.hpp"
#include "interp/grid.hpp"

namespace delone::interp {

/// A blended surface on a grid; on the sphere x is longitude and y latitude, degrees.
/// Errors as the piecewise linear one.
template <int Degree>
[[nodiscard]] std::vector<double> scan(const BlendCells<PlaneSpace, Degree>& cells,
                                       const Grid& grid, const RunOptions& run);
template <int Degree>
[[nodiscard]] std::vector<double> scan(const BlendCells<SphereSpace, Degree>& cells,
                                       const Grid& grid, const RunOptions& run);

}  // namespace delone::interp
