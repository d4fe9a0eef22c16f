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

/// Names for variables: valid, not those of coordinates, each once.
class VariableNames {
 public:
  [[nodiscard]] std::string next(const std::string& wanted) {
    std::string stem = valid_variable_name(wanted);
    for (const char* const taken : {"lon", "lat", "x", "y"})
      if (stem == taken) stem += "_value";
    std::string name = stem;
    for (int number = 2; std::ranges::find(taken_, name) != taken_.end(); ++number)
      name = stem + "_" + std::to_string(number);
    taken_.push_back(name);
    return name;
  }

 private:
  std::vector<std::string> taken_;
};

int add_data(NetcdfImage& image, const std::string& name, const std::string& long_name,
             const std::string& units, const std::vector<int>& dimensions) {
  const int variable = image.add_variable(name, dimensions);
  image.add_text(variable, "long_name", long_name);
  image.add_text(variable, "units", units);
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
  VariableNames names;
  const std::vector<int> dimensions{y_dimension, x_dimension};
  const GridInfo& info = grid.info;
  const int data = add_data(image, names.next(info.name),
                            info.long_name.empty() ? info.name : info.long_name,
                            info.units, dimensions);
  std::vector<int> more;
  for (const GridVariable& variable : grid.more) {
    more.push_back(add_data(image, names.next(variable.name), variable.name,
                            variable.units, dimensions));
  }
  image.end_definitions();
  image.put(y_variable, coordinates(y_axis));
  image.put(x_variable, coordinates(x_axis));
  image.put(data, with_fill_values(grid.field.values));
  for (std::size_t i = 0; i < more.size(); ++i)
    image.put(more[i], with_fill_values(grid.more[i].values));
  image.write_to(file);
  file.commit();
}

}  // namespace delone::io
