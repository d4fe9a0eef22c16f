#pragma once

#include <cstddef>
#include <vector>

#include "interp/grid.hpp"
#include "io/colormap.hpp"
#include "io/map_frame.hpp"

namespace delone::io {

/// Colours row by row, the top row first.
struct Raster {
  int width = 0, height = 0;
  std::vector<Color> pixels;
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] Color at(int column, int row) const { return pixels[index(column, row)]; }
};

/// The colour of what is missing.
inline constexpr Color blank_color{240, 240, 240};

/// The field as the centres of width x height pixels see it, the frame being spread over
/// them evenly.
///
/// Between nodes values are interpolated bilinearly, where nodes are denser than pixels
/// averaged with the same tent; a pixel in the middle of a node's cell has that node's
/// colour. A pixel whose nearest node is missing (NaN or infinite) is blank, and missing
/// nodes have no part in what their neighbours show. Fields that go round the globe join
/// at the seam. Cost: O(pixels + nodes).
[[nodiscard]] Raster rasterize(const interp::Field& field, const MapFrame& frame,
                               const ColorScale& scale, int width, int height);

/// Squares of `size` pixels at places that are fractions of a raster's width (from the
/// left) and height (upwards).
struct RasterDots {
  std::vector<double> right, up;
  int size = 1;
  Color color;
};

/// The raster with the dots on it, as far as they lie inside; NaN is nowhere.
[[nodiscard]] Raster with_dots(Raster raster, const RasterDots& dots);

}  // namespace delone::io
