#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "interp/grid.hpp"
#include "interp/index.hpp"

namespace delone::interp {

/// The coordinates of an axis, ascending (equal ones where the spacing is below the
/// resolution of doubles).
class AxisTable {
 public:
  /// Coordinates are multiplied by `scale`, a power of two.
  explicit AxisTable(const Axis& axis, double scale = 1) : coordinates_(at(axis.size)) {
    for (std::int64_t i = 0; i < axis.size; ++i)
      coordinates_[at(i)] = axis.coordinate(i) * scale;
    const double extent = coordinates_.back() - coordinates_.front();
    spacing_ =
        axis.size > 1 && extent > 0 ? extent / static_cast<double>(axis.size - 1) : 1;
    per_spacing_ = 1 / spacing_;
    for (std::int64_t i = 0; i < axis.size; ++i) {
      unevenness_ = std::max(
          unevenness_, std::abs(position(coordinates_[at(i)]) - static_cast<double>(i)));
    }
  }

  [[nodiscard]] std::int64_t size() const noexcept {
    return static_cast<std::int64_t>(coordinates_.size());
  }
  [[nodiscard]] double operator[](std::int64_t i) const noexcept {
    return coordinates_[at(i)];
  }
  [[nodiscard]] const double* data() const noexcept { return coordinates_.data(); }
  [[nodiscard]] double spacing() const noexcept { return spacing_; }
  [[nodiscard]] double largest() const noexcept {
    return std::max(std::abs(coordinates_.front()), std::abs(coordinates_.back()));
  }
  /// Index, with fraction, of a coordinate: accurate to some units in the last place of
  /// largest() / spacing().
  [[nodiscard]] double position(double coordinate) const noexcept {
    return (coordinate - coordinates_.front()) * per_spacing_;
  }
  /// The most by which the position of a node differs from its index: rounding, which is
  /// large where the spacing is near the resolution of doubles.
  [[nodiscard]] double unevenness() const noexcept { return unevenness_; }
  /// A position as an index within 0 .. size(); NaN gives 0.
  [[nodiscard]] std::int64_t clamped(double position) const noexcept {
    const auto end = static_cast<double>(size());
    return !(position > 0)  ? 0
           : position < end ? static_cast<std::int64_t>(position)
                            : size();
  }
  /// The first index that is not below a position, within 0 .. size(); NaN gives 0.
  [[nodiscard]] std::int64_t first_at(double position) const noexcept {
    const double within = std::min(static_cast<double>(size()), std::max(0.0, position));
    const auto down = static_cast<std::int64_t>(within);
    return down + (static_cast<double>(down) < within ? 1 : 0);
  }
  /// The first index above a position, within 0 .. size().
  [[nodiscard]] std::int64_t first_above(double position) const noexcept {
    return position < 0 ? 0 : clamped(position + 1);
  }
  /// The first index whose coordinate is >= c; size() if there is none.
  [[nodiscard]] std::int64_t first_from(double c) const noexcept {
    std::int64_t i = clamped(position(c));
    while (i > 0 && coordinates_[at(i - 1)] >= c) --i;
    while (i < size() && coordinates_[at(i)] < c) ++i;
    return i;
  }
  /// The first index whose coordinate is > c; size() if there is none.
  [[nodiscard]] std::int64_t first_after(double c) const noexcept {
    std::int64_t i = clamped(position(c));
    while (i > 0 && coordinates_[at(i - 1)] > c) --i;
    while (i < size() && coordinates_[at(i)] <= c) ++i;
    return i;
  }

 private:
  std::vector<double> coordinates_;
  double spacing_ = 1, per_spacing_ = 1, unevenness_ = 0;
};

}  // namespace delone::interp
