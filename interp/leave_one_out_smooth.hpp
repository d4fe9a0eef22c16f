#pragma once

#include <memory>
#include <span>

#include "interp/c1_options.hpp"
#include "interp/leave_one_out.hpp"

namespace delone::interp {

/// The exact leave-one-out residuals of PlaneC1 / SphereC1 with their choices kept: for
/// every row the value at its position of the surface that is fitted to all other
/// positions with the same tension (and bounds and degree), to rounding. Where tension or
/// gradients are not given they are what the surface over all rows chooses. Polynomials
/// about the nodes around are fitted anew, from the neighbours that these have once the
/// site is gone. Global gradients, in which every row has a part, are found anew among
/// the nodes within four steps, which gives predictions to some 1e-4 of the range; to
/// some 1e-2 beside hubs, where fewer nodes are taken.
///
/// Outside::linear predicts beyond the hull of the others by the surface's continuation;
/// on the sphere it predicts nothing there.
/// Apart from that what is outside, repeated rows, few points, errors and threads are as
/// with leave_out_linear, and tension as with PlaneC1. Where more than 64 nodes are at
/// hand for a fit and some are equally far, those kept may be others than after
/// rebuilding.
///
/// Cost: three fits a site, some 20 microseconds, and O(d), d the number of neighbours of
/// its neighbours; with global gradients some 100. Throws Error besides for
/// `options.choices`.
[[nodiscard]] LeaveOneOut leave_out_c1(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const C1Options& options = {},
    const RunOptions& run = {});
[[nodiscard]] LeaveOneOut leave_out_c1(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const C1Options& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
