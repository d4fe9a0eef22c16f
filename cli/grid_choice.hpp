#pragma once

#include <optional>

#include "cli/options.hpp"
#include "cli/points.hpp"
#include "interp/grid.hpp"

namespace delone::cli {

/// What a regular grid covers, and how finely; empty: chosen from the data.
struct GridSettings {
  std::optional<interp::Region> region;
  std::optional<interp::Spacing> spacing;
  std::optional<interp::NodeCounts> counts;

  [[nodiscard]] bool is_asked_for() const noexcept { return region || spacing || counts; }
};

/// --region, --spacing, --size.
void add_grid_options(CLI::App& app, GridSettings& settings);

/// The grid, said in one line. Throws UsageError for a region or spacing that cannot be,
/// Error for points that span no region and for a grid beyond memory.
[[nodiscard]] interp::Grid choose_grid(const GridSettings& settings, const Points& points,
                                       const Triangulated& triangulated,
                                       const Reporter& reporter);

}  // namespace delone::cli
