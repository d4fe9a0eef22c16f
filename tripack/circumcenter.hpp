#pragma once

#include "delaunay/double_double.hpp"
#include "tripack/point.hpp"

/// Where the circumcentre of a triangle lies, as seen from one of its corners. Internal:
/// use tripack/measures.hpp and tripack/voronoi.hpp.
namespace delone::tripack {

struct WidePoint2 {
  delaunay::DoubleDouble x, y;
};

/// Circumcentre minus v to about 2^-85 of the circumradius, slivers and needles included;
/// not finite if the three are on a line. Any scale; exponents of the sides may differ by
/// 2^400.
[[nodiscard]] WidePoint2 circumcenter_offset_wide(Point2 v, Point2 b, Point2 c) noexcept;
[[nodiscard]] Point2 circumcenter_offset_accurate(Point2 v, Point2 b, Point2 c) noexcept;

/// b - v for a neighbour b of v, and its square: what the triangles on both sides of the
/// edge share.
struct Spoke {
  double x, y, square;
};
[[nodiscard]] inline Spoke spoke(Point2 v, Point2 b) noexcept {
  const double x = b.x - v.x, y = b.y - v.y;
  return {x, y, x * x + y * y};
}

/// Circumcentre minus v, with an error below 2^-45 of the circumradius. Where the angle
/// at v is below 7 degrees, rounded differences no longer tell and the wide form is
/// taken.
[[nodiscard]] inline Point2 circumcenter_offset(Point2 v, Point2 b, Point2 c,
                                                const Spoke& to_b,
                                                const Spoke& to_c) noexcept {
  constexpr double squared_sine = 1.0 / 64;
  constexpr double smallest = 0x1p-900, largest = 0x1p900;
  const double det = to_b.x * to_c.y - to_b.y * to_c.x, square = det * det;
  if (square >= squared_sine * (to_b.square * to_c.square) && square > smallest &&
      square < largest) {
    const double scale = 0.5 / det;
    return {(to_c.y * to_b.square - to_b.y * to_c.square) * scale,
            (to_b.x * to_c.square - to_c.x * to_b.square) * scale};
  }
  return circumcenter_offset_accurate(v, b, c);
}

}  // namespace delone::tripack
