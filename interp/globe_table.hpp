#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "interp/axis_table.hpp"
#include "interp/grid.hpp"
#include "interp/sphere_vector.hpp"

namespace delone::interp {

using stripack::Direction;

/// Directions of the nodes of a longitude-latitude grid from cosines and sines of its
/// columns and rows: the same bits as Direction::from(LonLat) up to the sign of zeros.
class GlobeTable {
 public:
  explicit GlobeTable(const Grid& grid) : lon_(grid.x), lat_(grid.y) {
    for (std::int64_t i = 0; i < columns(); ++i) {
      const Direction d = Direction::from(stripack::LonLat{lon_[i], 0});
      cos_lon_.push_back(d.x());
      sin_lon_.push_back(d.y());
    }
    for (std::int64_t j = 0; j < rows(); ++j) {
      const Direction d = Direction::from(stripack::LonLat{0, lat_[j]});
      cos_lat_.push_back(d.x());
      sin_lat_.push_back(d.z());
    }
  }

  [[nodiscard]] std::int64_t columns() const noexcept { return lon_.size(); }
  [[nodiscard]] std::int64_t rows() const noexcept { return lat_.size(); }
  [[nodiscard]] const AxisTable& lon() const noexcept { return lon_; }
  [[nodiscard]] const double* cos_lon() const noexcept { return cos_lon_.data(); }
  [[nodiscard]] const double* sin_lon() const noexcept { return sin_lon_.data(); }
  [[nodiscard]] const double* cos_lat() const noexcept { return cos_lat_.data(); }
  [[nodiscard]] const double* sin_lat() const noexcept { return sin_lat_.data(); }
  [[nodiscard]] double cos_lat(std::int64_t j) const noexcept { return cos_lat_[at(j)]; }
  [[nodiscard]] double sin_lat(std::int64_t j) const noexcept { return sin_lat_[at(j)]; }
  [[nodiscard]] bool is_pole(std::int64_t j) const noexcept {
    return std::abs(lat_[j]) == 90;
  }
  [[nodiscard]] Direction node(std::int64_t i, std::int64_t j) const {
    return Direction::from(stripack::LonLat{lon_[i], lat_[j]});
  }
  [[nodiscard]] Vector3 vector(std::int64_t i, std::int64_t j) const noexcept {
    return {cos_lat_[at(j)] * cos_lon_[at(i)], cos_lat_[at(j)] * sin_lon_[at(i)],
            sin_lat_[at(j)]};
  }
  /// Rows whose sine lies in [low, high] up to rounding, the poles left out.
  [[nodiscard]] IndexRange rows_between(double low, double high) const noexcept {
    constexpr double margin = 0x1p-49;
    const auto begin = std::lower_bound(sin_lat_.begin(), sin_lat_.end(), low - margin);
    const auto end = std::upper_bound(begin, sin_lat_.end(), high + margin);
    IndexRange range{begin - sin_lat_.begin(), end - sin_lat_.begin()};
    while (!range.is_empty() && is_pole(range.begin)) ++range.begin;
    while (!range.is_empty() && is_pole(range.end - 1)) --range.end;
    return range;
  }
  /// The first row whose sine is not below `sine`; rows() if there is none.
  [[nodiscard]] std::int64_t first_row_from(double sine) const noexcept {
    const std::int64_t guess =
        lat_.first_at(lat_.position(std::asin(sine) * (180 / std::numbers::pi)));
    if ((guess == 0 || sin_lat_[at(guess - 1)] < sine) &&
        (guess == rows() || sin_lat_[at(guess)] >= sine))
      return guess;
    return std::lower_bound(sin_lat_.begin(), sin_lat_.end(), sine) - sin_lat_.begin();
  }
  /// Columns in a whole turn.
  [[nodiscard]] double turn() const noexcept { return 360 / lon_.spacing(); }
  /// Bound on the rounding error of a longitude's position, in columns.
  [[nodiscard]] double tolerance() const noexcept {
    return lon_.unevenness() + 0x1p-47 * (360 + lon_.largest()) / lon_.spacing();
  }

  /// Calls f(shift) for every whole number of turns by which [begin, end] (positions in
  /// columns) is moved to reach within `slack` of the grid's columns: a grid may show a
  /// meridian twice.
  template <class F>
  void for_each_turn(double begin, double end, double slack, F f) const {
    const double last = static_cast<double>(columns() - 1), whole = turn();
    double turns = 0;
    while (end + (turns - 1) * whole >= -slack) --turns;
    while (end + turns * whole < -slack) ++turns;
    for (; begin + turns * whole <= last + slack; ++turns) f(turns * whole);
  }

 private:
  AxisTable lon_, lat_;
  std::vector<double> cos_lon_, sin_lon_, cos_lat_, sin_lat_;
};

}  // namespace delone::interp
