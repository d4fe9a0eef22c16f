#pragma once

#include <array>
#include <span>
#include <vector>

#include "interp/blend_model.hpp"
#include "interp/blend_space.hpp"
#include "interp/c1_choices.hpp"
#include "interp/stencil.hpp"

namespace delone::interp {

/// A node's polynomial as a linear function of the values around it, and of its gradient
/// where that is known.
template <int Degree>
struct BlendNode {
  double per_radius = 0, tension = 0;
  std::vector<Site> sites;  ///< of the stencil
  /// Terms x sites: what (value of a site - value of the node) adds to a coefficient.
  /// Where the gradient is known, what the rise above it adds.
  std::vector<double> weights;
  /// Where the gradient is known the places (u, v) of the sites; else empty.
  std::vector<std::array<double, 2>> places;
  double gradient_part = 1;  ///< of the polynomial

  [[nodiscard]] const double* weights_of(std::size_t term) const noexcept {
    return weights.data() + term * sites.size();
  }
  /// The polynomial for given values, in no bounds. `slope`: by scaled length along the
  /// axes of the node, where it is known.
  [[nodiscard]] BlendModel<Degree> model(Site node, std::span<const double> site_values,
                                         std::array<double, 2> slope = {}) const;
};

/// The mix of the fits of all degrees that a choice names, as fit_blend_model makes them
/// but for weights ((R - d) / d)^nearness. `gradients`: global if the node's is known.
template <BlendSpace Space, int Degree>
[[nodiscard]] BlendNode<Degree> blend_node(
    const Space& space, const typename Space::Triangulation& triangulation, Site site,
    std::span<const StencilNode> stencil, const C1NodeChoice& choice,
    Gradients gradients = Gradients::local);

/// Throws Error for local bounds.
void check_linear(const C1Options& options);

/// Throws Error, if there are choices, as check_linear, and if they are for other
/// gradients than the options ask for, not of the degree or not one a site, have parts
/// that do not sum to one, or come with a tension.
void check_choices(const C1Options& options, Site num_sites);

}  // namespace delone::interp
