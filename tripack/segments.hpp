#pragma once

#include <array>
#include <cstdint>

#include "tripack/point.hpp"

namespace delone::tripack {

/// What two closed segments have in common.
enum class Meeting : std::uint8_t {
  none,
  cross,    ///< one point, inside both
  touch,    ///< one point, an end of at least one of them
  overlap,  ///< a segment
};

/// Exact for the doubles given. A segment may be a single point.
[[nodiscard]] Meeting meeting(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;

struct Intersection {
  Meeting kind = Meeting::none;
  /// The first `num_points` are the point in common, or the two ends of the overlap.
  std::array<Point2, 2> points{};
  int num_points = 0;
};

/// The segments a-b and c-d. Where they touch or overlap the points are corners given;
/// where they cross, each coordinate is within 2 units in its last place or 2^-80 of the
/// shorter segment, also for lines that are almost parallel.
[[nodiscard]] Intersection intersect(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;

}  // namespace delone::tripack
