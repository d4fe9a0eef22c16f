#pragma once

#include <vector>

#include "stripack/direction.hpp"

namespace delone::io {

/// Longitudes from west to east and latitudes from south to north, degrees. `west` may
/// have any wrap; east - west is at most 360.
struct LonLatBox {
  double west_deg = -180, south_deg = -90, east_deg = 180, north_deg = 90;
};

/// A piece of coast. Longitudes run on across the date line: neighbours never differ by
/// more than 180 degrees.
using CoastLine = std::vector<stripack::LonLat>;

/// The coast that passes through `box`, in the longitudes of the box: every segment whose
/// own bounding box meets it, so lines overhang the box by up to one segment. Coast at
/// the seam of a box that goes all round appears at both sides. Cost: linear in the 5119
/// points of the table. Source: Natural Earth 1:110m, public domain (data/coastline).
[[nodiscard]] std::vector<CoastLine> coast_in(const LonLatBox& box);

}  // namespace delone::io
