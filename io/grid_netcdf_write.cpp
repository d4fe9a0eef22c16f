#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/grid_netcdf.hpp"
#include "io/output_file.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

/// A NetCDF file (classic format, 64-bit offsets) that the library builds in memory: so
/// it reaches devices and pipes too, and OutputFile sees every failure of the disk.
class NetcdfImage {
 public:
  explicit NetcdfImage(std::string path) : path_(std::move(path)) {
    check(nc_create_mem("delone", NC_64BIT_OFFSET, 0, &id_));
    int previous_mode = 0;
    check(nc_set_fill(id_, NC_NOFILL, &previous_mode));  // every value gets written
  }
  ~NetcdfImage() {
    if (id_ >= 0) nc_abort(id_);
  }
  NetcdfImage(const NetcdfImage&) = delete;
  NetcdfImage& operator=(const NetcdfImage&) = delete;

  int add_dimension(const char* name, std::int64_t size) {
    int dimension = 0;
    check(nc_def_dim(id_, name, static_cast<std::size_t>(size), &dimension));
    return dimension;
  }
  int add_variable(const std::string& name, const std::vector<int>& dimensions) {
    int variable = 0;
    check(nc_def_var(id_, name.c_str(), NC_DOUBLE, static_cast<int>(dimensions.size()),
                     dimensions.data(), &variable));
    return variable;
  }
  /// Attributes with nothing to say are left out.
  void add_text(int variable, const char* name, std::string_view text) {
    if (!text.empty())
      check(nc_put_att_text(id_, variable, name, text.size(), text.data()));
  }
  void add_fill_value(int variable, double value) {
    check(nc_put_att_double(id_, variable, "_FillValue", NC_DOUBLE, 1, &value));
  }
  void end_definitions() { check(nc_enddef(id_)); }
  void put(int variable, const std::vector<double>& values) {
    check(nc_put_var_double(id_, variable, values.data()));
  }

  /// Ends the image and writes it to `file`.
  void write_to(OutputFile& file) {
    NC_memio memory{};
    check(nc_close_memio(std::exchange(id_, -1), &memory));
    const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
    file.write({static_cast<const char*>(memory.memory), memory.size});
  }

 private:
  void check(int status) const {
    if (status != NC_NOERR)
      throw WriteError(path_ + ": cannot be written: " + nc_strerror(status));
  }

  std::string path_;
  int id_ = -1;
};

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
