#include "interp/plane_facet.hpp"

#include <cmath>
#include <utility>

namespace delone::interp {

namespace {

using delaunay::two_difference;

double squared_length(double x, double y) { return x * x + y * y; }

// Twice the area as long as it is large enough beside the sides to be accurate in
// doubles; else 0.
double plain_area(Point2 a, Point2 b, Point2 c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  const double longest =
      std::max(std::max(squared_length(ux, uy), squared_length(vx, vy)),
               squared_length(vx - ux, vy - uy));
  const double area = ux * vy - uy * vx;
  return area > thin_ratio * longest ? area : 0;
}

// (b - a) x (c - a) to about 100 bits
DoubleDouble accurate_cross(Point2 a, Point2 b, Point2 c) {
  return two_difference(b.x, a.x) * two_difference(c.y, a.y) -
         two_difference(b.y, a.y) * two_difference(c.x, a.x);
}

std::array<double, 3> normalized(double wa, double wb, double wc) {
  wa = std::max(wa, 0.0), wb = std::max(wb, 0.0), wc = std::max(wc, 0.0);
  const double sum = wa + wb + wc;
  return {wa / sum, wb / sum, wc / sum};
}

// The two corners that are farthest apart, the first in order of the corners.
std::pair<std::size_t, std::size_t> longest_side(const std::array<Point2, 3>& p) {
  const auto length = [&](std::size_t i, std::size_t j) {
    return squared_length(p[j].x - p[i].x, p[j].y - p[i].y);
  };
  const double ab = length(0, 1), ac = length(0, 2), bc = length(1, 2);
  if (ab >= ac && ab >= bc) return {0, 1};
  return ac >= bc ? std::pair<std::size_t, std::size_t>{0, 2}
                  : std::pair<std::size_t, std::size_t>{1, 2};
}

}  // namespace

bool is_thin(Point2 a, Point2 b, Point2 c) noexcept { return plain_area(a, b, c) == 0; }

PlaneFacet::PlaneFacet(const PlaneCorner& a, const PlaneCorner& b,
                       const PlaneCorner& c) noexcept
    : origin_(a.p),
      value_(a.value),
      low_(std::min(std::min(a.value, b.value), c.value)),
      high_(std::max(std::max(a.value, b.value), c.value)) {
  const double area = plain_area(a.p, b.p, c.p);
  if (area == 0) {
    set_slopes(b, c);
    return;
  }
  const double ux = b.p.x - a.p.x, uy = b.p.y - a.p.y, vx = c.p.x - a.p.x,
               vy = c.p.y - a.p.y;
  const double zb = b.value - a.value, zc = c.value - a.value;
  x_slope_.high = (zb * vy - zc * uy) / area;
  y_slope_.high = (zc * ux - zb * vx) / area;
}

PlaneFacet::PlaneFacet(const PlaneCorner& a, const PlaneCorner& b) noexcept
    : origin_(a.p),
      value_(a.value),
      low_(std::min(a.value, b.value)),
      high_(std::max(a.value, b.value)) {
  set_slope_along(a, b);
}

void PlaneFacet::set_slopes(const PlaneCorner& b, const PlaneCorner& c) noexcept {
  const PlaneCorner a{origin_, value_};
  const DoubleDouble area = accurate_cross(a.p, b.p, c.p);
  if (!(area.high > 0)) {
    const std::array<PlaneCorner, 3> corners{a, b, c};
    const auto [i, j] = longest_side({a.p, b.p, c.p});
    set_slope_along(corners[i], corners[j]);
    return;
  }
  is_thin_ = true;
  const DoubleDouble zb = two_difference(b.value, a.value),
                     zc = two_difference(c.value, a.value);
  x_slope_ =
      (zb * two_difference(c.p.y, a.p.y) - zc * two_difference(b.p.y, a.p.y)) / area;
  y_slope_ =
      (zc * two_difference(b.p.x, a.p.x) - zb * two_difference(c.p.x, a.p.x)) / area;
}

void PlaneFacet::set_slope_along(const PlaneCorner& a, const PlaneCorner& b) noexcept {
  origin_ = a.p;
  value_ = a.value;
  const double dx = b.p.x - a.p.x, dy = b.p.y - a.p.y, dz = b.value - a.value;
  if (dx == 0 && dy == 0) return;
  (std::abs(dx) >= std::abs(dy) ? x_slope_ : y_slope_).high =
      std::abs(dx) >= std::abs(dy) ? dz / dx : dz / dy;
}

void PlaneFacet::fill_row(double* row, const double* x, IndexRange columns,
                          double y) const noexcept {
  if (is_thin_) {
    for (std::int64_t i = columns.begin; i < columns.end; ++i)
      row[i] = thin_value({x[i], y});
    return;
  }
  const PlaneFacet facet =
      *this;  // a copy that the stores cannot change: kept in registers
  const double start = facet.row_start(y);
  for (std::int64_t i = columns.begin; i < columns.end; ++i)
    row[i] = facet.value_in_row(start, x[i]);
}

double PlaneFacet::thin_value(Point2 p) const noexcept {
  const DoubleDouble rise = x_slope_ * two_difference(p.x, origin_.x) +
                            y_slope_ * two_difference(p.y, origin_.y);
  return std::max(low_, std::min(high_, (DoubleDouble{value_, 0} + rise).rounded()));
}

std::array<double, 3> corner_weights(Point2 a, Point2 b, Point2 c, Point2 p) noexcept {
  if (const double area = plain_area(a, b, c); area > 0) {
    const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
    const double qx = p.x - a.x, qy = p.y - a.y;
    const double wb = (qx * vy - qy * vx) / area, wc = (ux * qy - uy * qx) / area;
    return normalized(1 - wb - wc, wb, wc);
  }
  const DoubleDouble area = accurate_cross(a, b, c);
  if (area.high > 0) {
    return normalized((accurate_cross(p, b, c) / area).rounded(),
                      (accurate_cross(p, c, a) / area).rounded(),
                      (accurate_cross(p, a, b) / area).rounded());
  }
  const std::array<Point2, 3> corners{a, b, c};
  const auto [i, j] = longest_side(corners);
  std::array<double, 3> weights{};
  weights[j] = edge_weight(corners[i], corners[j], p);
  weights[i] = 1 - weights[j];
  return weights;
}

double edge_weight(Point2 a, Point2 b, Point2 p) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  if (dx == 0 && dy == 0) return 0;
  const double t = std::abs(dx) >= std::abs(dy) ? (p.x - a.x) / dx : (p.y - a.y) / dy;
  return std::max(0.0, std::min(1.0, t));
}

}  // namespace delone::interp
