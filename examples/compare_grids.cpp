// How far is a gridded field from the truth?
//
//   compare_grids GRID.nc TRUTH.nc
//
// Compares two longitude/latitude grids at the nodes that both have, and prints the root
// mean square of the difference, weighted by area, and the largest difference with its
// place.

#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <optional>

#include "io/grid_file.hpp"

namespace {

using delone::interp::Axis;
using delone::interp::Field;

std::optional<std::int64_t> find_on_axis(const Axis& axis, double coordinate) {
  const double step = std::round((coordinate - axis.offset) / axis.spacing);
  const std::int64_t i = static_cast<std::int64_t>(step) - axis.first_step;
  if (i < 0 || i >= axis.size || axis.coordinate(i) != coordinate) return std::nullopt;
  return i;
}

// The two grids may cut the globe at different meridians.
std::optional<std::int64_t> find_meridian(const Axis& axis, double lon_deg) {
  for (const double turn : {0.0, 360.0, -360.0}) {
    if (const auto i = find_on_axis(axis, lon_deg + turn)) return i;
  }
  return std::nullopt;
}

double value_at(const Field& field, std::int64_t column, std::int64_t row) {
  return field.values[static_cast<std::size_t>(row * field.grid.x.size + column)];
}

class Difference {
 public:
  void add(double error, double lon_deg, double lat_deg) {
    const double weight = std::cos(lat_deg * std::numbers::pi / 180);
    ++num_nodes_;
    weighted_squares_ += weight * error * error;
    weights_ += weight;
    if (error > largest_) {
      largest_ = error;
      lon_deg_ = lon_deg;
      lat_deg_ = lat_deg;
    }
  }
  [[nodiscard]] bool is_empty() const { return num_nodes_ == 0; }
  void print(const char* units) const {
    std::printf(
        "rms %.3f %s, largest %.1f %s at longitude %g, latitude %g (%lld nodes)\n",
        std::sqrt(weighted_squares_ / weights_), units, largest_, units, lon_deg_,
        lat_deg_, static_cast<long long>(num_nodes_));
  }

 private:
  std::int64_t num_nodes_ = 0;
  double weighted_squares_ = 0, weights_ = 0;
  double largest_ = 0, lon_deg_ = 0, lat_deg_ = 0;
};

// Nodes that only one grid has, or where one of them is missing, are passed over.
Difference difference(const Field& field, const Field& truth) {
  Difference sum;
  for (std::int64_t row = 0; row < field.grid.y.size; ++row) {
    const double lat_deg = field.grid.y.coordinate(row);
    const auto truth_row = find_on_axis(truth.grid.y, lat_deg);
    if (!truth_row) continue;
    for (std::int64_t column = 0; column < field.grid.x.size; ++column) {
      const double lon_deg = field.grid.x.coordinate(column);
      const auto truth_column = find_meridian(truth.grid.x, lon_deg);
      if (!truth_column) continue;
      const double error = std::abs(value_at(field, column, row) -
                                    value_at(truth, *truth_column, *truth_row));
      if (!std::isnan(error)) sum.add(error, lon_deg, lat_deg);
    }
  }
  return sum;
}

}  // namespace

int main(int num_arguments, char** arguments) try {
  if (num_arguments != 3) {
    std::fputs("usage: compare_grids GRID.nc TRUTH.nc\n", stderr);
    return 2;
  }
  const delone::io::GridFile grid = delone::io::read_grid(arguments[1]);
  const delone::io::GridFile truth = delone::io::read_grid(arguments[2]);
  const Difference d = difference(grid.field, truth.field);
  if (d.is_empty()) {
    std::fputs("compare_grids: error: the grids have no node in common\n", stderr);
    return 3;
  }
  d.print(grid.info.units.c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "compare_grids: error: %s\n", error.what());
  return 3;
}
