#pragma once

#include <array>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/arc_tension_options.hpp"
#include "interp/linear_surface.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// The arcs of a triangulation: rows of both ends (of a repeated position the first row),
/// the smaller one first, sorted. The order of tension factors. O(n log n).
[[nodiscard]] std::vector<std::array<delaunay::Node, 2>> tension_arcs(
    const tripack::Triangulation& triangulation);
[[nodiscard]] std::vector<std::array<delaunay::Node, 2>> tension_arcs(
    const stripack::Triangulation& triangulation);

/// The least tension factor of every arc with which the Hermite tension spline of its
/// ends meets the demand; tension_factor_max where only a larger one does. The ends'
/// slopes are the gradients, one a row (repeated positions: the mean), along the arc; on
/// the sphere, by radians, along the great circle. In the order of tension_arcs().
///
/// Cost: 0.1 microseconds an arc and some 5 for each that is tightened. Throws Error for
/// what values_at_sites refuses, for gradients that are not one finite pair a row, and as
/// check(ArcDemand). Does not depend on the number of threads or the order of rows.
///
/// What it finds: R. J. Renka, SIAM J. Sci. Stat. Comput. 8 (1987) 393-415 (there
/// GETSIG).
[[nodiscard]] std::vector<double> tension_factors(
    const tripack::Triangulation& triangulation, std::span<const double> row_values,
    std::span<const Gradient2> row_gradients, const ArcDemand& demand,
    const RunOptions& run = {});
[[nodiscard]] std::vector<double> tension_factors(
    const stripack::Triangulation& triangulation, std::span<const double> row_values,
    std::span<const GradientSphere> row_gradients, const ArcDemand& demand,
    const RunOptions& run = {});

}  // namespace delone::interp
