#pragma once

#include <memory>
#include <span>

#include "interp/c1_choices.hpp"
#include "interp/operator.hpp"

namespace delone::interp {

/// The operator of PlaneC1 / SphereC1 with `options.choices`; without choices, with those
/// of c1_choices(triangulation, options), from where the nodes are. The surface that the
/// choices are given to as well is the same within 1e-13 of the range of the data.
///
/// A row holds the nodes of three stencils, 30 to 40 weights, some of them negative.
/// Their magnitudes add up to 1 to 3 at most places; at worst, at hulls and beside
/// slivers, to some 20 with the choices from geometry. By as much errors of the data are
/// amplified. Outside::linear (plane): its own continuation, here in no bounds. Local
/// bounds, and gradients that are not local, are refused with Error, as is what PlaneC1
/// refuses; otherwise as linear_operator. Cost: some 5 microseconds a target, and 20 for
/// each node and edge around some target.
[[nodiscard]] Operator c1_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const C1Options& options = {},
    const RunOptions& run = {});
[[nodiscard]] Operator c1_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const C1Options& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
