#pragma once

#include <array>
#include <cmath>

#include "stripack/direction.hpp"

/// Vectors of 113 bits, to judge doubles by.
namespace delone::support {

__extension__ typedef __float128 Quad;
using QuadVector = std::array<Quad, 3>;

inline Quad quad_sqrt(Quad v) {
  Quad root = std::sqrt(static_cast<double>(v));
  for (int i = 0; i < 3; ++i) root = (root + v / root) / 2;
  return root;
}

inline Quad dot(const QuadVector& a, const QuadVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline QuadVector cross(const QuadVector& a, const QuadVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

inline QuadVector operator-(const QuadVector& a, const QuadVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline QuadVector unit(const QuadVector& v) {
  const Quad length = quad_sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// The direction that the doubles stand for.
inline QuadVector unit(const stripack::Direction& d) {
  return unit(QuadVector{d.x(), d.y(), d.z()});
}

/// The centre of the circle through three directions, on the side from which they are
/// counter-clockwise.
inline QuadVector circumcenter(const stripack::Direction& a, const stripack::Direction& b,
                               const stripack::Direction& c) {
  const QuadVector u = unit(a);
  return unit(cross(unit(b) - u, unit(c) - u));
}

inline double length(const QuadVector& v) {
  return std::sqrt(static_cast<double>(dot(v, v)));
}

}  // namespace delone::support
