#include "cli/points.hpp"

#include <fmt/format.h>

#include <limits>
#include <string_view>

#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "io/mesh.hpp"
#include "io/output_file.hpp"
#include "stripack/merge_near.hpp"
#include "tripack/merge_near.hpp"

namespace delone::cli {
namespace {

io::PointTable nodes_of(const PointSettings& settings, io::Mesh mesh) {
  const io::TableOptions& columns = settings.columns;
  if (!columns.x.empty() || !columns.y.empty() || !columns.value.empty())
    throw UsageError(settings.path + " is a mesh; columns are chosen in tables");
  if (columns.needs_value)
    throw Error(settings.path + ": a mesh has no values here; give a table with them");
  io::PointTable table;
  table.num_rows = mesh.num_nodes();
  table.x = std::move(mesh.x);
  table.y = std::move(mesh.y);
  table.is_lonlat = mesh.space == io::Mesh::Space::globe;
  table.x_name = table.is_lonlat ? "longitude" : "x";
  table.y_name = table.is_lonlat ? "latitude" : "y";
  return table;
}

void say_columns(const Points& points, const Reporter& reporter) {
  const io::PointTable& table = points.table;
  std::string columns = fmt::format("x is '{}', y is '{}'", table.x_name, table.y_name);
  if (!table.value.empty()) columns += fmt::format(", value is '{}'", table.value_name);
  if (points.has_errors)
    columns += fmt::format(" with errors '{}'", table.second_value_name);
  else if (!table.second_value.empty())
    columns +=
        fmt::format(" towards east and '{}' towards north", table.second_value_name);
  std::string dropped;
  if (table.num_missing > 0)
    dropped += fmt::format(", {} with missing values dropped", table.num_missing);
  if (table.num_bad > 0)
    dropped += fmt::format(", {} skipped", counted(table.num_bad, "bad row"));
  reporter.say("{}: {}, on the {}; {}{}", display_name(points.path), columns,
               name_of(points.domain), counted(points.size(), "point"), dropped);
}

/// Throws Error at the first row whose position an earlier row has.
template <class Triangulation>
void refuse_repeats(const Triangulation& t, const io::PointTable& table) {
  for (std::int32_t row = 0; row < t.num_rows(); ++row) {
    const auto site = static_cast<std::size_t>(t.sites()[static_cast<std::size_t>(row)]);
    const std::int32_t first = t.rows()[site];
    if (first == row) continue;
    throw Error(
        fmt::format(
            "row {} repeats the position of row {}; remove one, or choose another "
            "--duplicates",
            node_number(table, row), node_number(table, first)),
        {row, first});
  }
}

std::string described_repeats(std::int64_t num_repeats, const Points& points) {
  if (num_repeats == 0) return "";
  const std::string rows = fmt::format("{} {} one", counted(num_repeats, "row"),
                                       num_repeats == 1 ? "repeats" : "repeat");
  if (points.table.value.empty()) return fmt::format(" ({})", rows);
  return fmt::format(" ({}, --duplicates {})", rows, name_of(points.duplicates));
}

template <class Triangulation>
void say_triangulated(const Triangulation& t, const Points& points,
                      const Reporter& reporter) {
  const std::string_view line = points.is_on_plane() ? "line" : "great circle";
  reporter.say("{}{}, {}{}", counted(t.num_sites(), "different position"),
               described_repeats(t.num_rows() - t.num_sites(), points),
               counted(t.num_triangles(), "triangle"),
               t.dimension() == 1 ? fmt::format(": all lie on one {}", line) : "");
}

template <class Triangulation, class Point>
std::shared_ptr<const Triangulation> build(const Points& points,
                                           std::span<const Point> positions,
                                           Reporter& reporter) {
  return blaming(points, [&] {
    auto t = std::make_shared<const Triangulation>(positions,
                                                   reporter.run_options("triangulating"));
    if (points.duplicates == interp::Duplicates::error && points.table.value.empty())
      refuse_repeats(*t, points.table);
    say_triangulated(*t, points, reporter);
    return t;
  });
}

delaunay::MergedRows find_near(const Points& points, double distance) {
  if (points.is_on_plane()) return tripack::merge_near(plane_points(points), distance);
  const auto positions = directions(points);
  if (points.domain == Domain::ellipsoid)
    return stripack::merge_near_wgs84(positions, distance);
  return stripack::merge_near(positions, distance / stripack::earth_radius_km);
}

/// Moves every point to the one that stands for it; from then on they are repeats.
void merge_near(Points& points, double distance, const Reporter& reporter) {
  const auto merged = blaming(points, [&] { return find_near(points, distance); });
  io::PointTable& table = points.table;
  std::int64_t num_moved = 0;
  const std::vector<double> x = table.x, y = table.y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto to = static_cast<std::size_t>(merged.stands_for[i]);
    if (x[i] != x[to] || y[i] != y[to]) ++num_moved;
    table.x[i] = x[to];
    table.y[i] = y[to];
  }
  reporter.say("{} moved to another within {}{} (--merge-within): {} left",
               counted(num_moved, "point"), distance, points.is_on_plane() ? "" : " km",
               counted(merged.num_kept, "position"));
}

}  // namespace

