#include "io/picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "delaunay/error.hpp"
#include "io/coastline.hpp"
#include "io/label_text.hpp"
#include "io/map_drawing.hpp"
#include "io/map_frame.hpp"
#include "io/map_layout.hpp"
#include "io/output_file.hpp"
#include "io/picture_projection.hpp"

namespace delone::io {
namespace {

constexpr int narrowest_px = 200, widest_px = 10000;
constexpr Color ink{38, 38, 38}, white{255, 255, 255}, node_label_color{150, 30, 30},
    cell_label_color{60, 90, 130}, graticule_color{215, 215, 215},
    coast_color{150, 150, 150};

void require(bool holds, const char* message) {
  if (!holds) throw Error(message);
}

void check(const Picture& picture, const PictureOptions& options) {
  for (const auto& [x, y] : picture.dots)
    require(std::isfinite(x) && std::isfinite(y), "picture: a dot is not finite");
  require(options.width_px >= narrowest_px && options.width_px <= widest_px,
          "picture: the width must be 200 to 10000 pixels");
  if (!options.window) return;
  const auto& [west, east, south, north] = *options.window;
  require(std::isfinite(west + east + south + north) && west < east && south < north,
          "picture: the window needs west < east and south < north");
}

/// The sides of a range with a margin; of a single value with room around it.
std::pair<double, double> widened(double low, double high) {
  const double margin =
      high > low ? 0.04 * (high - low) : std::max(1e-3 * std::abs(low), 1e-300);
  return {low - margin, high + margin};
}

MapFrame plane_frame_of(const Picture& picture) {
  if (picture.dots.empty()) return {};
  const auto [left, right] =
      std::ranges::minmax(picture.dots, {}, [](const PicturePoint& p) { return p[0]; });
  const auto [bottom, top] =
      std::ranges::minmax(picture.dots, {}, [](const PicturePoint& p) { return p[1]; });
  const auto [west, east] = widened(left[0], right[0]);
  const auto [south, north] = widened(bottom[1], top[1]);
  require(std::isfinite(2 * (east - west)) && std::isfinite(2 * (north - south)),
          "picture: the dots are too far apart to be drawn");
  return {west, south, east, north, false};
}

/// Longitudes between the two sides of the widest gap; all of them if no gap is wide.
std::pair<double, double> longitudes_of(const Picture& picture) {
  std::vector<double> longitudes;
  for (const PicturePoint& p : picture.dots)
    if (std::abs(p[1]) < 90) longitudes.push_back(std::remainder(p[0], 360));
  if (longitudes.empty()) return {-180, 180};
  std::ranges::sort(longitudes);
  double widest = longitudes.front() + 360 - longitudes.back();
  std::pair<double, double> found{longitudes.front(), longitudes.back()};
  for (std::size_t i = 0; i + 1 < longitudes.size(); ++i) {
    const double gap = longitudes[i + 1] - longitudes[i];
    if (gap <= widest) continue;
    widest = gap;
    found = {longitudes[i + 1], longitudes[i] + 360};
  }
  constexpr double narrowest_gap = 60;
  return widest < narrowest_gap ? std::pair<double, double>{-180, 180}
                                : widened(found.first, found.second);
}

MapFrame globe_frame_of(const Picture& picture) {
  if (picture.dots.empty()) return {-180, -90, 180, 90, true};
  const auto [bottom, top] =
      std::ranges::minmax(picture.dots, {}, [](const PicturePoint& p) { return p[1]; });
  auto [west, east] = longitudes_of(picture);
  auto [south, north] = widened(bottom[1], top[1]);
  const bool is_global = east - west >= 360;
  if (is_global && top[1] - bottom[1] > 120) south = -90, north = 90;
  return {west, std::max(south, -90.0), east, std::min(north, 90.0), is_global};
}

MapContent content_of(const Picture& picture, const PictureOptions& options) {
  const bool is_globe = picture.space == Mesh::Space::globe;
  MapContent content;
  content.kind = is_globe ? MapKind::globe : MapKind::plane;
  content.frame = is_globe ? globe_frame_of(picture) : plane_frame_of(picture);
  if (options.window) {
    const auto& [west, east, south, north] = *options.window;
    content.frame = {west, south, east, north, is_globe && east - west >= 360};
  }
  content.aspect = is_globe ? globe_aspect(content.frame) : plane_aspect(content.frame);
  content.title = printable(options.title);
  content.bar = MapContent::Bar::absent;
  return content;
}

/// Draws lines, dots and labels wherever the projection puts them.
class PictureDrawing {
 public:
  PictureDrawing(const Projection& projection, double scale, Canvas& canvas)
      : projection_(projection), scale_(scale), canvas_(canvas) {}

  void draw_layers(const Picture& picture) {
    for (const PictureLayer& layer : picture.layers)
      draw_lines(layer.lines, {layer.color, scale_ * layer.width});
  }

  void draw_lines(const std::vector<PictureLine>& lines, Stroke stroke) {
    std::vector<CanvasLine> visible;
    for (const PictureLine& line : lines)
      for (CanvasLine& part : projection_.visible(line))
        if (part.size() > 1) visible.push_back(std::move(part));
    canvas_.draw_lines(visible, stroke);
  }

