#include "cli/hull_command.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "io/output_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  std::string output = "/dev/stdout";
};

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_output(settings.output, {settings.points.path});
  const Points points = read_points(settings.points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  const auto boundary =
      std::visit([](const auto& t) { return t->boundary(); }, triangulated);
  if (boundary.empty()) reporter.say("the points go round the sphere: there is no hull");
  std::string text;
  for (const std::int32_t row : boundary)
    text += fmt::format("{}\n", node_number(points.table, row));
  reporter.timed(Phase::write, [&] { io::write_text(settings.output, text); });
  return ExitCode::done;
}

}  // namespace

Command add_hull_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("hull", "Nodes of the convex hull, counter-clockwise");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  app.add_option("-o,--output", settings->output,
                 "File to write (default: standard output)")
      ->type_name("FILE");
  app.footer(
      "One data row number a line, counted from 0, points on hull edges included. Points "
      "on one line\n"
      "give the chain from end to end; points all round the sphere have no hull.\n\n"
      "Example:\n  delone hull stations.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