bool holds_mesh(const std::string& path) {
  const std::string format = io::file_format(path);
  return io::is_mesh_format(format) && (format != "nc" || io::holds_ugrid(path));
}

Points read_points(const PointSettings& settings, Reporter& reporter) {
  if (settings.path.ends_with(".poly"))
    throw Error(settings.path +
                ": segments are for `delone triangulate`, `grid`, `sample`, `check` and "
                "`plot`; give a .node file or a table of points here");
  const std::string format = io::file_format(settings.path);
  if (format == "geojson" || format == "json")
    throw Error(
        settings.path +
        ": GeoJSON is for --constraints of `delone triangulate`, `grid`, `sample` "
        "and `check`; give a table of points here");
  Points points{
      settings.path, {}, Domain::plane, settings.duplicates, holds_mesh(settings.path)};
  points.has_errors = settings.has_errors;
  points.table = reporter.timed(Phase::read, [&] {
    return points.are_mesh_nodes ? nodes_of(settings, io::read_mesh(settings.path))
                                 : io::read_table(settings.path, settings.columns);
  });
  points.domain =
      settings.domain.value_or(points.table.is_lonlat ? Domain::sphere : Domain::plane);
  reporter.count_points(points.size());
  say_columns(points, reporter);
  if (settings.merge_within) merge_near(points, *settings.merge_within, reporter);
  return points;
}

std::int32_t node_number(const io::PointTable& table, std::int64_t row) {
  const std::int64_t number = table.row_of(static_cast<std::size_t>(row));
  if (number > std::numeric_limits<std::int32_t>::max()) {
    throw Error("node numbers end at 2147483647; split the file");
  }
  return static_cast<std::int32_t>(number);
}

std::string display_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

Error located(const Points& points, const Error& error) {
  std::string place = display_name(points.path);
  if (!error.rows().empty()) {
    const auto row = static_cast<std::size_t>(error.rows().front());
    place += points.are_mesh_nodes ? fmt::format(": node {}", row)
                                   : fmt::format(": line {}", points.table.line_of(row));
  }
  return Error(fmt::format("{}: {}", place, error.what()),
               std::vector<std::int64_t>(error.rows().begin(), error.rows().end()));
}

std::vector<tripack::Point2> plane_points(const Points& points) {
  std::vector<tripack::Point2> result(points.table.x.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = {points.table.x[i], points.table.y[i]};
  return result;
}

std::vector<stripack::Direction> directions(const Points& points) {
  std::vector<stripack::Direction> result;
  result.reserve(points.table.x.size());
  try {
    for (std::size_t i = 0; i < points.table.x.size(); ++i) {
      result.push_back(stripack::Direction::from({points.table.x[i], points.table.y[i]}));
    }
  } catch (const Error& error) {
    throw located(points,
                  Error(error.what(), {static_cast<std::int64_t>(result.size())}));
  }
  return result;
}

Triangulated triangulate(const Points& points, Reporter& reporter) {
  return reporter.timed(Phase::build, [&]() -> Triangulated {
    if (points.is_on_plane()) {
      return build<tripack::Triangulation>(
          points, std::span<const tripack::Point2>(plane_points(points)), reporter);
    }
    return build<stripack::Triangulation>(
        points, std::span<const stripack::Direction>(directions(points)), reporter);
  });
}

int dimension(const Triangulated& triangulated) {
  return std::visit([](const auto& t) { return t->dimension(); }, triangulated);
}

}  // namespace delone::cli
