#pragma once

#include <memory>
#include <span>

#include "interp/leave_one_out.hpp"
#include "interp/smooth_options.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// The leave-one-out residuals of PlaneSmooth / SphereSmooth: what the surface would be
/// at every row's position without the data there, for the parameter
/// (SmoothFit::parameter) that is given or that the whole set chooses.
///
/// The position stays a node of the triangulation, one without a datum. Then the residual
/// is the misfit over 1 - h, where h is how much the datum counts at its own position,
/// exactly: the diagonal of the linear map from values to smoothed values comes from the
/// sparse factor. Root mean squares of these are what generalised cross-validation
/// estimates. A length below a twentieth of the mean spacing counts as that (predictions
/// differ by some 1e-5 of the residuals), since misfits are then lost in rounding.
///
/// Positions that the others do not enclose are outside: missing; with Outside::nearest
/// the value at the nearest other position of the surface without the data here; with
/// Outside::linear (plane) the node's own value, which the surface's roughness continues.
/// Missing too where 1 - h is below 1e-11: no other datum has a say. Up to three
/// positions, which are not smoothed: as leave_out_linear. Repeated rows are left out
/// together; `options.errors` weigh the data. Threads and errors as PlaneSmooth.
///
/// Cost: the surface, and about three times a factor; besides, with Outside::nearest, one
/// solution a position of the hull. Source: P. Craven, G. Wahba, Numer. Math. 31 (1979)
/// 377-403, lemma 3.1.
[[nodiscard]] LeaveOneOut leave_out_smooth(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const SmoothOptions& options = {},
    const RunOptions& run = {});
[[nodiscard]] LeaveOneOut leave_out_smooth(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const SmoothOptions& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
