#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "io/grid_netcdf.hpp"
#include "io/netcdf_image.hpp"
#include "io/output_file.hpp"

namespace delone::io {
namespace {

/// What CF says of a coordinate.
struct Coordinate {
  const char* name;
  std::string_view standard_name, long_name, units, axis;
};

Coordinate x_coordinate(const GridInfo& info) {
  if (info.is_lonlat) return {"lon", "longitude", "longitude", "degrees_east", "X"};
  return {"x", "", info.x_name.empty() ? "x" : std::string_view(info.x_name),
          info.x_units, "X"};
}

Coordinate y_coordinate(const GridInfo& info) {
  if (info.is_lonlat) return {"lat", "latitude", "latitude", "degrees_north", "Y"};
  return {"y", "", info.y_name.empty() ? "y" : std::string_view(info.y_name),
          info.y_units, "Y"};
}

int add_coordinate(NetcdfImage& image, const Coordinate& coordinate, int dimension) {
  const int variable = image.add_variable(coordinate.name, {dimension});
  image.add_text(variable, "standard_name", coordinate.standard_name);
  image.add_text(variable, "long_name", coordinate.long_name);
  image.add_text(variable, "units", coordinate.units);
  image.add_text(variable, "axis", coordinate.axis);
  return variable;
}

int add_data(NetcdfImage& image, const GridInfo& info,
             const std::vector<int>& dimensions) {
  std::string name = valid_variable_name(info.name);
  for (const char* const taken : {"lon", "lat", "x", "y"})
    if (name == taken) name += "_value";
  const int variable = image.add_variable(name, dimensions);
  image.add_text(variable, "long_name",
                 info.long_name.empty() ? info.name : info.long_name);
  image.add_text(variable, "units", info.units);
  image.add_fill_value(variable, NC_FILL_DOUBLE);
  return variable;
}

std::vector<double> coordinates(const interp::Axis& axis) {
  std::vector<double> result;
  for (std::int64_t i = 0; i < axis.size; ++i) result.push_back(axis.coordinate(i));
  return result;
}

std::vector<double> with_fill_values(std::vector<double> values) {
  std::ranges::replace_if(
      values, [](double v) { return !std::isfinite(v); }, NC_FILL_DOUBLE);
  return values;
}

}  // namespace

void write_grid_netcdf(const std::string& path, const GridFile& grid) {
  OutputFile file(path);
  NetcdfImage image(path);
  const auto& [x_axis, y_axis] = grid.field.grid;
  const Coordinate x = x_coordinate(grid.info), y = y_coordinate(grid.info);
  const int y_dimension = image.add_dimension(y.name, y_axis.size);
  const int x_dimension = image.add_dimension(x.name, x_axis.size);
  image.add_text(NC_GLOBAL, "Conventions", "CF-1.8");
  image.add_text(NC_GLOBAL, "title", grid.info.title);
  const int y_variable = add_coordinate(image, y, y_dimension);
  const int x_variable = add_coordinate(image, x, x_dimension);
  const int data = add_data(image, grid.info, {y_dimension, x_dimension});
  image.end_definitions();
  image.put(y_variable, coordinates(y_axis));
  image.put(x_variable, coordinates(x_axis));
  image.put(data, with_fill_values(grid.field.values));
  image.write_to(file);
  file.commit();
}

}  // namespace delone::io
