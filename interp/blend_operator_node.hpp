#pragma once

#include <span>
#include <vector>

#include "interp/blend_model.hpp"
#include "interp/blend_space.hpp"
#include "interp/c1_choices.hpp"
#include "interp/stencil.hpp"

namespace delone::interp {

/// A node's polynomial as a linear function of the values around it.
template <int Degree>
struct BlendNode {
  double per_radius = 0, tension = 0;
  std::vector<Site> sites;  ///< of the stencil
  /// Terms x sites: what (value of a site - value of the node) adds to a coefficient.
  std::vector<double> weights;

  [[nodiscard]] const double* weights_of(std::size_t term) const noexcept {
    return weights.data() + term * sites.size();
  }
  /// The polynomial for given values, in no bounds.
  [[nodiscard]] BlendModel<Degree> model(Site node,
                                         std::span<const double> site_values) const;
};

/// The mix of the fits of all degrees that a choice names, as fit_blend_model makes them
/// but for weights ((R - d) / d)^nearness.
template <BlendSpace Space, int Degree>
[[nodiscard]] BlendNode<Degree> blend_node(
    const Space& space, const typename Space::Triangulation& triangulation, Site site,
    std::span<const StencilNode> stencil, const C1NodeChoice& choice);

/// Throws Error for local bounds, and for gradients that are not local.
void check_linear(const C1Options& options);

/// Throws Error, if there are choices, as check_linear, and if they are not of the degree
/// or not one a site, have parts that do not sum to one, or come with a tension.
void check_choices(const C1Options& options, Site num_sites);

}  // namespace delone::interp
