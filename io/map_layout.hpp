#pragma once

#include <optional>
#include <string>

#include "io/axis_ticks.hpp"
#include "io/canvas.hpp"
#include "io/colormap.hpp"
#include "io/map_frame.hpp"

namespace delone::io {

enum class MapKind : std::uint8_t { plane, globe };

/// A quantity with its units as it is printed; both may be empty.
struct Quantity {
  std::string name, units;
};

/// "name (10³ units)", leaving out what there is not.
[[nodiscard]] std::string quantity_text(const Quantity& quantity, int exponent);

/// What a map shows, before anything has a place.
struct MapContent {
  MapKind kind = MapKind::plane;
  MapFrame frame;
  double aspect = 1;                ///< width over height
  std::optional<ColorScale> scale;  ///< nothing if there are no values
  std::string title;
  Quantity x, y, value;  ///< x and y are printed on plane maps only
  enum class Bar : std::uint8_t { shown, absent };
  Bar bar = Bar::shown;  ///< the room for a colour bar, also of a map without values
};

/// Sizes in pixels of a map 1200 pixels wide, to be multiplied by MapLayout::scale.
namespace map_size {
inline constexpr double margin = 24, title = 25, title_gap = 18;
inline constexpr double label = 19, name = 20, name_gap = 16;
inline constexpr double tick = 7, tick_gap = 7;
inline constexpr double bar = 20, bar_gap = 30;
inline constexpr double capital_height = 0.729;  // of a text of size 1
}  // namespace map_size

/// Where everything goes, in pixels. The plot's box has whole coordinates, so that its
/// pixels are the picture's.
struct MapLayout {
  double scale = 1;
  int width = 0, height = 0;
  CanvasBox plot, bar;
  Reading bar_reading = Reading::across;  ///< below wide plots, else upwards to the right
  Ticks x, y, value;
  double y_label_width = 0, value_label_width = 0;
};

/// The layout of a map `width_px` wide; its height follows from the content. `ruler`
/// measures texts.
[[nodiscard]] MapLayout lay_out(const MapContent& content, int width_px,
                                const Canvas& ruler);

}  // namespace delone::io
