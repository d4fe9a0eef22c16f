#include "cli/cross_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "cli/output.hpp"
#include "cli/queries.hpp"
#include "cli/smoothing.hpp"
#include "interp/error_report.hpp"
#include "interp/leave_one_out_natural.hpp"
#include "interp/leave_one_out_scatter.hpp"
#include "interp/leave_one_out_smooth.hpp"
#include "interp/leave_one_out_smoothing.hpp"
#include "io/output_file.hpp"

namespace delone::cli {
namespace {

namespace fs = std::filesystem;

using interp::ErrorReport;
using interp::LeaveOneOut;

constexpr std::size_t num_told = 5;

/// Files that need not exist yet.
bool is_same_place(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  const auto place = [&](std::string_view path) {
    return fs::weakly_canonical(fs::absolute(path, error), error);
  };
  return place(a) == place(b) || fs::equivalent(a, b, error);
}

LeaveOneOut leave_out(const auto& triangulation, const Points& points,
                      const SurfaceSettings& settings, const RunOptions& run) {
  const GlobeOptions options = globe_options(points, settings);
  const std::vector<double>& values = points.table.value;
  switch (settings.method) {
    case Method::nearest:
      return interp::leave_out_nearest(triangulation, values, options.common, run);
    case Method::c1:
      return interp::leave_out_c1(triangulation, values, options.c1, run);
    case Method::natural:
    case Method::natural_c1:
      return interp::leave_out_natural(triangulation, values, options.natural, run);
    case Method::idw:
      return interp::leave_out_inverse_distance(triangulation, values, {}, options.common,
                                                run);
    case Method::shepard:
      return interp::leave_out_shepard(triangulation, values, {}, options.common, run);
    case Method::rbf:
      return interp::leave_out_radial(triangulation, values, {}, options.common, run);
    case Method::smooth:
      return interp::leave_out_smooth(
          triangulation, values, smooth_options(points, options.common, settings.smooth),
          run);
    case Method::linear:
      break;
  }
  return interp::leave_out_linear(triangulation, values, options.common, run);
}

struct Validation {
  LeaveOneOut left_out;
  ErrorReport report;
  std::vector<interp::Outlier> outliers;
};

Validation validate(const Points& points, const Triangulated& triangulated,
                    const SurfaceSettings& settings, const RunOptions& run) {
  return std::visit(
      [&](const auto& t) {
        Validation result;
        result.left_out = leave_out(t, points, settings, run);
        result.report = interp::error_report(result.left_out.residual);
        result.outliers = interp::find_outliers(*t, points.table.value, result.left_out);
        return result;
      },
      triangulated);
}

double median_of(std::vector<double> values) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// NaN where all residuals are alike.
std::vector<double> standardised(const Validation& validation) {
  const double median = median_of(validation.left_out.residual),
               deviation = validation.report.robust_deviation;
  std::vector<double> result = validation.left_out.residual;
  for (double& r : result)
    r = deviation > 0 ? (r - median) / deviation
                      : std::numeric_limits<double>::quiet_NaN();
  return result;
}

std::vector<bool> outlier_flags(const Validation& validation) {
  std::vector<bool> flags(validation.left_out.residual.size());
  for (const auto& outlier : validation.outliers)
    flags[static_cast<std::size_t>(outlier.row)] = true;
  return flags;
}

std::string as_text(const Points& points, const Validation& validation) {
  const io::PointTable& table = points.table;
  const std::vector<double> scores = standardised(validation);
  const std::vector<bool> flags = outlier_flags(validation);
  fmt::memory_buffer buffer;
  fmt::format_to(std::back_inserter(buffer),
                 "row,{},value,predicted,residual,standardised,outlier\n",
                 points.is_on_plane() ? "x,y" : "lon,lat");
  for (std::size_t i = 0; i < table.value.size(); ++i) {
    fmt::format_to(std::back_inserter(buffer), "{}",
                   node_number(table, static_cast<std::int64_t>(i)));
    for (const double number :
         {table.x[i], table.y[i], table.value[i], validation.left_out.predicted[i],
          validation.left_out.residual[i], scores[i]})
      append_number(buffer, number);
    fmt::format_to(std::back_inserter(buffer), ",{}\n", flags[i] ? 1 : 0);
  }
  return {buffer.data(), buffer.size()};
}

void say_row(const Points& points, const Validation& validation, std::size_t row,
             std::string_view what, const Reporter& reporter) {
  reporter.say("cross-validation: {}: row {}, line {}: value {:.6g}, predicted {:.6g}",
               what, node_number(points.table, static_cast<std::int64_t>(row)),
               points.table.line_of(row), points.table.value[row],
               validation.left_out.predicted[row]);
}

/// The rows with the largest errors, those first; of equal ones the first rows.
std::vector<std::size_t> worst_rows(const std::vector<double>& residuals) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < residuals.size(); ++i)
    if (!std::isnan(residuals[i])) rows.push_back(i);
  const auto last =
      rows.begin() + static_cast<std::ptrdiff_t>(std::min(num_told, rows.size()));
  std::partial_sort(rows.begin(), last, rows.end(), [&](std::size_t a, std::size_t b) {
    const double of_a = std::abs(residuals[a]), of_b = std::abs(residuals[b]);
    return of_a != of_b ? of_a > of_b : a < b;
  });
  rows.erase(last, rows.end());
  return rows;
}

