#include "stripack/arcs.hpp"

#include <algorithm>
#include <cmath>

#include "delaunay/double_double.hpp"
#include "delaunay/error.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using delaunay::DoubleDouble;
using delaunay::two_difference;
using delaunay::two_product;

struct WideVector {
  DoubleDouble x, y, z;
};

WideVector cross(const WideVector& a, const WideVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

WideVector wide(const Direction& a) { return {{a.x(), 0}, {a.y(), 0}, {a.z(), 0}}; }

// a x b, from their difference: nothing cancels however close they are.
WideVector normal(const Direction& a, const Direction& b) {
  return cross(wide(a), {two_difference(b.x(), a.x()), two_difference(b.y(), a.y()),
                         two_difference(b.z(), a.z())});
}

double largest_component(const WideVector& v) {
  return std::max({std::abs(v.x.high), std::abs(v.y.high), std::abs(v.z.high)});
}

// Products of small normals must not underflow.
WideVector scaled(const WideVector& v) {
  const double largest = largest_component(v);
  if (!(largest > 0)) return v;
  const double factor = std::ldexp(1.0, -std::ilogb(largest));
  return {v.x * factor, v.y * factor, v.z * factor};
}

Direction direction(const WideVector& v) {
  const WideVector w = scaled(v);
  return Direction::from(w.x.rounded(), w.y.rounded(), w.z.rounded());
}

Direction opposite(const Direction& d) { return Direction::from(-d.x(), -d.y(), -d.z()); }

bool is_opposite(const Direction& a, const Direction& b) {
  return is_same_direction(a, opposite(b));
}

void check_arc(const Direction& a, const Direction& b) {
  if (is_opposite(a, b))
    throw Error("an arc between opposite points is not unique; give a point in between");
}

double dot(const Direction& a, const Direction& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

int sign_of_dot(const Direction& a, const Direction& b) {
  delaunay::ExactSum<6> sum;
  sum.add(two_product(a.x(), b.x()));
  sum.add(two_product(a.y(), b.y()));
  sum.add(two_product(a.z(), b.z()));
  const double value = sum.rounded().high;
  return static_cast<int>(value > 0) - static_cast<int>(value < 0);
}

bool is_on_arc(const Direction& a, const Direction& b, const Direction& p) {
  return is_same_direction(a, p) || is_same_direction(b, p) ||
         (!is_same_direction(a, b) && is_inside_arc(a, b, p));
}

ArcIntersection at_one_point(Meeting kind, const Direction& p) {
  return {kind, {p, p}, 1};
}

// Ends that lie on the other arc, each position once.
ArcIntersection intersect_at_ends(const Direction& a, const Direction& b,
                                  const Direction& c, const Direction& d) {
  ArcIntersection result;
  const auto add = [&](const Direction& p) {
    for (int i = 0; i < result.num_points; ++i) {
      if (is_same_direction(result.points[static_cast<std::size_t>(i)], p)) return;
    }
    if (result.num_points < 2)
      result.points[static_cast<std::size_t>(result.num_points++)] = p;
  };
  if (is_on_arc(c, d, a)) add(a);
  if (is_on_arc(c, d, b)) add(b);
  if (is_on_arc(a, b, c)) add(c);
  if (is_on_arc(a, b, d)) add(d);
  if (result.num_points == 1) return at_one_point(Meeting::touch, result.points[0]);
  if (result.num_points == 2) result.kind = Meeting::overlap;
  return result;
}

// The sense of n is chosen so that it lies on the side of a and b.
Direction on_side_of(const Direction& n, const Direction& a, const Direction& b) {
  return dot(n, a) + dot(n, b) >= 0 ? n : opposite(n);
}

}  // namespace

ArcIntersection intersect(const Direction& a, const Direction& b, const Direction& c,
                          const Direction& d) {
  check_arc(a, b);
  check_arc(c, d);
  ArcIntersection ends = intersect_at_ends(a, b, c, d);
  if (ends.num_points > 0) return ends;
  const int side = orientation(a, b, d);
  const bool is_crossing = side != 0 && orientation(a, b, c) == -side &&
                           orientation(c, d, a) == side && orientation(c, d, b) == -side;
  if (!is_crossing) return {};
  const Direction p = direction(cross(scaled(normal(a, b)), scaled(normal(c, d))));
  return at_one_point(Meeting::cross, on_side_of(p, a, b));
}

std::optional<Direction> intersect_great_circle(const Direction& pole, const Direction& a,
                                                const Direction& b) {
  check_arc(a, b);
  const int u = sign_of_dot(pole, a), v = sign_of_dot(pole, b);
  if (u == 0 && v == 0) return is_same_direction(a, b) ? std::optional(a) : std::nullopt;
  if (u == 0) return a;
  if (v == 0) return b;
  if (u == v) return std::nullopt;
  const Direction p = direction(cross(scaled(normal(a, b)), wide(pole)));
  return on_side_of(p, a, b);
}

Direction pole_of(const Direction& a, const Direction& b) {
  check_arc(a, b);
  if (is_same_direction(a, b)) throw Error("one point has no great circle");
  return direction(normal(a, b));
}

Direction midpoint(const Direction& a, const Direction& b) {
  check_arc(a, b);
  return Direction::from(a.x() + b.x(), a.y() + b.y(), a.z() + b.z());
}

}  // namespace delone::stripack
