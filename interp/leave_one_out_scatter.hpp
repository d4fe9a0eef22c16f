#pragma once

#include <memory>
#include <span>

#include "interp/idw_surface.hpp"
#include "interp/leave_one_out.hpp"
#include "interp/rbf_surface.hpp"
#include "interp/shepard_surface.hpp"

namespace delone::interp {

/// The exact leave-one-out residuals of PlaneInverseDistance / SphereInverseDistance: for
/// every row the value at its position of the surface over all other positions.
///
/// What the others do not enclose (and the ends of a chain) is outside: missing, or as
/// `options.outside` says; Outside::linear means the method's own continuation. An
/// isolated site is predicted from its nearest ones however far these are, unless
/// `max_distance` or the radius ends before them: then it is missing. Repeated rows, few
/// points, errors and threads: as leave_out_linear. Cost: a query a site.
[[nodiscard]] LeaveOneOut leave_out_inverse_distance(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const InverseDistanceOptions& weights = {},
    const SurfaceOptions& options = {}, const RunOptions& run = {});
[[nodiscard]] LeaveOneOut leave_out_inverse_distance(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const InverseDistanceOptions& weights = {},
    const SurfaceOptions& options = {}, const RunOptions& run = {});

/// The same for PlaneShepard / SphereShepard: nodal functions and discs that know a site
/// are fitted again without it. Exact, to rounding, where discs reach; in the gaps of
/// clusters the fewer nodes that take over are those of the whole set but the site. Up to
/// 64 positions every surface is built again. Cost: some 30 fits a site, 0.3
/// milliseconds.
[[nodiscard]] LeaveOneOut leave_out_shepard(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const ShepardOptions& shepard = {},
    const SurfaceOptions& options = {}, const RunOptions& run = {});
[[nodiscard]] LeaveOneOut leave_out_shepard(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const ShepardOptions& shepard = {},
    const SurfaceOptions& options = {}, const RunOptions& run = {});

/// The same for PlaneRadial / SphereRadial. Sets of at most `most_at_once` positions: the
/// spline through all others, to rounding (where splines are held back, beside
/// near-duplicates, to some hundredths of what these differ by). Larger ones: where the
/// discs of local splines lie is a choice made for the whole set and kept; the splines
/// that know a site are solved again without it. Up to 64 positions every surface is
/// built again.
///
/// Cost: four or five local systems a site, some 0.5 milliseconds; for one spline through
/// n positions n systems, n^4 / 3 operations (12 seconds for 512).
[[nodiscard]] LeaveOneOut leave_out_radial(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const RadialOptions& radial = {},
    const SurfaceOptions& options = {}, const RunOptions& run = {});
[[nodiscard]] LeaveOneOut leave_out_radial(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const RadialOptions& radial = {},
    const SurfaceOptions& options = {}, const RunOptions& run = {});

}  // namespace delone::interp
