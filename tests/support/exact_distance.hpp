#pragma once

#include "stripack/direction.hpp"
#include "tripack/point.hpp"

/// The judge of distances: exact rationals of any size (GMP), straight from the
/// definitions.
namespace delone::support {

/// -1 if `a` is nearer to `p` than `b`, +1 if farther, 0 if both are as far.
[[nodiscard]] int exact_compare_distances(tripack::Point2 p, tripack::Point2 a,
                                          tripack::Point2 b);
/// The same by the angle of the exact directions.
[[nodiscard]] int exact_compare_distances(const stripack::Direction& p,
                                          const stripack::Direction& a,
                                          const stripack::Direction& b);
/// Is `a` at most `radius` away from `p`?
[[nodiscard]] bool exact_is_within(tripack::Point2 p, tripack::Point2 a, double radius);

}  // namespace delone::support
