#pragma once

#include <span>

#include "delaunay/merge_near.hpp"
#include "tripack/point.hpp"

namespace delone::tripack {

using delaunay::MergedRows;

/// Merges points that are at most `distance` apart (0: equal ones only).
///
/// In the order of (x, y) a position is kept if none kept before it is within the
/// distance; every other one then goes to the nearest one kept. Exact: what is kept is
/// more than the distance apart, what is merged is at most that far from what stands for
/// it, and both depend on the positions only, not on the order of rows. (Chains of near
/// points do not collapse into one; no claim that fewer could not have been kept.) Of
/// repeated rows the first is named. O(n log n).
///
/// Throws Error for a point that is not finite (naming its row) and a distance that is
/// negative or not finite.
[[nodiscard]] MergedRows merge_near(std::span<const Point2> points, double distance);

}  // namespace delone::tripack
