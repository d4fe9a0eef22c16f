#pragma once

#include <cstdint>
#include <vector>

#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// `size` equally spaced coordinates, coordinate(i) = (first_step + i) * spacing +
/// offset, computed from the step number so that no rounding errors add up.
///
/// Where the spacing is a ratio of two short numbers, `length / parts` (0.1 = 1 / 10; 180
/// / 49), the coordinate is computed as step * length / parts: then a node at three steps
/// of 0.1 is the double nearest to 0.3, which is where a table puts an observation at
/// "0.3", and both ends of a region are hit exactly. `parts` 0: no such ratio.
struct Axis {
  double spacing = 1;
  std::int64_t first_step = 0;
  std::int64_t size = 0;
  double offset = 0;
  double length = 0, parts = 0;

  [[nodiscard]] double coordinate(std::int64_t i) const noexcept {
    const double step = static_cast<double>(first_step + i);
    return (parts > 0 ? step * length / parts : step * spacing) + offset;
  }
  friend bool operator==(const Axis&, const Axis&) = default;
};

/// A regular grid of nodes: x (or longitude, degrees) fastest, y (or latitude, degrees)
/// upwards.
struct Grid {
  Axis x, y;
  [[nodiscard]] std::int64_t size() const noexcept { return x.size * y.size; }
  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Throws Error if an axis has no nodes, or several with a spacing that is not positive,
/// or is not finite.
void check(const Grid& grid);
/// The same for a longitude-latitude grid; besides, Error for latitudes outside -90..90.
void check_globe(const Grid& grid);

/// Values on a grid, row-major with y slow: values[j * x.size + i]. NaN is missing.
struct Field {
  Grid grid;
  std::vector<double> values;
};

/// A rectangle, sides included. On the globe in degrees: longitudes of any wrap, west <
/// east <= west + 360 (so a region across the date line is 170 .. 190), -90 <= south <=
/// north <= 90.
struct Region {
  double west = 0, east = 0, south = 0, north = 0;
  friend bool operator==(const Region&, const Region&) = default;
};

/// Distances between neighbouring nodes, data units or degrees.
struct Spacing {
  double x = 1, y = 1;
  friend bool operator==(const Spacing&, const Spacing&) = default;
};

/// Numbers of nodes.
struct NodeCounts {
  std::int64_t x = 0, y = 0;
  friend bool operator==(const NodeCounts&, const NodeCounts&) = default;
};

/// The smallest rectangle that holds the sites. Throws Error if there are none.
[[nodiscard]] Region covering_region(const tripack::Triangulation& triangulation);

/// The whole globe (-180 .. 180, -90 .. 90) when the sites go round it (their longitudes
/// leave no gap of 180 degrees) or a pole is a site or lies in the triangulated region;
/// else the smallest longitude-latitude rectangle that holds the sites, across the date
/// line if that is shorter (then east > 180). Throws Error if there are no sites.
[[nodiscard]] Region covering_region(const stripack::Triangulation& triangulation);

/// The smallest region on multiples of the spacing that holds `region`; no latitude
/// leaves -90 .. 90, and the whole globe stays as it is.
[[nodiscard]] Region widened_plane_region(const Region& region, Spacing spacing);
[[nodiscard]] Region widened_globe_region(const Region& region, Spacing spacing);

/// The spacing that gives about four nodes for each observation, rounded to 1, 2 or 5
/// times a power of ten (to the nearest in ratio), the same for x and y. On the globe at
/// most 10 degrees, so that it divides 90.
[[nodiscard]] Spacing suggested_plane_spacing(const Region& region,
                                              std::int64_t num_observations);
[[nodiscard]] Spacing suggested_globe_spacing(const Region& region,
                                              std::int64_t num_observations);

/// Nodes over a region of the plane, both ends included. Where the ends are multiples of
/// the spacing, or the spacing divides the region, the nodes run from end to end; else
/// they are multiples of the spacing and the region is widened outwards to the next ones.
/// Throws Error for an empty or non-finite region, a spacing that is not positive, or
/// more than 2^40 nodes.
[[nodiscard]] Grid plane_grid(const Region& region, Spacing spacing);
/// The same with given numbers of nodes; a single one stands in the middle, and a region
/// without extent gets a single one.
[[nodiscard]] Grid plane_grid(const Region& region, NodeCounts counts);

/// Nodes over a region of the globe in degrees, as plane_grid; a region that spans 360
/// degrees does not repeat its first meridian, and no latitude leaves -90..90. Throws
/// Error besides for latitudes outside -90..90.
[[nodiscard]] Grid globe_grid(const Region& region, Spacing spacing);
[[nodiscard]] Grid globe_grid(const Region& region, NodeCounts counts);

/// The nodes of a grid as points, row by row.
[[nodiscard]] std::vector<tripack::Point2> plane_nodes(const Grid& grid);
/// The nodes of a longitude-latitude grid as directions. Throws Error for latitudes
/// outside -90..90.
[[nodiscard]] std::vector<stripack::Direction> globe_nodes(const Grid& grid);

}  // namespace delone::interp
