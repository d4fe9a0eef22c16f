#include "io/map_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace delone::io {
namespace {

constexpr double narrowest = 0.4, widest = 4;

double lower_side(const interp::Axis& axis) {
  return axis.coordinate(0) - axis.spacing / 2;
}
double upper_side(const interp::Axis& axis) {
  return axis.coordinate(axis.size - 1) + axis.spacing / 2;
}

/// Maps of the whole globe look best with a round longitude at their sides.
double first_longitude(const interp::Axis& longitudes) {
  const double first = longitudes.coordinate(0);
  return std::remainder(first, 10) == 0 ? first : lower_side(longitudes);
}

}  // namespace

MapFrame plane_frame(const interp::Grid& grid) {
  return {lower_side(grid.x), lower_side(grid.y), upper_side(grid.x), upper_side(grid.y),
          false};
}

MapFrame globe_frame(const interp::Grid& grid) {
  MapFrame frame = plane_frame(grid);
  frame.south = std::max(frame.south, -90.0);
  frame.north = std::min(frame.north, 90.0);
  if (frame.east - frame.west > 360 * (1 - 1e-9)) {
    frame.west = first_longitude(grid.x);
    frame.east = frame.west + 360;
    const double length = grid.x.spacing * static_cast<double>(grid.x.size);
    frame.is_closed = std::abs(length - 360) <= 1e-6 * grid.x.spacing;
  }
  return frame;
}

double plane_aspect(const MapFrame& frame) {
  return std::clamp((frame.east - frame.west) / (frame.north - frame.south), narrowest,
                    widest);
}

double globe_aspect(const MapFrame& frame) {
  const double middle_deg = (frame.south + frame.north) / 2;
  const double width = frame.east - frame.west;
  const double shrink = width >= 180 ? 1 : std::cos(middle_deg * std::numbers::pi / 180);
  return std::clamp(shrink * width / (frame.north - frame.south), narrowest, widest);
}

}  // namespace delone::io
