#pragma once

#include "tripack/point.hpp"

namespace delone::tripack {

/// Where the segments a-b and c-d cross, rounded to doubles.
///
/// They must cross between their ends. The result is within the bounding boxes of both,
/// and about as close to both lines as rounding allows: a few units in the last place of
/// the coordinates. Never overflows.
///
/// If one of the four ends is within `reach` of the other segment's line and within its
/// box, that end is the result. Without this, segments that almost coincide would be cut
/// into ever smaller pieces, each off by a rounding of its own.
[[nodiscard]] Point2 rounded_crossing(Point2 a, Point2 b, Point2 c, Point2 d,
                                      double reach) noexcept;

}  // namespace delone::tripack
