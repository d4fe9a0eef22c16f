#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "delaunay/double_double.hpp"
#include "interp/index.hpp"
#include "tripack/point.hpp"

namespace delone::interp {

using delaunay::DoubleDouble;
using tripack::Point2;

/// A corner of a facet: position and value.
struct PlaneCorner {
  Point2 p;
  double value = 0;
};

/// Triangles whose height is below this part of their longest side are evaluated in
/// double-double arithmetic: in plain doubles the error relative to the range of values
/// grows as side / height.
inline constexpr double thin_ratio = 0x1p-6;

/// Is the triangle's height below thin_ratio of its longest side?
[[nodiscard]] bool is_thin(Point2 a, Point2 b, Point2 c) noexcept;

/// A linear function by its value and slopes at a point, kept between two bounds.
struct PlainPlaneFacet {
  Point2 origin;
  double value = 0, x_slope = 0, y_slope = 0, low = 0, high = 0;
};

/// The linear function through three corners, or along two.
///
/// Computed from the first corner, so that constants are reproduced exactly, and kept
/// between the smallest and the largest corner value, which is where it lies in exact
/// arithmetic and where rounding must not take it. Error: some 100 units in the last
/// place of the range of the corner values, for thin triangles too.
class PlaneFacet {
 public:
  /// Corners counter-clockwise. Three that are on one line up to rounding give the
  /// function along their longest side.
  PlaneFacet(const PlaneCorner& a, const PlaneCorner& b, const PlaneCorner& c) noexcept;
  /// Linear from a to b, constant across the axis in which they are farther apart.
  PlaneFacet(const PlaneCorner& a, const PlaneCorner& b) noexcept;

  [[nodiscard]] bool is_thin() const noexcept { return is_thin_; }
  [[nodiscard]] Point2 gradient() const noexcept {
    return {x_slope_.high, y_slope_.high};
  }
  /// The function as it is evaluated; none for thin triangles.
  [[nodiscard]] std::optional<PlainPlaneFacet> formula() const noexcept {
    if (is_thin_) return {};
    return PlainPlaneFacet{origin_, value_, x_slope_.high, y_slope_.high, low_, high_};
  }

  [[nodiscard]] double operator()(Point2 p) const noexcept {
    return is_thin_ ? thin_value(p) : value_in_row(row_start(p.y), p.x);
  }

  /// At places `columns` of `x`, all at one y, into the same places of `row`.
  void fill_row(double* row, const double* x, IndexRange columns,
                double y) const noexcept;

  // The same in two steps, for runs of nodes with one y; facets that are not thin.
  [[nodiscard]] double row_start(double y) const noexcept {
    return value_ + y_slope_.high * (y - origin_.y);
  }
  [[nodiscard]] double value_in_row(double start, double x) const noexcept {
    // min and max in this order also turn NaN (from slopes beyond the largest double)
    // into a bound.
    return std::max(low_, std::min(high_, start + x_slope_.high * (x - origin_.x)));
  }

 private:
  void set_slopes(const PlaneCorner& b, const PlaneCorner& c) noexcept;
  void set_slope_along(const PlaneCorner& a, const PlaneCorner& b) noexcept;
  [[nodiscard]] double thin_value(Point2 p) const noexcept;

  Point2 origin_;
  double value_;
  DoubleDouble x_slope_, y_slope_;
  double low_, high_;
  bool is_thin_ = false;
};

/// Weights of the corners a, b, c (counter-clockwise) at a point of their closed
/// triangle: not negative, sum one up to rounding. Accurate for thin triangles as
/// PlaneFacet is.
[[nodiscard]] std::array<double, 3> corner_weights(Point2 a, Point2 b, Point2 c,
                                                   Point2 p) noexcept;

/// The weight of b at a point of the segment from a to b, 0 .. 1.
[[nodiscard]] double edge_weight(Point2 a, Point2 b, Point2 p) noexcept;

}  // namespace delone::interp
