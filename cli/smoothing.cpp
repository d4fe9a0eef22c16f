#include "cli/smoothing.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>

namespace delone::cli {
namespace {

using interp::SmoothBy;

SmoothSettings parse_smooth(const std::string& text) {
  if (text == "auto") return {SmoothBy::cross_validation, 0, true};
  if (text == "errors") return {SmoothBy::errors, 0, true};
  double length = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), length);
  if (error != std::errc() || end != text.data() + text.size() || !(length >= 0)) {
    throw UsageError(
        fmt::format("--smooth takes auto, errors or a length (kilometres, on the plane "
                    "the unit of x and y), not '{}'",
                    text));
  }
  return {SmoothBy::wavelength, length, true};
}

std::string chosen_by(SmoothBy by) {
  if (by == SmoothBy::wavelength) return "";
  return by == SmoothBy::errors ? ", so that misfits are as large as the errors"
                                : ", chosen by cross-validation";
}

}  // namespace

void add_smooth_options(CLI::App& app, PointSettings& points, SurfaceSettings& settings) {
  app.add_option_function<std::string>(
         "--smooth",
         [&settings](const std::string& text) { settings.smooth = parse_smooth(text); },
         "smooth: a length L (kilometres, on the plane the unit of x and y): waves of "
         "length L keep half of their height, shorter ones less; auto (default): the L "
         "that predicts left-out data best; errors: the L whose misfits are as large as "
         "--errors say")
      ->type_name("L|auto|errors");
  const auto set_errors = [&points](const std::string& column) {
    points.columns.second_value = column;
    points.has_errors = true;
  };
  CLI::Option* const errors = app.add_option_function<std::string>(
      "--errors", set_errors,
      "smooth: column of the values' standard deviations; a value counts by one over its "
      "square");
  errors->type_name("COLUMN");
  if (CLI::Option* const vector = app.get_option_no_throw("--vector"))
    errors->excludes(vector);
}

void add_smooth_length(CLI::App& app, SurfaceSettings& settings) {
  app.add_option_function<std::string>(
         "--smooth",
         [&settings](const std::string& text) { settings.smooth = parse_smooth(text); },
         "smooth: a length L (kilometres, on the plane the unit of x and y): waves of "
         "length L keep half of their height, shorter ones less")
      ->type_name("L");
}

void check_smooth_options(const Points& points, const SurfaceSettings& settings) {
  if (settings.method != Method::smooth) {
    if (!settings.smooth.is_given && !points.has_errors) return;
    throw UsageError(fmt::format("--smooth and --errors are for --method smooth, not {}",
                                 name_of(settings.method)));
  }
  if (settings.smooth.by == SmoothBy::errors && !points.has_errors)
    throw UsageError("--smooth errors needs --errors COLUMN, the standard deviations");
}

interp::SmoothOptions smooth_options(const Points& points,
                                     const interp::SurfaceOptions& common,
                                     const SmoothSettings& settings) {
  interp::SmoothOptions options;
  static_cast<interp::SurfaceOptions&>(options) = common;
  options.by = settings.by;
  options.wavelength = points.is_on_plane() ? settings.length
                                            : settings.length / stripack::earth_radius_km;
  if (points.has_errors) options.errors = points.table.second_value;
  return options;
}

void say_smoothing(const interp::SmoothFit& fit, const Points& points,
                   const SmoothSettings& settings, const Reporter& reporter) {
  const double length =
      points.is_on_plane() ? fit.wavelength : fit.wavelength * stripack::earth_radius_km;
  const std::string what =
      std::isinf(length) ? std::string(points.is_on_plane()
                                           ? "the plane of least squares"
                                           : "the first-degree harmonic of least squares")
                         : fmt::format("half is left of waves of length {:.4g}{}", length,
                                       points.is_on_plane() ? "" : " km");
  std::string misfit = fmt::format("misfit {:.4g} RMS", fit.rms_misfit);
  if (points.has_errors)
    misfit += fmt::format(" ({:.4g} of the errors)", fit.rms_misfit_over_errors);
  reporter.say("smooth: {}{}; {:.4g} degrees of freedom, {}, noise about {:.4g}", what,
               chosen_by(settings.by), fit.degrees_of_freedom, misfit, fit.noise);
}

}  // namespace delone::cli
