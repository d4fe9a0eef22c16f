#include "tripack/segments.hpp"

#include <algorithm>
#include <cmath>

#include "delaunay/double_double.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {

namespace {

using delaunay::DoubleDouble;
using delaunay::two_difference;

Intersection at_one_point(Meeting kind, Point2 p) { return {kind, {p, p}, 1}; }

// All four on one line: intervals in lexicographic order.
Intersection intersect_collinear(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (lexicographically_less(b, a)) std::swap(a, b);
  if (lexicographically_less(d, c)) std::swap(c, d);
  const Point2 from = lexicographically_less(a, c) ? c : a,
               to = lexicographically_less(b, d) ? b : d;
  if (lexicographically_less(to, from)) return {};
  if (from == to) return at_one_point(Meeting::touch, from);
  return {Meeting::overlap, {from, to}, 2};
}

bool is_between(Point2 a, Point2 b, Point2 p) {
  return lexicographically_less(a, b)
             ? !lexicographically_less(p, a) && !lexicographically_less(b, p)
             : !lexicographically_less(p, b) && !lexicographically_less(a, p);
}

// The bounding boxes of a-b and c-d have a point in common.
bool boxes_meet(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  return !apart(a.x, b.x, c.x, d.x) && !apart(a.y, b.y, c.y, d.y);
}

// a-b reaches both sides of the line c-d, or that line.
struct Sides {
  int a, b, c, d;  // of a and b beside c -> d, of c and d beside a -> b
};

Sides sides_of(Point2 a, Point2 b, Point2 c, Point2 d) {
  return {orientation(c, d, a), orientation(c, d, b), orientation(a, b, c),
          orientation(a, b, d)};
}

DoubleDouble cross(Point2 from, Point2 to, Point2 origin, Point2 end) {
  return delaunay::determinant(two_difference(to.x, from.x), two_difference(to.y, from.y),
                               two_difference(end.x, origin.x),
                               two_difference(end.y, origin.y));
}

// a + (b - a) part / whole
Point2 crossing_point(Point2 a, Point2 b, Point2 c, Point2 d) {
  const DoubleDouble part = cross(a, c, c, d), whole = cross(a, b, c, d);
  const DoubleDouble t = part / whole;
  const auto along = [&](double from, double to) {
    const double v = (DoubleDouble{from, 0} + two_difference(to, from) * t).rounded();
    return std::clamp(v, std::min(from, to), std::max(from, to));
  };
  return {along(a.x, b.x), along(a.y, b.y)};
}

Point2 times(Point2 p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
}

// From the shorter segment, on a scale at which no product overflows.
Point2 crossing_point_scaled(Point2 a, Point2 b, Point2 c, Point2 d) {
  const double first = std::hypot(b.x / 2 - a.x / 2, b.y / 2 - a.y / 2),
               second = std::hypot(d.x / 2 - c.x / 2, d.y / 2 - c.y / 2);
  if (second < first) {
    std::swap(a, c);
    std::swap(b, d);
  }
  const double longer = std::max(first, second);
  const int exponent = longer > 0 ? std::ilogb(longer) : 0;
  if (std::abs(exponent) < 200) return crossing_point(a, b, c, d);
  return times(crossing_point(times(a, -exponent), times(b, -exponent),
                              times(c, -exponent), times(d, -exponent)),
               exponent);
}

}  // namespace

Intersection intersect(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  if (!boxes_meet(a, b, c, d)) return {};
  const Sides s = sides_of(a, b, c, d);
  if (s.a == 0 && s.b == 0 && s.c == 0 && s.d == 0)
    return intersect_collinear(a, b, c, d);
  if (s.a * s.b > 0 || s.c * s.d > 0) return {};
  if (s.a == 0 && is_between(c, d, a)) return at_one_point(Meeting::touch, a);
  if (s.b == 0 && is_between(c, d, b)) return at_one_point(Meeting::touch, b);
  if (s.c == 0 && is_between(a, b, c)) return at_one_point(Meeting::touch, c);
  if (s.d == 0 && is_between(a, b, d)) return at_one_point(Meeting::touch, d);
  if (s.a * s.b < 0 && s.c * s.d < 0)
    return at_one_point(Meeting::cross, crossing_point_scaled(a, b, c, d));
  return {};
}

Meeting meeting(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  return intersect(a, b, c, d).kind;
}

}  // namespace delone::tripack
