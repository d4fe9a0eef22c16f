#include "tripack/constrained_crossing.hpp"

#include <algorithm>
#include <cmath>

namespace delone::tripack {

namespace {

double largest(Point2 p) { return std::max(std::abs(p.x), std::abs(p.y)); }

Point2 scaled(Point2 p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
}

struct Range {
  double low, high;
};

// What two intervals have in common; they do have something.
Range common(double a, double b, double c, double d) {
  return {std::max(std::min(a, b), std::min(c, d)),
          std::min(std::max(a, b), std::max(c, d))};
}

double middle(Range r) { return r.low / 2 + r.high / 2; }

double clamped(double v, Range r) { return std::clamp(v, r.low, r.high); }

// The part of a-b up to the crossing. Of lines that are parallel but for rounding any
// point that both boxes hold will do.
double fraction(Point2 a, Point2 b, Point2 c, Point2 d) {
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double vx = d.x - c.x, vy = d.y - c.y;
  const double t = ((c.x - a.x) * vy - (c.y - a.y) * vx) / (ux * vy - uy * vx);
  if (t >= 0 && t <= 1) return t;
  const double px = middle(common(a.x, b.x, c.x, d.x)) - a.x;
  const double py = middle(common(a.y, b.y, c.y, d.y)) - a.y;
  const double s = (px * ux + py * uy) / (ux * ux + uy * uy);
  return s >= 0 && s <= 1 ? s : 0.5;
}

// Of p from the line through a and b.
double distance(Point2 p, Point2 a, Point2 b) {
  const double ux = b.x - a.x, uy = b.y - a.y;
  return std::abs(ux * (p.y - a.y) - uy * (p.x - a.x)) / std::hypot(ux, uy);
}

}  // namespace

Point2 rounded_crossing(Point2 a, Point2 b, Point2 c, Point2 d, double reach) noexcept {
  const Range x = common(a.x, b.x, c.x, d.x), y = common(a.y, b.y, c.y, d.y);
  const auto is_in_both = [&](Point2 p) {
    return clamped(p.x, x) == p.x && clamped(p.y, y) == p.y;
  };
  // To about 1: no product overflows or loses bits.
  const int exponent =
      -std::ilogb(std::max({largest(a), largest(b), largest(c), largest(d)}));
  const Point2 sa = scaled(a, exponent), sb = scaled(b, exponent);
  const Point2 sc = scaled(c, exponent), sd = scaled(d, exponent);
  const double near = std::ldexp(reach, exponent);
  if (is_in_both(a) && distance(sa, sc, sd) <= near) return a;
  if (is_in_both(b) && distance(sb, sc, sd) <= near) return b;
  if (is_in_both(c) && distance(sc, sa, sb) <= near) return c;
  if (is_in_both(d) && distance(sd, sa, sb) <= near) return d;
  const double t = fraction(sa, sb, sc, sd);
  const Point2 p =
      scaled({sa.x + t * (sb.x - sa.x), sa.y + t * (sb.y - sa.y)}, -exponent);
  return {clamped(p.x, x) + 0.0, clamped(p.y, y) + 0.0};
}

}  // namespace delone::tripack
