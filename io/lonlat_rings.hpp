#pragma once

#include <array>
#include <vector>

namespace delone::io {

/// Corners (x, y) or (longitude, latitude in degrees), counter-clockwise, the last not
/// repeating the first.
using PlaneRing = std::vector<std::array<double, 2>>;

/// A spherical polygon as rings of a map from -180 to 180 degrees, cut at the date line
/// as RFC 7946 (3.1.9) asks.
///
/// `corners`: longitudes of any wrap; the sides are great-circle arcs shorter than 180
/// degrees, the inside on their left, the polygon convex or nearly so (a triangle, a
/// Voronoi cell). The rings have the same corners and, where a side meets the date line,
/// the latitude at which the great circle does. A corner at a pole, whose longitude means
/// nothing, becomes two at the longitudes of its neighbours; a side over a pole is led
/// there; a polygon that holds a pole reaches along it from -180 to 180. Polygons without
/// area on the map (fewer than three corners) come back as they are. Cost: linear.
[[nodiscard]] std::vector<PlaneRing> cut_at_date_line(const PlaneRing& corners);

}  // namespace delone::io
