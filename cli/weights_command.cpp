#include "cli/weights_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "cli/grid_choice.hpp"
#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "cli/surface.hpp"
#include "interp/c1_operator.hpp"
#include "interp/natural_operator.hpp"
#include "interp/operator.hpp"
#include "io/weights_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  QuerySettings targets;  ///< no path: a grid
  GridSettings grid;
  SurfaceSettings surface;
  OutputSettings output;
};

/// Methods whose values are sums of weights times data.
bool has_weights(Method method) {
  return method == Method::nearest || method == Method::linear ||
         method == Method::natural || method == Method::natural_c1 ||
         method == Method::c1;
}

void check_method(const SurfaceSettings& surface) {
  if (!has_weights(surface.method)) {
    throw UsageError(
        fmt::format("--method {} has no weights here; take nearest, linear, natural, "
                    "natural-c1 or c1",
                    name_of(surface.method)));
  }
  if (surface.is_bounded)
    throw UsageError(
        "--bounded depends on the values, so it has no weights; leave it out");
  if (surface.gradients == interp::Gradients::global)
    throw UsageError("weights of c1 are of local gradients; leave --gradients out");
}

void check_targets(const Settings& settings) {
  if (settings.targets.path.empty()) {
    if (settings.targets.x.empty() && settings.targets.y.empty()) return;
    throw UsageError("--query-x and --query-y are columns of TARGETS; name that file");
  }
  if (settings.grid.is_asked_for()) {
    throw UsageError(
        "--region, --spacing and --size lay a grid; leave them out with TARGETS");
  }
}

template <class Triangulation, class Point>
interp::Operator operator_of(const std::shared_ptr<const Triangulation>& t,
                             std::span<const Point> targets, Method method,
                             const GlobeOptions& options, const RunOptions& run) {
  switch (method) {
    case Method::nearest:
      return interp::nearest_operator(t, targets, options.common, run);
    case Method::c1:
      return interp::c1_operator(t, targets, options.c1, run);
    case Method::natural:
    case Method::natural_c1:
      return interp::natural_operator(t, targets, options.natural, run);
    default:
      return interp::linear_operator(t, targets, options.common, run);
  }
}

/// Where values are wanted, and how a file says it.
struct Targets {
  std::optional<interp::Grid> grid;
  std::optional<Points> points;  ///< else
  io::WeightsSide side;
};

io::WeightsSide side_of(const Points& points) {
  io::WeightsSide side;
  side.space = points.is_on_plane() ? io::Mesh::Space::plane : io::Mesh::Space::globe;
  side.x = points.table.x;
  side.y = points.table.y;
  return side;
}

/// All data rows of the file; those that were dropped take no part.
io::WeightsSide source_of(const Points& points) {
  io::WeightsSide side = side_of(points);
  if (points.table.row.empty()) return side;
  const auto size = static_cast<std::size_t>(points.table.num_rows);
  side.x.assign(size, 0);
  side.y.assign(size, 0);
  side.mask.assign(size, 0);
  for (std::size_t i = 0; i < points.table.x.size(); ++i) {
    const auto row = static_cast<std::size_t>(points.table.row_of(i));
    side.x[row] = points.table.x[i];
    side.y[row] = points.table.y[i];
    side.mask[row] = 1;
  }
  return side;
}

interp::Operator for_all_rows(const interp::Operator& weights, const Points& points) {
  if (points.table.row.empty()) return weights;
  std::vector<delaunay::Node> rows;
  for (std::size_t i = 0; i < points.table.x.size(); ++i)
    rows.push_back(node_number(points.table, static_cast<std::int64_t>(i)));
  return weights.spread_to_rows(rows, static_cast<delaunay::Node>(points.table.num_rows));
}