  void draw_dots(const Picture& picture) {
    const double count = static_cast<double>(picture.dots.size()) + 1;
    const double radius = scale_ * std::clamp(60 / std::sqrt(count), 0.6, 3.6);
    const Stroke ring{white, radius > 1.2 * scale_ ? 1.2 * scale_ : 0};
    for (const PicturePoint& dot : picture.dots)
      if (const auto place = projection_.place(dot))
        canvas_.draw_dot(*place, radius, ink, ring);
  }

  void draw_labels(const Picture& picture) {
    const double count = static_cast<double>(picture.labels.size()) + 1;
    const double size = scale_ * std::clamp(320 / std::sqrt(count), 5.0, 17.0);
    for (const PictureLabel& label : picture.labels) {
      const auto place = projection_.place(label.place);
      if (!place) continue;
      const bool is_node = label.kind == PictureLabel::Kind::node;
      const CanvasPoint anchor =
          is_node ? CanvasPoint{place->x + 0.4 * size, place->y - 0.4 * size} : *place;
      canvas_.draw_text(printable(label.text), anchor,
                        {.size = size,
                         .across = is_node ? Align::begin : Align::middle,
                         .along = is_node ? Align::end : Align::middle,
                         .color = is_node ? node_label_color : cell_label_color});
    }
  }

 private:
  const Projection& projection_;
  double scale_;
  Canvas& canvas_;
};

std::string render_frame(const Picture& picture, const PictureOptions& options,
                         PictureFormat format) {
  const MapContent content = content_of(picture, options);
  const bool is_globe = content.kind == MapKind::globe;
  const MapLayout layout =
      lay_out(content, options.width_px, Canvas(PictureFormat::png, 1, 1));
  Canvas canvas(format, layout.width, layout.height);
  MapDrawing map(content, layout, canvas);
  const Projection projection(is_globe ? Projection::Kind::map : Projection::Kind::plane,
                              content.frame, layout.plot);
  PictureDrawing drawing(projection, layout.scale, canvas);
  if (is_globe) {
    map.draw_graticule(graticule_color);
    map.draw_coast(coast_color);
  }
  canvas.clip(layout.plot);
  drawing.draw_layers(picture);
  canvas.unclip();
  drawing.draw_dots(picture);
  drawing.draw_labels(picture);
  map.draw_axes();
  map.draw_title();
  return canvas.finish();
}

std::vector<PictureLine> graticule() {
  constexpr int step = 30;
  std::vector<PictureLine> lines;
  for (int lon = -180; lon < 180; lon += step) {
    auto& line = lines.emplace_back();
    for (int lat = -90; lat <= 90; lat += step)
      line.push_back({static_cast<double>(lon), static_cast<double>(lat)});
  }
  for (int lat = -60; lat <= 60; lat += step) {
    auto& line = lines.emplace_back();
    for (int lon = -180; lon <= 180; lon += 2)
      line.push_back({static_cast<double>(lon), static_cast<double>(lat)});
  }
  return lines;
}

std::vector<PictureLine> coast() {
  std::vector<PictureLine> lines;
  for (const CoastLine& coast_line : coast_in({})) {
    auto& line = lines.emplace_back();
    for (const auto& p : coast_line) line.push_back({p.lon_deg, p.lat_deg});
  }
  return lines;
}

std::string render_globe(const Picture& picture, const PictureOptions& options,
                         PictureFormat format) {
  const double scale = std::max(options.width_px / 1200.0, 0.4);
  const double margin = scale * map_size::margin, title_size = scale * map_size::title;
  const std::string title = printable(options.title);
  const double top =
      margin + (title.empty() ? 0 : title_size + scale * map_size::title_gap);
  const CanvasBox plot{margin, top, options.width_px - 2 * margin,
                       options.width_px - 2 * margin};
  Canvas canvas(format, options.width_px,
                static_cast<int>(std::ceil(plot.bottom() + margin)));
  const Projection projection(*options.view, plot);
  PictureDrawing drawing(projection, scale, canvas);
  drawing.draw_lines(graticule(), {graticule_color, 0.8 * scale});
  drawing.draw_lines(coast(), {coast_color, 1.1 * scale});
  drawing.draw_layers(picture);
  canvas.draw_circle({plot.left + plot.width / 2, plot.top + plot.height / 2},
                     plot.width / 2, {ink, 1.5 * scale});
  drawing.draw_dots(picture);
  drawing.draw_labels(picture);
  canvas.draw_text(title, {options.width_px / 2.0, margin},
                   {.size = title_size, .along = Align::begin});
  return canvas.finish();
}

}  // namespace

std::string render_picture(const Picture& picture, const PictureOptions& options,
                           PictureFormat format) {
  check(picture, options);
  if (options.view && picture.space == Mesh::Space::globe)
    return render_globe(picture, options, format);
  return render_frame(picture, options, format);
}

void write_picture(const std::string& path, const Picture& picture,
                   const PictureOptions& options, const std::string& format) {
  write_text(path, render_picture(picture, options, picture_format(path, format)));
}

}  // namespace delone::io
