#pragma once

#include <cstdint>

namespace delone::delaunay {

/// How four points lie: the corners of a convex quadrilateral, counter-clockwise, or of a
/// triangle with the last one inside.
enum class FourShape : std::uint8_t { unclear, quadrilateral, triangle };
struct FourCorners {
  FourShape shape = FourShape::unclear;
  std::uint8_t corner[4] = {};
};

/// By the turns of the triples without point 0, 1, 2, 3, none of which is on one line:
/// bit i is set if triple i, its points in order, turns left. Unclear where no points
/// turn so.
struct FourCornerTable {
  FourCorners entry[16];
  [[nodiscard]] constexpr const FourCorners& operator[](unsigned i) const {
    return entry[i];
  }

  constexpr FourCornerTable() : entry{} {
    for (unsigned turns = 0; turns < 16; ++turns)
      for (unsigned order = 0; order < 256; ++order) try_order(turns, order);
  }

 private:
  static constexpr bool is_left(unsigned turns, unsigned a, unsigned b, unsigned c) {
    const bool is_even = (a < b) + (b < c) + (c < a) == 2;
    return ((turns >> (6 - a - b - c) & 1u) != 0) == is_even;
  }
  constexpr void try_order(unsigned turns, unsigned order) {
    const unsigned a = order & 3u, b = order >> 2 & 3u, c = order >> 4 & 3u,
                   d = order >> 6;
    if (((1u << a) | (1u << b) | (1u << c) | (1u << d)) != 15u) return;
    if (!is_left(turns, a, b, c) || !is_left(turns, a, b, d)) return;
    FourShape shape = FourShape::unclear;
    if (is_left(turns, b, c, d))
      shape = is_left(turns, c, a, d)   ? FourShape::triangle
              : is_left(turns, a, c, d) ? FourShape::quadrilateral
                                        : FourShape::unclear;
    if (shape == FourShape::unclear) return;
    entry[turns] = {shape,
                    {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                     static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(d)}};
  }
};
inline constexpr FourCornerTable four_corner_table;

}  // namespace delone::delaunay
