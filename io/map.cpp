#include "io/map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "delaunay/error.hpp"
#include "io/label_text.hpp"
#include "io/map_drawing.hpp"
#include "io/map_frame.hpp"
#include "io/map_layout.hpp"
#include "io/output_file.hpp"

namespace delone::io {
namespace {

constexpr int narrowest_px = 200, widest_px = 10000;

void require(bool holds, const char* message) {
  if (!holds) throw Error(message);
}

void check(const interp::Axis& axis) {
  require(axis.size >= 1, "map: the grid has no nodes");
  require(std::isfinite(axis.spacing) && axis.spacing > 0,
          "map: the spacing of the grid must be a positive number");
  const double length = axis.spacing * static_cast<double>(axis.size);
  require(std::isfinite(2 * axis.coordinate(0)) && std::isfinite(2 * length) &&
              std::isfinite(2 * axis.coordinate(axis.size - 1)),
          "map: the coordinates of the grid must be finite");
}

void check(const interp::Field& field, const MapOptions& options) {
  check(field.grid.x);
  check(field.grid.y);
  require(field.grid.size() == static_cast<std::int64_t>(field.values.size()),
          "map: the grid needs one value a node");
  require(options.point_x.size() == options.point_y.size(),
          "map: points need as many x as y");
  require(options.width_px >= narrowest_px && options.width_px <= widest_px,
          "map: the width must be 200 to 10000 pixels");
}

/// Nothing if every value is missing.
std::optional<ColorScale> scale_of(const std::vector<double>& values) {
  double min = 0, max = 0;
  bool is_empty = true;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    min = is_empty ? value : std::min(min, value);
    max = is_empty ? value : std::max(max, value);
    is_empty = false;
  }
  if (is_empty) return std::nullopt;
  return ColorScale::choose(min, max);
}

std::string first_of(std::initializer_list<std::string> texts) {
  for (const std::string& text : texts)
    if (!text.empty()) return printable(text);
  return "";
}

/// Empty if the long name is but the name of a column once more.
std::string own_long_name(const GridInfo& info) {
  return info.long_name == info.name ? "" : info.long_name;
}

/// "geoid (m)" for a column geoid_m.
std::string readable_name(const GridInfo& info) {
  return quantity_text({printed_name(printable(info.name), info.units),
                        printed_units(printable(info.units))},
                       0);
}

/// What the colour bar says: the variable's long name, or its short one where the title
/// says the long one already.
std::string value_name(const GridInfo& info, const std::string& title) {
  const std::string long_name = printable(own_long_name(info));
  if (!long_name.empty() && long_name != title) return long_name;
  return printed_name(printable(info.name), info.units);
}

MapContent content_of(const GridFile& grid, const MapOptions& options) {
  const GridInfo& info = grid.info;
  MapContent content;
  content.kind = info.is_lonlat ? MapKind::globe : MapKind::plane;
  content.frame =
      info.is_lonlat ? globe_frame(grid.field.grid) : plane_frame(grid.field.grid);
  content.aspect =
      info.is_lonlat ? globe_aspect(content.frame) : plane_aspect(content.frame);
  content.scale = scale_of(grid.field.values);
  content.title =
      first_of({options.title, info.title, own_long_name(info), readable_name(info)});
  content.x = {first_of({info.x_name, "x"}), printed_units(printable(info.x_units))};
  content.y = {first_of({info.y_name, "y"}), printed_units(printable(info.y_units))};
  content.value = {value_name(info, content.title), printed_units(printable(info.units))};
  return content;
}

}  // namespace

std::string render_map(const GridFile& grid, const MapOptions& options,
                       PictureFormat format) {
  check(grid.field, options);
  const MapContent content = content_of(grid, options);
  const MapLayout layout =
      lay_out(content, options.width_px, Canvas(PictureFormat::png, 1, 1));
  Canvas canvas(format, layout.width, layout.height);
  MapDrawing drawing(content, layout, canvas);
  const auto points =
      options.draw_points ? MapPoints{options.point_x, options.point_y} : MapPoints{};
  drawing.draw_field(grid.field, points);
  if (content.kind == MapKind::globe) {
    drawing.draw_graticule();
    drawing.draw_coast();
  }
  drawing.draw_points(points);
  drawing.draw_axes();
  drawing.draw_title();
  if (content.scale)
    drawing.draw_color_bar();
  else
    drawing.draw_note("no values");
  return canvas.finish();
}

void write_map(const std::string& path, const GridFile& grid, const MapOptions& options,
               const std::string& format) {
  write_text(path, render_map(grid, options, picture_format(path, format)));
}

}  // namespace delone::io