void say_errors(const ErrorReport& report, const Reporter& reporter) {
  reporter.say(
      "cross-validation: RMS error {:.4g}, mean absolute {:.4g}, median {:.4g}, bias "
      "{:.4g}; 90 % below {:.4g}, 99 % below {:.4g}",
      report.rms, report.mean_abs, report.median_abs, report.mean, report.abs_90,
      report.abs_99);
}

void say(const Points& points, const Validation& validation, Method method,
         const Reporter& reporter) {
  const ErrorReport& report = validation.report;
  reporter.say(
      "cross-validation of {}: {} predicted from the others{}", name_of(method),
      counted(report.count, "point"),
      report.num_missing == 0
          ? ""
          : fmt::format(", {} outside of them (--extrapolate nearest predicts these too)",
                        report.num_missing));
  if (report.count == 0) return;
  say_errors(report, reporter);
  const std::vector<std::size_t> worst = worst_rows(validation.left_out.residual);
  for (std::size_t k = 0; k < worst.size(); ++k)
    say_row(points, validation, worst[k], fmt::format("error {}", k + 1), reporter);
  const auto num_outliers = static_cast<std::int64_t>(validation.outliers.size());
  reporter.say("cross-validation: {}{}", counted(num_outliers, "outlier"),
               num_outliers == 0 ? "" : " (more than 5 robust deviations off)");
  for (std::size_t k = 0; k < std::min(num_told, validation.outliers.size()); ++k)
    say_row(points, validation, static_cast<std::size_t>(validation.outliers[k].row),
            fmt::format("outlier {}", k + 1), reporter);
}

}  // namespace

void add_cross_validation_option(CLI::App& app, CrossValidationSettings& settings) {
  app.add_option(
         "--cross-validate", settings.path,
         "Leave out every point in turn and write what the others say of it: row, "
         "position, value, predicted, residual, standardised, outlier")
      ->type_name("FILE.csv");
}

std::string_view obstacle_to_validation(const PointSettings& points,
                                        const ConstraintSettings& constraints,
                                        const VectorSettings& vector) {
  if (has_segments(points.path, constraints)) return "segments";
  return vector.is_wanted ? "--vector" : "";
}

void check_cross_validation(const CrossValidationSettings& settings,
                            std::string_view obstacle,
                            std::initializer_list<std::string_view> inputs,
                            std::initializer_list<std::string_view> outputs) {
  if (!settings.is_wanted()) return;
  if (!obstacle.empty())
    throw UsageError(fmt::format(
        "--cross-validate does not go with {}; leave out one of them", obstacle));
  if (fs::path(settings.path).extension() != ".csv")
    throw UsageError(fmt::format(
        "--cross-validate {}: the table is CSV; name a file that ends in .csv",
        settings.path));
  for (const std::string_view output : outputs) {
    if (is_same_place(settings.path, output))
      throw UsageError(fmt::format(
          "--cross-validate {}: another output has this name; name another file",
          settings.path));
  }
  check_output(settings.path, inputs);
}

void cross_validate(const CrossValidationSettings& settings, const Points& points,
                    const Triangulated& triangulated, const SurfaceSettings& surface,
                    Reporter& reporter) {
  if (!settings.is_wanted()) return;
  const Validation validation = reporter.timed(Phase::evaluate, [&] {
    return blaming(points, [&] {
      return validate(points, triangulated, surface,
                      reporter.run_options("cross-validating"));
    });
  });
  say(points, validation, surface.method, reporter);
  reporter.timed(Phase::write,
                 [&] { io::write_text(settings.path, as_text(points, validation)); });
  reporter.say("wrote {}", settings.path);
}

}  // namespace delone::cli
