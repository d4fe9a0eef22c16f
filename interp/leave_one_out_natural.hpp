#pragma once

#include <memory>
#include <span>

#include "interp/leave_one_out.hpp"
#include "interp/natural_surface.hpp"

namespace delone::interp {

/// The exact leave-one-out residuals of PlaneNatural / SphereNatural, of all kinds: for
/// every row the value at its position of the surface over all other positions, which is
/// what building the triangulation without it would give, to rounding. The natural
/// neighbours of a removed site are those that it had. For sibson_c1 the gradients of
/// these are fitted anew, without it.
///
/// What is outside, repeated rows, few points, errors and threads: as leave_out_linear.
///
/// Cost: O(k log k) for a site with k neighbours, some 5 microseconds; sibson_c1 some 20,
/// and O(d) besides, d the number of neighbours of its neighbours.
[[nodiscard]] LeaveOneOut leave_out_natural(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const NaturalOptions& options = {},
    const RunOptions& run = {});
[[nodiscard]] LeaveOneOut leave_out_natural(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const NaturalOptions& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
