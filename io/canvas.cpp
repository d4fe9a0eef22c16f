#include "io/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "io/picture_bytes.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

constexpr double points_per_pixel = 0.75;

cairo_status_t append(void* bytes, const unsigned char* data,
                      unsigned int length) noexcept {
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (...) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

cairo_surface_t* make_surface(PictureFormat format, std::string& bytes, int width_px,
                              int height_px) {
  const double width = points_per_pixel * width_px, height = points_per_pixel * height_px;
  switch (format) {
    case PictureFormat::png:
      return cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px);
    case PictureFormat::svg:
      return cairo_svg_surface_create_for_stream(append, &bytes, width, height);
    case PictureFormat::pdf:
      return cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
    case PictureFormat::eps:
      return cairo_ps_surface_create_for_stream(append, &bytes, width, height);
  }
  return nullptr;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw WriteError(std::string("picture cannot be drawn: ") +
                     cairo_status_to_string(status));
}

void set_color(cairo_t* context, Color color) {
  cairo_set_source_rgb(context, color.red / 255.0, color.green / 255.0,
                       color.blue / 255.0);
}

void set_stroke(cairo_t* context, Stroke stroke) {
  set_color(context, stroke.color);
  cairo_set_line_width(context, stroke.width);
}

/// Hinting off: letters have the same widths in every format and at every size.
void set_font(cairo_t* context) {
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

double fraction(Align align) {
  return align == Align::begin ? 0 : align == Align::middle ? 0.5 : 1;
}

std::vector<std::uint32_t> packed(const Raster& raster) {
  std::vector<std::uint32_t> pixels(raster.pixels.size());
  std::transform(raster.pixels.begin(), raster.pixels.end(), pixels.begin(), [](Color c) {
    return static_cast<std::uint32_t>(c.red << 16 | c.green << 8 | c.blue);
  });
  return pixels;
}

}  // namespace

void Canvas::Closer::operator()(_cairo* context) const noexcept {
  cairo_destroy(context);
}
void Canvas::Closer::operator()(_cairo_surface* surface) const noexcept {
  cairo_surface_destroy(surface);
}

