#include "cli/voronoi_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "cli/output.hpp"
#include "cli/picture_options.hpp"
#include "cli/points.hpp"
#include "cli/triangle_output.hpp"
#include "io/cell_file.hpp"
#include "io/picture.hpp"
#include "io/voronoi_file.hpp"
#include "stripack/voronoi.hpp"
#include "tripack/voronoi.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  OutputSettings output;
  std::string region;
  PictureSettings picture;
};

struct Cells {
  io::Mesh::Space space = io::Mesh::Space::plane;
  std::vector<io::Cell> list;
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr io::Color cell_color{190, 80, 40};

std::optional<tripack::Region> parse_region(const Settings& settings) {
  if (settings.region.empty()) return std::nullopt;
  const std::vector<double> sides = parse_numbers("--region", settings.region, 4, 4);
  if (!(sides[0] < sides[1]) || !(sides[2] < sides[3]))
    throw UsageError("--region W/E/S/N needs west below east and south below north");
  return tripack::Region::box({sides[0], sides[2]}, {sides[1], sides[3]});
}

/// What the points cover and a tenth more; a square round a single place or a line.
tripack::Region box_around(const tripack::Triangulation& t) {
  tripack::Point2 low = t.points()[0], high = low;
  for (const tripack::Point2 p : t.points()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double width = std::max(high.x - low.x, high.y - low.y),
               margin = width > 0 ? width / 10 : 0.5;
  return tripack::Region::box({low.x - margin, low.y - margin},
                              {high.x + margin, high.y + margin});
}

/// The cell of every position, in the order of rows.
template <class Triangulation, class MakeCell>
std::vector<io::Cell> cells_of(const Points& points, const Triangulation& t,
                               MakeCell make_cell) {
  std::vector<io::Cell> cells;
  for (std::int32_t row = 0; row < t.num_rows(); ++row) {
    const std::int32_t site = t.sites()[static_cast<std::size_t>(row)];
    if (t.rows()[static_cast<std::size_t>(site)] != row) continue;
    io::Cell& cell = cells.emplace_back(make_cell(site));
    cell.node = node_number(points.table, row);
  }
  return cells;
}

/// With a region everything is clipped to it; without, areas are those of whole cells,
/// and unbounded ones have rings only, which end at a box round the points.
Cells plane_cells(const Points& points, const PlaneTriangulation& t,
                  const std::optional<tripack::Region>& region, Reporter& reporter) {
  if (t->num_sites() == 0) return {};
  const RunOptions run = reporter.run_options("measuring cells");
  const tripack::Voronoi diagram(t, run);
  const auto measures =
      tripack::voronoi_measures(*t, region.value_or(tripack::Region()), run);
  const tripack::Region window = region ? *region : box_around(*t);
  const auto make_cell = [&](std::int32_t site) {
    io::Cell cell;
    const tripack::CellMeasure& measure = measures[static_cast<std::size_t>(site)];
    cell.area = measure.area;
    cell.centroid = {measure.centroid.x, measure.centroid.y};
    cell.is_bounded = diagram.is_bounded(site);
    const bool is_whole = cell.is_bounded && !region;
    for (const tripack::Polygon& part :
         diagram.clipped(site, is_whole ? tripack::Region() : window)) {
      io::PlaneRing& ring = cell.rings.emplace_back();
      for (const tripack::Point2 p : part) ring.push_back({p.x, p.y});
      if (region) cell.num_corners += static_cast<std::int64_t>(ring.size());
    }
    if (!region) cell.num_corners = std::ssize(diagram.cell(site));
    return cell;
  };
  return {io::Mesh::Space::plane, cells_of(points, *t, make_cell)};
}

Cells globe_cells(const Points& points, const GlobeTriangulation& t, Reporter& reporter) {
  constexpr double longest_side = 1;  // radians
  constexpr double radius = stripack::earth_radius_km;
  const RunOptions run = reporter.run_options("measuring cells");
  const stripack::Voronoi diagram(t, run);
  const auto measures = stripack::voronoi_measures(*t, run);
  std::vector<double> areas;
  if (points.domain == Domain::ellipsoid)
    areas = stripack::voronoi_areas_km2_wgs84(diagram, run);
  const auto make_cell = [&](std::int32_t site) {
    io::Cell cell;
    const auto at = static_cast<std::size_t>(site);
    const stripack::LonLat centroid = stripack::lonlat(measures[at].centroid);
    cell.area = areas.empty() ? measures[at].area * radius * radius : areas[at];
    cell.centroid = {centroid.lon_deg, centroid.lat_deg};
    if (t->num_sites() == 1) cell.centroid = {nan, nan};
    cell.num_corners = std::ssize(diagram.cell(site));
    const auto outline = diagram.outline(site, longest_side);
    if (outline.empty()) return cell;
    io::PlaneRing& ring = cell.rings.emplace_back();
    for (const stripack::Direction& d : outline) {
      const stripack::LonLat p = stripack::lonlat(d);
      ring.push_back({p.lon_deg, p.lat_deg});
    }
    return cell;
  };
  return {io::Mesh::Space::globe, cells_of(points, *t, make_cell)};
}

Cells find_cells(const Points& points, const Triangulated& triangulated,
                 const std::optional<tripack::Region>& region, Reporter& reporter) {
  return reporter.timed(Phase::evaluate, [&] {
    if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated))
      return plane_cells(points, *plane, region, reporter);
    return globe_cells(points, std::get<GlobeTriangulation>(triangulated), reporter);
  });
}

