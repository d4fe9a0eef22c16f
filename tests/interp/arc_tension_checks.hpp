#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "interp/arc_tension.hpp"
#include "interp/arc_tension_surface.hpp"
#include "interp/index.hpp"
#include "interp/surfaces.hpp"
#include "support/random.hpp"

/// What the tests of surfaces with tension along arcs share.
namespace delone::support {

using interp::ArcShape;
using interp::Gradient2;
using interp::HermiteArc;
using interp::PlaneTensionSpline;
using interp::TensionSplineOptions;

inline TensionSplineOptions with_shape(ArcShape shape) {
  TensionSplineOptions options;
  options.demand.shape = shape;
  return options;
}
inline TensionSplineOptions with_range(double least, double most) {
  TensionSplineOptions options;
  options.demand.least = least;
  options.demand.most = most;
  return options;
}

/// Of every arc what the surface has at its ends, in the order of tension_arcs().
inline std::vector<HermiteArc> arcs_of(const PlaneTensionSpline& surface,
                                       const PlanePoints& points,
                                       const std::vector<double>& values,
                                       const tripack::Triangulation& t) {
  std::vector<HermiteArc> arcs;
  for (const auto& [from, to] : interp::tension_arcs(t)) {
    const tripack::Point2 a = points[interp::at(from)], b = points[interp::at(to)];
    const Gradient2 g = surface.gradient(a), h = surface.gradient(b);
    const double dx = b.x - a.x, dy = b.y - a.y;
    arcs.push_back({values[interp::at(from)], values[interp::at(to)], g.x * dx + g.y * dy,
                    h.x * dx + h.y * dy, 1});
  }
  return arcs;
}

/// Gradients that neither the surface nor a shape was made for.
inline std::vector<Gradient2> random_gradients(std::size_t n, std::uint64_t seed,
                                               double size) {
  SplitMix64 random(seed);
  std::vector<Gradient2> result(n);
  for (auto& g : result) g = {random.between(-size, size), random.between(-size, size)};
  return result;
}

}  // namespace delone::support
