#include "cli/grid_choice.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>

namespace delone::cli {
namespace {

/// The region asked for, or the one that covers the data.
interp::Region choose_region(const GridSettings& settings, const Points& points,
                             const Triangulated& triangulated) {
  if (!settings.region) {
    return std::visit([](const auto& t) { return interp::covering_region(*t); },
                      triangulated);
  }
  interp::Region region = *settings.region;
  // 170/-170 is the way people write a region across the date line.
  if (!points.is_on_plane() && region.east <= region.west) region.east += 360;
  return region;
}

interp::Spacing choose_spacing(const GridSettings& settings, const Points& points,
                               const interp::Region& region,
                               std::int64_t num_observations) {
  if (settings.spacing) return *settings.spacing;
  return points.is_on_plane() ? interp::suggested_plane_spacing(region, num_observations)
                              : interp::suggested_globe_spacing(region, num_observations);
}

interp::Grid lay_grid(const GridSettings& settings, const Points& points,
                      const Triangulated& triangulated) {
  const interp::Region region = choose_region(settings, points, triangulated);
  if (settings.counts) {
    return points.is_on_plane() ? interp::plane_grid(region, *settings.counts)
                                : interp::globe_grid(region, *settings.counts);
  }
  // Of a domain these are its corners, most of which may be a coast's and no
  // observations.
  const auto num_sites = std::min<std::int64_t>(
      points.size(),
      std::visit([](const auto& t) { return t->num_sites(); }, triangulated));
  const interp::Spacing spacing = choose_spacing(settings, points, region, num_sites);
  // The ends of a region that was asked for are kept; one that was found is widened, so
  // that nodes lie on multiples of the spacing wherever the data begin.
  if (points.is_on_plane()) {
    return interp::plane_grid(
        settings.region ? region : interp::widened_plane_region(region, spacing),
        spacing);
  }
  return interp::globe_grid(
      settings.region ? region : interp::widened_globe_region(region, spacing), spacing);
}

/// A grid beyond memory is refused here: the system would grant it and kill the program
/// when it is filled.
void check_memory(const interp::Grid& grid) {
  const double needed = static_cast<double>(grid.size()) * sizeof(double);
  const double available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                           static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed < available) return;
  throw Error(
      fmt::format("a grid of {} x {} nodes needs {:.0f} GB of memory and there are "
                  "{:.0f} GB; choose a "
                  "coarser --spacing or a smaller --region",
                  grid.x.size, grid.y.size, needed / 1e9, available / 1e9));
}

std::string described(const interp::Axis& axis) {
  return fmt::format("{:.10g} to {:.10g} by {:.10g}", axis.coordinate(0),
                     axis.coordinate(axis.size - 1), axis.spacing);
}

}  // namespace

interp::Grid choose_grid(const GridSettings& settings, const Points& points,
                         const Triangulated& triangulated, const Reporter& reporter) {
  try {
    const interp::Grid grid = lay_grid(settings, points, triangulated);
    check_memory(grid);
    const bool is_chosen = !settings.spacing && !settings.counts;
    reporter.say(
        "grid: {} x {} nodes, {} {}, {} {}{}", grid.x.size, grid.y.size,
        points.is_on_plane() ? "x" : "lon", described(grid.x),
        points.is_on_plane() ? "y" : "lat", described(grid.y),
        is_chosen ? " (about four nodes a point; --spacing or --size chooses)" : "");
    return grid;
  } catch (const Error& error) {
    if (settings.is_asked_for()) throw UsageError(error.what());
    throw located(points, error);
  }
}

void add_grid_options(CLI::App& app, GridSettings& settings) {
  const auto set_region = [&settings](const std::string& text) {
    const auto n = parse_numbers("--region", text, 4, 4);
    settings.region = interp::Region{n[0], n[1], n[2], n[3]};
  };
  const auto set_spacing = [&settings](const std::string& text) {
    const auto n = parse_numbers("--spacing", text, 1, 2);
    settings.spacing = interp::Spacing{n.front(), n.back()};
  };
  const auto set_size = [&settings](const std::string& text) {
    const auto n = parse_counts("--size", text);
    settings.counts = interp::NodeCounts{n[0], n[1]};
  };
  app.add_option_function<std::string>("--region", set_region,
                                       "What to cover (default: the data)")
      ->type_name("W/E/S/N");
  auto* spacing = app.add_option_function<std::string>("--spacing", set_spacing,
                                                       "Distance of the nodes")
                      ->type_name("DX[/DY]");
  app.add_option_function<std::string>("--size", set_size, "Number of nodes")
      ->type_name("NX/NY")
      ->excludes(spacing);
}

}  // namespace delone::cli
