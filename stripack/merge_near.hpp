#pragma once

#include <span>

#include "delaunay/merge_near.hpp"
#include "stripack/direction.hpp"

namespace delone::stripack {

using delaunay::MergedRows;

/// Merges directions that are at most `angle_rad` apart, as `angle` gives it (0: equal
/// ones only).
///
/// In the order of (x, y, z) a position is kept if none kept before it is within the
/// angle; every other one then goes to the nearest one kept. What is kept is more than
/// the angle apart, what is merged is at most that far from what stands for it, and both
/// depend on the positions only, not on the order of rows. (Chains of near points do not
/// collapse into one; no claim that fewer could not have been kept.) Poles and the date
/// line are places like any other. Of repeated rows the first is named. O(n log n).
///
/// Throws Error for an angle that is negative or not finite.
[[nodiscard]] MergedRows merge_near(std::span<const Direction> points, double angle_rad);

/// The same for geodesics on WGS84 of at most `distance_km` kilometres; directions are
/// geodetic latitudes.
[[nodiscard]] MergedRows merge_near_wgs84(std::span<const Direction> points,
                                          double distance_km);

}  // namespace delone::stripack
