#pragma once

#include <vector>

#include "tripack/polygon.hpp"

/// Cutting polygons by half-planes. Internal: use tripack/voronoi.hpp.
namespace delone::tripack {

/// The points p with normal . p <= offset.
struct HalfPlane {
  Point2 normal;
  double offset = 0;
};

/// What is nearer to the origin than to d: exactly the bisector's side, on the scale
/// of 1.
[[nodiscard]] HalfPlane nearer_to_origin(Point2 d) noexcept;

/// Above 0 outside.
[[nodiscard]] inline double height(const HalfPlane& half, Point2 p) noexcept {
  return half.normal.x * p.x + half.normal.y * p.y - half.offset;
}
/// Where the side between two points passes the line, from their heights.
[[nodiscard]] inline Point2 crossing(Point2 inside, Point2 outside, double inner,
                                     double outer) noexcept {
  const double t = inner / (inner - outer);
  return {inside.x + t * (outside.x - inside.x), inside.y + t * (outside.y - inside.y)};
}

/// The parts of a simple counter-clockwise polygon inside the half-plane, each a simple
/// counter-clockwise polygon. A polygon wholly inside is given back as it is.
[[nodiscard]] std::vector<Polygon> clip(Polygon polygon, const HalfPlane& half);
[[nodiscard]] std::vector<Polygon> clip(std::vector<Polygon> polygons,
                                        const HalfPlane& half);

}  // namespace delone::tripack
