#include "cli/sample_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "cli/arc_tension.hpp"
#include "cli/constrained_surface.hpp"
#include "cli/cross_validation.hpp"
#include "cli/derivatives.hpp"
#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "cli/smoothing.hpp"
#include "cli/surface.hpp"
#include "cli/vector_field.hpp"
#include "io/output_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  ConstraintSettings constraints;
  QuerySettings queries;
  SurfaceSettings surface;
  OutputSettings output;
  VectorSettings vector;
  CrossValidationSettings validation;
  bool wants_gradient = false;
};

using Columns = std::vector<io::GridVariable>;

std::vector<std::string> gradient_names(const Points& points) {
  const std::string& name = points.table.value_name;
  if (points.is_on_plane())
    return {fmt::format("d{}_dx", name), fmt::format("d{}_dy", name)};
  return {name + "_east_per_km", name + "_north_per_km"};
}

Columns gradient_columns(const Surface& surface, const Points& points,
                         const Points& queries, Reporter& reporter) {
  const auto names = gradient_names(points);
  Columns columns{{names[0], "", {}}, {names[1], "", {}}};
  for (const auto& g :
       gradients_at(surface, queries, reporter.run_options("gradients"))) {
    columns[0].values.push_back(g[0]);
    columns[1].values.push_back(g[1]);
  }
  return columns;
}

/// What is written behind the queries' columns: the value, then what was asked for.
Columns evaluate(const Settings& settings, const Surface& surface, const Points& points,
                 const Points& queries, Reporter& reporter) {
  Columns columns{{points.table.value_name, "", {}}}, more;
  columns[0].values = reporter.timed(Phase::evaluate, [&] {
    return values_at(surface, queries, reporter.run_options("sampling"));
  });
  if (settings.vector.wants_derivatives) {
    more = derivatives_at(surface, points, "", queries, reporter);
  } else if (settings.wants_gradient) {
    more = reporter.timed(Phase::evaluate, [&] {
      return gradient_columns(surface, points, queries, reporter);
    });
  }
  std::ranges::move(more, std::back_inserter(columns));
  return columns;
}

/// Columns behind those of the queries.
std::string as_text(const Points& queries, const Columns& columns) {
  std::vector<std::string> names;
  for (const auto& column : columns) names.push_back(column.name);
  return query_csv(queries, names, [&](fmt::memory_buffer& buffer, std::size_t i) {
    for (const auto& column : columns) append_number(buffer, column.values[i]);
  });
}

void say_missing(const std::vector<double>& values, const Reporter& reporter) {
  const auto num_missing =
      std::ranges::count_if(values, [](double v) { return std::isnan(v); });
  if (num_missing == 0) return;
  reporter.say("{} of {} queries have no value (--extrapolate gives them one)",
               num_missing, values.size());
}

void check_derivatives(const Settings& settings) {
  if (settings.vector.is_wanted && settings.wants_gradient)
    throw UsageError(
        "--gradient is of one value; with --vector take --derivatives, which gives "
        "divergence and curl");
}

void check_validation(const Settings& settings) {
  check_cross_validation(
      settings.validation,
      obstacle_to_validation(settings.points, settings.constraints, settings.vector),
      {settings.points.path, settings.queries.path, settings.constraints.path},
      {settings.output.path});
}

/// The text to write.
std::string sample(const Settings& settings, const Points& points, const Points& queries,
                   Reporter& reporter) {
  const Triangulated triangulated = triangulate(points, reporter);
  if (settings.vector.is_wanted) {
    const auto field = fit_vectors(points, triangulated, settings.surface, reporter);
    const auto columns = vectors_at(field, settings.vector, points, queries, reporter);
    say_missing(columns[0].values, reporter);
    return as_text(queries, columns);
  }
  const Surface surface = fit(points, triangulated, settings.surface, reporter);
  const Columns columns = evaluate(settings, surface, points, queries, reporter);
  say_missing(columns[0].values, reporter);
  cross_validate(settings.validation, points, triangulated, settings.surface, reporter);
  return as_text(queries, columns);
}

/// The same over a domain, no value reaching across its curves.
std::string sample_domain(const Settings& settings, Reporter& reporter) {
  if (settings.vector.is_wanted)
    throw UsageError("--vector does not go with segments; leave out one of them");
  check_curved_options(settings.points, settings.surface);
  check_inputs(settings.queries.path, settings.constraints.path);
  const CurvedData data = read_curved(settings.points, settings.constraints, reporter);
  const Points& points = data.input.points;
  const Points queries =
      read_queries(settings.queries, settings.points, points, reporter);
  const Surface surface = fit(data, settings.surface, reporter);
  const Columns columns = evaluate(settings, surface, points, queries, reporter);
  const auto num_missing =
      std::ranges::count_if(columns[0].values, [](double v) { return std::isnan(v); });
  if (num_missing > 0)
    reporter.say("{} of {} queries have no value: they are outside the domain",
                 num_missing, columns[0].values.size());
  return as_text(queries, columns);
}

void write(const Settings& settings, const std::string& text, Reporter& reporter) {
  reporter.timed(Phase::write, [&] { io::write_text(settings.output.path, text); });
  reporter.say("wrote {}", settings.output.path);
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  check_derivatives(settings);
  check_arc_tension(settings.surface);
  check_arc_tension_without(settings.vector.is_wanted         ? "--vector"
                            : settings.validation.is_wanted() ? "--cross-validate"
                            : has_segments(settings.points.path, settings.constraints)
                                ? "segments"
                                : "",
                            settings.surface);
  static_cast<void>(choose_format(settings.output, {"csv"}));
  check_inputs(settings.points.path, settings.queries.path);
  check_output(settings.output.path,
               {settings.points.path, settings.queries.path, settings.constraints.path});
  check_validation(settings);
  if (has_segments(settings.points.path, settings.constraints)) {
    write(settings, sample_domain(settings, reporter), reporter);
    return ExitCode::done;
  }
  const Points points = read_points(settings.points, reporter);
  const Points queries =
      read_queries(settings.queries, settings.points, points, reporter);
  write(settings, sample(settings, points, queries, reporter), reporter);
  return ExitCode::done;
}

}  // namespace

Command add_sample_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("sample", "Values and gradients at scattered query points");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::needed);
  add_vector_option(app, settings->points, settings->vector);
  add_query_options(app, settings->queries);
  add_surface_options(app, settings->surface);
  add_arc_tension_options(app, settings->surface);
  add_smooth_options(app, settings->points, settings->surface);
  add_domain_options(app, settings->constraints);
  add_output_options(app, settings->output,
                     ".csv: the columns of QUERIES, the value, the derivatives");
  app.add_flag("--gradient", settings->wants_gradient,
               "Derivatives too: by x and y, on the globe towards east and north for "
               "each kilometre");
  app.add_flag("--derivatives", settings->vector.wants_derivatives,
               "As --gradient, and of c1 second derivatives and the Laplacian; with "
               "--vector divergence and curl for each kilometre");
  add_cross_validation_option(app, settings->validation);
  app.footer(
      "Rows stay in the order of QUERIES; a missing value is an empty field.\n\n"
      "Segments (a .poly file in the place of POINTS, or --constraints) are coasts and "
      "faults: queries\n"
      "outside the domain that they enclose are missing, and nothing is interpolated "
      "across them.\n\n"
      "Example:\n  delone sample geoid.csv cities.csv -o cities_geoid.csv --gradient\n"
      "  delone sample soundings.csv boats.csv --constraints lake.poly -o depths.csv\n"
      "  delone sample dem.csv wells.csv -o out.csv --method c1 --derivatives "
      "--cross-validate left_out.csv");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
