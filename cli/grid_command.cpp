#include "cli/grid_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "cli/surface.hpp"
#include "interp/grid.hpp"
#include "io/grid_file.hpp"
#include "io/map.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  SurfaceSettings surface;
  OutputSettings output;
  std::optional<interp::Region> region;
  std::optional<interp::Spacing> spacing;
  std::optional<interp::NodeCounts> counts;
  OutputSettings map;
  std::string title, units;
  bool draws_points = false;
};

/// The region asked for, or the one that covers the data.
interp::Region choose_region(const Settings& settings, const Points& points,
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

interp::Spacing choose_spacing(const Settings& settings, const Points& points,
                               const interp::Region& region,
                               std::int64_t num_observations) {
  if (settings.spacing) return *settings.spacing;
  return points.is_on_plane() ? interp::suggested_plane_spacing(region, num_observations)
                              : interp::suggested_globe_spacing(region, num_observations);
}

interp::Grid lay_grid(const Settings& settings, const Points& points,
                      const Triangulated& triangulated) {
  const interp::Region region = choose_region(settings, points, triangulated);
  if (settings.counts) {
    return points.is_on_plane() ? interp::plane_grid(region, *settings.counts)
                                : interp::globe_grid(region, *settings.counts);
  }
  const auto num_sites =
      std::visit([](const auto& t) { return t->num_sites(); }, triangulated);
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

interp::Grid choose_grid(const Settings& settings, const Points& points,
                         const Triangulated& triangulated, const Reporter& reporter) {
  const bool is_asked_for = settings.region || settings.spacing || settings.counts;
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
    if (is_asked_for) throw UsageError(error.what());
    throw located(points, error);
  }
}

/// Points on one line enclose no area, so a grid over them would be missing everywhere.
void check_dimension(const Settings& settings, const Points& points,
                     const Triangulated& triangulated) {
  if (dimension(triangulated) >= 2 ||
      settings.surface.outside == interp::Outside::nearest)
    return;
  const std::int64_t num_sites =
      std::visit([](const auto& t) { return t->num_sites(); }, triangulated);
  const std::string problem =
      num_sites == 1 ? std::string("one position encloses")
                     : fmt::format("all points lie on one {} and enclose",
                                   points.is_on_plane() ? "line" : "great circle");
  throw located(points,
                Error(problem + " no area to interpolate in; use --extrapolate nearest"));
}

interp::Field evaluate(const Surface& surface, const interp::Grid& grid,
                       Reporter& reporter) {
  return reporter.timed(Phase::evaluate, [&] {
    return std::visit(
        [&](const auto& s) { return s.grid(grid, reporter.run_options("gridding")); },
        surface);
  });
}

void say_field(const interp::Field& field, const Reporter& reporter) {
  const auto is_missing = [](double v) { return std::isnan(v); };
  const auto num_missing = std::ranges::count_if(field.values, is_missing);
  const auto num_values = static_cast<std::int64_t>(field.values.size());
  if (num_missing == num_values) {
    reporter.say(
        "grid: every node is missing; check --region, --extrapolate and --max-distance");
    return;
  }
  const auto less = [&](double a, double b) {
    return !is_missing(a) && (is_missing(b) || a < b);
  };
  const auto greater = [&](double a, double b) {
    return !is_missing(a) && (is_missing(b) || a > b);
  };
  reporter.say("grid: values {:.6g} to {:.6g}, {} of {} nodes missing",
               *std::ranges::min_element(field.values, less),
               *std::ranges::min_element(field.values, greater), num_missing, num_values);
}

io::GridInfo grid_info(const Settings& settings, const Points& points) {
  io::GridInfo info;
  info.name = points.table.value_name;
  info.long_name = points.table.value_name;
  info.units = settings.units.empty() ? points.table.value_units : settings.units;
  info.is_lonlat = !points.is_on_plane();
  info.x_name = points.table.x_name;
  info.y_name = points.table.y_name;
  info.title = settings.title;
  return info;
}

void draw(const OutputSettings& output, const std::string& format,
          const Settings& settings, const Points& points, const io::GridFile& grid) {
  io::MapOptions options;
  options.title = settings.title;
  options.draw_points = settings.draws_points;
  options.point_x = points.table.x;
  options.point_y = points.table.y;
  io::write_map(output.path, grid, options, format);
}

void write(const Settings& settings, const std::string& format, const Points& points,
           const io::GridFile& grid, Reporter& reporter) {
  reporter.timed(Phase::write, [&] {
    if (format == "png") {
      draw(settings.output, format, settings, points, grid);
    } else {
      io::write_grid(settings.output.path, grid, format);
    }
    if (!settings.map.path.empty())
      draw(settings.map, choose_map_format(settings.map), settings, points, grid);
  });
  reporter.say("wrote {}", settings.output.path);
  if (!settings.map.path.empty()) reporter.say("wrote {}", settings.map.path);
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  const std::string format = choose_format(settings.output, {"nc", "csv", "asc", "png"});
  check_output(settings.output.path, {settings.points.path});
  if (!settings.map.path.empty()) {
    static_cast<void>(choose_map_format(settings.map));
    check_output(settings.map.path, {settings.points.path});
  }
  const Points points = read_points(settings.points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  check_dimension(settings, points, triangulated);
  const interp::Grid grid = choose_grid(settings, points, triangulated, reporter);
  const Surface surface = fit(points, triangulated, settings.surface, reporter);
  const io::GridFile file{evaluate(surface, grid, reporter), grid_info(settings, points)};
  say_field(file.field, reporter);
  write(settings, format, points, file, reporter);
  return ExitCode::done;
}

void add_grid_options(CLI::App& app, Settings& settings) {
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

void add_picture_options(CLI::App& app, Settings& settings) {
  app.add_option("--map", settings.map.path,
                 "Draw a map besides: .png, .svg, .pdf or .eps")
      ->type_name("FILE");
  app.add_flag("--points", settings.draws_points, "Show the points on the map");
  app.add_option("--title", settings.title, "Title of the grid and the map")
      ->type_name("TEXT");
  app.add_option("--units", settings.units,
                 "Unit of the values (default: from the column's name)")
      ->type_name("TEXT");
}

}  // namespace

Command add_grid_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand("grid", "Scattered values to a regular grid");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::needed);
  add_grid_options(app, *settings);
  add_surface_options(app, settings->surface);
  add_output_options(app, settings->output,
                     ".nc (NetCDF, CF), .csv, .asc (Esri), .png (a map)");
  add_picture_options(app, *settings);
  app.footer(
      "Nodes lie on multiples of the spacing; a global grid has its poles and does not "
      "repeat its first\n"
      "meridian. What no triangle encloses is missing unless --extrapolate is given.\n\n"
      "Example:\n  delone grid geoid.csv --spacing 0.5 -o geoid.nc --map geoid.png");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
