#include "cli/sample_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "cli/surface.hpp"
#include "io/output_file.hpp"

namespace delone::cli {
namespace {

struct Settings {
  PointSettings points;
  QuerySettings queries;
  SurfaceSettings surface;
  OutputSettings output;
  bool wants_gradient = false;
};

/// What is written behind the queries' columns.
struct Samples {
  std::vector<double> values;
  std::vector<std::array<double, 2>> gradients;  ///< empty unless wanted
};

std::vector<std::string> column_names(const Points& points, bool with_gradient) {
  const std::string& name = points.table.value_name;
  if (!with_gradient) return {name};
  if (points.is_on_plane())
    return {name, fmt::format("d{}_dx", name), fmt::format("d{}_dy", name)};
  return {name, name + "_east_per_km", name + "_north_per_km"};
}

Samples evaluate(const Settings& settings, const Surface& surface, const Points& queries,
                 Reporter& reporter) {
  return reporter.timed(Phase::evaluate, [&] {
    Samples samples;
    samples.values = values_at(surface, queries, reporter.run_options("sampling"));
    if (settings.wants_gradient) {
      samples.gradients =
          gradients_at(surface, queries, reporter.run_options("gradients"));
    }
    return samples;
  });
}

std::string as_text(const Points& points, const Points& queries, const Samples& samples) {
  const bool with_gradient = !samples.gradients.empty();
  return query_csv(queries, column_names(points, with_gradient),
                   [&](fmt::memory_buffer& buffer, std::size_t i) {
                     append_number(buffer, samples.values[i]);
                     if (!with_gradient) return;
                     append_number(buffer, samples.gradients[i][0]);
                     append_number(buffer, samples.gradients[i][1]);
                   });
}

void say_missing(const Samples& samples, const Reporter& reporter) {
  const auto num_missing =
      std::ranges::count_if(samples.values, [](double v) { return std::isnan(v); });
  if (num_missing == 0) return;
  reporter.say("{} of {} queries have no value (--extrapolate gives them one)",
               num_missing, samples.values.size());
}

ExitCode run(const Settings& settings, Reporter& reporter) {
  static_cast<void>(choose_format(settings.output, {"csv"}));
  check_inputs(settings.points.path, settings.queries.path);
  check_output(settings.output.path, {settings.points.path, settings.queries.path});
  const Points points = read_points(settings.points, reporter);
  const Points queries =
      read_queries(settings.queries, settings.points, points, reporter);
  const Surface surface =
      fit(points, triangulate(points, reporter), settings.surface, reporter);
  const Samples samples = evaluate(settings, surface, queries, reporter);
  say_missing(samples, reporter);
  reporter.timed(Phase::write, [&] {
    io::write_text(settings.output.path, as_text(points, queries, samples));
  });
  reporter.say("wrote {}", settings.output.path);
  return ExitCode::done;
}

}  // namespace

Command add_sample_command(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("sample", "Values and gradients at scattered query points");
  const auto settings = std::make_shared<Settings>();
  add_point_options(app, settings->points, Values::needed);
  add_query_options(app, settings->queries);
  add_surface_options(app, settings->surface);
  add_output_options(app, settings->output,
                     ".csv: the columns of QUERIES, the value, the derivatives");
  app.add_flag("--gradient", settings->wants_gradient,
               "Derivatives too: by x and y, on the globe towards east and north for "
               "each kilometre");
  app.footer(
      "Rows stay in the order of QUERIES; a missing value is an empty field.\n\n"
      "Example:\n  delone sample geoid.csv cities.csv -o cities_geoid.csv --gradient");
  return {&app, [settings](Reporter& reporter) { return run(*settings, reporter); }};
}

}  // namespace delone::cli