Targets choose_targets(const Settings& settings, const Points& points,
                       const Triangulated& triangulated, Reporter& reporter) {
  Targets targets;
  if (settings.targets.path.empty()) {
    targets.grid = choose_grid(settings.grid, points, triangulated, reporter);
    targets.side =
        io::weights_side(*targets.grid, points.is_on_plane() ? io::Mesh::Space::plane
                                                             : io::Mesh::Space::globe);
  } else {
    targets.points = read_queries(settings.targets, settings.points, points, reporter);
    targets.side = side_of(*targets.points);
  }
  return targets;
}

interp::Operator make_weights(const Settings& settings, const Points& points,
                              const Triangulated& triangulated, const Targets& targets,
                              Reporter& reporter) {
  const GlobeOptions options = globe_options(points, settings.surface);
  const Method method = settings.surface.method;
  const RunOptions run = reporter.run_options("weights");
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated)) {
    const auto positions =
        targets.grid ? interp::plane_nodes(*targets.grid) : plane_points(*targets.points);
    return operator_of(*plane, std::span(positions), method, options, run);
  }
  const auto positions =
      targets.grid ? interp::globe_nodes(*targets.grid) : directions(*targets.points);
  return operator_of(std::get<GlobeTriangulation>(triangulated), std::span(positions),
                     method, options, run);
}

void say_weights(const interp::Operator& weights, const Reporter& reporter) {
  const auto& matrix = weights.matrix();
  std::int64_t num_missing = 0;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    num_missing += matrix.outerIndexPtr()[i] == matrix.outerIndexPtr()[i + 1] ? 1 : 0;
  reporter.say("{} weights for {}, {} of them missing", matrix.nonZeros(),
               counted(matrix.rows(), "target"), num_missing);
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_method(settings.surface);
  check_targets(settings);
  static_cast<void>(choose_format(settings.output, {"nc"}));
  check_inputs(settings.points.path, settings.targets.path);
  check_output(settings.output.path, {settings.points.path, settings.targets.path});
  const Points points = read_points(settings.points, reporter);
  const Triangulated triangulated = triangulate(points, reporter);
  const Targets targets = choose_targets(settings, points, triangulated, reporter);
  const interp::Operator weights = reporter.timed(Phase::evaluate, [&] {
    return blaming(points, [&] {
      return for_all_rows(make_weights(settings, points, triangulated, targets, reporter),
                          points);
    });
  });
  io::WeightsFile file{weights, source_of(points), targets.side, {}, {}};
  file.map_method = name_of(settings.surface.method);
  say_weights(file.weights, reporter);
  reporter.timed(Phase::write, [&] { io::write_weights(settings.output.path, file); });
  reporter.say("wrote {}", settings.output.path);
  return ExitCode::done;
}

void add_target_options(CLI::App& app, QuerySettings& settings) {
  app.add_option("TARGETS", settings.path,
                 "Table of target points (default: a regular grid)")
      ->type_name("");
  app.add_option("--query-x", settings.x, "Column of x or longitude of the targets")
      ->type_name("COLUMN");
  app.add_option("--query-y", settings.y, "Column of y or latitude of the targets")
      ->type_name("COLUMN");
}

}  // namespace

Command add_weights_command(CLI::App& program) {
  CLI::App& app = *program.add_subcommand(
      "weights", "The weights of an interpolation, for any number of fields");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::ignored);
  add_target_options(app, settings->targets);
  add_grid_options(app, settings->grid);
  add_surface_options(app, settings->surface);
  add_output_options(app, settings->output, ".nc, in the layout of SCRIP and ESMF");
  app.footer(
      "Methods: nearest, linear, natural, natural-c1 and c1. What these two choose by "
      "the "
      "values\n"
      "otherwise is chosen from where the points are, so that the weights are good for "
      "all fields.\n"
      "Columns of the weights are the data rows of POINTS. ESMF, CDO and NCO read the "
      "file; `delone\n"
      "apply` applies it.\n\n"
      "Example:\n  delone weights stations.csv cities.csv --method natural -o w.nc\n"
      "  delone weights stations.csv --spacing 0.5 --method c1 -o w.nc");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
