#include "cli/triangulate_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/constraints.hpp"
#include "cli/output.hpp"
#include "cli/points.hpp"
#include "cli/triangle_output.hpp"
#include "io/poly_file.hpp"

namespace delone::cli {
namespace {

namespace fs = std::filesystem;

struct Settings {
  PointSettings points;
  ConstraintSettings constraints;
  TriangleOutput output;
};

void write(const Settings& settings, const std::string& format, const Points& points,
           const Triangulated& triangulated) {
  const auto triangles = numbered_triangles(
      points, std::visit([](const auto& t) { return t->triangles(); }, triangulated));
  const auto file_base =
      points.table.is_node_file ? std::optional(points.table.base) : std::nullopt;
  write_triangulation(settings.output, format, output_nodes(points), triangles, file_base,
                      [&] { return neighbor_lists(points, triangulated); });
}

/// Where added vertices are written. Formats that only number nodes leave them to an
/// .ele file's companion of the same name, or to another run.
void write_added(const Settings& settings, const std::string& format,
                 const ConstrainedInput& input, const ConstrainedOutput& result,
                 Reporter& reporter) {
  const std::string& path = settings.output.output.path;
  if (result.num_added == 0 || !names_rows_only(format)) return;
  if (format != "ele" || path == "-") {
    reporter.say("{}: the last nodes of -o FILE.node",
                 counted(result.num_added, "added point"));
    return;
  }
  const std::string nodes = fs::path(path).replace_extension(".node").string();
  check_output(nodes,
               {settings.points.path, settings.constraints.path, input.points.path});
  TriangleOutput output = settings.output;
  output.output.path = nodes;
  output.writes_neighbors = false;
  write_triangulation(output, "node", result.nodes, {}, input.file_base, {});
  reporter.say("wrote {}: {}", nodes, counted(result.num_added, "added point"));
}

/// The domain as segments that only meet in nodes: what its triangles can be checked
/// against.
void write_poly(const Settings& settings, const ConstrainedInput& input,
                const ConstrainedOutput& result) {
  io::PolyFile file;
  file.nodes.x = result.nodes.x;
  file.nodes.y = result.nodes.y;
  file.nodes.base = settings.output.base.value_or(input.file_base.value_or(0));
  file.graph.segments = result.pieces;
  file.graph.holes = hole_points(input, settings.constraints, result);
  file.graph.regions = input.graph.regions;
  io::write_poly(settings.output.output.path, file);
}

/// Triangles of the domain that segments enclose.
void run_constrained(const Settings& settings, const std::string& format,
                     Reporter& reporter) {
  if (lists_neighbors(format))
    throw UsageError(
        "a domain with holes has no lists of neighbours; write its triangles (.ele, "
        ".tri)");
  const ConstrainedInput input =
      read_constrained(settings.points, settings.constraints.path, reporter);
  ConstrainedOutput result = triangulate(input, settings.constraints, reporter);
  reporter.timed(Phase::write, [&] {
    if (format == "poly") return write_poly(settings, input, result);
    write_added(settings, format, input, result, reporter);
    write_triangulation(settings.output, format, std::move(result.nodes),
                        result.triangles, input.file_base, {});
  });
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  const std::string format = choose_triangle_format(settings.output);
  const std::string& path = settings.output.output.path;
  if (has_segments(settings.points.path, settings.constraints)) {
    check_output(path, {settings.points.path, settings.constraints.path});
    run_constrained(settings, format, reporter);
    reporter.say("wrote {}", path);
    return ExitCode::done;
  }
  if (format == "poly")
    throw UsageError(
        "a .poly file holds segments; give some with --constraints, or write "
        "the points (.node)");
  check_output(path, {settings.points.path});
  const Points points = read_points(settings.points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  reporter.timed(Phase::write, [&] { write(settings, format, points, triangulated); });
  reporter.say("wrote {}", path);
  return ExitCode::done;
}

}  // namespace

Command add_triangulate_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("triangulate", "Delaunay triangles of scattered points");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  app.get_option("POINTS")->description(
      "Table of points: CSV, TSV, blanks or .node; - reads standard input; a .poly file "
      "with points and segments; or a mesh (.off, .ply, .vtu, UGRID .nc), for its nodes");
  add_domain_options(app, settings->constraints);
  add_refinement_options(app, settings->constraints);
  add_triangle_output_options(app, settings->output);
  app.footer(
      "Nodes are data rows counted from --base; of rows at one position the first is "
      "used. Points that are added get the numbers after them; an .ele file then comes "
      "with "
      "a .node file.\n\n"
      "Example:\n  delone triangulate stations.csv -o stations.tri --base 1\n"
      "  delone triangulate lake.poly -o lake.ele --min-angle 25 --max-area 0.5\n"
      "  delone triangulate stations.csv -o stations.svg --show points,voronoi --labels "
      "nodes\n"
      "  delone triangulate lake.poly -o lake.1.poly --min-angle 25");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
