#include "cli/surface.hpp"

#include <fmt/format.h>

#include "cli/arc_tension.hpp"
#include "cli/smoothing.hpp"

namespace delone::cli {
namespace {

using interp::Outside;

const std::vector<Choice<Method>> method_choices{{"linear", Method::linear},
                                                 {"nearest", Method::nearest},
                                                 {"c1", Method::c1},
                                                 {"natural", Method::natural},
                                                 {"natural-c1", Method::natural_c1},
                                                 {"idw", Method::idw},
                                                 {"shepard", Method::shepard},
                                                 {"rbf", Method::rbf},
                                                 {"smooth", Method::smooth}};
const std::vector<Choice<interp::FitDegree>> degree_choices{
    {"3", interp::FitDegree::cubic}, {"4", interp::FitDegree::quartic}};
const std::vector<Choice<interp::Gradients>> gradient_choices{
    {"auto", interp::Gradients::automatic},
    {"local", interp::Gradients::local},
    {"global", interp::Gradients::global}};
const std::vector<Choice<Outside>> outside_choices{{"nearest", Outside::nearest},
                                                   {"linear", Outside::linear}};

interp::SurfaceOptions surface_options(const Points& points,
                                       const SurfaceSettings& settings) {
  interp::SurfaceOptions options;
  options.duplicates = points.duplicates;
  options.outside = settings.outside;
  options.max_distance = settings.max_distance;
  options.distance = points.domain == Domain::ellipsoid
                         ? interp::GlobeDistance::geodesic_wgs84
                         : interp::GlobeDistance::great_circle;
  return options;
}

/// Kilometres a radian of direction covers towards east and towards north.
stripack::EastNorth km_per_radian(Domain domain, double lat_deg) {
  if (domain == Domain::ellipsoid) return stripack::curvature_radii_km_wgs84(lat_deg);
  return {stripack::earth_radius_km, stripack::earth_radius_km};
}

template <class T>
concept PlaneSurface = requires(const T& surface, tripack::Point2 p) {
  surface.value(p);
};

std::vector<std::array<double, 2>> gradients_of(const PlaneSurface auto& surface,
                                                const Points& queries,
                                                const RunOptions& run) {
  std::vector<std::array<double, 2>> result;
  result.reserve(queries.table.x.size());
  for (const auto& g : surface.gradients(plane_points(queries), run))
    result.push_back({g.x, g.y});
  return result;
}

std::vector<std::array<double, 2>> gradients_of(const auto& surface,
                                                const Points& queries,
                                                const RunOptions& run) {
  const auto gradients = surface.gradients(directions(queries), run);
  std::vector<std::array<double, 2>> result(gradients.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const stripack::EastNorth km = km_per_radian(queries.domain, queries.table.y[i]);
    result[i] = {gradients[i].east / km.east, gradients[i].north / km.north};
  }
  return result;
}

std::vector<double> values_of(const PlaneSurface auto& surface, const Points& queries,
                              const RunOptions& run) {
  return surface.values(plane_points(queries), run);
}

std::vector<double> values_of(const auto& surface, const Points& queries,
                              const RunOptions& run) {
  return surface.values(directions(queries), run);
}

struct PlaneSurfaces {
  using Linear = interp::PlaneLinear;
  using Nearest = interp::PlaneNearest;
  using C1 = interp::PlaneC1;
  using Natural = interp::PlaneNatural;
  using InverseDistance = interp::PlaneInverseDistance;
  using Shepard = interp::PlaneShepard;
  using Radial = interp::PlaneRadial;
  using Smooth = interp::PlaneSmooth;
  using TensionSpline = interp::PlaneTensionSpline;
};
struct SphereSurfaces {
  using Linear = interp::SphereLinear;
  using Nearest = interp::SphereNearest;
  using C1 = interp::SphereC1;
  using Natural = interp::SphereNatural;
  using InverseDistance = interp::SphereInverseDistance;
  using Shepard = interp::SphereShepard;
  using Radial = interp::SphereRadial;
  using Smooth = interp::SphereSmooth;
  using TensionSpline = interp::SphereTensionSpline;
};

interp::C1Options c1_options(const interp::SurfaceOptions& common,
                             const SurfaceSettings& settings) {
  interp::C1Options options;
  static_cast<interp::SurfaceOptions&>(options) = common;
  options.tension = settings.tension;
  options.gradients = settings.gradients;
  options.degree = settings.degree;
  options.bounds = settings.is_bounded ? interp::Bounds::local : interp::Bounds::widened;
  return options;
}

interp::NaturalOptions natural_options(const interp::SurfaceOptions& common,
                                       Method method) {
  interp::NaturalOptions options;
  options.kind = method == Method::natural_c1 ? interp::NaturalKind::sibson_c1
                                              : interp::NaturalKind::sibson;
  options.duplicates = common.duplicates;
  options.outside = common.outside;
  options.max_distance = common.max_distance;
  options.distance = common.distance;
  return options;
}

/// What was left open and how it was chosen.
void say_fit(const interp::C1Fit& fit, const SurfaceSettings& settings,
             const Reporter& reporter) {
  if (fit.num_tested == 0) return;
  std::vector<std::string> chosen;
  if (settings.gradients == interp::Gradients::automatic) {
    chosen.emplace_back(fit.gradients == interp::Gradients::global ? "global gradients"
                                                                   : "local gradients");
  }
  if (!settings.tension) chosen.push_back(fmt::format("tension {:.2g}", fit.tension));
  reporter.say(
      "c1: {}, chosen by leaving out {} points: RMS error {:.4g} (linear {:.4g})",
      fmt::join(chosen, " and "), fit.num_tested, fit.left_out_rms,
      fit.linear_left_out_rms);
}

template <class TensionSpline>
Surface fit_tension_spline(const auto& triangulation, const Points& points,
                           const SurfaceSettings& settings, const interp::C1Options& c1,
                           Reporter& reporter) {
  const TensionSpline surface(
      triangulation, points.table.value,
      tension_spline_options(c1, settings.arcs, points.table.value),
      reporter.run_options("fitting"));
  say_arc_tension(surface.fit(), reporter);
  return surface;
}

/// The method's surface over a triangulation of either kind.
template <class Surfaces>
Surface fit_method(const auto& triangulation, const Points& points,
                   const SurfaceSettings& settings, Reporter& reporter) {
  const interp::SurfaceOptions options = surface_options(points, settings);
  const std::vector<double>& values = points.table.value;
  const RunOptions run = reporter.run_options("fitting");
  switch (settings.method) {
    case Method::nearest:
      return typename Surfaces::Nearest(triangulation, values, options);
    case Method::c1: {
      if (settings.arcs.is_wanted()) {
        return fit_tension_spline<typename Surfaces::TensionSpline>(
            triangulation, points, settings, c1_options(options, settings), reporter);
      }
      typename Surfaces::C1 surface(triangulation, values, c1_options(options, settings),
                                    run);
      say_fit(surface.fit(), settings, reporter);
      return surface;
    }
    case Method::natural:
    case Method::natural_c1:
      return typename Surfaces::Natural(triangulation, values,
                                        natural_options(options, settings.method));
    case Method::idw:
      return typename Surfaces::InverseDistance(triangulation, values, {}, options);
    case Method::shepard:
      return typename Surfaces::Shepard(triangulation, values, {}, options, run);
    case Method::rbf:
      return typename Surfaces::Radial(triangulation, values, {}, options, run);
    case Method::smooth: {
      typename Surfaces::Smooth surface(
          triangulation, values, smooth_options(points, options, settings.smooth), run);
      say_smoothing(surface.fit(), points, settings.smooth, reporter);
      return surface;
    }
    case Method::linear:
      break;
  }
  return typename Surfaces::Linear(triangulation, values, options);
}

Surface fit_domain(const Points& points, const Triangulated& triangulated,
                   const SurfaceSettings& settings, Reporter& reporter) {
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated))
    return fit_method<PlaneSurfaces>(*plane, points, settings, reporter);
  return fit_method<SphereSurfaces>(std::get<GlobeTriangulation>(triangulated), points,
                                    settings, reporter);
}

