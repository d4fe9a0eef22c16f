#pragma once

namespace delone::tripack {

/// A position in the plane. Any unit, the same for x and y.
struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

}  // namespace delone::tripack
