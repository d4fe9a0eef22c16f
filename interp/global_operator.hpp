#pragma once

#include <memory>
#include <span>

#include "interp/c1_choices.hpp"
#include "interp/factored_operator.hpp"

namespace delone::interp {

/// The operator of PlaneC1 / SphereC1 with global gradients and `options.choices`;
/// without choices, with those of c1_choices(triangulation, options) for
/// Gradients::global, from where the nodes are. The surface that the choices are given to
/// as well is the same within 1e-13 of the range of the data.
///
/// A gradient depends on all values, the less the farther away: about fourfold less a
/// step along edges, and on nothing more than 24 steps away. So explicit rows hold some
/// 4,000 weights, of which a tolerance of 1e-6 leaves 300 and one of 1e-3 leaves 90
/// (RowOptions::tolerance).
///
/// Outside::linear: the surface's own continuation, here in no bounds. Local bounds and
/// gradients that are asked to be local are refused with Error, as is what PlaneC1
/// refuses; otherwise as c1_operator. Repeated rows: as linear_operator.
///
/// Cost: that of c1_operator over three unknowns a node, and of the choices some 200
/// microseconds a node, if they are not given; 100 bytes an edge. A field: some 3
/// microseconds a node. An explicit row: some 10 milliseconds, whatever the number of
/// nodes.
[[nodiscard]] FactoredOperator global_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const C1Options& options = {},
    const RunOptions& run = {});
[[nodiscard]] FactoredOperator global_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const C1Options& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
