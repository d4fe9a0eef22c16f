#include "io/grid_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "io/table.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

using interp::Field;

double value_at(const Field& field, std::int64_t i, std::int64_t j) {
  return field.values[static_cast<std::size_t>(j * field.grid.x.size + i)];
}

/// A cell size for both directions. An axis of one node has any.
double square_spacing(const std::string& path, const interp::Grid& grid) {
  const double dx = grid.x.spacing, dy = grid.y.spacing;
  if (grid.x.size == 1) return dy;
  // Spacings that were computed from coordinates may differ in their last digits.
  if (grid.y.size == 1 || std::abs(dx - dy) <= 1e-9 * dx) return dx;
  throw WriteError(path +
                   ": an Esri ASCII grid needs the same spacing both ways, these are " +
                   std::to_string(dx) + " and " + std::to_string(dy) +
                   "; choose one spacing or write .nc");
}

/// -9999, or with more nines if the field holds that as a value.
std::int64_t no_data_value(const Field& field) {
  std::int64_t result = -9999;
  while (std::ranges::find(field.values, static_cast<double>(result)) !=
         field.values.end())
    result = 10 * result - 9;
  return result;
}

}  // namespace

void write_grid_csv(const std::string& path, const GridFile& grid) {
  const auto& [x, y] = grid.field.grid;
  TextWriter text(path);
  text << (grid.info.is_lonlat ? "lon,lat," : "x,y,") << csv_field(grid.info.name);
  for (const GridVariable& variable : grid.more) text << ',' << csv_field(variable.name);
  text << '\n';
  for (std::int64_t j = 0; j < y.size; ++j)
    for (std::int64_t i = 0; i < x.size; ++i) {
      text << x.coordinate(i) << ',' << y.coordinate(j) << ','
           << value_at(grid.field, i, j);
      for (const GridVariable& variable : grid.more)
        text << ',' << variable.values[static_cast<std::size_t>(j * x.size + i)];
      text << '\n';
    }
  text.commit();
}

void write_grid_esri(const std::string& path, const GridFile& grid) {
  const auto& [x, y] = grid.field.grid;
  const double spacing = square_spacing(path, grid.field.grid);
  const std::int64_t no_data = no_data_value(grid.field);
  TextWriter text(path);
  text << "ncols " << x.size << "\nnrows " << y.size << "\nxllcenter " << x.coordinate(0)
       << "\nyllcenter " << y.coordinate(0) << "\ncellsize " << spacing
       << "\nNODATA_value " << no_data << '\n';
  for (std::int64_t j = y.size - 1; j >= 0; --j)
    for (std::int64_t i = 0; i < x.size; ++i) {
      const double value = value_at(grid.field, i, j);
      if (std::isfinite(value))
        text << value;
      else
        text << no_data;
      text << (i + 1 < x.size ? ' ' : '\n');
    }
  text.commit();
}

}  // namespace delone::io
