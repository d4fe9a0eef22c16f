#pragma once

#include "interp/grid.hpp"

namespace delone::io {

/// What part of the plane or the globe a map shows: coordinates of its four sides
/// (degrees on the globe).
struct MapFrame {
  double west = 0, south = 0, east = 1, north = 1;
  bool is_closed = false;  ///< the last node's eastern neighbour is the first
};

/// The frame that holds the cells of all nodes: each node stands in the middle of a cell
/// as large as the spacing, so a grid of one node has a frame too. On the globe cells end
/// at the poles, and a grid that goes all round has a frame of 360 degrees that starts at
/// its first node if that is a multiple of ten degrees, else at the side of the node's
/// cell.
[[nodiscard]] MapFrame plane_frame(const interp::Grid& grid);
[[nodiscard]] MapFrame globe_frame(const interp::Grid& grid);

/// Width over height of a map, between 0.4 and 4: longer strips are stretched. A degree
/// of longitude is as long as one of latitude if the map spans half the globe or more,
/// else shorter by the cosine of its middle latitude.
[[nodiscard]] double plane_aspect(const MapFrame& frame);
[[nodiscard]] double globe_aspect(const MapFrame& frame);

}  // namespace delone::io
