#pragma once

namespace delone::tripack {

/// A position in the plane. Any unit, the same for x and y.
struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

/// The order by x, then y: along any line, and that by which ties are broken.
[[nodiscard]] inline bool lexicographically_less(Point2 a, Point2 b) noexcept {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace delone::tripack
