#pragma once

#include <span>
#include <string>

#include "io/grid_file.hpp"
#include "io/picture_format.hpp"

namespace delone::io {

struct MapOptions {
  std::string title{};  ///< empty: made from the variable
  int width_px = 1200;  ///< 200 to 10000; vector formats count 0.75 points a pixel
  bool draw_points = false;
  std::span<const double> point_x{}, point_y{};  ///< observations, drawn if draw_points
};

/// A picture of a grid, fit to be printed: the field in a perceptual colour map (blue to
/// red about zero where the values lie on both sides of it, else viridis), a colour bar
/// with units, axes (plane) or graticule and coastlines (longitude and latitude), title,
/// and on request the observations as dots.
///
/// Each pixel shows the field at its centre, interpolated bilinearly between nodes
/// (averaged where nodes are denser than pixels); a pixel whose nearest node is missing
/// (NaN or infinite) is left blank. Scales are equal along both axes of the plane, and a
/// degree of longitude shrinks with the cosine of the middle latitude on regional maps;
/// only strips beyond 1:4 are stretched. A grid without any value, with one value or one
/// node makes a map too.
///
/// The bytes of the file depend on the arguments alone. Throws Error if the sizes do not
/// match, an axis is empty or not finite, its spacing is not positive, or the width is
/// out of range. Cost: O(nodes + pixels), the file in memory.
[[nodiscard]] std::string render_map(const GridFile& grid, const MapOptions& options,
                                     PictureFormat format);

/// render_map to a file; the format follows `format` or else the extension: png, svg,
/// pdf, eps. Throws WriteError too.
void write_map(const std::string& path, const GridFile& grid,
               const MapOptions& options = {}, const std::string& format = "");

}  // namespace delone::io
