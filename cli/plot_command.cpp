#include "cli/plot_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "cli/constraints.hpp"
#include "cli/output.hpp"
#include "cli/picture_options.hpp"
#include "cli/points.hpp"
#include "cli/triangle_output.hpp"
#include "io/grid_file.hpp"
#include "io/map.hpp"
#include "io/output_file.hpp"
#include "io/triangle_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings file;  ///< FILE, and how it is read if it is a table of points
  std::string variable, points, triangles;
  OutputSettings output;
  PictureSettings picture;
  bool keeps_outside = false;
};

constexpr io::Color segment_color{190, 40, 40};

/// The positions that --points asks for; none without it.
io::PointTable observations(const Settings& settings, Reporter& reporter) {
  if (settings.points.empty()) return {};
  PointSettings points;
  points.path = settings.points;
  points.columns.needs_value = false;
  return read_points(points, reporter).table;
}

void refuse_mesh_options(const Settings& settings) {
  const PictureSettings& picture = settings.picture;
  if (picture.show.empty() && picture.labels.empty() && picture.window.empty() &&
      picture.view.empty() && settings.triangles.empty())
    return;
  throw UsageError(
      "--show, --labels, --window, --view and --triangles are for pictures of points and "
      "triangles; this file holds a grid");
}

void plot_grid(const Settings& settings, const std::string& format, Reporter& reporter) {
  refuse_mesh_options(settings);
  const std::string& path = settings.file.path;
  const io::GridFile grid =
      reporter.timed(Phase::read, [&] { return io::read_grid(path, settings.variable); });
  const io::PointTable points = observations(settings, reporter);
  reporter.say("{}: {} x {} nodes of '{}'", path, grid.field.grid.x.size,
               grid.field.grid.y.size, grid.info.name);
  io::MapOptions options;
  options.title = settings.picture.title;
  options.width_px = settings.picture.width_px;
  options.draw_points = !settings.points.empty();
  options.point_x = points.x;
  options.point_y = points.y;
  reporter.timed(Phase::write,
                 [&] { io::write_map(settings.output.path, grid, options, format); });
}

void draw(const Settings& settings, const io::Mesh& mesh, const io::ShownParts& parts,
          const std::string& format, Reporter& reporter) {
  reporter.timed(Phase::write, [&] {
    draw_mesh(settings.output.path, mesh, settings.picture, parts, format);
  });
}

void plot_mesh(const Settings& settings, const std::string& format, Reporter& reporter) {
  const std::string& path = settings.file.path;
  const io::Mesh mesh = reporter.timed(Phase::read, [&] { return io::read_mesh(path); });
  reporter.say("{}: {} over {}, on the {}", path, counted(mesh.num_cells(), "cell"),
               counted(mesh.num_nodes(), "node"),
               mesh.space == io::Mesh::Space::plane ? "plane" : "sphere");
  draw(settings, mesh, shown_parts(settings.picture, {}), format, reporter);
}

/// The triangles of the points: from --triangles, or their Delaunay triangulation.
std::vector<io::Triangle> triangles_of(const Settings& settings, const Points& points,
                                       Reporter& reporter) {
  if (!settings.triangles.empty())
    return reporter
        .timed(
            Phase::read,
            [&] { return io::read_triangles(settings.triangles, points.table.num_rows); })
        .triangles;
  const Triangulated triangulated = triangulate(points, reporter);
  return numbered_triangles(
      points, std::visit([](const auto& t) { return t->triangles(); }, triangulated));
}

void plot_points(const Settings& settings, const std::string& format,
                 Reporter& reporter) {
  io::ShownParts usual;
  usual.triangles = !settings.triangles.empty();
  io::ShownParts parts = shown_parts(settings.picture, usual);
  const Points points = read_points(settings.file, reporter);
  // Repeats are found by triangulating.
  if (points.duplicates == interp::Duplicates::error && !needs_triangles(parts))
    static_cast<void>(triangulate(points, reporter));
  parts.base = points.table.base;
  io::Mesh mesh = output_nodes(points);
  if (needs_triangles(parts))
    for (const io::Triangle& triangle : triangles_of(settings, points, reporter))
      mesh.add_cell(triangle);
  draw(settings, mesh, parts, format, reporter);
}

