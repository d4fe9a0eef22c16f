#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/colormap.hpp"
#include "io/mesh.hpp"
#include "io/picture_format.hpp"
#include "stripack/direction.hpp"

namespace delone::io {

/// A place of a picture: x and y, or longitude (any wrap) and latitude in degrees.
using PicturePoint = std::array<double, 2>;

/// Points joined in a row, by straight lines in the plane, by great-circle arcs shorter
/// than 180 degrees on the globe.
using PictureLine = std::vector<PicturePoint>;

/// Lines of one colour. The width is in pixels of a picture 1200 pixels wide.
struct PictureLayer {
  Color color;
  double width = 1;
  std::vector<PictureLine> lines;
};

struct PictureLabel {
  PicturePoint place{};
  std::string text;
  enum class Kind : std::uint8_t {
    node,  ///< beside the place
    cell   ///< on the place
  };
  Kind kind = Kind::node;
};

/// What a picture of points, triangles and cells shows, from the bottom up.
struct Picture {
  Mesh::Space space = Mesh::Space::plane;
  std::vector<PictureLayer> layers;
  std::vector<PicturePoint> dots;
  std::vector<PictureLabel> labels;
};

/// The sides of a window: x or longitudes, y or latitudes.
struct PictureWindow {
  double west = 0, east = 1, south = 0, north = 1;
};

struct PictureOptions {
  std::string title{};
  int width_px = 1200;  ///< 200 to 10000; vector formats count 0.75 points a pixel
  /// Default: what the dots cover, with a margin; the whole globe if they go round it.
  std::optional<PictureWindow> window{};
  /// Globe only: an orthographic view from above this place, the hidden side not drawn.
  /// Default: a map of longitude and latitude. No window then.
  std::optional<stripack::LonLat> view{};
};

/// A picture as the bytes of a file: lines, dots and labels in a frame with axes (plane),
/// on a map with coast and graticule, or on a globe seen from space.
///
/// Scales are equal along both axes of the plane; only strips beyond 1:4 are stretched.
/// Lines may be longer than any window; they are cut before they are drawn. The bytes
/// depend on the arguments alone. Throws Error if a dot or a window is not finite, the
/// window is empty or the width is out of range. Cost: linear.
[[nodiscard]] std::string render_picture(const Picture& picture,
                                         const PictureOptions& options,
                                         PictureFormat format);

/// render_picture to a file; the format follows `format` or else the extension: png, svg,
/// pdf, eps. Throws WriteError too.
void write_picture(const std::string& path, const Picture& picture,
                   const PictureOptions& options = {}, const std::string& format = "");

}  // namespace delone::io
