#pragma once

#include <span>
#include <string>

#include "io/canvas.hpp"
#include "io/map_layout.hpp"
#include "io/map_raster.hpp"

namespace delone::io {

/// Observations in the map's coordinates, any wrap.
struct MapPoints {
  std::span<const double> x, y;
};

/// Draws the parts of a map, each into its place of the layout. Parts inside the plot are
/// clipped to it.
class MapDrawing {
 public:
  MapDrawing(const MapContent& content, const MapLayout& layout, Canvas& canvas);

  /// The field and, where they are too many to be drawn one by one, the points as pixels
  /// of it.
  void draw_field(const interp::Field& field, const MapPoints& points);
  void draw_graticule(Color color = {125, 125, 125});
  void draw_coast(Color color = {45, 45, 45});
  /// Dots, smaller the more there are; nothing if draw_field() has them.
  void draw_points(const MapPoints& points);
  void draw_note(const std::string& text);
  /// Frame, ticks, labels and, in the plane, the names of the axes.
  void draw_axes();
  void draw_color_bar();
  void draw_title();

 private:
  [[nodiscard]] double scaled(double size) const noexcept { return layout_.scale * size; }
  [[nodiscard]] double line_width(double size) const noexcept;
  [[nodiscard]] CanvasPoint place(double x, double y) const noexcept;
  [[nodiscard]] double wrapped(double x) const noexcept;
  [[nodiscard]] RasterDots dots(const MapPoints& points) const;
  [[nodiscard]] std::string fitted(const std::string& text, double size,
                                   double room) const;
  void draw_frame(CanvasBox box);
  void draw_ticks_below(const CanvasBox& box, std::span<const double> places,
                        std::span<const std::string> labels);
  void draw_ticks_left();
  void draw_ticks_right();
  void draw_names();
  void draw_bar_name(const std::string& text);

  const MapContent& content_;
  const MapLayout& layout_;
  Canvas& canvas_;
};

}  // namespace delone::io