void check_extrapolation(const Points& points, const SurfaceSettings& settings) {
  if (settings.outside != Outside::linear) return;
  if (!points.is_on_plane())
    check_arc_tension_without("--extrapolate linear on the globe", settings);
  if (!points.is_on_plane() && settings.method != Method::c1) {
    throw UsageError(
        "--extrapolate linear works on the globe with --method c1 only; take that, or "
        "--extrapolate nearest");
  }
  if (settings.method == Method::nearest || settings.method == Method::natural ||
      settings.method == Method::natural_c1) {
    throw UsageError(fmt::format(
        "--extrapolate linear does not go with --method {}; use --extrapolate "
        "nearest",
        name_of(settings.method)));
  }
}

void add_c1_options(CLI::App& app, SurfaceSettings& settings) {
  add_choice<interp::Gradients>(
      app, "--gradients", settings.gradients, gradient_choices,
      "c1: at the nodes, fitted to the values around each (local), or of least curvature "
      "of all together (global); auto (default): whichever predicts left-out points "
      "better");
  const auto set_tension = [&settings](const double& tension) {
    if (!(tension >= 0 && tension <= 1))
      throw UsageError("--tension takes a number from 0 (smooth) to 1 (next to linear)");
    settings.tension = tension;
  };
  app.add_option_function<double>(
         "--tension", set_tension,
         "c1: 0 (smooth) to 1 (next to linear); default: what predicts left-out points "
         "best")
      ->type_name("T");
  app.add_flag("--bounded", settings.is_bounded,
               "c1: stay among the values around each triangle");
  add_choice<interp::FitDegree>(app, "--fit-degree", settings.degree, degree_choices,
                                "c1: 3 (default) or, for smooth data, 4");
  for (const char* const name : {"--gradients", "--tension", "--bounded", "--fit-degree"})
    settings.c1_options.push_back(app.get_option(name));
}

}  // namespace

