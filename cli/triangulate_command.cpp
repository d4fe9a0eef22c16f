#include "cli/triangulate_command.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "io/triangle_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  OutputSettings output;
  int base = 0;
  bool is_canonical = false;  // every output is; the flag says that a script relies on it
  bool writes_neighbors = false;
};

std::vector<io::Triangle> numbered_triangles(const Points& points,
                                             const Triangulated& triangulated) {
  auto triangles = std::visit([](const auto& t) { return t->triangles(); }, triangulated);
  if (points.table.row.empty()) return triangles;
  for (io::Triangle& triangle : triangles) {
    for (std::int32_t& corner : triangle) corner = node_number(points.table, corner);
  }
  return triangles;
}

struct NeighborLists {
  std::vector<std::int32_t> nodes;
  std::vector<std::vector<std::int32_t>> lists;
};

NeighborLists neighbor_lists(const Points& points, const Triangulated& triangulated) {
  NeighborLists result;
  const auto collect = [&](const auto& t) {
    for (std::int32_t row = 0; row < t->num_rows(); ++row) {
      const auto site =
          static_cast<std::size_t>(t->sites()[static_cast<std::size_t>(row)]);
      if (t->rows()[site] != row)
        continue;  // a repeat: its first row answers for the position
      result.nodes.push_back(node_number(points.table, row));
      auto& list = result.lists.emplace_back(t->neighbors(row));
      for (std::int32_t& node : list) node = node_number(points.table, node);
    }
  };
  std::visit(collect, triangulated);
  return result;
}

void write(const Settings& settings, const std::string& format, const Points& points,
           const Triangulated& triangulated) {
  const std::string& path = settings.output.path;
  if (format == "adj") {
    const NeighborLists neighbors = neighbor_lists(points, triangulated);
    io::write_adj(path, neighbors.nodes, neighbors.lists, settings.base);
    return;
  }
  const auto triangles = numbered_triangles(points, triangulated);
  if (format == "tri") io::write_tri(path, triangles, settings.base);
  if (format == "ele") io::write_ele(path, triangles, settings.base);
  if (settings.writes_neighbors) {
    io::write_neigh(std::filesystem::path(path).replace_extension(".neigh").string(),
                    triangles, settings.base);
  }
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  const std::string format = choose_format(settings.output, {"tri", "ele", "adj"});
  if (settings.writes_neighbors && (format != "ele" || settings.output.path == "-")) {
    throw UsageError(
        "--neighbors writes a .neigh file beside an .ele file; give -o FILE.ele");
  }
  check_output(settings.output.path, {settings.points.path});
  const Points points = read_points(settings.points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  reporter.timed(Phase::write, [&] { write(settings, format, points, triangulated); });
  reporter.say("wrote {}", settings.output.path);
  return ExitCode::done;
}

}  // namespace

Command add_triangulate_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("triangulate", "Delaunay triangles of scattered points");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  add_output_options(app, settings->output,
                     ".tri (index triples), .ele (of Triangle), .adj (a node and its "
                     "neighbours counter-clockwise)");
  app.add_option("--base", settings->base,
                 "Number of the first data row: 0 (default) or 1")
      ->type_name("N")
      ->check(CLI::Range(0, 1));
  app.add_flag("--canonical", settings->is_canonical,
               "Smallest corner first, triangles sorted (they always are)");
  app.add_flag("--neighbors", settings->writes_neighbors,
               "Beside OUT.ele write OUT.neigh");
  app.footer(
      "Nodes are data rows counted from --base; of rows at one position the first is "
      "used.\n\n"
      "Example:\n  delone triangulate stations.csv -o stations.tri --base 1");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
