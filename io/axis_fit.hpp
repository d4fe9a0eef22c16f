#pragma once

#include <span>

#include "interp/grid.hpp"

namespace delone::io {

/// Coordinates as a file holds them, turned into an axis.
struct FittedAxis {
  interp::Axis axis;
  bool is_descending = false;  ///< the coordinates fall; `axis` rises
  double largest_deviation =
      0;  ///< of a coordinate from the axis; infinite if there is no such axis
};

/// The equally spaced axis through `coordinates` (at least one).
///
/// The spacing is the mean one, or, where that fits as well, the ratio of short numbers
/// next to it, so that coordinates 0, 0.1, 0.2, 0.30000000000000004 give an axis that
/// holds 0.3. Steps are counted from zero; an offset below 1e-9 of a step is taken for
/// rounding. One coordinate has spacing 1. Coordinates that are not finite, or whose ends
/// are equal, deviate infinitely. O(n).
[[nodiscard]] FittedAxis fit_axis(std::span<const double> coordinates);

}  // namespace delone::io
