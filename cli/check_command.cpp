#include "cli/check_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <unordered_map>

#include "cli/constraints.hpp"
#include "cli/output.hpp"
#include "cli/points.hpp"
#include "io/output_file.hpp"
#include "io/triangle_file.hpp"
#include "stripack/constrained_list_defect.hpp"
#include "stripack/defect.hpp"
#include "stripack/hash.hpp"
#include "stripack/predicates.hpp"
#include "tripack/constrained_list_defect.hpp"
#include "tripack/defect.hpp"
#include "tripack/hash.hpp"
#include "tripack/predicates.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  std::string triangles;
  ConstraintSettings constraints;
};

/// From data rows to kept rows.
class KeptRows {
 public:
  explicit KeptRows(const io::PointTable& table) {
    for (std::size_t i = 0; i < table.x.size(); ++i)
      kept_.emplace(table.row_of(i), static_cast<std::int32_t>(i));
  }
  /// Replaces data rows by kept rows; the first row that has none, which stops it.
  [[nodiscard]] std::optional<std::int32_t> replace(std::span<std::int32_t> rows) const {
    for (std::int32_t& row : rows) {
      const auto found = kept_.find(row);
      if (found == kept_.end()) return row;
      row = found->second;
    }
    return std::nullopt;
  }

 private:
  std::unordered_map<std::int64_t, std::int32_t> kept_;
};

/// Programs differ in the orientation of their triangles, and some mix both. Which way
/// round corners are listed says nothing about which triangle is meant.
template <class Point>
void turn_counter_clockwise(const std::vector<Point>& points,
                            std::vector<io::Triangle>& triangles) {
  for (io::Triangle& t : triangles) {
    const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
    if (orientation(at(0), at(1), at(2)) < 0) std::swap(t[1], t[2]);
  }
}

std::optional<std::string> find_defect(const Points& points,
                                       std::vector<io::Triangle> triangles) {
  const auto over = [&](const auto& positions) {
    turn_counter_clockwise(positions, triangles);
    return find_defect(std::span(positions), triangles);
  };
  return points.is_on_plane() ? over(plane_points(points)) : over(directions(points));
}

std::optional<std::string> find_defect(const Points& points,
                                       const delaunay::NeighborRings& rings) {
  const auto over = [&](const auto& positions) {
    return find_defect(std::span(positions), rings);
  };
  return points.is_on_plane() ? over(plane_points(points)) : over(directions(points));
}

using Defect = std::optional<std::string>;

Defect find_defect_of_triangles(const Points& points,
                                std::vector<io::Triangle> triangles) {
  const KeptRows kept(points.table);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (const auto row = kept.replace(triangles[i]))
      return fmt::format("triangle {} uses row {}, which has no position", i, *row);
  }
  return find_defect(points, std::move(triangles));
}

Defect find_defect_of_rings(const Points& points, const delaunay::NeighborRings& rings) {
  const KeptRows kept(points.table);
  delaunay::NeighborRings kept_rings;
  for (std::size_t i = 0; i < points.table.x.size(); ++i) {
    const auto row = static_cast<std::size_t>(points.table.row_of(i));
    auto& ring = kept_rings.emplace_back(rings.at(row));
    if (const auto bad = kept.replace(ring))
      return fmt::format("row {} has the neighbour {}, which has no position", row, *bad);
  }
  return find_defect(points, kept_rings);
}

/// What a file holds, and what is wrong with it.
struct Verdict {
  std::string holding;
  Defect defect;
  std::string hash{};  ///< of triangles without a defect
  std::string_view kind = "Delaunay";
};

std::string hash_of(std::span<const tripack::Point2> points,
                    std::span<const io::Triangle> triangles) {
  return to_string(tripack::hash_of_positions(points, triangles));
}
std::string hash_of(std::span<const stripack::Direction> points,
                    std::span<const io::Triangle> triangles) {
  return to_string(stripack::hash_of_positions(points, triangles));
}

std::string hash_of(const Points& points, std::vector<io::Triangle> triangles) {
  const KeptRows kept(points.table);
  for (io::Triangle& t : triangles) static_cast<void>(kept.replace(t));
  return points.is_on_plane() ? hash_of(plane_points(points), triangles)
                              : hash_of(directions(points), triangles);
}

template <class Find>
Defect numbered_defect(const Points& points, Find find) {
  auto defect = blaming(points, find);
  if (defect && points.size() != points.table.num_rows)
    *defect += " (rows counted without the dropped ones)";
  return defect;
}

Verdict judge(const Settings& settings, const Points& points, Reporter& reporter) {
  const std::string format = io::file_format(settings.triangles);
  const std::int64_t num_rows = points.table.num_rows;
  if (format == "adj" || format == "renka") {
    const auto file = reporter.timed(
        Phase::read, [&] { return io::read_rings(settings.triangles, num_rows); });
    return reporter.timed(Phase::evaluate, [&]() -> Verdict {
      return {"lists of neighbours", numbered_defect(points, [&] {
                return find_defect_of_rings(points, file.rings);
              })};
    });
  }
  auto file = reporter.timed(
      Phase::read, [&] { return io::read_triangles(settings.triangles, num_rows); });
  const auto num_triangles = static_cast<std::int64_t>(file.triangles.size());
  return reporter.timed(Phase::evaluate, [&]() -> Verdict {
    Verdict verdict{counted(num_triangles, "triangle"), numbered_defect(points, [&] {
                      return find_defect_of_triangles(points, file.triangles);
                    })};
    if (!verdict.defect) verdict.hash = hash_of(points, std::move(file.triangles));
    return verdict;
  });
}

