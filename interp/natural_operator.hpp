#pragma once

#include <memory>
#include <span>

#include "interp/natural_surface.hpp"
#include "interp/operator.hpp"

namespace delone::interp {

/// The operator of PlaneNatural / SphereNatural of any kind at the given targets, within
/// 1e-13 of the range of the data. sibson_c1: with gradients fitted at the nodes as
/// SlopeLimit::positions says, whatever the options' `slope_limit`.
///
/// A row of sibson and laplace holds the natural neighbours, usually 6, with weights that
/// are not negative; of sibson_c1 their neighbours too, usually 16, some negative: their
/// magnitudes add up to some 1.2 in well placed data. Where a target is nearer to a site
/// than 1e-13 of the distances around, rounding of the weights shows. Otherwise as
/// linear_operator; Outside::linear is refused with Error.
[[nodiscard]] Operator natural_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const NaturalOptions& options = {},
    const RunOptions& run = {});
[[nodiscard]] Operator natural_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const NaturalOptions& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
