#include "cli/grid_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/arc_tension.hpp"
#include "cli/constrained_surface.hpp"
#include "cli/cross_validation.hpp"
#include "cli/derivatives.hpp"
#include "cli/grid_choice.hpp"
#include "cli/output.hpp"
#include "cli/points.hpp"
#include "cli/smoothing.hpp"
#include "cli/surface.hpp"
#include "cli/vector_field.hpp"
#include "interp/grid.hpp"
#include "io/grid_file.hpp"
#include "io/map.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  ConstraintSettings constraints;
  SurfaceSettings surface;
  OutputSettings output;
  VectorSettings vector;
  CrossValidationSettings validation;
  GridSettings grid;
  OutputSettings map;
  std::string title, units;
  bool draws_points = false;
};

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

void say_field(const std::string& name, const std::vector<double>& values,
               const Reporter& reporter) {
  const auto is_missing = [](double v) { return std::isnan(v); };
  const auto num_missing = std::ranges::count_if(values, is_missing);
  const auto num_values = static_cast<std::int64_t>(values.size());
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
  reporter.say("grid: {} {:.6g} to {:.6g}, {} of {} nodes missing", name,
               *std::ranges::min_element(values, less),
               *std::ranges::min_element(values, greater), num_missing, num_values);
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

void check_vector(const Settings& settings) {
  if (settings.vector.is_wanted &&
      has_segments(settings.points.path, settings.constraints))
    throw UsageError("--vector does not go with segments; leave out one of them");
  if (settings.vector.is_wanted && !settings.map.path.empty())
    throw UsageError(
        "--map draws one value; with --vector leave it out and draw a component with "
        "delone plot --variable");
}

void check_validation(const Settings& settings) {
  check_cross_validation(
      settings.validation,
      obstacle_to_validation(settings.points, settings.constraints, settings.vector),
      {settings.points.path, settings.constraints.path},
      {settings.output.path, settings.map.path});
}

/// What is for pictures needs one.
void check_points(const Settings& settings, const std::string& format) {
  if (settings.draws_points && format != "png" && settings.map.path.empty())
    throw UsageError("--points shows them on a map; give --map FILE or write a .png");
}

std::string choose_format(const Settings& settings) {
  if (settings.vector.is_wanted) return choose_format(settings.output, {"nc", "csv"});
  const std::string format = choose_format(settings.output, {"nc", "csv", "asc", "png"});
  if (settings.vector.wants_derivatives && format != "nc" && format != "csv")
    throw UsageError(
        fmt::format("--derivatives are several variables, which {} does not hold; write "
                    ".nc or .csv",
                    format));
  return format;
}

/// One value and what was asked for besides.
io::GridFile fill_scalar(const Settings& settings, const Points& points,
                         const Surface& surface, const interp::Grid& grid,
                         Reporter& reporter) {
  io::GridFile file{evaluate(surface, grid, reporter), grid_info(settings, points), {}};
  say_field("values", file.field.values, reporter);
  if (!settings.vector.wants_derivatives) return file;
  file.more = derivatives_on(surface, points, file.info.units, grid, reporter);
  for (const auto& more : file.more) say_field(more.name, more.values, reporter);
  return file;
}

/// The grid's values, fitted and evaluated.
io::GridFile fill(const Settings& settings, const Points& points,
                  const Triangulated& triangulated, const interp::Grid& grid,
                  Reporter& reporter) {
  if (!settings.vector.is_wanted) {
    const Surface surface = fit(points, triangulated, settings.surface, reporter);
    return fill_scalar(settings, points, surface, grid, reporter);
  }
  const auto field = fit_vectors(points, triangulated, settings.surface, reporter);
  io::GridFile file = vectors_on(field, settings.vector, points, grid, reporter);
  file.info.title = settings.title;
  if (!settings.units.empty()) {
    file.info.units = file.more[0].units = settings.units;
    for (std::size_t i = 1; i < file.more.size(); ++i)
      file.more[i].units = settings.units + " km-1";
  }
  say_field(file.info.name, file.field.values, reporter);
  for (const auto& more : file.more) say_field(more.name, more.values, reporter);
  return file;
}

/// The same over a domain, no value reaching across its curves.
void grid_domain(const Settings& settings, const std::string& format,
                 Reporter& reporter) {
  check_curved_options(settings.points, settings.surface);
  const CurvedData data = read_curved(settings.points, settings.constraints, reporter);
  const Points& points = data.input.points;
  check_dimension(settings, points, data.domain);
  const interp::Grid grid = choose_grid(settings.grid, points, data.domain, reporter);
  const Surface surface = fit(data, settings.surface, reporter);
  const io::GridFile file = fill_scalar(settings, points, surface, grid, reporter);
  write(settings, format, points, file, reporter);
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_vector(settings);
  check_arc_tension(settings.surface);
  check_arc_tension_without(settings.vector.is_wanted         ? "--vector"
                            : settings.validation.is_wanted() ? "--cross-validate"
                            : has_segments(settings.points.path, settings.constraints)
                                ? "segments"
                                : "",
                            settings.surface);
  const std::string format = choose_format(settings);
  check_points(settings, format);
  check_output(settings.output.path, {settings.points.path, settings.constraints.path});
  if (!settings.map.path.empty()) {
    static_cast<void>(choose_map_format(settings.map));
    check_output(settings.map.path, {settings.points.path, settings.constraints.path});
  }
  check_validation(settings);
  if (has_segments(settings.points.path, settings.constraints)) {
    grid_domain(settings, format, reporter);
    return ExitCode::done;
  }
  const Points points = read_points(settings.points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  check_dimension(settings, points, triangulated);
  const interp::Grid grid = choose_grid(settings.grid, points, triangulated, reporter);
  const io::GridFile file = fill(settings, points, triangulated, grid, reporter);
  cross_validate(settings.validation, points, triangulated, settings.surface, reporter);
  write(settings, format, points, file, reporter);
  return ExitCode::done;
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
  add_vector_option(app, settings->points, settings->vector);
  app.add_flag("--derivatives", settings->vector.wants_derivatives,
               "First derivatives too, by x and y or towards east and north for each "
               "kilometre, and of c1 second ones and the Laplacian; with --vector "
               "divergence and curl (.nc, .csv)");
  add_cross_validation_option(app, settings->validation);
  add_grid_options(app, settings->grid);
  add_surface_options(app, settings->surface);
  add_arc_tension_options(app, settings->surface);
  add_smooth_options(app, settings->points, settings->surface);
  add_domain_options(app, settings->constraints);
  add_output_options(app, settings->output,
                     ".nc (NetCDF, CF), .csv, .asc (Esri), .png (a map)");
  add_picture_options(app, *settings);
  app.footer(
      "Nodes lie on multiples of the spacing; a global grid has its poles and does not "
      "repeat its first\n"
      "meridian. What no triangle encloses is missing unless --extrapolate is given.\n\n"
      "Segments (a .poly file in the place of POINTS, or --constraints) are coasts and "
      "faults: only the\n"
      "domain that they enclose is covered, and nothing is interpolated across them.\n\n"
      "Example:\n  delone grid geoid.csv --spacing 0.5 -o geoid.nc --map geoid.png\n"
      "  delone grid soundings.csv --constraints lake.geojson --method c1 -o depth.nc\n"
      "  delone grid wells.csv --constraints faults.geojson --keep-outside -o top.nc\n"
      "  delone grid geoid.csv --method c1 --derivatives -o geoid.nc --cross-validate "
      "left_out.csv\n"
      "  delone grid left_out.csv --value residual -o errors.nc --map errors.png");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