/// Data rows, then vertices of the constraints, as rows of the triangulation; a sentence
/// at the first that has no position.
Defect renumber(const Points& points, std::vector<io::Triangle>& triangles) {
  const KeptRows kept(points.table);
  const std::int64_t num_rows = points.table.num_rows;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::int32_t& corner : triangles[i]) {
      if (corner >= num_rows) {
        corner = static_cast<std::int32_t>(corner - num_rows + points.size());
      } else if (const auto row = kept.replace(std::span(&corner, 1))) {
        return fmt::format("triangle {} uses row {}, which has no position", i, *row);
      }
    }
  }
  return std::nullopt;
}

template <class Triangulation>
Verdict judge_list(const Points& points, const Triangulation& t,
                   std::vector<io::Triangle> triangles) {
  Verdict verdict{
      fmt::format("{} with {}", counted(std::ssize(triangles), "triangle"),
                  counted(std::ssize(t.constraint_edges()), "constrained edge")),
      renumber(points, triangles)};
  verdict.kind = "constrained Delaunay";
  if (!verdict.defect) verdict.defect = find_defect(t, triangles);
  if (verdict.defect) return verdict;
  std::vector<typename std::decay_t<decltype(t.points())>::value_type> positions;
  for (std::int32_t row = 0; row < t.num_rows(); ++row) positions.push_back(t.point(row));
  verdict.hash = hash_of(positions, triangles);
  return verdict;
}

/// The triangles against the constrained triangulation of the points and segments.
Verdict judge_constrained(const Settings& settings, const ConstrainedInput& input,
                          Reporter& reporter) {
  const Constrained built = build_constrained(input, settings.constraints, reporter);
  return std::visit(
      [&](const auto& t) {
        const std::int64_t num_rows =
            input.points.table.num_rows + t.num_rows() - input.points.size();
        auto file = reporter.timed(Phase::read, [&] {
          return io::read_triangles(settings.triangles, num_rows);
        });
        return reporter.timed(Phase::evaluate, [&] {
          return judge_list(input.points, t, std::move(file.triangles));
        });
      },
      built);
}

ExitCode report(const Settings& settings, const Points& points, const Verdict& verdict) {
  if (!verdict.defect) {
    print(fmt::format("{}: {} over {}\n", verdict.kind, verdict.holding,
                      counted(points.size(), "point")));
    if (!verdict.hash.empty()) print(fmt::format("hash: {}\n", verdict.hash));
    return ExitCode::done;
  }
  print(fmt::format("not {}: {}\n", verdict.kind, *verdict.defect));
  report_failure(fmt::format("{} is not a {} triangulation of {}: {}",
                             display_name(settings.triangles), verdict.kind,
                             display_name(points.path), *verdict.defect));
  return ExitCode::check_failed;
}

/// A mesh file holds its own points.
std::string own_triangles(const Settings& settings) {
  if (holds_mesh(settings.points.path)) return settings.points.path;
  throw UsageError(
      "TRIANGLES is required where POINTS is no mesh; see delone check --help");
}

/// Unit vectors were rounded to degrees on the way.
void refuse_unit_vectors(const Points& points) {
  if (points.table.is_lonlat && io::file_format(points.path) != "nc")
    throw Error(points.path +
                ": its nodes are unit vectors, which as degrees would be rounded; give "
                "the points as a table in degrees");
}

ExitCode run(Settings settings, Reporter& reporter) {
  const bool is_alone = settings.triangles.empty();
  if (is_alone) settings.triangles = own_triangles(settings);
  check_inputs(settings.points.path, settings.triangles);
  if (has_segments(settings.points.path, settings.constraints)) {
    check_inputs(settings.constraints.path, settings.triangles);
    const ConstrainedInput input =
        read_constrained(settings.points, settings.constraints.path, reporter);
    if (is_alone) refuse_unit_vectors(input.points);
    return report(settings, input.points, judge_constrained(settings, input, reporter));
  }
  const Points points = read_points(settings.points, reporter);
  if (is_alone) refuse_unit_vectors(points);
  const Verdict verdict = judge(settings, points, reporter);
  if (verdict.defect)
    reporter.say(
        "without segments; a mesh of a domain is checked with its .poly file or "
        "--constraints");
  return report(settings, points, verdict);
}

}  // namespace

Command add_check_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand(
      "check", "Is this a Delaunay triangulation of these points?");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  app.add_option(
         "TRIANGLES", settings->triangles,
         "A .tri, .ele, .adj, .renka, .off, .ply, .vtu or UGRID .nc file, or what "
         "Qhull's options i and Fv print, or in a file .o what its option o prints; not "
         "needed if POINTS is a mesh")
      ->type_name("");
  app.get_option("POINTS")->description(
      "Table of points: CSV, TSV, blanks or .node; - reads standard input; a .poly file "
      "with points and segments; or a mesh (.off, .ply, .vtu, UGRID .nc), checked alone "
      "if no TRIANGLES are named");
  add_domain_options(app, settings->constraints);
  app.footer(
      "Exact: no tolerance. Ties (four points on a circle) may be broken either way. "
      "Exit status 0 if\n"
      "it is Delaunay, 1 if not, with the reason. With segments: is it the constrained "
      "Delaunay\n"
      "triangulation of the domain that they enclose, or with --keep-outside of the "
      "hull? Vertices of\n"
      "the constraints are numbered after the data rows, as `delone triangulate` "
      "does.\n\n"
      "Example:\n  delone check stations.csv stations.tri\n"
      "  delone check mesh.vtu\n"
      "  delone check lake.poly lake.ele");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
