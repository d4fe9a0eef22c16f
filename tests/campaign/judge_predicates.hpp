#pragma once

#include "stripack/direction.hpp"
#include "tripack/point.hpp"

/// The judge's own predicates: exact for the doubles given, quick enough for millions of
/// sets, and without a line in common with the library's. A filter in long double decides
/// nearly all; where it cannot, integers of 128 bits or the arithmetic of support/exact
/// (GMP) do.
namespace delone::campaign {

/// +1 left of a -> b, -1 right, 0 on the line.
[[nodiscard]] int orientation(tripack::Point2 a, tripack::Point2 b, tripack::Point2 c);
/// +1 inside the circle through a, b, c (counter-clockwise), -1 outside, 0 on it.
[[nodiscard]] int in_circle(tripack::Point2 a, tripack::Point2 b, tripack::Point2 c,
                            tripack::Point2 p);

/// The sign of det(a, b, c).
[[nodiscard]] int orientation(const stripack::Direction& a, const stripack::Direction& b,
                              const stripack::Direction& c);
/// +1 beyond the plane through the unit vectors of a, b, c (counter-clockwise), -1 on the
/// centre's side of it, 0 in it.
[[nodiscard]] int in_circle(const stripack::Direction& a, const stripack::Direction& b,
                            const stripack::Direction& c, const stripack::Direction& p);
/// Do a and b, as vectors, lie on one line through the centre?
[[nodiscard]] bool is_parallel(const stripack::Direction& a,
                               const stripack::Direction& b);
/// Are a and b, as vectors, positive multiples of one another?
[[nodiscard]] bool is_same_ray(const stripack::Direction& a,
                               const stripack::Direction& b);

}  // namespace delone::campaign
