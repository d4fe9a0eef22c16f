#pragma once

#include <cmath>

#include "interp/linear_surface.hpp"
#include "interp/sphere_vector.hpp"

namespace delone::interp {

/// The parts of a tangent vector. At a pole the longitude counts as 0, as lonlat() has
/// it.
[[nodiscard]] inline GradientSphere east_and_north(
    Vector3 g, const stripack::Direction& p) noexcept {
  const double across = std::hypot(p.x(), p.y());
  const double cosine = across == 0 ? 1 : p.x() / across,
               sine = across == 0 ? 0 : p.y() / across;
  return {.east = g.y * cosine - g.x * sine,
          .north = g.z * across - p.z() * (g.x * cosine + g.y * sine)};
}

}  // namespace delone::interp
