#include <netcdf.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>
#include <vector>

#include "io/axis_fit.hpp"
#include "io/classic_header.hpp"
#include "io/fields.hpp"
#include "io/grid_netcdf.hpp"
#include "io/line_reader.hpp"
#include "io/netcdf_source.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

enum class AxisKind : std::uint8_t { longitude, latitude, x, y, other };

bool is_upward(AxisKind kind) {
  return kind == AxisKind::latitude || kind == AxisKind::y;
}

/// The coordinate variable of a dimension: one-dimensional and called like it.
std::optional<int> coordinate_variable(const NetcdfSource& file,
                                       const Dimension& dimension) {
  const auto variable = file.find_variable(dimension.name);
  if (!variable || !is_numeric(file.type(*variable))) return std::nullopt;
  const auto dims = file.dimensions(*variable);
  if (dims.size() != 1 || dims[0].id != dimension.id) return std::nullopt;
  return variable;
}

/// Why a variable is no grid that can be read; empty if it is one.
std::string unfit_reason(const NetcdfSource& file, int variable) {
  if (!is_numeric(file.type(variable))) return "holds no numbers";
  const auto dims = file.dimensions(variable);
  if (dims.size() < 2) return "has fewer than two dimensions";
  for (std::size_t d = 0; d + 2 < dims.size(); ++d)
    if (dims[d].size != 1)
      return "has " + std::to_string(dims[d].size) + " layers along '" + dims[d].name +
             "'; take one out first (ncks -d " + dims[d].name + ",0)";
  for (std::size_t d = dims.size() - 2; d < dims.size(); ++d)
    if (!coordinate_variable(file, dims[d]))
      return "has no coordinate variable for its dimension '" + dims[d].name + "'";
  return "";
}

int choose_variable(const NetcdfSource& file, const std::string& name) {
  if (!name.empty()) {
    const auto variable = file.find_variable(name);
    if (!variable) file.fail("no variable '" + excerpt(name) + "'");
    const std::string why_not = unfit_reason(file, *variable);
    if (!why_not.empty()) file.fail("variable '" + name + "' " + why_not);
    return *variable;
  }
  std::string reasons;
  for (int variable = 0; variable < file.num_variables(); ++variable) {
    const std::string why_not = unfit_reason(file, variable);
    if (why_not.empty()) return variable;
    if (reasons.empty() && file.dimensions(variable).size() >= 2)
      reasons = "; '" + file.variable_name(variable) + "' " + why_not;
  }
  file.fail("no variable over two coordinate variables" + reasons);
}

AxisKind kind_of(const NetcdfSource& file, int variable) {
  const std::string units = to_lower(file.text(variable, "units"));
  const std::string name = to_lower(file.variable_name(variable));
  const std::string standard_name = file.text(variable, "standard_name");
  const std::string axis = file.text(variable, "axis");
  const bool is_degrees = units.starts_with("degree");
  const auto ends = [&](const char* letter, const char* word) {
    return is_degrees &&
           (units.ends_with(word) || units.ends_with(std::string("_") + letter) ||
            units == std::string("degree") + letter ||
            units == std::string("degrees") + letter);
  };
  if (standard_name == "longitude" || ends("e", "east")) return AxisKind::longitude;
  if (standard_name == "latitude" || ends("n", "north")) return AxisKind::latitude;
  if (name == "lon" || name == "longitude") return AxisKind::longitude;
  if (name == "lat" || name == "latitude") return AxisKind::latitude;
  if (axis == "X" || name == "x" || name == "easting") return AxisKind::x;
  if (axis == "Y" || name == "y" || name == "northing") return AxisKind::y;
  return AxisKind::other;
}

/// Numbers stored as float stand for the decimal that their author meant: 0.1f is 0.1.
void widen_as_decimals(std::vector<double>& numbers) {
  for (double& number : numbers) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(number));
    number = parse_number({text.data(), end.ptr}).value;
  }
}

/// 178, 179, -180, -179 -> 178, 179, 180, 181.
void continue_longitudes(std::vector<double>& longitudes) {
  for (std::size_t i = 1; i < longitudes.size(); ++i) {
    const double turns = std::round((longitudes[i] - longitudes[i - 1]) / 360);
    if (std::isfinite(turns)) longitudes[i] -= 360 * turns;
  }
}

