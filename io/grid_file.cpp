#include "io/grid_file.hpp"

#include <cstdint>

#include "io/grid_netcdf.hpp"
#include "io/grid_text.hpp"
#include "io/output_file.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

void check_size(const interp::Grid& grid, const std::vector<double>& values) {
  const auto& [x, y] = grid;
  if (x.size > 0 && y.size > 0 && grid.size() == std::ssize(values)) return;
  throw Error("write_grid: " + std::to_string(values.size()) + " values for " +
              std::to_string(x.size) + " x " + std::to_string(y.size) + " nodes");
}

}  // namespace

void write_grid(const std::string& path, const GridFile& grid,
                const std::string& format) {
  check_size(grid.field.grid, grid.field.values);
  for (const GridVariable& variable : grid.more)
    check_size(grid.field.grid, variable.values);
  const std::string kind = file_format(path, format);
  if (kind == "nc") return write_grid_netcdf(path, grid);
  if (kind == "csv") return write_grid_csv(path, grid);
  if (kind == "asc") {
    if (grid.more.empty()) return write_grid_esri(path, grid);
    throw WriteError(path + ": an Esri ASCII grid holds one variable, not " +
                     std::to_string(grid.more.size() + 1) + "; write .nc or .csv");
  }
  const bool is_tiff = kind == "tif" || kind == "tiff";
  const std::string what = is_tiff        ? "GeoTIFF is not built into this program"
                           : kind.empty() ? "the name has no extension"
                                          : "no grid format '" + kind + "'";
  throw WriteError(path + ": " + what + "; a grid is written as .nc, .csv or .asc");
}

GridFile read_grid(const std::string& path, const std::string& variable) {
  return read_grid_netcdf(path, variable);
}

std::string valid_variable_name(const std::string& name) {
  constexpr std::size_t longest = 128;
  std::string result;
  for (const char c : name) {
    if (is_letter(c) || is_digit(c))
      result += c;
    else if (!result.empty() && result.back() != '_')
      result += '_';
    if (result.size() == longest) break;
  }
  while (result.ends_with('_')) result.pop_back();
  if (result.empty()) return "value";
  return is_letter(result.front()) ? result : "v_" + result;
}

}  // namespace delone::io
