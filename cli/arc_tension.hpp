#pragma once

#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "cli/surface.hpp"
#include "interp/arc_tension_options.hpp"

namespace delone::cli {

/// --shape, --range and --arc-tension.
void add_arc_tension_options(CLI::App& app, SurfaceSettings& settings);

/// Throws UsageError for these options with another method, and with others of c1 that
/// the surface of tension splines does not have.
void check_arc_tension(const SurfaceSettings& settings);
/// Throws UsageError if they were given: they do not go with `other`, unless that is
/// empty.
void check_arc_tension_without(std::string_view other, const SurfaceSettings& settings);

/// Without a range: that of the values, widened by a quarter.
[[nodiscard]] interp::TensionSplineOptions tension_spline_options(
    const interp::C1Options& c1, const ArcTensionSettings& settings,
    const std::vector<double>& values);

void say_arc_tension(const interp::TensionSplineFit& fit, const Reporter& reporter);

}  // namespace delone::cli
