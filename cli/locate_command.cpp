#include "cli/locate_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "io/output_file.hpp"

namespace delone::cli {
namespace {

using Triangle = std::array<std::int32_t, 3>;

struct Settings {
  PointSettings points;
  QuerySettings queries;
  std::string output = "/dev/stdout";
};

/// The place of the triangle on the left of `arc` in the sorted list that `triangulate`
/// writes.
template <class Triangulation>
std::int64_t triangle_number(const Triangulation& t,
                             const std::vector<Triangle>& triangles, delaunay::Arc arc) {
  Triangle corners = t.adjacency().left(arc);
  for (std::int32_t& corner : corners)
    corner = t.rows()[static_cast<std::size_t>(corner)];
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return std::ranges::lower_bound(triangles, corners) - triangles.begin();
}

template <class Triangulation, class Point>
std::vector<std::int64_t> locate_all(const Triangulation& t,
                                     const std::vector<Point>& queries) {
  std::vector<std::int64_t> result(queries.size(), -1);
  if (t.dimension() < 2) return result;
  const std::vector<Triangle> triangles = t.triangles();
  delaunay::Arc arc;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    // From the last hit: queries that follow a track are a step or two apart.
    arc = t.find(queries[i], arc);
    if (t.adjacency().has_left(arc)) result[i] = triangle_number(t, triangles, arc);
  }
  return result;
}

std::vector<std::int64_t> locate_all(const Triangulated& triangulated,
                                     const Points& queries) {
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated)) {
    return locate_all(**plane, plane_points(queries));
  }
  return locate_all(*std::get<GlobeTriangulation>(triangulated), directions(queries));
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_inputs(settings.points.path, settings.queries.path);
  check_output(settings.output, {settings.points.path, settings.queries.path});
  const Points points = read_points(settings.points, reporter);
  const Points queries =
      read_queries(settings.queries, settings.points, points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  const auto located =
      reporter.timed(Phase::evaluate, [&] { return locate_all(triangulated, queries); });
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
      "outside. A query on an edge or a node belongs to one of the triangles there.\n\n"
      "Example:\n  delone locate stations.csv cities.csv -o cities_triangle.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
