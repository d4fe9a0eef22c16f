#pragma once

#include <cstdint>
#include <span>

#include "delaunay/options.hpp"
#include "interp/blend_fit.hpp"
#include "interp/blend_space.hpp"

namespace delone::interp {

/// What predicts nodes that are left out best.
struct BlendChoice {
  Stiffness stiffness;
  Gradients gradients = Gradients::local;
  std::int64_t num_tested = 0;  ///< nodes left out
  double rms = 0, linear_rms = 0;
};

/// What the options leave open chosen, what they say taken (`num_tested` is 0 where
/// nothing is left open).
///
/// Leaves out nodes one by one and predicts each from the surface that is fitted without
/// it in the triangle that then lies in its place. All nodes of a small set, of a large
/// one some hundreds spread along the curve. Nodes on the boundary are not counted.
/// Global gradients are tried where local ones do not come down to a twentieth of the
/// linear surface's errors. Cost: 40 microseconds a node, for global ones as much again.
template <BlendSpace Space, int Degree>
[[nodiscard]] BlendChoice choose_blend(const Space& space,
                                       const typename Space::Triangulation& triangulation,
                                       std::span<const double> site_values,
                                       const C1Options& options,
                                       const BlendFitOptions& fit, const RunOptions& run);

}  // namespace delone::interp
