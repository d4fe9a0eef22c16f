#include "io/map_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "io/coastline.hpp"
#include "io/label_text.hpp"

namespace delone::io {
namespace {

constexpr Color ink{38, 38, 38};
constexpr Color white{255, 255, 255};

// More dots than this cannot be told apart, and make vector files of hundreds of
// megabytes.
constexpr std::size_t most_drawn_points = 20000;

/// The middle of the pixel: a line of whole width is sharp there.
double pixel_centre(double place) { return std::floor(place) + 0.5; }

}  // namespace

MapDrawing::MapDrawing(const MapContent& content, const MapLayout& layout, Canvas& canvas)
    : content_(content), layout_(layout), canvas_(canvas) {}

/// Of whole pixels from the width where that makes no visible difference to the weight.
double MapDrawing::line_width(double size) const noexcept {
  return std::max(1.0, std::round(scaled(size)));
}

CanvasPoint MapDrawing::place(double x, double y) const noexcept {
  const auto& [west, south, east, north, is_closed] = content_.frame;
  const CanvasBox& plot = layout_.plot;
  return {plot.left + (x - west) / (east - west) * plot.width,
          plot.top + (north - y) / (north - south) * plot.height};
}

/// A longitude in the turn that starts at the western side; on the plane `x` itself.
double MapDrawing::wrapped(double x) const noexcept {
  if (content_.kind == MapKind::plane) return x;
  return x + 360 * std::ceil((content_.frame.west - x) / 360);
}

std::string MapDrawing::fitted(const std::string& text, double size, double room) const {
  if (canvas_.text_width(text, size) <= room) return text;
  const auto cut = [&text](std::size_t num_bytes) {
    return std::string(first_bytes(text, num_bytes)) + "…";
  };
  std::size_t fits = 0, too_long = text.size();
  while (too_long - fits > 1) {
    const std::size_t middle = fits + (too_long - fits) / 2;
    (canvas_.text_width(cut(middle), size) <= room ? fits : too_long) = middle;
  }
  return cut(fits);
}

RasterDots MapDrawing::dots(const MapPoints& points) const {
  const int pixel = canvas_.raster_density();
  RasterDots dots{{}, {}, std::max(pixel, static_cast<int>(scaled(pixel))), ink};
  const auto& [west, south, east, north, is_closed] = content_.frame;
  for (const double x : points.x)
    dots.right.push_back((wrapped(x) - west) / (east - west));
  for (const double y : points.y) dots.up.push_back((y - south) / (north - south));
  return dots;
}

void MapDrawing::draw_field(const interp::Field& field, const MapPoints& points) {
  const int density = canvas_.raster_density();
  // Without any value the colours of the scale do not matter: everything is blank.
  Raster raster =
      rasterize(field, content_.frame, content_.scale.value_or(ColorScale::choose(0, 1)),
                density * static_cast<int>(layout_.plot.width),
                density * static_cast<int>(layout_.plot.height));
  if (points.x.size() > most_drawn_points)
    raster = with_dots(std::move(raster), dots(points));
  canvas_.draw_raster(raster, layout_.plot);
}

void MapDrawing::draw_graticule(Color color) {
  canvas_.clip(layout_.plot);
  const Stroke stroke{color, scaled(0.6)};
  const auto& [west, south, east, north, is_closed] = content_.frame;
  for (const double lon : layout_.x.values)
    canvas_.draw_segment(place(lon, south), place(lon, north), stroke);
  for (const double lat : layout_.y.values)
    canvas_.draw_segment(place(west, lat), place(east, lat), stroke);
  canvas_.unclip();
}

void MapDrawing::draw_coast(Color color) {
  canvas_.clip(layout_.plot);
  const auto& [west, south, east, north, is_closed] = content_.frame;
  std::vector<CanvasPoint> points;
  for (const CoastLine& line : coast_in({west, south, east, north})) {
    points.clear();
    for (const auto& p : line) points.push_back(place(p.lon_deg, p.lat_deg));
    canvas_.draw_line(points, {color, std::max(0.7, scaled(1.1))});
  }
  canvas_.unclip();
}

void MapDrawing::draw_points(const MapPoints& points) {
  const auto& [x, y] = points;
  if (x.empty() || x.size() > most_drawn_points) return;
  const double count = static_cast<double>(x.size());
  const double radius = scaled(std::clamp(60 / std::sqrt(count), 0.75, 3.2));
  const Stroke ring{white, radius > scaled(1.2) ? scaled(1.2) : 0};
  const CanvasBox& plot = layout_.plot;
  canvas_.clip(plot);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const CanvasPoint p = place(wrapped(x[i]), y[i]);
    // False for NaN too.
    const bool is_near = p.x >= plot.left - radius && p.x <= plot.right() + radius &&
                         p.y >= plot.top - radius && p.y <= plot.bottom() + radius;
    if (is_near) canvas_.draw_dot(p, radius, ink, ring);
  }
  canvas_.unclip();
}

void MapDrawing::draw_note(const std::string& text) {
  const CanvasBox& plot = layout_.plot;
  canvas_.draw_text(text, {plot.left + plot.width / 2, plot.top + plot.height / 2},
                    {.size = scaled(map_size::name)});
}

