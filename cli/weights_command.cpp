#include "cli/weights_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "cli/grid_choice.hpp"
#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "cli/smoothing.hpp"
#include "cli/surface.hpp"
#include "interp/c1_operator.hpp"
#include "interp/global_operator.hpp"
#include "interp/natural_operator.hpp"
#include "interp/operator.hpp"
#include "interp/smooth_operator.hpp"
#include "io/weights_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  QuerySettings targets;  ///< no path: a grid
  GridSettings grid;
  SurfaceSettings surface;
  OutputSettings output;
  std::optional<double> tolerance;  ///< of rows that are dense in principle
  io::WeightsLayout layout = io::WeightsLayout::esmf;
};

const std::vector<Choice<io::WeightsLayout>> layouts{{"esmf", io::WeightsLayout::esmf},
                                                     {"scrip", io::WeightsLayout::scrip}};

/// Methods whose values are sums of weights times data.
bool has_weights(Method method) {
  return method == Method::nearest || method == Method::linear ||
         method == Method::natural || method == Method::natural_c1 ||
         method == Method::c1 || method == Method::smooth;
}

/// Whether every value takes something from (nearly) all data.
bool is_dense(const SurfaceSettings& surface) {
  return surface.method == Method::smooth ||
         (surface.method == Method::c1 && surface.gradients == interp::Gradients::global);
}

void check_smoothing(const SurfaceSettings& surface) {
  if (surface.method != Method::smooth) {
    if (!surface.smooth.is_given) return;
    throw UsageError(
        fmt::format("--smooth is for --method smooth, not {}", name_of(surface.method)));
  }
  if (surface.smooth.is_given && surface.smooth.by == interp::SmoothBy::wavelength)
    return;
  throw UsageError(
      "weights of smooth are for one length; give --smooth L (delone grid says which "
      "one it chooses)");
}

double checked_tolerance(const Settings& settings) {
  constexpr double usual = 1e-6, most = 0.01;
  if (!settings.tolerance) return usual;
  if (!is_dense(settings.surface)) {
    throw UsageError(
        "--tolerance is for --method smooth and for c1 with --gradients global; leave it "
        "out");
  }
  if (!(*settings.tolerance >= 0 && *settings.tolerance <= most))
    throw UsageError("--tolerance takes a number from 0 to 0.01");
  return *settings.tolerance;
}

void check_method(const SurfaceSettings& surface) {
  if (!has_weights(surface.method)) {
    throw UsageError(
        fmt::format("--method {} has no weights here; take nearest, linear, natural, "
                    "natural-c1, c1 or smooth",
                    name_of(surface.method)));
  }
  if (surface.is_bounded)
    throw UsageError(
        "--bounded depends on the values, so it has no weights; leave it out");
  check_smoothing(surface);
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

void check_layout(const Settings& settings, const Points& points) {
  if (settings.layout == io::WeightsLayout::scrip && points.is_on_plane()) {
    throw UsageError(
        "--layout scrip is for longitude and latitude; leave it out, or give --on "
        "sphere");
  }
}

void check_rim(const SurfaceSettings& surface, const Points& points) {
  if (surface.outside != interp::Outside::linear || points.is_on_plane()) return;
  throw UsageError(
      "weights on the globe end where the triangles do; take --extrapolate nearest, or "
      "leave it out");
}

/// A row of smoothing weights takes a solution over all points.
void check_size(std::size_t num_targets, delaunay::Site num_points) {
  constexpr double most = 0x1p31;
  const double count = static_cast<double>(num_targets) * num_points;
  if (count <= most) return;
  throw Error(fmt::format(
      "smooth takes every value from all points, {:.2g} weights for {} targets and {} "
      "points are too many; ask for fewer targets, thin the points (delone block), or "
      "take delone grid",
      count, num_targets, num_points));
}

template <class Triangulation, class Point>
interp::Operator operator_of(const std::shared_ptr<const Triangulation>& t,
                             std::span<const Point> targets, const Settings& settings,
                             const Points& points, const GlobeOptions& options,
                             const RunOptions& run) {
  const interp::RowOptions rows{.tolerance = checked_tolerance(settings)};
  switch (settings.surface.method) {
    case Method::nearest:
      return interp::nearest_operator(t, targets, options.common, run);
    case Method::c1:
      if (is_dense(settings.surface))
        return interp::global_operator(t, targets, options.c1).explicit_rows(rows, run);
      return interp::c1_operator(t, targets, options.c1, run);
    case Method::smooth:
      check_size(targets.size(), t->num_sites());
      return interp::smooth_operator(
                 t, targets,
                 smooth_options(points, options.common, settings.surface.smooth),
                 {run.num_threads, {}})
          .explicit_rows(rows, run);
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
  const RunOptions run = reporter.run_options("weights");
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated)) {
    const auto positions =
        targets.grid ? interp::plane_nodes(*targets.grid) : plane_points(*targets.points);
    return operator_of(*plane, std::span(positions), settings, points, options, run);
  }
  const auto positions =
      targets.grid ? interp::globe_nodes(*targets.grid) : directions(*targets.points);
  return operator_of(std::get<GlobeTriangulation>(triangulated), std::span(positions),
                     settings, points, options, run);
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
  const double tolerance = checked_tolerance(settings);
  static_cast<void>(choose_format(settings.output, {"nc"}));
  check_inputs(settings.points.path, settings.targets.path);
  check_output(settings.output.path, {settings.points.path, settings.targets.path});
  const Points points = read_points(settings.points, reporter);
  check_layout(settings, points);
  check_rim(settings.surface, points);
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
  if (is_dense(settings.surface)) {
    reporter.say(
        "small weights are left out: no value changes by more than {:g} of the "
        "range of the data (--tolerance)",
        tolerance);
  }
  reporter.timed(Phase::write,
                 [&] { io::write_weights(settings.output.path, file, settings.layout); });
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
  add_smooth_length(app, settings->surface);
  app.add_option("--tolerance", settings->tolerance,
                 "smooth, and c1 with global gradients: how much small weights that are "
                 "left out may change a value, as a part of the range of the data "
                 "(default 1e-6; 0: all are kept)")
      ->type_name("T");
  add_output_options(app, settings->output, ".nc");
  add_choice<io::WeightsLayout>(
      app, "--layout", settings->layout, layouts,
      "What the file calls its parts: esmf (default) or scrip (globe; for CDO)");
  app.footer(
      "Methods: nearest, linear, natural, natural-c1, c1 and smooth (with --smooth L). "
      "What is\n"
      "otherwise chosen by the values is chosen from where the points are, so that the "
      "weights are\n"
      "good for all fields. smooth, and c1 with --gradients global, take every value "
      "from all points:\n"
      "small weights are left out (--tolerance), and a row takes a solution.\n"
      "Columns of the weights are the data rows of POINTS. ESMF and NCO read the file, "
      "with\n"
      "--layout scrip CDO does; `delone apply` applies it.\n\n"
      "Example:\n  delone weights stations.csv cities.csv --method natural -o w.nc\n"
      "  delone weights stations.csv --spacing 0.5 --method c1 -o w.nc");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
