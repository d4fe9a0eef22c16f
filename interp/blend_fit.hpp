#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
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
/// A tension that is given, 0 .. 1.
[[nodiscard]] constexpr Stiffness stiffness_of(double tension) noexcept {
  Stiffness stiffness;
  stiffness.tension = tension;
  return stiffness;
}
inline constexpr std::size_t num_stiffness_levels = 5;
inline constexpr std::array<Stiffness, num_stiffness_levels> stiffness_levels{
    Stiffness{0.1, 0}, Stiffness{-0.3, 0.4}, Stiffness{0.1, 0.6}, Stiffness{0.3, 0.8},
    Stiffness{0.8, 0.97}};

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
/// (degree 4: 1.02) times the largest distance, in coordinates divided by R; degrees 1,
/// 2, 3 (4) and the constant are mixed by the inverse cube of how well each predicts the
/// neighbours that it is not shown (leave-one-out residuals r / (1 - h), h the leverage).
/// Where no degree predicts well, along tracks, in noise, at a gap, the constant prevails
/// and the node gets tension. A ridge of 1e-10 with one step of refinement leaves
/// coefficients that the positions do not determine at zero and others exact.
/// Cost: some 2,000 multiplications for degree 3.
///
/// A `gradient` that is given (a tangent vector, by scaled length) is the polynomial's at
/// the node; the degrees above it are fitted to what remains, and nothing prevails over
/// it.
template <BlendSpace Space, int Degree>
[[nodiscard]] BlendModel<Degree> fit_blend_model(
    const Space& space, const typename Space::Triangulation& triangulation,
    std::span<const double> site_values, Site site, std::span<const StencilNode> stencil,
    const BlendFitOptions& options,
    const std::optional<typename Space::Vector>& gradient = {});

/// The same of nodes that are counted in any way: `points` and `values` of all of them.
template <BlendSpace Space, int Degree>
[[nodiscard]] BlendModel<Degree> fit_blend_model(
    const Space& space, std::span<const typename Space::Point> points,
    std::span<const double> values, Site node, std::span<const StencilNode> stencil,
    const BlendFitOptions& options,
    const std::optional<typename Space::Vector>& gradient = {});

/// The gradient at a site if there is one: not NaN.
template <BlendSpace Space>
[[nodiscard]] std::optional<typename Space::Vector> known_gradient(
    std::span<const typename Space::Vector> site_gradients, Site site) {
  if (site_gradients.empty()) return {};
  const typename Space::Vector& g = site_gradients[at(site)];
  if (!std::isfinite(Space::dot(g, g))) return {};
  return g;
}

/// Nearest nodes that a stencil of a degree should hold.
[[nodiscard]] constexpr std::size_t num_nearest(int degree) noexcept {
  return degree == 4 ? 28 : 16;
}

}  // namespace delone::interp
