#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "cli/constraints.hpp"
#include "cli/options.hpp"
#include "cli/points.hpp"
#include "cli/surface.hpp"
#include "cli/vector_field.hpp"

namespace delone::cli {

/// --cross-validate: what the surface says at every point without it.
struct CrossValidationSettings {
  std::string path;  ///< of the table; empty: not wanted
  [[nodiscard]] bool is_wanted() const noexcept { return !path.empty(); }
};

void add_cross_validation_option(CLI::App& app, CrossValidationSettings& settings);

/// What is wanted that predictions do not go with: segments, --vector or nothing (empty).
[[nodiscard]] std::string_view obstacle_to_validation(
    const PointSettings& points, const ConstraintSettings& constraints,
    const VectorSettings& vector);

/// Asks before any work what can be asked: throws UsageError if the predictions do not go
/// with something else that is wanted (`obstacle`; empty: nothing), unless the file is a
/// .csv and none of `inputs` and `outputs`, and io::WriteError if it cannot be opened.
void check_cross_validation(const CrossValidationSettings& settings,
                            std::string_view obstacle,
                            std::initializer_list<std::string_view> inputs,
                            std::initializer_list<std::string_view> outputs);

/// If wanted: leaves out every position in turn, writes a table with a line a row, in
/// their order (row, position, value, predicted, residual, standardised, outlier), and
/// says errors, outliers and the worst rows.
///
/// `residual` is predicted - value, `standardised` its distance from the median of all in
/// robust deviations, `outlier` 1 or 0 (interp::find_outliers). Missing predictions,
/// where the other points do not enclose one, are empty fields.
void cross_validate(const CrossValidationSettings& settings, const Points& points,
                    const Triangulated& triangulated, const SurfaceSettings& surface,
                    Reporter& reporter);

}  // namespace delone::cli