io::PictureLayer cell_layer(const Cells& cells) {
  io::PictureLayer layer{cell_color, 1, {}};
  for (const io::Cell& cell : cells.list) {
    for (const io::PlaneRing& ring : cell.rings) {
      io::PictureLine& line = layer.lines.emplace_back(ring.begin(), ring.end());
      line.push_back(ring.front());
    }
  }
  layer.width = layer.lines.size() > 5000 ? 0.4 : 1;
  return layer;
}

void draw(const Settings& settings, const std::string& format, const Points& points,
          const Triangulated& triangulated, const Cells& cells) {
  io::ShownParts usual;
  usual.triangles = false;
  usual.voronoi = true;
  io::ShownParts parts = shown_parts(settings.picture, usual);
  const bool shows_cells = parts.voronoi;
  parts.voronoi = false;  // those found here are exact
  io::Mesh mesh = output_nodes(points);
  for (const io::Triangle& triangle : numbered_triangles(
           points,
           std::visit([](const auto& t) { return t->triangles(); }, triangulated)))
    mesh.add_cell(triangle);
  io::Picture picture = io::make_picture(mesh, parts);
  if (shows_cells) picture.layers.push_back(cell_layer(cells));
  draw_picture(settings.output.path, picture, settings.picture, format);
}

void write(const Settings& settings, const std::string& format, const Points& points,
           const Triangulated& triangulated, const Cells& cells) {
  const std::string& path = settings.output.path;
  if (format == "csv") {
    io::write_cells_csv(path, cells.space, cells.list);
  } else if (format == "geojson") {
    io::write_cells_geojson(path, cells.space, cells.list);
  } else if (format == "nc") {
    const io::Mesh mesh = io::cell_mesh(cells.space, cells.list);
    if (mesh.num_cells() == 0)
      throw Error("there is no cell with corners; write .csv instead");
    io::write_mesh(path, mesh, format);
  } else {
    draw(settings, format, points, triangulated, cells);
  }
}

/// The files of Triangle hold the diagram, not its cells.
bool is_diagram(const std::string& format) {
  return format == "v.node" || format == "v.edge";
}

void check_diagram(const std::string& format, const Settings& settings,
                   const Points& points) {
  if (!is_diagram(format)) return;
  if (!points.is_on_plane())
    throw UsageError(fmt::format(
        "{} files are for the plane; on the globe write .geojson or .nc", "." + format));
  if (!settings.region.empty())
    throw UsageError(fmt::format(
        "--region clips cells; a .{} file holds the whole diagram, rays included",
        format));
}

void write_diagram(const Settings& settings, const std::string& format,
                   const Points& points, const PlaneTriangulation& t,
                   Reporter& reporter) {
  const auto diagram = reporter.timed(Phase::evaluate, [&] {
    return tripack::Voronoi(t, reporter.run_options("finding vertices"));
  });
  const int base = points.table.is_node_file ? points.table.base : 0;
  reporter.timed(Phase::write, [&] {
    format == "v.node" ? io::write_v_node(settings.output.path, diagram, base)
                       : io::write_v_edge(settings.output.path, diagram, base);
  });
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  const std::string format = choose_format(
      settings.output,
      {"csv", "geojson", "nc", "v.node", "v.edge", "svg", "png", "pdf", "eps"});
  const std::optional<tripack::Region> region = parse_region(settings);
  check_output(settings.output.path, {settings.points.path});
  const Points points = read_points(settings.points, reporter);
  if (region && !points.is_on_plane())
    throw UsageError("--region clips cells of the plane; on the globe they are closed");
  check_diagram(format, settings, points);
  const Triangulated triangulated = triangulate(points, reporter);
  if (is_diagram(format)) {
    write_diagram(settings, format, points, std::get<PlaneTriangulation>(triangulated),
                  reporter);
    reporter.say("wrote {}", settings.output.path);
    return ExitCode::done;
  }
  const Cells cells = find_cells(points, triangulated, region, reporter);
  reporter.timed(Phase::write,
                 [&] { write(settings, format, points, triangulated, cells); });
  reporter.say("wrote {}", settings.output.path);
  return ExitCode::done;
}

}  // namespace

Command add_voronoi_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("voronoi", "Voronoi cells: what is nearest to each point");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  add_output_options(app, settings->output,
                     ".csv (area, centroid, corners, bounded), .geojson, .nc (UGRID), "
                     ".v.node and .v.edge (Triangle's vertices and edges, rays included; "
                     "plane), .svg, .png, .pdf, .eps");
  app.add_option("--region", settings->region, "Plane: clip the cells to this box")
      ->type_name("W/E/S/N");
  add_picture_options(app, settings->picture);
  app.footer(
      "Areas are in squared units of the coordinates, on the globe in square kilometres "
      "(--on ellipsoid: of WGS84). Without --region unbounded cells of the plane have no "
      "area, and their polygons end at a box around the points.\n\n"
      "Example:\n  delone voronoi stations.csv -o cells.csv --region 0/100/0/50");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
