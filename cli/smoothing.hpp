#pragma once

#include "cli/points.hpp"
#include "cli/surface.hpp"
#include "interp/smooth_options.hpp"

namespace delone::cli {

/// --smooth and --errors, after --vector.
void add_smooth_options(CLI::App& app, PointSettings& points, SurfaceSettings& settings);

/// --smooth with a length only, for what knows no values.
void add_smooth_length(CLI::App& app, SurfaceSettings& settings);

/// Throws UsageError for options of smoothing with another method, and for misfits as
/// large as errors without errors.
void check_smooth_options(const Points& points, const SurfaceSettings& settings);

/// Refers to the errors of `points`.
[[nodiscard]] interp::SmoothOptions smooth_options(const Points& points,
                                                   const interp::SurfaceOptions& common,
                                                   const SmoothSettings& settings);

void say_smoothing(const interp::SmoothFit& fit, const Points& points,
                   const SmoothSettings& settings, const Reporter& reporter);

}  // namespace delone::cli
