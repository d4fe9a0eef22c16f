#pragma once

#include <cmath>

#include "delaunay/error.hpp"
#include "interp/plane_reach.hpp"
#include "interp/sphere_reach.hpp"
#include "interp/surface_options.hpp"

namespace delone::interp {

// What surfaces over either kind of points ask in the same words.

[[nodiscard]] inline bool is_finite(tripack::Point2 p) noexcept {
  return std::isfinite(p.x) && std::isfinite(p.y);
}
[[nodiscard]] inline bool is_finite(const stripack::Direction&) noexcept { return true; }

[[nodiscard]] inline PlaneReach reach_of(const tripack::Triangulation& t,
                                         const SurfaceOptions& options) {
  return {t, options.max_distance};
}
[[nodiscard]] inline SphereReach reach_of(const stripack::Triangulation& t,
                                          const SurfaceOptions& options) {
  return {t, options.max_distance, options.distance};
}

}  // namespace delone::interp