FittedAxis read_axis(const NetcdfSource& file, int variable) {
  std::vector<double> coordinates = file.values(variable);
  const std::string name = file.variable_name(variable);
  if (coordinates.empty()) file.fail("coordinate variable '" + name + "' is empty");
  const bool is_float = file.type(variable) == NC_FLOAT;
  if (is_float) widen_as_decimals(coordinates);
  if (kind_of(file, variable) == AxisKind::longitude) continue_longitudes(coordinates);
  const FittedAxis fitted = fit_axis(coordinates);
  double largest = 0;
  for (const double c : coordinates) largest = std::max(largest, std::abs(c));
  const double rounding = is_float ? std::numeric_limits<float>::epsilon()
                                   : std::numeric_limits<double>::epsilon();
  const double spacing = fitted.axis.spacing;
  // Files hold coordinates that were rounded to some digits, too; a thousandth of a step
  // is no other grid.
  const double allowed = std::min(1e-3 * spacing + 4 * rounding * largest, 0.1 * spacing);
  if (!(fitted.largest_deviation <= allowed))
    file.fail("coordinates '" + name +
              "' are not equally spaced, which a grid here must be");
  return fitted;
}

double default_fill_value(nc_type type) {
  switch (type) {
    case NC_SHORT:
      return NC_FILL_SHORT;
    case NC_INT:
      return NC_FILL_INT;
    case NC_FLOAT:
      return static_cast<double>(NC_FILL_FLOAT);
    case NC_DOUBLE:
      return NC_FILL_DOUBLE;
    default:
      return std::numeric_limits<double>::quiet_NaN();  // bytes have none; equal to
                                                        // nothing
  }
}

std::vector<double> read_data(const NetcdfSource& file, int variable) {
  const nc_type type = file.type(variable);
  const auto as_stored = [type](double fill) {
    return type == NC_FLOAT ? static_cast<double>(static_cast<float>(fill)) : fill;
  };
  const double fill =
      as_stored(file.number(variable, "_FillValue").value_or(default_fill_value(type)));
  const double missing = as_stored(file.number(variable, "missing_value").value_or(fill));
  const double scale = file.number(variable, "scale_factor").value_or(1);
  const double offset = file.number(variable, "add_offset").value_or(0);
  std::vector<double> values = file.values(variable);
  for (double& value : values) {
    const bool is_missing = value == fill || value == missing || !std::isfinite(value);
    value =
        is_missing ? std::numeric_limits<double>::quiet_NaN() : value * scale + offset;
  }
  return values;
}

/// How a file's rows and columns lie in ours.
struct Arrangement {
  bool is_transposed = false, is_x_descending = false, is_y_descending = false;
};

std::vector<double> rearranged(std::vector<double> values, std::size_t nx, std::size_t ny,
                               Arrangement as) {
  if (!as.is_transposed && !as.is_x_descending && !as.is_y_descending) return values;
  std::vector<double> result(values.size());
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t from_i = as.is_x_descending ? nx - 1 - i : i;
      const std::size_t from_j = as.is_y_descending ? ny - 1 - j : j;
      result[j * nx + i] =
          values[as.is_transposed ? from_i * ny + from_j : from_j * nx + from_i];
    }
  return result;
}

GridInfo describe(const NetcdfSource& file, int variable, int x, int y) {
  const auto title_of = [&](int coordinate) {
    const std::string long_name = file.text(coordinate, "long_name");
    return long_name.empty() ? file.variable_name(coordinate) : long_name;
  };
  return {.name = file.variable_name(variable),
          .long_name = file.text(variable, "long_name"),
          .units = file.text(variable, "units"),
          .is_lonlat = kind_of(file, x) == AxisKind::longitude &&
                       kind_of(file, y) == AxisKind::latitude,
          .x_name = title_of(x),
          .y_name = title_of(y),
          .x_units = file.text(x, "units"),
          .y_units = file.text(y, "units"),
          .title = file.text(NC_GLOBAL, "title")};
}

}  // namespace

GridFile read_grid_netcdf(const std::string& path, const std::string& variable_name) {
  const NetcdfSource file(path);
  const int variable = choose_variable(file, variable_name);
  const auto dims = file.dimensions(variable);
  int y = *coordinate_variable(file, dims[dims.size() - 2]);
  int x = *coordinate_variable(file, dims[dims.size() - 1]);
  const bool is_transposed = is_upward(kind_of(file, x)) && !is_upward(kind_of(file, y));
  if (is_transposed) std::swap(x, y);
  const FittedAxis x_axis = read_axis(file, x), y_axis = read_axis(file, y);
  const Arrangement arrangement{is_transposed, x_axis.is_descending,
                                y_axis.is_descending};
  const auto nx = static_cast<std::size_t>(x_axis.axis.size);
  const auto ny = static_cast<std::size_t>(y_axis.axis.size);
  return {.field = {.grid = {x_axis.axis, y_axis.axis},
                    .values = rearranged(read_data(file, variable), nx, ny, arrangement)},
          .info = describe(file, variable, x, y)};
}

}  // namespace delone::io
