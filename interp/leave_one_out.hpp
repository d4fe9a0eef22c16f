#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/surface_options.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// What the other observations say about each observation, one entry a row.
///
/// Rows that share a position are left out together: the prediction is made without the
/// position, so that repeats do not vouch for one another, and compared with each of the
/// rows.
struct LeaveOneOut {
  std::vector<double> predicted;  ///< NaN: missing
  std::vector<double> residual;   ///< predicted - value; NaN: missing
  std::int64_t num_missing = 0;   ///< rows without a prediction
};

/// The exact leave-one-out residuals of PlaneLinear / SphereLinear: for every row the
/// value at its position of the surface over all other positions, which is what building
/// the triangulation without it would give, to rounding.
///
/// Positions that the others do not enclose are outside: missing (and counted) or as
/// `options.outside` says. On the sphere the others may lie in a hemisphere although all
/// together do not; then a position outside of that is missing as well. One position:
/// missing. O(degree) a position, 0.3 microseconds; positions at the boundary with
/// Outside::linear, chains and everything with a finite max_distance take some
/// microseconds, because a small triangulation of what lies around is built. In parallel,
/// the same bits for every number of threads. Throws Error for what the surfaces refuse;
/// Cancelled.
[[nodiscard]] LeaveOneOut leave_out_linear(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const SurfaceOptions& options = {},
    const RunOptions& run = {});
[[nodiscard]] LeaveOneOut leave_out_linear(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const SurfaceOptions& options = {},
    const RunOptions& run = {});

/// The same for PlaneNearest / SphereNearest. Of several nearest positions the one that
/// comes first along the triangulation's curve.
[[nodiscard]] LeaveOneOut leave_out_nearest(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const SurfaceOptions& options = {},
    const RunOptions& run = {});
[[nodiscard]] LeaveOneOut leave_out_nearest(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const SurfaceOptions& options = {},
    const RunOptions& run = {});

/// Residuals from predictions by site (`site_predictions`) for the values of rows.
[[nodiscard]] LeaveOneOut left_out_rows(std::span<const delaunay::Site> sites,
                                        std::span<const double> site_predictions,
                                        std::span<const double> row_values);

}  // namespace delone::interp
