#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "delaunay/curve_order.hpp"

namespace delone::delaunay {

/// Half the length of an interval, or all of it where halves underflow. Never overflows.
[[nodiscard]] inline double half_extent(double low, double high) noexcept {
  const double half = high / 2 - low / 2;
  return half >= 0x1p-1000 ? half : high - low;
}

/// Spreads an interval of length 2 `half` from `low` on over integer cells 0 .. num_cells
/// - 1, its ends in different cells. A square takes the same `half` for both coordinates:
/// cells must be square, or neighbours on the curve are no neighbours in space.
///
/// Coordinates are first scaled by a power of two, so that neither the difference of the
/// ends overflows (+-1e308) nor its inverse (denormal extents).
class CellScale {
 public:
  CellScale(double low, double half, double num_cells) : last_(num_cells - 1) {
    if (!(half > 0)) return;
    power_ = std::ldexp(1.0, std::clamp(-std::ilogb(half), -1000, 1000));
    low_ = low * power_;
    scale_ = num_cells / (2 * (half * power_));  // 2 half may overflow
  }
  [[nodiscard]] std::uint32_t cell(double v) const noexcept {
    const double t = (v * power_ - low_) * scale_;
    return static_cast<std::uint32_t>(std::min(std::max(t, 0.0), last_));
  }

 private:
  double power_ = 0, low_ = 0, scale_ = 0, last_;
};

}  // namespace delone::delaunay
