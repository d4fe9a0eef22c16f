#pragma once

#include <algorithm>
#include <cmath>

#include "stripack/direction.hpp"

namespace delone::interp {

/// A vector of space, for arithmetic with directions.
struct Vector3 {
  double x = 0, y = 0, z = 0;
};
[[nodiscard]] inline Vector3 vector(const stripack::Direction& d) noexcept {
  return {d.x(), d.y(), d.z()};
}
[[nodiscard]] inline Vector3 operator-(Vector3 a, Vector3 b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline Vector3 operator+(Vector3 a, Vector3 b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline Vector3 operator*(double s, Vector3 a) noexcept {
  return {s * a.x, s * a.y, s * a.z};
}
[[nodiscard]] inline double dot(Vector3 a, Vector3 b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Vector3 cross(Vector3 a, Vector3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double largest_component(Vector3 a) noexcept {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}
/// Without underflow.
[[nodiscard]] inline double length(Vector3 a) noexcept {
  const double largest = largest_component(a);
  if (largest == 0) return 0;
  const Vector3 scaled{a.x / largest, a.y / largest, a.z / largest};
  return largest * std::sqrt(dot(scaled, scaled));
}

/// Unit vector towards east; at a pole towards 90 degrees east, as if its longitude were
/// 0.
[[nodiscard]] inline Vector3 east_at(const stripack::Direction& p) noexcept {
  const double across = std::hypot(p.x(), p.y());
  return across == 0 ? Vector3{0, 1, 0} : Vector3{-p.y() / across, p.x() / across, 0};
}

}  // namespace delone::interp
