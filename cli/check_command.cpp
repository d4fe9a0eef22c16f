#include "cli/check_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <unordered_map>

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "io/triangle_file.hpp"
#include "stripack/defect.hpp"
#include "tripack/defect.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  std::string triangles;
};

/// The triangles in kept rows instead of data rows, or the first triangle that uses a
/// dropped row.
struct KeptTriangles {
  std::vector<io::Triangle> triangles;
  std::optional<std::string> defect;
};

KeptTriangles in_kept_rows(const io::PointTable& table,
                           std::vector<io::Triangle> triangles) {
  if (table.row.empty()) return {std::move(triangles), {}};
  std::unordered_map<std::int64_t, std::int32_t> kept;
  for (std::size_t i = 0; i < table.row.size(); ++i) {
    kept.emplace(table.row[i], static_cast<std::int32_t>(i));
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::int32_t& corner : triangles[i]) {
      const auto found = kept.find(corner);
      if (found == kept.end()) {
        return {{},
                fmt::format("triangle {} uses row {}, which has no position", i, corner)};
      }
      corner = found->second;
    }
  }
  return {std::move(triangles), {}};
}

std::optional<std::string> find_defect(const Points& points,
                                       const std::vector<io::Triangle>& triangles) {
  if (points.is_on_plane()) return tripack::find_defect(plane_points(points), triangles);
  return stripack::find_defect(directions(points), triangles);
}

std::optional<std::string> find_defect_of_file(const Points& points,
                                               io::TriangleFile file) {
  KeptTriangles kept = in_kept_rows(points.table, std::move(file.triangles));
  if (kept.defect) return kept.defect;
  auto defect = blaming(points, [&] { return find_defect(points, kept.triangles); });
  if (defect && !points.table.row.empty())
    *defect += " (rows counted without the dropped ones)";
  return defect;
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_inputs(settings.points.path, settings.triangles);
  const Points points = read_points(settings.points, reporter);
  auto file = reporter.timed(Phase::read, [&] {
    return io::read_triangles(settings.triangles, points.table.num_rows);
  });
  const auto num_triangles = static_cast<std::int64_t>(file.triangles.size());
  const auto defect = reporter.timed(
      Phase::evaluate, [&] { return find_defect_of_file(points, std::move(file)); });
  if (!defect) {
    print(fmt::format("Delaunay: {} over {}\n", counted(num_triangles, "triangle"),
                      counted(points.size(), "point")));
    return ExitCode::done;
  }
  print(fmt::format("not Delaunay: {}\n", *defect));
  report_failure(fmt::format("{} is not a Delaunay triangulation of {}: {}",
                             display_name(settings.triangles), display_name(points.path),
                             *defect));
  return ExitCode::check_failed;
}

}  // namespace

Command add_check_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand(
      "check", "Is this a Delaunay triangulation of these points?");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  app.add_option("TRIANGLES", settings->triangles, "A .tri or .ele file")
      ->required()
      ->type_name("");
  app.footer(
      "Exact: no tolerance. Ties (four points on a circle) may be broken either way. "
      "Exit status 0 if\n"
      "it is Delaunay, 1 if not, with the reason.\n\n"
      "Example:\n  delone check stations.csv stations.tri");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
