#pragma once

#include <string>
#include <vector>

#include "interp/grid.hpp"

namespace delone::io {

/// What a grid file says of its variable and coordinates.
struct GridInfo {
  std::string name = "value";  ///< made a valid NetCDF name when written
  std::string long_name, units;
  bool is_lonlat = false;                        ///< lon/lat in degrees, else x/y
  std::string x_name, y_name, x_units, y_units;  ///< plane only; long names, may be empty
  std::string title;
};

/// Another variable on the nodes of a file's first one, such as the other component of a
/// vector.
struct GridVariable {
  std::string name, units;
  std::vector<double> values;
};

struct GridFile {
  interp::Field field;
  GridInfo info;
  std::vector<GridVariable> more = {};  ///< `nc` and `csv` only
};

/// Writes a grid; the same bytes for the same field and info. The format is `format` or
/// the extension:
///
/// - `nc`: NetCDF classic with 64-bit offsets, CF-1.8: coordinate variables `lon`, `lat`
///   or `x`, `y` with units, the data as double with `_FillValue` for missing nodes,
///   long_name, units; no history, no date.
/// - `csv`: a header line, then x,y,value (and the values of `more`) row by row from the
///   south-west; missing values empty.
/// - `asc`: Esri ASCII grid, which knows square cells only; -9999 (or -99999, ...) for
///   missing nodes.
///
/// Names of variables that are the same once made valid get a number. Pictures are
/// io/map.hpp's. Throws WriteError: no such format, spacing that is not square, several
/// variables in an `asc`, and as OutputFile; Error if a number of values is not that of
/// the grid's nodes or is zero.
void write_grid(const std::string& path, const GridFile& grid,
                const std::string& format = "");

/// Reads `variable`, or the first one over two coordinate variables, of a NetCDF file
/// (classic or NetCDF-4).
///
/// Leading dimensions must have size 1. Coordinates must be equally spaced to a
/// thousandth of a step and the rounding of their type; descending ones are turned round,
/// longitudes that jump by 360 are continued, dimensions in the order x, y are exchanged.
/// _FillValue, missing_value and infinities become NaN; scale_factor and add_offset are
/// applied. `info.is_lonlat` if units, standard_name or name say so. Sizes are held
/// against the file's before memory is taken. Throws ReadError.
[[nodiscard]] GridFile read_grid(const std::string& path,
                                 const std::string& variable = "");

/// A name that NetCDF and CF allow, as near to `name` as can be: letters, digits and
/// underscores, a letter first. "value" if nothing is left.
[[nodiscard]] std::string valid_variable_name(const std::string& name);

}  // namespace delone::io
