#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "interp/sphere_vector.hpp"

namespace delone::interp {

/// An edge of a spherical triangle as rows of latitude see it.
///
/// Along a row the side of the edge's plane, n . p, is a cosine of longitude plus a
/// constant: the edge leaves out an arc of the row around the meridian opposite to its
/// normal.
struct SphereEdge {
  double x_normal = 0, y_normal = 0, z_normal = 0;  // unit, into the triangle
  double across = 0;                                // length of its horizontal part
  double error = 0;            // bound on that of normal . p, p a unit vector
  double top = 0, bottom = 0;  // sines of the latitudes that the edge spans
  double opposite = 0;         // meridian opposite to the normal, in columns
};

[[nodiscard]] inline SphereEdge sphere_edge(Vector3 a, Vector3 b) noexcept {
  SphereEdge e;
  std::tie(e.bottom, e.top) = std::minmax(a.z, b.z);
  const Vector3 side = b - a;
  const double largest = largest_component(side);  // as small as 5e-324
  const Vector3 upscaled{side.x / largest, side.y / largest, side.z / largest};
  const Vector3 normal = cross(a, upscaled);
  const double squared_size = dot(normal, normal);
  if (!(squared_size > 0)) {
    e.error = 1;
    return e;
  }
  const double per_size = 1 / std::sqrt(squared_size);
  e.x_normal = normal.x * per_size;
  e.y_normal = normal.y * per_size;
  e.z_normal = normal.z * per_size;
  e.across = std::sqrt(e.x_normal * e.x_normal + e.y_normal * e.y_normal);
  // Ends within some units in the last place may differ more in length than in direction.
  e.error = 0x1p-48 * std::max(1.0, 2 * per_size);
  // The great circle's highest (lowest) point is on the arc if z rises (falls) from both
  // ends.
  const double bend = dot(side, side) / 2;
  const double from_a = side.z + bend * a.z, from_b = bend * b.z - side.z;
  if (from_a > 0 && from_b > 0) e.top = std::max(e.top, e.across);
  if (from_a < 0 && from_b < 0) e.bottom = std::min(e.bottom, -e.across);
  return e;
}

/// Might the triangle hold the north (sign +1) or south (-1) pole?
[[nodiscard]] inline bool may_hold_pole(const std::array<SphereEdge, 3>& edges,
                                        double sign) noexcept {
  return std::all_of(edges.begin(), edges.end(),
                     [&](const SphereEdge& e) { return sign * e.z_normal > -e.error; });
}

/// The part of a row that an edge leaves out, in radians of longitude.
struct LeftOut {
  enum class Kind : std::uint8_t { nothing, arc, everything, unknown };
  Kind kind = Kind::arc;
  double half_width = 0;
  double slack = 0;  // bound on the error of its ends
};
[[nodiscard]] inline LeftOut left_out(const SphereEdge& e, double cos_lat,
                                      double sin_lat) noexcept {
  const double amplitude = e.across * cos_lat, constant = e.z_normal * sin_lat;
  if (constant > amplitude + e.error) return {LeftOut::Kind::nothing};
  if (constant < -amplitude - e.error) return {LeftOut::Kind::everything};
  if (amplitude <= 2 * e.error) return {LeftOut::Kind::unknown};
  // n . p < 0 where the cosine of the angle from the opposite meridian is above `cosine`.
  const double cosine = std::max(-1.0, std::min(1.0, constant / amplitude));
  const double error = e.error / amplitude, squared_sine = 1 - cosine * cosine;
  const double slack = squared_sine > 0x1p-10
                           ? 0x1p6 * error
                           : 2 * error / std::sqrt(std::max(squared_sine, error));
  return {LeftOut::Kind::arc, std::acos(cosine), slack};
}

}  // namespace delone::interp