Canvas::Canvas(PictureFormat format, int width_px, int height_px)
    : format_(format),
      bytes_(std::make_unique<std::string>()),
      surface_(make_surface(format, *bytes_, width_px, height_px)),
      context_(cairo_create(surface_.get())) {
  check(cairo_surface_status(surface_.get()));
  check(cairo_status(context_.get()));
  if (format == PictureFormat::eps) cairo_ps_surface_set_eps(surface_.get(), 1);
  if (format != PictureFormat::png)
    cairo_scale(context_.get(), points_per_pixel, points_per_pixel);
  set_color(context_.get(), {255, 255, 255});
  cairo_paint(context_.get());
  set_font(context_.get());
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

double Canvas::text_width(const std::string& text, double size) const {
  cairo_text_extents_t extents;
  cairo_set_font_size(context_.get(), size);
  cairo_text_extents(context_.get(), text.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::draw_text(const std::string& text, CanvasPoint anchor,
                       const TextStyle& style) {
  // The height of DejaVu's capitals, so that labels of different letters share a line.
  const double capital_height = 0.729 * style.size;
  const double back = fraction(style.across) * text_width(text, style.size);
  const double down = (1 - fraction(style.along)) * capital_height;
  cairo_t* context = context_.get();
  cairo_save(context);
  cairo_translate(context, anchor.x, anchor.y);
  if (style.reading == Reading::upwards) cairo_rotate(context, -std::numbers::pi / 2);
  set_color(context, style.color);
  cairo_set_font_size(context, style.size);
  cairo_move_to(context, -back, down);
  cairo_show_text(context, text.c_str());
  cairo_restore(context);
}

void Canvas::draw_line(std::span<const CanvasPoint> points, Stroke stroke) {
  cairo_new_path(context_.get());
  for (const CanvasPoint p : points) cairo_line_to(context_.get(), p.x, p.y);
  set_stroke(context_.get(), stroke);
  cairo_stroke(context_.get());
}

void Canvas::draw_lines(std::span<const std::vector<CanvasPoint>> lines, Stroke stroke) {
  // Cairo's time to paint a path grows faster than its length.
  constexpr std::size_t most_together = 400;
  while (!lines.empty()) {
    const auto batch = lines.first(std::min(lines.size(), most_together));
    cairo_new_path(context_.get());
    for (const auto& line : batch) {
      cairo_new_sub_path(context_.get());
      for (const CanvasPoint p : line) cairo_line_to(context_.get(), p.x, p.y);
    }
    set_stroke(context_.get(), stroke);
    cairo_stroke(context_.get());
    lines = lines.subspan(batch.size());
  }
}

void Canvas::draw_circle(CanvasPoint centre, double radius, Stroke stroke) {
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  set_stroke(context_.get(), stroke);
  cairo_stroke(context_.get());
}

void Canvas::draw_segment(CanvasPoint from, CanvasPoint to, Stroke stroke) {
  draw_line(std::array{from, to}, stroke);
}

void Canvas::draw_box(CanvasBox box, Stroke stroke) {
  cairo_rectangle(context_.get(), box.left, box.top, box.width, box.height);
  set_stroke(context_.get(), stroke);
  cairo_stroke(context_.get());
}

void Canvas::draw_dot(CanvasPoint centre, double radius, Color fill, Stroke ring) {
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  if (ring.width > 0) {
    set_stroke(context_.get(), ring);
    cairo_stroke_preserve(context_.get());
  }
  set_color(context_.get(), fill);
  cairo_fill(context_.get());
}

void Canvas::draw_raster(const Raster& raster, CanvasBox box) {
  auto pixels = packed(raster);
  cairo_surface_t* image = cairo_image_surface_create_for_data(
      reinterpret_cast<unsigned char*>(pixels.data()), CAIRO_FORMAT_RGB24, raster.width,
      raster.height, 4 * raster.width);
  cairo_t* context = context_.get();
  cairo_save(context);
  cairo_translate(context, box.left, box.top);
  cairo_scale(context, box.width / raster.width, box.height / raster.height);
  cairo_set_source_surface(context, image, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
  cairo_rectangle(context, 0, 0, raster.width, raster.height);
  cairo_fill(context);
  cairo_restore(context);
  // The vector surfaces took a copy; from here on `pixels` may go.
  cairo_surface_finish(image);
  cairo_surface_destroy(image);
}

void Canvas::draw_gradient(const Colormap& colormap, CanvasBox box, Reading reading) {
  const bool is_upwards = reading == Reading::upwards;
  cairo_pattern_t* pattern =
      is_upwards ? cairo_pattern_create_linear(0, box.bottom(), 0, box.top)
                 : cairo_pattern_create_linear(box.left, 0, box.right(), 0);
  for (std::size_t i = 0; i < colormap.size(); i += 5) {
    const Color c = colormap[i];
    cairo_pattern_add_color_stop_rgb(pattern, static_cast<double>(i) / 255, c.red / 255.0,
                                     c.green / 255.0, c.blue / 255.0);
  }
  cairo_rectangle(context_.get(), box.left, box.top, box.width, box.height);
  cairo_set_source(context_.get(), pattern);
  cairo_fill(context_.get());
  cairo_pattern_destroy(pattern);
}

void Canvas::clip(CanvasBox box) {
  cairo_save(context_.get());
  cairo_rectangle(context_.get(), box.left, box.top, box.width, box.height);
  cairo_clip(context_.get());
}

void Canvas::unclip() { cairo_restore(context_.get()); }

int Canvas::raster_density() const noexcept {
  return format_ == PictureFormat::png ? 1 : 2;
}

std::string Canvas::finish() {
  check(cairo_status(context_.get()));
  if (format_ == PictureFormat::png)
    check(cairo_surface_write_to_png_stream(surface_.get(), append, bytes_.get()));
  if (format_ == PictureFormat::pdf)
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  cairo_surface_finish(surface_.get());
  check(cairo_surface_status(surface_.get()));
  if (format_ == PictureFormat::eps) return without_creation_date(std::move(*bytes_));
  if (format_ == PictureFormat::svg) return with_canonical_ids(*bytes_);
  return std::move(*bytes_);
}

}  // namespace delone::io
