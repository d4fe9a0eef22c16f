#include "cli/plot_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "io/grid_file.hpp"
#include "io/map.hpp"

namespace delone::cli {
namespace {

struct Settings {
  std::string grid, variable;
  OutputSettings output;
  std::string points, title;
  int width_px = 1200;
};

/// The positions that --points asks for; none without it.
io::PointTable observations(const Settings& settings, Reporter& reporter) {
  if (settings.points.empty()) return {};
  PointSettings points;
  points.path = settings.points;
  points.columns.needs_value = false;
  return read_points(points, reporter).table;
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  const std::string format = choose_map_format(settings.output);
  check_output(settings.output.path, {settings.grid, settings.points});
  const io::GridFile grid = reporter.timed(
      Phase::read, [&] { return io::read_grid(settings.grid, settings.variable); });
  const io::PointTable points = observations(settings, reporter);
  reporter.say("{}: {} x {} nodes of '{}'", settings.grid, grid.field.grid.x.size,
               grid.field.grid.y.size, grid.info.name);
  io::MapOptions options;
  options.title = settings.title;
  options.width_px = settings.width_px;
  options.draw_points = !settings.points.empty();
  options.point_x = points.x;
  options.point_y = points.y;
  reporter.timed(Phase::write,
                 [&] { io::write_map(settings.output.path, grid, options, format); });
  reporter.say("wrote {}", settings.output.path);
  return ExitCode::done;
}

}  // namespace

Command add_plot_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand("plot", "A picture of a grid");
  const auto settings = std::make_shared<Settings>();
  app.add_option("GRID", settings->grid, "A NetCDF file with a regular grid")
      ->required()
      ->type_name("");
  app.add_option("--variable", settings->variable,
                 "Which variable (default: the first of two dimensions)")
      ->type_name("NAME");
  add_output_options(app, settings->output, ".png, .svg, .pdf or .eps");
  app.add_option("--points", settings->points, "Show the points of this table")
      ->type_name("FILE");
  app.add_option("--title", settings->title, "Title (default: from the variable)")
      ->type_name("TEXT");
  app.add_option("--width", settings->width_px, "Width in pixels (default: 1200)")
      ->type_name("N")
      ->check(CLI::Range(200, 10000));
  app.footer(
      "Example:\n  delone plot geoid.nc -o geoid.svg --title \"Height of the geoid\"");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
