#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "stripack/direction.hpp"

/// Great circles and arcs on the sphere: which meet is decided exactly, where to 1e-15
/// radians, also for arcs that are short or almost parallel.
namespace delone::stripack {

/// What two arcs, each shorter than pi, have in common.
enum class Meeting : std::uint8_t {
  none,
  cross,    ///< one point, inside both
  touch,    ///< one point, an end of at least one of them
  overlap,  ///< an arc
};

struct ArcIntersection {
  Meeting kind = Meeting::none;
  /// The first `num_points` are the point in common, or the two ends of the overlap.
  std::array<Direction, 2> points{};
  int num_points = 0;
};

/// The arcs a-b and c-d, ends included. An arc may be a single point. Throws Error if the
/// ends of an arc are opposite.
[[nodiscard]] ArcIntersection intersect(const Direction& a, const Direction& b,
                                        const Direction& c, const Direction& d);

/// Where the great circle with the given pole meets the arc from a to b: the one point,
/// or nothing if there is none or if the arc lies on the circle. Exact in which. Throws
/// Error if a and b are opposite.
[[nodiscard]] std::optional<Direction> intersect_great_circle(const Direction& pole,
                                                              const Direction& a,
                                                              const Direction& b);

/// The pole of the great circle from a to b, which lies on its left. Throws Error if a
/// and b are the same or opposite.
[[nodiscard]] Direction pole_of(const Direction& a, const Direction& b);

/// The point of the arc halfway between a and b, also if they are almost opposite. Throws
/// Error if they are opposite.
[[nodiscard]] Direction midpoint(const Direction& a, const Direction& b);

}  // namespace delone::stripack
