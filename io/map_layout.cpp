#include "io/map_layout.hpp"

#include <algorithm>
#include <cmath>

#include "io/label_text.hpp"

namespace delone::io {
namespace {

// Plots at least so much wider than high have their colour bar below.
constexpr double wide_aspect = 1.45;
// A plot is at most so much higher than the picture is wide.
constexpr double tallest = 1.05;

struct Margins {
  double left = 0, top = 0, right = 0, bottom = 0;
};

class LayoutMaker {
 public:
  LayoutMaker(const MapContent& content, int width_px, const Canvas& ruler)
      : content_(content), ruler_(ruler) {
    layout_.width = width_px;
    layout_.scale = std::max(width_px / 1200.0, 0.4);
    layout_.bar_reading =
        content.aspect >= wide_aspect ? Reading::across : Reading::upwards;
  }

  /// The margins hang on the widths of the labels, these on the ticks, these on the size
  /// of the plot and so on the margins. Three rounds settle it: the first guess is close,
  /// and only the number of digits matters.
  MapLayout make() {
    for (int round = 0; round < 3; ++round) {
      place_boxes(margins());
      choose_ticks();
    }
    place_boxes(margins());
    return layout_;
  }

 private:
  [[nodiscard]] double scaled(double size) const { return layout_.scale * size; }

  [[nodiscard]] double widest(const Ticks& ticks) const {
    double width = 0;
    for (const std::string& label : ticks.labels)
      width = std::max(width, ruler_.text_width(label, scaled(map_size::label)));
    return width;
  }

  /// From the side of a box to the far side of its tick labels.
  [[nodiscard]] double label_room(double label_extent) const {
    return scaled(map_size::tick + map_size::tick_gap) + label_extent;
  }

  [[nodiscard]] double label_height() const {
    return scaled(map_size::label * map_size::capital_height);
  }

  [[nodiscard]] double name_room(const std::string& text) const {
    if (text.empty()) return 0;
    return scaled(map_size::name_gap + map_size::name * map_size::capital_height);
  }

  [[nodiscard]] double bar_name_room() const {
    return name_room(quantity_text(content_.value, layout_.value.exponent));
  }

  [[nodiscard]] Margins margins() const {
    Margins m;
    const double margin = scaled(map_size::margin);
    const bool is_plane = content_.kind == MapKind::plane;
    m.top = margin;
    if (!content_.title.empty())
      m.top += scaled(map_size::title * map_size::capital_height + map_size::title_gap);
    m.left = margin + label_room(layout_.y_label_width) +
             (is_plane ? name_room(quantity_text(content_.y, 0)) : 0);
    m.right = std::max(margin, widest(layout_.x) / 2 + scaled(6));
    m.bottom = margin + label_room(label_height()) +
               (is_plane ? name_room(quantity_text(content_.x, 0)) : 0);
    if (content_.bar == MapContent::Bar::absent) return m;
    const double bar_side = scaled(map_size::bar + map_size::bar_gap) + bar_name_room();
    if (layout_.bar_reading == Reading::across)
      m.bottom += bar_side + label_room(label_height());
    else
      m.right = margin + bar_side + label_room(layout_.value_label_width);
    return m;
  }

  void place_boxes(const Margins& m) {
    CanvasBox& plot = layout_.plot;
    const double room = std::max(layout_.width - m.left - m.right, 16.0);
    plot.height = std::round(std::min(room / content_.aspect, tallest * layout_.width));
    plot.height = std::max(plot.height, 16.0);
    plot.width = std::round(std::min(room, plot.height * content_.aspect));
    plot.left = std::round(m.left + (room - plot.width) / 2);
    plot.top = std::round(m.top);
    layout_.height = static_cast<int>(std::ceil(plot.bottom() + m.bottom));
    layout_.bar = layout_.bar_reading == Reading::across ? bar_below(m) : bar_beside();
  }

  [[nodiscard]] CanvasBox bar_below(const Margins& m) const {
    const CanvasBox& plot = layout_.plot;
    const double height = std::round(scaled(map_size::bar));
    const double width = std::round(0.62 * plot.width);
    // From the bottom of the picture upwards: margin, name, labels, bar.
    const double below =
        scaled(map_size::margin) + bar_name_room() + label_room(label_height());
    return {std::round(plot.left + (plot.width - width) / 2),
            std::round(plot.bottom() + m.bottom - below - height), width, height};
  }

  [[nodiscard]] CanvasBox bar_beside() const {
    const CanvasBox& plot = layout_.plot;
    return {std::round(plot.right() + scaled(map_size::bar_gap)), plot.top,
            std::round(scaled(map_size::bar)), plot.height};
  }

  /// The most ticks, up to `most`, whose labels stand side by side with room between
  /// them. `place` gives a value's place on the axis in pixels.
  template <typename MakeTicks, typename Place>
  requires std::invocable<MakeTicks, int> && std::invocable<Place, double>
  [[nodiscard]] Ticks fitting(int most, const MakeTicks& make_ticks,
                              const Place& place) const {
    for (int count = most; count > 2; --count) {
      const Ticks ticks = make_ticks(count);
      if (ticks.values.size() < 2) return ticks;
      const double step = place(ticks.values[1]) - place(ticks.values[0]);
      if (widest(ticks) + scaled(0.9 * map_size::label) <= step) return ticks;
    }
    return make_ticks(2);
  }

  /// How many ticks an upright axis takes without looking crowded.
  [[nodiscard]] int ticks_along(double length) const {
    return std::clamp(static_cast<int>(length / scaled(70)), 2, 12);
  }

  void choose_ticks() {
    const MapFrame& frame = content_.frame;
    const bool is_globe = content_.kind == MapKind::globe;
    const auto x_ticks = is_globe ? longitude_ticks : linear_ticks;
    const auto y_ticks = is_globe ? latitude_ticks : linear_ticks;
    const double pixels_per_unit = layout_.plot.width / (frame.east - frame.west);
    layout_.x = fitting(
        13, [&](int count) { return x_ticks(frame.west, frame.east, count); },
        [&](double x) { return pixels_per_unit * x; });
    layout_.y = y_ticks(frame.south, frame.north, ticks_along(layout_.plot.height));
    layout_.y_label_width = widest(layout_.y);
    if (content_.scale) choose_value_ticks(*content_.scale);
  }

  void choose_value_ticks(const ColorScale& scale) {
    const auto make_ticks = [&](int count) {
      return linear_ticks(scale.low(), scale.high(), count);
    };
    layout_.value = layout_.bar_reading == Reading::upwards
                        ? make_ticks(ticks_along(layout_.bar.height))
                        : fitting(9, make_ticks, [&](double value) {
                            return layout_.bar.width * scale.position(value);
                          });
    layout_.value_label_width = widest(layout_.value);
  }

  const MapContent& content_;
  const Canvas& ruler_;
  MapLayout layout_;
};

}  // namespace

std::string quantity_text(const Quantity& quantity, int exponent) {
  const std::string factor = exponent == 0 ? "" : power_of_ten(exponent);
  const bool needs_blank = !factor.empty() && !quantity.units.empty();
  const std::string units = factor + (needs_blank ? " " : "") + quantity.units;
  if (units.empty()) return quantity.name;
  return quantity.name.empty() ? units : quantity.name + " (" + units + ")";
}

MapLayout lay_out(const MapContent& content, int width_px, const Canvas& ruler) {
  return LayoutMaker(content, width_px, ruler).make();
}

}  // namespace delone::io
