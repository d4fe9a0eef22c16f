#pragma once

#include <memory>
#include <span>

#include "interp/factored_operator.hpp"
#include "interp/smooth_options.hpp"

namespace delone::interp {

/// The operator of PlaneSmooth / SphereSmooth at a fixed wavelength
/// (SmoothBy::wavelength; where another one chose it for a field, fit().wavelength) with
/// `options.choices`; without choices, with those of c1_choices(triangulation,
/// options) for Gradients::given. The surface that the choices are given to as well
/// is the same within 1e-13 of the range of the data.
///
/// `options.errors` are one a row, and the same for all fields. Repeated rows: their
/// mean, weighted by these errors; `first` and `last` take one; other policies are not
/// linear in the data and are refused with Error if a position repeats.
///
/// Throws Error besides where the wavelength is not given, for choices that are not for
/// known gradients, and as PlaneSmooth; Cancelled.
///
/// Cost: one sparse Cholesky factor, 300 n^1.5 multiplications and 60 n log2 n numbers
/// for n evenly spread nodes (10,000: 65 MB, 100,000: 800 MB), kept as long as the
/// operator. A field or an explicit row: some three passes over the factor, sixteen rows
/// together. Explicit rows are dense, 12 bytes a node and target, unless small weights
/// are left out (RowOptions::tolerance), which fall off beyond a wavelength.
[[nodiscard]] FactoredOperator smooth_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const SmoothOptions& options,
    const RunOptions& run = {});
[[nodiscard]] FactoredOperator smooth_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const SmoothOptions& options,
    const RunOptions& run = {});

}  // namespace delone::interp
