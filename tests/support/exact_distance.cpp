#include "support/exact_distance.hpp"

#include <gmpxx.h>

#include <cmath>

namespace delone::support {

namespace {

using stripack::Direction;
using tripack::Point2;

mpq_class squared_distance(Point2 p, Point2 a) {
  const mpq_class dx = mpq_class(a.x) - mpq_class(p.x),
                  dy = mpq_class(a.y) - mpq_class(p.y);
  return dx * dx + dy * dy;
}

mpq_class dot(const Direction& a, const Direction& b) {
  return mpq_class(a.x()) * mpq_class(b.x()) + mpq_class(a.y()) * mpq_class(b.y()) +
         mpq_class(a.z()) * mpq_class(b.z());
}

// cos |cos| of the angle between two directions, times the square of |p|: it falls as the
// angle grows.
mpq_class signed_square_of_cosine(const Direction& p, const Direction& a) {
  const mpq_class along = dot(p, a);
  return along * abs(along) / dot(a, a);
}

}  // namespace

int exact_compare_distances(Point2 p, Point2 a, Point2 b) {
  return cmp(squared_distance(p, a), squared_distance(p, b));
}

int exact_compare_distances(const Direction& p, const Direction& a, const Direction& b) {
  return cmp(signed_square_of_cosine(p, b), signed_square_of_cosine(p, a));
}

bool exact_is_within(Point2 p, Point2 a, double radius) {
  if (std::isinf(radius)) return true;
  return squared_distance(p, a) <= mpq_class(radius) * mpq_class(radius);
}

}  // namespace delone::support
