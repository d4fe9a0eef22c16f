#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "delaunay/options.hpp"
#include "interp/blend_fit.hpp"
#include "interp/blend_space.hpp"

namespace delone::interp {

/// How well surfaces of each stiffness predict nodes that are left out.
struct StiffnessChoice {
  std::size_t level = 0;        ///< the best
  std::int64_t num_tested = 0;  ///< nodes left out
  std::array<double, num_stiffness_levels> rms{};
  double linear_rms = 0;
};

/// Leaves out nodes one by one and predicts each from the surface that is fitted without
/// it in the triangle that then lies in its place. All nodes of a small set, of a large
/// one some hundreds spread along the curve. Nodes on the boundary are not counted.
/// Cost: 40 microseconds a node.
template <BlendSpace Space, int Degree>
[[nodiscard]] StiffnessChoice choose_stiffness(
    const Space& space, const typename Space::Triangulation& triangulation,
    std::span<const double> site_values, const BlendFitOptions& options,
    const RunOptions& run);

}  // namespace delone::interp
