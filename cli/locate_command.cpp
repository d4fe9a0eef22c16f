#include "cli/locate_command.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "io/output_file.hpp"
#include "stripack/locate_batch.hpp"
#include "tripack/locate_batch.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  QuerySettings queries;
  std::string output = "/dev/stdout";
};

std::vector<std::int32_t> locate_all(const Triangulated& triangulated,
                                     const Points& queries, const RunOptions& options) {
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated))
    return tripack::locate_triangles(**plane, plane_points(queries), options);
  return stripack::locate_triangles(*std::get<GlobeTriangulation>(triangulated),
                                    directions(queries), options);
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_inputs(settings.points.path, settings.queries.path);
  check_output(settings.output, {settings.points.path, settings.queries.path});
  const Points points = read_points(settings.points, reporter);
  const Points queries =
      read_queries(settings.queries, settings.points, points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  const auto located = reporter.timed(Phase::evaluate, [&] {
    return locate_all(triangulated, queries, reporter.run_options("locating"));
  });
  reporter.timed(Phase::write, [&] {
    const auto append = [&](fmt::memory_buffer& buffer, std::size_t i) {
      fmt::format_to(std::back_inserter(buffer), ",{}", located[i]);
    };
    io::write_text(settings.output, query_csv(queries, {"triangle"}, append));
  });
  return ExitCode::done;
}

}  // namespace

Command add_locate_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("locate", "The triangle that holds each query point");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  add_query_options(app, settings->queries);
  app.add_option("-o,--output", settings->output,
                 "CSV to write (default: standard output)")
      ->type_name("FILE");
  app.footer(
      "Triangles are counted from 0 in the order in which `delone triangulate` writes "
      "them; -1 is\n"
      "outside. A query on an edge or a node belongs to one of the triangles there, "
      "always "
      "the same.\n\n"
      "Example:\n  delone locate stations.csv cities.csv -o cities_triangle.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
