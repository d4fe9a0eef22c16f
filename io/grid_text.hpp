#pragma once

#include <string>

#include "io/grid_file.hpp"

namespace delone::io {

/// See write_grid, `csv`.
void write_grid_csv(const std::string& path, const GridFile& grid);

/// See write_grid, `asc`.
void write_grid_esri(const std::string& path, const GridFile& grid);

}  // namespace delone::io
