#pragma once

#include "stripack/direction.hpp"

namespace delone::stripack {

/// Where the arcs a-b and c-d (less than pi) cross, rounded to doubles; or one of the
/// four ends that is within 2^-50 radians of the other arc.
///
/// They must cross between their ends. Off both arcs by a few units in the last place,
/// however short they are. An arc that the result divides is longer than its halves, as
/// long as there are doubles for that; so dividing comes to an end.
[[nodiscard]] Direction rounded_crossing(const Direction& a, const Direction& b,
                                         const Direction& c, const Direction& d);

}  // namespace delone::stripack