std::string_view name_of(Method method) {
  for (const auto& [word, meaning] : method_choices)
    if (meaning == method) return word;
  return {};
}

void check_c1_options(const SurfaceSettings& settings) {
  check_arc_tension(settings);
  if (settings.method == Method::c1) return;
  for (const CLI::Option* const option : settings.c1_options) {
    if (option->count() > 0)
      throw UsageError(fmt::format("{} is for --method c1, not {}", option->get_name(),
                                   name_of(settings.method)));
  }
}

void add_surface_options(CLI::App& app, SurfaceSettings& settings) {
  add_choice<Method>(app, "--method", settings.method, method_choices,
                     "linear (default), nearest, c1 (smooth), natural, natural-c1, idw, "
                     "shepard, rbf or smooth (near noisy data, not through them)");
  add_choice<Outside>(
      app, "--extrapolate", settings.outside, outside_choices,
      "Outside the points: nearest or, on the plane and of c1 on the globe, linear: the "
      "surface's own continuation (default: missing)");
  const auto set_distance = [&settings](const double& distance) {
    if (!(distance >= 0))
      throw UsageError("--max-distance must be a number that is not negative");
    settings.max_distance = distance;
  };
  app.add_option_function<double>(
         "--max-distance", set_distance,
         "Missing where every point is farther: kilometres, on the plane the "
         "unit of x and y")
      ->type_name("D");
  add_c1_options(app, settings);
}

void add_triangle_surface_options(CLI::App& app, SurfaceSettings& settings) {
  const std::vector<Choice<Method>> choices{{"linear", Method::linear},
                                            {"c1", Method::c1}};
  add_choice<Method>(app, "--method", settings.method, choices,
                     "linear (default) or c1 (smooth)");
  add_c1_options(app, settings);
}

GlobeOptions globe_options(const Points& points, const SurfaceSettings& settings) {
  check_extrapolation(points, settings);
  check_c1_options(settings);
  check_smooth_options(points, settings);
  const interp::SurfaceOptions common = surface_options(points, settings);
  return {common, c1_options(common, settings), natural_options(common, settings.method)};
}

Surface fit(const Points& points, const Triangulated& triangulated,
            const SurfaceSettings& settings, Reporter& reporter) {
  check_extrapolation(points, settings);
  check_c1_options(settings);
  check_smooth_options(points, settings);
  return reporter.timed(Phase::fit, [&] {
    return blaming(points,
                   [&] { return fit_domain(points, triangulated, settings, reporter); });
  });
}

std::vector<double> values_at(const Surface& surface, const Points& queries,
                              const RunOptions& run) {
  return std::visit([&](const auto& s) { return values_of(s, queries, run); }, surface);
}

std::vector<std::array<double, 2>> gradients_at(const Surface& surface,
                                                const Points& queries,
                                                const RunOptions& run) {
  return std::visit([&](const auto& s) { return gradients_of(s, queries, run); },
                    surface);
}

}  // namespace delone::cli