/// The segments as they stand in the file.
io::PictureLayer segment_layer(const tripack::PlanarGraph& graph) {
  io::PictureLayer layer{segment_color, 2, {}};
  for (const auto& segment : graph.segments) {
    io::PictureLine& line = layer.lines.emplace_back();
    for (const auto end : segment) {
      const tripack::Point2 p = graph.points[static_cast<std::size_t>(end)];
      line.push_back({p.x, p.y});
    }
  }
  if (layer.lines.size() > 5000) layer.width = 1;
  return layer;
}

/// Segments, and the triangles of the domain that they enclose.
void plot_poly(const Settings& settings, const std::string& format, Reporter& reporter) {
  ConstraintSettings constraints;
  constraints.keeps_outside = settings.keeps_outside;
  const ConstrainedInput input = read_constrained(settings.file, "", reporter);
  io::ShownParts parts = shown_parts(settings.picture, {});
  parts.base = input.file_base.value_or(0);
  io::Mesh mesh = needs_triangles(parts) ? io::Mesh() : output_nodes(input.points);
  if (needs_triangles(parts)) {
    ConstrainedOutput domain = triangulate(input, constraints, reporter);
    mesh = std::move(domain.nodes);
    for (const io::Triangle& triangle : domain.triangles) mesh.add_cell(triangle);
  }
  io::Picture picture = io::make_picture(mesh, parts);
  picture.layers.push_back(segment_layer(input.graph));
  reporter.timed(Phase::write, [&] {
    draw_picture(settings.output.path, picture, settings.picture, format);
  });
}

/// An .ele file is drawn over the .node file of the same name.
Settings with_nodes_of_elements(Settings settings) {
  if (io::file_format(settings.file.path) != "ele") return settings;
  settings.triangles = settings.file.path;
  settings.file.path =
      std::filesystem::path(settings.triangles).replace_extension(".node").string();
  return settings;
}

ExitCode run(const Settings& given, Reporter& reporter) {
  const std::string format = choose_map_format(given.output);
  const Settings settings = with_nodes_of_elements(given);
  const std::string& path = settings.file.path;
  check_output(settings.output.path, {path, settings.points, settings.triangles});
  const std::string kind = io::file_format(path);
  const bool is_grid = kind == "nc" && !io::holds_ugrid(path);
  if (is_grid)
    plot_grid(settings, format, reporter);
  else if (is_poly(path))
    plot_poly(settings, format, reporter);
  else if (io::is_mesh_format(kind))
    plot_mesh(settings, format, reporter);
  else
    plot_points(settings, format, reporter);
  reporter.say("wrote {}", settings.output.path);
  return ExitCode::done;
}

}  // namespace

Command add_plot_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand(
      "plot", "A picture of a grid, of points or of a triangulation");
  const auto settings = std::make_shared<Settings>();
  app.add_option("FILE", settings->file.path,
                 "A NetCDF grid; a mesh (.off, .ply, .vtu, UGRID .nc, or .ele beside its "
                 ".node); a .poly file; or a table of points")
      ->required()
      ->type_name("");
  app.add_option("--variable", settings->variable,
                 "Grids: which variable (default: the first of two dimensions)")
      ->type_name("NAME");
  add_output_options(app, settings->output, ".png, .svg, .pdf or .eps");
  app.add_option("--points", settings->points, "Grids: show the points of this table")
      ->type_name("FILE");
  app.add_option("--triangles", settings->triangles,
                 "Points: their triangles, if they are to be others than Delaunay's")
      ->type_name("FILE");
  add_table_options(app, settings->file);
  app.add_flag("--keep-outside", settings->keeps_outside,
               ".poly: the triangles of the whole hull, holes too");
  settings->file.columns.needs_value = false;
  add_picture_options(app, settings->picture);
  app.footer(
      "Example:\n  delone plot geoid.nc -o geoid.svg --title \"Height of the geoid\"\n"
      "  delone plot stations.csv -o stations.pdf --show points,voronoi --view 10/50\n"
      "  delone plot lake.poly -o lake.png");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
