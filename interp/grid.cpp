#include "interp/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "delaunay/error.hpp"
#include "interp/index.hpp"

namespace delone::interp {

namespace {

constexpr double most_nodes = 0x1p40;

// Up to the rounding of decimals typed as coordinates and spacing.
bool is_whole(double value) {
  return std::abs(value - std::round(value)) <= 0x1p-44 * std::max(1.0, std::abs(value));
}

void check(const Region& r) {
  if (!std::isfinite(r.west) || !std::isfinite(r.east) || !std::isfinite(r.south) ||
      !std::isfinite(r.north)) {
    throw Error("the region's sides must be finite numbers");
  }
  if (!std::isfinite(r.east - r.west) || !std::isfinite(r.north - r.south)) {
    throw Error("the region is wider than the largest number; scale the coordinates");
  }
  if (r.west > r.east || r.south > r.north)
    throw Error("the region's west must be below its east, its south below its north");
}

void check_globe(const Region& r) {
  check(r);
  if (r.east - r.west > 360) throw Error("the region is wider than 360 degrees");
  if (r.south < -90 || r.north > 90)
    throw Error("the region's latitudes must lie within -90..90 degrees");
}

void check(Spacing s) {
  if (!(s.x > 0) || !(s.y > 0) || !std::isfinite(s.x) || !std::isfinite(s.y)) {
    throw Error("the spacing must be a positive number");
  }
}

void check(NodeCounts n) {
  if (n.x < 1 || n.y < 1) throw Error("a grid needs at least one node each way");
}

// spacing = length / parts with short numbers, where the decimal that was typed shows
// them.
void set_ratio(Axis& axis) {
  double parts = 1;
  for (int digits = 0; digits <= 12; ++digits, parts *= 10) {
    const double length = std::round(axis.spacing * parts);
    if (length < 1 || length > 0x1p40 || length / parts != axis.spacing) continue;
    axis.length = length;
    axis.parts = parts;
    return;
  }
}

double checked_count(double count) {
  if (!(count <= most_nodes))
    throw Error("the grid would have more than 2^40 nodes; take a larger spacing");
  return count;
}

// Nodes from `low` to `high`, both ends included where the spacing allows, else widened
// outwards.
Axis axis_between(double low, double high, double spacing) {
  Axis axis{.spacing = spacing};
  set_ratio(axis);
  const double steps = (high - low) / spacing;
  checked_count(steps);
  const bool on_multiples = is_whole(low / spacing) && is_whole(high / spacing);
  if (!on_multiples && is_whole(steps)) {
    axis.offset = low;
    axis.size = static_cast<std::int64_t>(std::round(steps)) + 1;
    return axis;
  }
  const double first =
      on_multiples ? std::round(low / spacing) : std::floor(low / spacing);
  const double last =
      on_multiples ? std::round(high / spacing) : std::ceil(high / spacing);
  checked_count(std::max(std::abs(first), std::abs(last)) /
                4096);  // steps stay exact as doubles
  axis.first_step = static_cast<std::int64_t>(first);
  axis.size = static_cast<std::int64_t>(last) - axis.first_step + 1;
  return axis;
}

// `size` nodes from `low` to `high`; one node stands in the middle.
Axis axis_with_size(double low, double high, std::int64_t size) {
  if (size == 1 || low == high) return {.size = 1, .offset = low + (high - low) / 2};
  const auto parts = static_cast<double>(size - 1);
  Axis axis{.spacing = (high - low) / parts, .size = size, .offset = low};
  if (std::isfinite((high - low) * parts)) axis.length = high - low, axis.parts = parts;
  return axis;
}

double multiple_below(double value, double spacing) {
  const double steps = value / spacing;
  return (is_whole(steps) ? std::round(steps) : std::floor(steps)) * spacing;
}

double multiple_above(double value, double spacing) {
  return -multiple_below(-value, spacing);
}

bool is_global(const Region& r) { return r.east - r.west == 360; }

// Takes off the nodes beyond the poles that widening brought.
void keep_within_poles(Axis& axis) {
  while (axis.size > 1 && axis.coordinate(0) < -90) {
    ++axis.first_step;
    --axis.size;
  }
  while (axis.size > 1 && axis.coordinate(axis.size - 1) > 90) --axis.size;
}

void check_size(const Grid& grid) {
  checked_count(static_cast<double>(grid.x.size) * static_cast<double>(grid.y.size));
}

Spacing rounded_spacing(double spacing) {
  const double decade = std::pow(10.0, std::floor(std::log10(spacing)));
  const double digit = spacing / decade;
  // Steps at the geometric means of 1, 2, 5, 10. Whole powers below one as 1 / 10^k,
  // which is the nearest double.
  const double rounded = digit < std::sqrt(2.0)    ? 1
                         : digit < std::sqrt(10.0) ? 2
                         : digit < std::sqrt(50.0) ? 5
                                                   : 10;
  const double result = decade < 1 ? rounded / std::round(1 / decade) : rounded * decade;
  return {result, result};
}

double ideal_spacing(const Region& r, std::int64_t num_observations) {
  const double width = r.east - r.west, height = r.north - r.south;
  const double nodes =
      4 * static_cast<double>(std::max<std::int64_t>(num_observations, 1));
  if (width > 0 && height > 0) return std::sqrt(width / nodes) * std::sqrt(height);
  return std::max(width, height) / nodes;
}

}  // namespace

void check(const Grid& grid) {
  for (const Axis& axis : {grid.x, grid.y}) {
    if (axis.size < 1) throw Error("a grid needs at least one node each way");
    if (!std::isfinite(axis.coordinate(0)) ||
        !std::isfinite(axis.coordinate(axis.size - 1))) {
      throw Error("the grid's coordinates must be finite");
    }
    if (axis.size > 1 && !(axis.coordinate(axis.size - 1) > axis.coordinate(0))) {
      throw Error("the grid's spacing must be positive");
    }
  }
  check_size(grid);
}

void check_globe(const Grid& grid) {
  check(grid);
  if (grid.y.coordinate(0) < -90 || grid.y.coordinate(grid.y.size - 1) > 90) {
    throw Error("the grid's latitudes must lie within -90..90 degrees");
  }
}

Region covering_region(const tripack::Triangulation& triangulation) {
  if (triangulation.num_sites() == 0) throw Error("there are no points to cover");
  const tripack::Point2 first = triangulation.points()[0];
  Region r{first.x, first.x, first.y, first.y};
  for (const tripack::Point2 p : triangulation.points()) {
    r.west = std::min(r.west, p.x), r.east = std::max(r.east, p.x);
    r.south = std::min(r.south, p.y), r.north = std::max(r.north, p.y);
  }
  return r;
}

Region widened_plane_region(const Region& r, Spacing spacing) {
  check(r);
  check(spacing);
  return {multiple_below(r.west, spacing.x), multiple_above(r.east, spacing.x),
          multiple_below(r.south, spacing.y), multiple_above(r.north, spacing.y)};
}

Region widened_globe_region(const Region& r, Spacing spacing) {
  check_globe(r);
  if (is_global(r)) return r;
  Region wide = widened_plane_region(r, spacing);
  wide.south = std::max(wide.south, -90.0);
  wide.north = std::min(wide.north, 90.0);
  if (wide.east - wide.west > 360) wide = {-180, 180, wide.south, wide.north};
  return wide;
}

Spacing suggested_plane_spacing(const Region& region, std::int64_t num_observations) {
  check(region);
  const double ideal = ideal_spacing(region, num_observations);
  return ideal > std::numeric_limits<double>::min() && std::isfinite(ideal)
             ? rounded_spacing(ideal)
             : Spacing{1, 1};
}

Spacing suggested_globe_spacing(const Region& region, std::int64_t num_observations) {
  const Spacing s = suggested_plane_spacing(region, num_observations);
  return s.x > 10 ? Spacing{10, 10} : s;
}

Grid plane_grid(const Region& region, Spacing spacing) {
  check(region);
  check(spacing);
  const Grid grid{axis_between(region.west, region.east, spacing.x),
                  axis_between(region.south, region.north, spacing.y)};
  check_size(grid);
  return grid;
}

Grid plane_grid(const Region& region, NodeCounts counts) {
  check(region);
  check(counts);
  const Grid grid{axis_with_size(region.west, region.east, counts.x),
                  axis_with_size(region.south, region.north, counts.y)};
  check_size(grid);
  return grid;
}

Grid globe_grid(const Region& region, Spacing spacing) {
  check_globe(region);
  Grid grid = plane_grid(region, spacing);
  keep_within_poles(grid.y);
  if (is_global(region)) {
    // Nodes from the first meridian on, as many as fit in one turn.
    const double turn = 360 / spacing.x;
    grid.x.size =
        static_cast<std::int64_t>(is_whole(turn) ? std::round(turn) : std::ceil(turn));
  }
  return grid;
}

Grid globe_grid(const Region& region, NodeCounts counts) {
  check_globe(region);
  Grid grid = plane_grid(region, counts);
  if (is_global(region) && counts.x > 1) {
    const auto parts = static_cast<double>(counts.x);
    grid.x = {.spacing = 360 / parts,
              .size = counts.x,
              .offset = region.west,
              .length = 360,
              .parts = parts};
  }
  if (region.north == 90 && region.south != -90 && counts.y > 1) {
    grid.y.offset = 90;  // counted from the pole, so that it is hit exactly
    grid.y.first_step = 1 - counts.y;
  }
  return grid;
}

std::vector<tripack::Point2> plane_nodes(const Grid& grid) {
  check(grid);
  std::vector<tripack::Point2> nodes;
  nodes.reserve(at(grid.size()));
  for (std::int64_t j = 0; j < grid.y.size; ++j) {
    for (std::int64_t i = 0; i < grid.x.size; ++i)
      nodes.push_back({grid.x.coordinate(i), grid.y.coordinate(j)});
  }
  return nodes;
}

std::vector<stripack::Direction> globe_nodes(const Grid& grid) {
  check_globe(grid);
  std::vector<stripack::Direction> nodes;
  nodes.reserve(at(grid.size()));
  for (std::int64_t j = 0; j < grid.y.size; ++j) {
    for (std::int64_t i = 0; i < grid.x.size; ++i) {
      nodes.push_back(stripack::Direction::from(
          stripack::LonLat{grid.x.coordinate(i), grid.y.coordinate(j)}));
    }
  }
  return nodes;
}

}  // namespace delone::interp
