#pragma once

#include <string>

#include "io/grid_file.hpp"

namespace delone::io {

/// See write_grid, `nc`.
void write_grid_netcdf(const std::string& path, const GridFile& grid);

/// See read_grid.
[[nodiscard]] GridFile read_grid_netcdf(const std::string& path,
                                        const std::string& variable);

}  // namespace delone::io
