#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interp/values.hpp"
#include "io/table.hpp"

namespace delone::cli {

/// What every subcommand is told.
struct RunSettings {
  bool is_quiet = false;
  bool prints_timings = false;
  int num_threads = 0;  ///< 0: all cores
};

/// Where the points lie. On the ellipsoid the points are triangulated as the directions
/// of their geodetic latitudes, and distances are geodesics on WGS84.
enum class Domain : std::uint8_t { plane, sphere, ellipsoid };

/// How a file of points is read.
struct PointSettings {
  std::string path;
  io::TableOptions columns;
  std::optional<Domain> domain;  ///< empty: by the names of the columns
  interp::Duplicates duplicates = interp::Duplicates::mean;
  /// Points this near one another become one: data units, on the globe kilometres.
  std::optional<double> merge_within;
  bool has_errors = false;  ///< columns.second_value is that of the values' errors
};

/// Where a result goes.
struct OutputSettings {
  std::string path, format;
};

/// A word that an option takes, and what it means.
template <class T>
using Choice = std::pair<std::string_view, T>;

/// The words of --on and --duplicates.
[[nodiscard]] const std::vector<Choice<Domain>>& domain_choices();
[[nodiscard]] const std::vector<Choice<interp::Duplicates>>& duplicates_choices();
[[nodiscard]] std::string_view name_of(Domain domain);
[[nodiscard]] std::string_view name_of(interp::Duplicates duplicates);

}  // namespace delone::cli
