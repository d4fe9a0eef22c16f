#include "cli/nearest_command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "io/output_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  QuerySettings queries;
  std::string output = "/dev/stdout";
};

std::vector<std::int32_t> nearest_rows(const Triangulated& triangulated,
                                       const Points& queries) {
  const auto find_all = [](const auto& t, const auto& positions) {
    std::vector<std::int32_t> rows;
    rows.reserve(positions.size());
    for (const auto& p : positions) {
      rows.push_back(t.nearest(p, rows.empty() ? delaunay::none : rows.back()));
    }
    return rows;
  };
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated)) {
    return find_all(**plane, plane_points(queries));
  }
  return find_all(*std::get<GlobeTriangulation>(triangulated), directions(queries));
}

/// Data units on the plane, kilometres on the globe.
double distance(const Points& points, std::size_t row, const Points& queries,
                std::size_t query) {
  const io::PointTable &from = queries.table, &to = points.table;
  if (points.is_on_plane())
    return std::hypot(from.x[query] - to.x[row], from.y[query] - to.y[row]);
  const stripack::LonLat a{from.x[query], from.y[query]}, b{to.x[row], to.y[row]};
  if (points.domain == Domain::ellipsoid) return stripack::geodesic_km(a, b);
  return stripack::angle(stripack::Direction::from(a), stripack::Direction::from(b)) *
         stripack::earth_radius_km;
}

std::string as_text(const Points& points, const Points& queries,
                    const std::vector<std::int32_t>& nearest) {
  const auto append = [&](fmt::memory_buffer& buffer, std::size_t i) {
    fmt::format_to(std::back_inserter(buffer), ",{}",
                   node_number(points.table, nearest[i]));
    append_number(buffer,
                  distance(points, static_cast<std::size_t>(nearest[i]), queries, i));
  };
  return query_csv(queries, {"node", points.is_on_plane() ? "distance" : "distance_km"},
                   append);
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_inputs(settings.points.path, settings.queries.path);
  check_output(settings.output, {settings.points.path, settings.queries.path});
  const Points points = read_points(settings.points, reporter);
  const Points queries =
      read_queries(settings.queries, settings.points, points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  const auto nearest = reporter.timed(
      Phase::evaluate, [&] { return nearest_rows(triangulated, queries); });
  reporter.timed(Phase::write, [&] {
    io::write_text(settings.output, as_text(points, queries, nearest));
  });
  return ExitCode::done;
}

}  // namespace

Command add_nearest_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("nearest", "The node nearest to each query point");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  add_query_options(app, settings->queries);
  app.add_option("-o,--output", settings->output,
                 "CSV to write (default: standard output)")
      ->type_name("FILE");
  app.footer(
      "Nodes are data rows counted from 0. Distances are in the unit of x and y, on the "
      "globe in\n"
      "kilometres; --on ellipsoid measures geodesics to the node nearest in "
      "direction.\n\n"
      "Example:\n  delone nearest stations.csv cities.csv -o cities_station.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
