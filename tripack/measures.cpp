#include "tripack/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delaunay/double_double.hpp"
#include "tripack/circumcenter.hpp"

namespace delone::tripack {

namespace {

using delaunay::DoubleDouble;
using delaunay::two_difference;

double length(Point2 a, Point2 b) { return std::hypot(b.x - a.x, b.y - a.y); }

// (b - a) x (c - a); on a scale at which nothing overflows, which is given back.
struct Cross {
  double value = 0;
  int exponent = 0;  // the cross product is value * 2^exponent
};

Cross cross(Point2 a, Point2 b, Point2 c) {
  DoubleDouble ux = two_difference(b.x, a.x), uy = two_difference(b.y, a.y),
               vx = two_difference(c.x, a.x), vy = two_difference(c.y, a.y);
  const double largest = std::max(
      {std::abs(ux.high), std::abs(uy.high), std::abs(vx.high), std::abs(vy.high)});
  const int exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
  for (DoubleDouble* d : {&ux, &uy, &vx, &vy})
    *d = {std::ldexp(d->high, -exponent), std::ldexp(d->low, -exponent)};
  return {delaunay::determinant(ux, uy, vx, vy).rounded(), 2 * exponent};
}

}  // namespace

TriangleQuality triangle_quality(const Triangulation& t) {
  const auto point = [&](Site s) { return t.points()[static_cast<std::size_t>(s)]; };
  return delaunay::measure_triangles(
      t.adjacency(),
      [&](Site s) {
        return delaunay::Position{point(s).x, point(s).y, 0};
      },
      [&](Site a, Site b) { return length(point(a), point(b)); });
}

double signed_area(Point2 a, Point2 b, Point2 c) noexcept {
  const Cross area2 = cross(a, b, c);
  return std::ldexp(area2.value, area2.exponent - 1);
}

Circle circumcircle(Point2 a, Point2 b, Point2 c) noexcept {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const WidePoint2 offset = circumcenter_offset_wide(a, b, c);
  const double radius = std::hypot(offset.x.rounded(), offset.y.rounded());
  if (!std::isfinite(radius))
    return {{nan, nan}, std::numeric_limits<double>::infinity()};
  return {{(offset.x + DoubleDouble{a.x, 0}).rounded(),
           (offset.y + DoubleDouble{a.y, 0}).rounded()},
          radius};
}

// Corners weighted with the opposite sides.
Circle incircle(Point2 a, Point2 b, Point2 c) noexcept {
  const double p = length(b, c), q = length(c, a), r = length(a, b), sum = p + q + r;
  if (sum == 0) return {a, 0};
  const auto weighted = [&](double u, double v, double w) {
    return u + (q / sum) * (v - u) + (r / sum) * (w - u);
  };
  return {{weighted(a.x, b.x, c.x), weighted(a.y, b.y, c.y)},
          2 * std::abs(signed_area(a, b, c)) / sum};
}

std::array<double, 3> angles(Point2 a, Point2 b, Point2 c) noexcept {
  const Cross area2 = cross(a, b, c);
  const auto angle = [&](Point2 at, Point2 from, Point2 to) {
    const int half = area2.exponent / 2;
    const double ux = std::ldexp(from.x - at.x, -half),
                 uy = std::ldexp(from.y - at.y, -half),
                 vx = std::ldexp(to.x - at.x, -half), vy = std::ldexp(to.y - at.y, -half);
    return std::atan2(std::abs(area2.value), ux * vx + uy * vy);
  };
  return {angle(a, b, c), angle(b, c, a), angle(c, a, b)};
}

double aspect_ratio(Point2 a, Point2 b, Point2 c) noexcept {
  return delaunay::aspect_ratio(angles(a, b, c));
}

}  // namespace delone::tripack
