#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "interp/blend_model.hpp"
#include "interp/blend_space.hpp"
#include "interp/c1_options.hpp"
#include "interp/stencil.hpp"

namespace delone::interp {

/// How readily a fit gives way to data that are not smooth. Levels from 0 (smooth) to
/// num_stiffness_levels - 1 (next to linear).
struct Stiffness {
  double doubt = 0.2;  ///< how much a degree must predict better than the one below it
  double tension = 0;  ///< of every node; what the data ask for comes on top
};
inline constexpr std::size_t num_stiffness_levels = 5;
[[nodiscard]] Stiffness stiffness_level(std::size_t level) noexcept;

/// Bounds for all values of a surface.
struct ValueRange {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

struct BlendFitOptions {
  Stiffness stiffness;
  Bounds bounds = Bounds::widened;
  ValueRange range;  ///< of all data
};

/// The largest hump of an edge.
[[nodiscard]] inline double most_hump(const BlendFitOptions& options) noexcept {
  constexpr double range_part = 0.1;
  return options.bounds == Bounds::local
             ? 0
             : range_part * (options.range.most - options.range.least);
}

/// The polynomial of a node, fitted to the values around it.
///
/// Weighted least squares through the node's value, weights ((R - d) / d)^2 with R 1.05
/// times the largest distance, in coordinates divided by R; degrees 1, 2, 3 (4) and the
/// constant are mixed by the inverse cube of how well each predicts the
/// neighbours that it is not shown (leave-one-out residuals r / (1 - h), h the leverage).
/// Where no degree predicts well, along tracks, in noise, at a gap, the constant prevails
/// and the node gets tension. A ridge of 1e-10 with one step of refinement leaves
/// coefficients that the positions do not determine at zero and others exact.
/// Cost: some 2,000 multiplications for degree 3.
template <BlendSpace Space, int Degree>
[[nodiscard]] BlendModel<Degree> fit_blend_model(
    const Space& space, const typename Space::Triangulation& triangulation,
    std::span<const double> site_values, Site site, std::span<const StencilNode> stencil,
    const BlendFitOptions& options);

/// Nearest nodes that a stencil of a degree should hold.
[[nodiscard]] constexpr std::size_t num_nearest(int degree) noexcept {
  return degree == 4 ? 24 : 16;
}

}  // namespace delone::interp
