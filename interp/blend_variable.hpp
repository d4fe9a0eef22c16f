#pragma once

#include "interp/blend_space.hpp"

namespace delone::interp {

/// The point as a function of two lengths from it: by x and y in the plane, along the
/// geodesics towards east and north on the sphere.
[[nodiscard]] inline PlaneSpace::Position<SecondOrder> variable(const PlaneSpace& space,
                                                                Point2 p) {
  const Point2 v = space.vector(p);
  return {SecondOrder(v.x, space.scale, 0), SecondOrder(v.y, 0, space.scale)};
}

[[nodiscard]] inline SphereSpace::Position<SecondOrder> variable(const SphereSpace&,
                                                                 const Direction& d) {
  const Vector3 p = vector(d), east = east_at(d), north = cross(p, east);
  const auto along = [](double at, double e, double n) {
    return SecondOrder(at, e, n, -at, 0, -at);
  };
  return {along(p.x, east.x, north.x), along(p.y, east.y, north.y),
          along(p.z, east.z, north.z)};
}

}  // namespace delone::interp
