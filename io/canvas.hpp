#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/colormap.hpp"
#include "io/map_raster.hpp"
#include "io/picture_format.hpp"

struct _cairo;
struct _cairo_surface;

namespace delone::io {

/// A place on the canvas: pixels from the left and from the top.
struct CanvasPoint {
  double x = 0, y = 0;
};

struct CanvasBox {
  double left = 0, top = 0, width = 0, height = 0;
  [[nodiscard]] double right() const noexcept { return left + width; }
  [[nodiscard]] double bottom() const noexcept { return top + height; }
};

struct Stroke {
  Color color;
  double width = 1;
};

enum class Align : std::uint8_t { begin, middle, end };
enum class Reading : std::uint8_t { across, upwards };

/// `across` is where the text's reading direction is anchored, `along` its height (begin:
/// the top of capital letters, end: the base line).
struct TextStyle {
  double size = 12;
  Align across = Align::middle, along = Align::middle;
  Reading reading = Reading::across;
  Color color{38, 38, 38};
};

/// A white page to draw on, and the only place that knows Cairo. What is drawn goes to
/// memory; finish() gives the file's bytes, which depend on nothing but what was drawn:
/// no dates, no counters. One page in PNG pixels is 0.75 points in the vector formats.
/// Text must be valid UTF-8; the font is DejaVu Sans where the machine has it.
class Canvas {
 public:
  Canvas(PictureFormat format, int width_px, int height_px);

  [[nodiscard]] double text_width(const std::string& text, double size) const;
  void draw_text(const std::string& text, CanvasPoint anchor, const TextStyle& style);
  void draw_line(std::span<const CanvasPoint> points, Stroke stroke);
  /// Many lines at once: where they meet or cross, nothing is painted twice.
  void draw_lines(std::span<const std::vector<CanvasPoint>> lines, Stroke stroke);
  void draw_segment(CanvasPoint from, CanvasPoint to, Stroke stroke);
  void draw_box(CanvasBox box, Stroke stroke);
  void draw_circle(CanvasPoint centre, double radius, Stroke stroke);
  /// A disc with a ring around it, if that has a width.
  void draw_dot(CanvasPoint centre, double radius, Color fill, Stroke ring);
  /// Spreads the raster over the box without smoothing.
  void draw_raster(const Raster& raster, CanvasBox box);
  /// From left to right, or from the bottom upwards.
  void draw_gradient(const Colormap& colormap, CanvasBox box, Reading reading);

  /// Until unclip(), nothing is drawn outside the box.
  void clip(CanvasBox box);
  void unclip();

  /// How many pixels of the finest kind a canvas pixel is worth: 1 in a PNG.
  [[nodiscard]] int raster_density() const noexcept;

  /// The finished file. Throws WriteError if Cairo failed (memory, size). Nothing can be
  /// drawn afterwards.
  [[nodiscard]] std::string finish();

 private:
  struct Closer {
    void operator()(_cairo* context) const noexcept;
    void operator()(_cairo_surface* surface) const noexcept;
  };

  PictureFormat format_;
  // On the heap, because Cairo keeps its address; before the surface, which may write
  // while it is closed.
  std::unique_ptr<std::string> bytes_;
  std::unique_ptr<_cairo_surface, Closer> surface_;
  std::unique_ptr<_cairo, Closer> context_;
};

}  // namespace delone::io
