#pragma once

#include <array>
#include <cstdint>

namespace delone::io {

/// A colour of the screen: sRGB, 8 bits a channel.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Color&, const Color&) = default;
};

/// 256 colours from the lowest value to the highest.
using Colormap = std::array<Color, 256>;

/// For values of one sign: viridis by N. J. Smith and S. van der Walt (2015), dedicated
/// to the public domain (CC0). Lightness grows evenly, also for the colour-blind and in
/// grey print.
[[nodiscard]] const Colormap& sequential_colormap() noexcept;

/// For values on both sides of zero: blue, near-white in the middle, red. Equal distances
/// from the middle have equal lightness (in Oklab, B. Ottosson 2020), so neither sign
/// looks stronger than the other.
[[nodiscard]] const Colormap& diverging_colormap() noexcept;

/// Oklab lightness, 0 (black) to 1 (white).
[[nodiscard]] double lightness(Color color) noexcept;

/// Which colour a value has.
class ColorScale {
 public:
  /// Picks the scale for values from `min` to `max` (finite, min <= max). Diverging and
  /// symmetric about zero if min < 0 < max and the two are within a factor of three;
  /// sequential from min to max otherwise. A single value is given room on both sides.
  /// Any finite doubles: nothing overflows.
  [[nodiscard]] static ColorScale choose(double min, double max) noexcept;

  [[nodiscard]] double low() const noexcept { return low_; }
  [[nodiscard]] double high() const noexcept { return high_; }
  [[nodiscard]] const Colormap& colormap() const noexcept { return *colormap_; }
  /// The place of `value` between low (0) and high (1), clamped.
  [[nodiscard]] double position(double value) const noexcept;
  /// The colour of `value` (not NaN).
  [[nodiscard]] Color color(double value) const noexcept;

 private:
  ColorScale(double low, double high, const Colormap& colormap) noexcept
      : low_(low), high_(high), colormap_(&colormap) {}
  double low_, high_;
  const Colormap* colormap_;
};

}  // namespace delone::io
