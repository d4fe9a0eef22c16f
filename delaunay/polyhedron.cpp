#include "delaunay/polyhedron.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "delaunay/double_double.hpp"
#include "delaunay/error.hpp"

namespace delone::delaunay {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using WidePosition = std::array<DoubleDouble, 3>;

WidePosition difference(const Position& a, const Position& b) {
  return {two_difference(a[0], b[0]), two_difference(a[1], b[1]),
          two_difference(a[2], b[2])};
}

WidePosition cross(const WidePosition& a, const WidePosition& b) {
  return {determinant(a[1], a[2], b[1], b[2]), determinant(a[2], a[0], b[2], b[0]),
          determinant(a[0], a[1], b[0], b[1])};
}

DoubleDouble dot(const WidePosition& a, const WidePosition& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void check(std::span<const Position> corners, std::span<const PolyhedronFace> faces) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const std::int32_t c : faces[f]) {
      if (c >= 0 && static_cast<std::size_t>(c) < corners.size()) continue;
      throw Error("face " + std::to_string(f) + " has the corner " + std::to_string(c) +
                      ", but there are " + std::to_string(corners.size()),
                  {static_cast<std::int64_t>(f)});
    }
  }
}

/// Sums over the tetrahedra between the first corner and the triangles of all faces.
struct Moments {
  DoubleDouble volume6;
  WidePosition moment24;

  void add(const WidePosition& a, const WidePosition& b, const WidePosition& c) {
    const DoubleDouble part = dot(a, cross(b, c));
    volume6 = volume6 + part;
    for (std::size_t k = 0; k < 3; ++k)
      moment24[k] = moment24[k] + part * (a[k] + b[k] + c[k]);
  }
};

Moments moments_of(std::span<const Position> corners,
                   std::span<const PolyhedronFace> faces) {
  check(corners, faces);
  Moments sum;
  const auto from_first = [&](std::int32_t c) {
    return difference(corners[static_cast<std::size_t>(c)], corners[0]);
  };
  for (const PolyhedronFace& face : faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      sum.add(from_first(face[0]), from_first(face[k]), from_first(face[k + 1]));
  }
  return sum;
}

}  // namespace

double polyhedron_volume(std::span<const Position> corners,
                         std::span<const PolyhedronFace> faces) {
  return moments_of(corners, faces).volume6.rounded() / 6;
}

Position polyhedron_centroid(std::span<const Position> corners,
                             std::span<const PolyhedronFace> faces) {
  const Moments m = moments_of(corners, faces);
  if (m.volume6.high == 0) return {nan, nan, nan};
  Position centroid{};
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleDouble offset = m.moment24[k] / (m.volume6 * 4);
    centroid[k] = (offset + DoubleDouble{corners[0][k], 0}).rounded();
  }
  return centroid;
}

Ball tetrahedron_circumsphere(const Position& a, const Position& b, const Position& c,
                              const Position& d) noexcept {
  const WidePosition u = difference(b, a), v = difference(c, a), w = difference(d, a);
  const WidePosition vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const DoubleDouble volume12 = dot(u, vw) * 2;
  if (volume12.high == 0)
    return {{nan, nan, nan}, std::numeric_limits<double>::infinity()};
  const DoubleDouble uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  Ball ball;
  Position offset{};
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleDouble o = (uu * vw[k] + vv * wu[k] + ww * uv[k]) / volume12;
    offset[k] = o.rounded();
    ball.center[k] = (o + DoubleDouble{a[k], 0}).rounded();
  }
  ball.radius = std::hypot(offset[0], offset[1], offset[2]);
  return ball;
}

}  // namespace delone::delaunay
