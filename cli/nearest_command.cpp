#include "cli/nearest_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "io/output_file.hpp"
#include "stripack/neighbor_search.hpp"
#include "tripack/neighbor_search.hpp"

namespace delone::cli {
namespace {

using delaunay::NeighborTable;

struct Settings {
  PointSettings points;
  QuerySettings queries;
  std::string output = "/dev/stdout";
  std::optional<std::int32_t> num_nearest;
  std::optional<double> within;  ///< data units on the plane, kilometres on the globe
};

/// Several lines a query, or one without a rank?
bool is_list(const Settings& settings) {
  return settings.within || settings.num_nearest.value_or(1) > 1;
}

NeighborTable on_plane(const Settings& settings, const tripack::Triangulation& t,
                       const Points& queries, const RunOptions& options) {
  const auto positions = plane_points(queries);
  if (settings.within)
    return tripack::nodes_within(t, positions, *settings.within, options);
  return tripack::nearest_k(t, positions, settings.num_nearest.value_or(1), options);
}

NeighborTable on_globe(const Settings& settings, const stripack::Triangulation& t,
                       const Points& queries, const RunOptions& options) {
  const auto positions = directions(queries);
  const std::int32_t k = settings.num_nearest.value_or(1);
  if (queries.domain == Domain::ellipsoid) {
    return settings.within
               ? stripack::nodes_within_wgs84(t, positions, *settings.within, options)
               : stripack::nearest_k_wgs84(t, positions, k, options);
  }
  NeighborTable table =
      settings.within
          ? stripack::nodes_within(t, positions,
                                   *settings.within / stripack::earth_radius_km, options)
          : stripack::nearest_k(t, positions, k, options);
  for (double& distance : table.distances) distance *= stripack::earth_radius_km;
  return table;
}

NeighborTable find_nearest(const Settings& settings, const Triangulated& triangulated,
                           const Points& queries, const RunOptions& options) {
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated))
    return on_plane(settings, **plane, queries, options);
  return on_globe(settings, *std::get<GlobeTriangulation>(triangulated), queries,
                  options);
}

/// At most as many a query as were asked for beside a radius.
std::size_t num_listed(const Settings& settings, const NeighborTable& table,
                       std::int64_t query) {
  const std::size_t num_found = table.rows_of(query).size();
  if (!settings.num_nearest) return num_found;
  return std::min(num_found, static_cast<std::size_t>(*settings.num_nearest));
}

/// One entry, or empty fields where a query has none.
void append_entry(fmt::memory_buffer& buffer, const Points& points,
                  const NeighborTable& table, std::int64_t query, std::size_t rank) {
  if (rank >= table.rows_of(query).size()) {
    fmt::format_to(std::back_inserter(buffer), ",");
    append_number(buffer, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  fmt::format_to(std::back_inserter(buffer), ",{}",
                 node_number(points.table, table.rows_of(query)[rank]));
  append_number(buffer, table.distances_of(query)[rank]);
}

/// A line for each node of each query, nearest first, with its rank from 1; one with
/// empty fields for a query without nodes.
std::string as_list(const Settings& settings, const Points& points, const Points& queries,
                    const NeighborTable& table, const std::string& distance_name) {
  fmt::memory_buffer buffer;
  const auto to = std::back_inserter(buffer);
  const char delimiter = queries.table.delimiter;
  if (!queries.table.header.empty()) {
    fmt::format_to(to, "{},rank,node,{}\n", as_csv(queries.table.header, delimiter),
                   distance_name);
  }
  for (std::size_t i = 0; i < queries.table.text.size(); ++i) {
    const auto query = static_cast<std::int64_t>(i);
    const std::string line = as_csv(queries.table.text[i], delimiter);
    const std::size_t count = num_listed(settings, table, query);
    for (std::size_t rank = 0; rank < std::max<std::size_t>(1, count); ++rank) {
      count == 0 ? fmt::format_to(to, "{},", line)
                 : fmt::format_to(to, "{},{}", line, rank + 1);
      append_entry(buffer, points, table, query, rank);
      buffer.push_back('\n');
    }
  }
  return {buffer.data(), buffer.size()};
}

std::string as_text(const Settings& settings, const Points& points, const Points& queries,
                    const NeighborTable& table) {
  const std::string name = points.is_on_plane() ? "distance" : "distance_km";
  if (is_list(settings)) return as_list(settings, points, queries, table, name);
  return query_csv(queries, {"node", name},
                   [&](fmt::memory_buffer& buffer, std::size_t i) {
                     append_entry(buffer, points, table, static_cast<std::int64_t>(i), 0);
                   });
}

void say_found(const Settings& settings, const NeighborTable& table,
               const Reporter& reporter) {
  if (!settings.within) return;
  std::int64_t num_empty = 0;
  for (std::int64_t i = 0; i < table.num_queries(); ++i)
    num_empty += table.rows_of(i).empty() ? 1 : 0;
  reporter.say("{} of {} have no node within {}", num_empty,
               counted(table.num_queries(), "query point"), *settings.within);
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_inputs(settings.points.path, settings.queries.path);
  check_output(settings.output, {settings.points.path, settings.queries.path});
  const Points points = read_points(settings.points, reporter);
  const Points queries =
      read_queries(settings.queries, settings.points, points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  const NeighborTable table = reporter.timed(Phase::evaluate, [&] {
    return find_nearest(settings, triangulated, queries,
                        reporter.run_options("searching"));
  });
  say_found(settings, table, reporter);
  reporter.timed(Phase::write, [&] {
    io::write_text(settings.output, as_text(settings, points, queries, table));
  });
  return ExitCode::done;
}

}  // namespace

Command add_nearest_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("nearest", "The nodes nearest to each query point");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  add_query_options(app, settings->queries);
  app.add_option("-k", settings->num_nearest,
                 "Nodes a query (default: 1, with --within all)")
      ->type_name("K")
      ->check(CLI::Range(1, std::numeric_limits<std::int32_t>::max()));
  app.add_option("--within", settings->within,
                 "Only nodes at most D away (unit of x and y, on the globe km)")
      ->type_name("D")
      ->check(refuse_negative);
  app.add_option("-o,--output", settings->output,
                 "CSV to write (default: standard output)")
      ->type_name("FILE");
  app.footer(
      "Nodes are data rows counted from 0. Distances are in the unit of x and y, on the "
      "globe in\n"
      "kilometres: great circles, with --on ellipsoid geodesics on WGS84. With -k or "
      "--within a line\n"
      "for each node, nearest first, and its rank; a query without nodes has one line "
      "with empty fields.\n\n"
      "Example:\n  delone nearest stations.csv cities.csv -k 3 -o cities_station.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
