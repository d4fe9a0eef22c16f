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

/// The parts of a simple counter-clockwise polygon inside the half-plane, each a simple
/// counter-clockwise polygon. A polygon wholly inside is given back as it is.
[[nodiscard]] std::vector<Polygon> clip(Polygon polygon, const HalfPlane& half);
[[nodiscard]] std::vector<Polygon> clip(std::vector<Polygon> polygons,
                                        const HalfPlane& half);

}  // namespace delone::tripack