/// Outside the box, so that it hides no pixel.
void MapDrawing::draw_frame(CanvasBox box) {
  const double width = line_width(1.2);
  canvas_.draw_box(
      {box.left - width / 2, box.top - width / 2, box.width + width, box.height + width},
      {ink, width});
}

void MapDrawing::draw_ticks_below(const CanvasBox& box, std::span<const double> places,
                                  std::span<const std::string> labels) {
  const double tick = scaled(map_size::tick);
  const double label_top = box.bottom() + tick + scaled(map_size::tick_gap);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double x = pixel_centre(places[i]);
    canvas_.draw_segment({x, box.bottom()}, {x, box.bottom() + tick},
                         {ink, line_width(1.2)});
    canvas_.draw_text(labels[i], {x, label_top},
                      {.size = scaled(map_size::label), .along = Align::begin});
  }
}

void MapDrawing::draw_ticks_left() {
  const double tick = scaled(map_size::tick), gap = scaled(map_size::tick_gap);
  const double left = layout_.plot.left;
  for (std::size_t i = 0; i < layout_.y.values.size(); ++i) {
    const double y = pixel_centre(place(content_.frame.west, layout_.y.values[i]).y);
    canvas_.draw_segment({left - tick, y}, {left, y}, {ink, line_width(1.2)});
    canvas_.draw_text(layout_.y.labels[i], {left - tick - gap, y},
                      {.size = scaled(map_size::label), .across = Align::end});
  }
}

void MapDrawing::draw_axes() {
  std::vector<double> places;
  for (const double x : layout_.x.values)
    places.push_back(place(x, content_.frame.south).x);
  draw_ticks_below(layout_.plot, places, layout_.x.labels);
  draw_ticks_left();
  draw_frame(layout_.plot);
  if (content_.kind == MapKind::plane) draw_names();
}

void MapDrawing::draw_names() {
  const CanvasBox& plot = layout_.plot;
  const double size = scaled(map_size::name);
  const double labels = scaled(map_size::tick + map_size::tick_gap);
  const double gap = scaled(map_size::name_gap);
  const double label_height = scaled(map_size::label * map_size::capital_height);
  canvas_.draw_text(
      fitted(quantity_text(content_.x, layout_.x.exponent), size, plot.width),
      {plot.left + plot.width / 2, plot.bottom() + labels + label_height + gap},
      {.size = size, .along = Align::begin});
  canvas_.draw_text(
      fitted(quantity_text(content_.y, layout_.y.exponent), size, plot.height),
      {plot.left - labels - layout_.y_label_width - gap, plot.top + plot.height / 2},
      {.size = size, .along = Align::end, .reading = Reading::upwards});
}

void MapDrawing::draw_ticks_right() {
  const CanvasBox& bar = layout_.bar;
  const double tick = scaled(map_size::tick), gap = scaled(map_size::tick_gap);
  for (std::size_t i = 0; i < layout_.value.values.size(); ++i) {
    const double up = content_.scale->position(layout_.value.values[i]);
    const double y = pixel_centre(bar.bottom() - up * bar.height);
    canvas_.draw_segment({bar.right(), y}, {bar.right() + tick, y},
                         {ink, line_width(1.2)});
    canvas_.draw_text(layout_.value.labels[i], {bar.right() + tick + gap, y},
                      {.size = scaled(map_size::label), .across = Align::begin});
  }
}

void MapDrawing::draw_bar_name(const std::string& text) {
  const CanvasBox& bar = layout_.bar;
  const double size = scaled(map_size::name);
  const double labels = scaled(map_size::tick + map_size::tick_gap);
  const double gap = scaled(map_size::name_gap);
  if (layout_.bar_reading == Reading::across) {
    const double label_height = scaled(map_size::label * map_size::capital_height);
    canvas_.draw_text(
        fitted(text, size, layout_.plot.width),
        {bar.left + bar.width / 2, bar.bottom() + labels + label_height + gap},
        {.size = size, .along = Align::begin});
  } else {
    canvas_.draw_text(fitted(text, size, bar.height),
                      {bar.right() + labels + layout_.value_label_width + gap,
                       bar.top + bar.height / 2},
                      {.size = size, .along = Align::begin, .reading = Reading::upwards});
  }
}

void MapDrawing::draw_color_bar() {
  const CanvasBox& bar = layout_.bar;
  canvas_.draw_gradient(content_.scale->colormap(), bar, layout_.bar_reading);
  std::vector<double> places;
  for (const double value : layout_.value.values)
    places.push_back(bar.left + content_.scale->position(value) * bar.width);
  if (layout_.bar_reading == Reading::across)
    draw_ticks_below(bar, places, layout_.value.labels);
  else
    draw_ticks_right();
  draw_frame(bar);
  draw_bar_name(quantity_text(content_.value, layout_.value.exponent));
}

void MapDrawing::draw_title() {
  const double size = scaled(map_size::title);
  const double room = layout_.width - 2 * scaled(map_size::margin);
  const std::string text = fitted(content_.title, size, room);
  // Over the middle of the plot, unless it would leave the picture.
  const double half = canvas_.text_width(text, size) / 2 + scaled(map_size::margin);
  const double middle = layout_.plot.left + layout_.plot.width / 2;
  canvas_.draw_text(text,
                    {std::clamp(middle, half, std::max(half, layout_.width - half)),
                     scaled(map_size::margin)},
                    {.size = size, .along = Align::begin});
}

}  // namespace delone::io
