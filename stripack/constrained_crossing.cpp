#include "stripack/constrained_crossing.hpp"

#include <cmath>

#include "stripack/distance_order.hpp"

namespace delone::stripack {

namespace {

struct Vector {
  double x, y, z;
};

Vector vector(const Direction& d) { return {d.x(), d.y(), d.z()}; }
Vector difference(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Vector a) { return std::hypot(a.x, a.y, a.z); }

// a x b through the difference: accurate for directions that are close.
Vector cross_near(Vector a, Vector b) {
  const Vector d = difference(b, a);
  return {a.y * d.z - a.z * d.y, a.z * d.x - a.x * d.z, a.x * d.y - a.y * d.x};
}

// The distance of p from the plane through the centre, a and b; through p's difference
// from the end that is nearer.
double height(Vector p, Vector a, Vector b) {
  const Vector n = cross_near(a, b);
  const Vector from_a = difference(p, a), from_b = difference(p, b);
  const Vector& near = length(from_a) < length(from_b) ? from_a : from_b;
  return dot(n, near) / length(n);
}

// Are both halves of a-b shorter if it goes through p?
bool shortens(const Direction& p, const Direction& a, const Direction& b) {
  const double whole = squared_chord(a, b);
  return squared_chord(p, a) < whole && squared_chord(p, b) < whole;
}

bool is_near(const Direction& end, const Direction& a, const Direction& b) {
  return shortens(end, a, b) &&
         std::abs(height(vector(end), vector(a), vector(b))) <= 0x1p-50;
}

Direction crossing(const Direction& a, const Direction& b, const Direction& c,
                   const Direction& d) {
  const Vector from = vector(a), to = vector(b), u = vector(c), v = vector(d);
  const double at_a = height(from, u, v), at_b = height(to, u, v);
  const double s = at_a / (at_a - at_b), t = s >= 0 && s <= 1 ? s : 0.5;
  const Vector side = difference(to, from);
  return Direction::from(from.x + t * side.x, from.y + t * side.y, from.z + t * side.z);
}

}  // namespace

Direction rounded_crossing(const Direction& a, const Direction& b, const Direction& c,
                           const Direction& d) {
  if (is_near(a, c, d)) return a;
  if (is_near(b, c, d)) return b;
  if (is_near(c, a, b)) return c;
  if (is_near(d, a, b)) return d;
  const Direction p = crossing(a, b, c, d);
  if (shortens(p, a, b) && shortens(p, c, d)) return p;
  // One of the four angles at the ends is at least a right one, and its corner is nearer
  // to both ends of the other arc than they are to one another.
  if (shortens(a, c, d)) return a;
  if (shortens(b, c, d)) return b;
  if (shortens(c, a, b)) return c;
  return d;
}

}  // namespace delone::stripack
