#include "cli/surface.hpp"

namespace delone::cli {
namespace {

using interp::Outside;

const std::vector<Choice<Method>> method_choices{{"linear", Method::linear},
                                                 {"nearest", Method::nearest}};
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

/// Linear or Nearest, as the method says, over any triangulation that both take.
template <class Linear, class Nearest>
Surface fit_method(const auto& triangulation, const Points& points,
                   const SurfaceSettings& settings) {
  const interp::SurfaceOptions options = surface_options(points, settings);
  if (settings.method == Method::nearest)
    return Nearest(triangulation, points.table.value, options);
  return Linear(triangulation, points.table.value, options);
}

Surface fit_domain(const Points& points, const Triangulated& triangulated,
                   const SurfaceSettings& settings) {
  if (const auto* plane = std::get_if<PlaneTriangulation>(&triangulated)) {
    return fit_method<interp::PlaneLinear, interp::PlaneNearest>(*plane, points,
                                                                 settings);
  }
  return fit_method<interp::SphereLinear, interp::SphereNearest>(
      std::get<GlobeTriangulation>(triangulated), points, settings);
}

void check_extrapolation(const Points& points, const SurfaceSettings& settings) {
  if (settings.outside != Outside::linear) return;
  if (!points.is_on_plane()) {
    throw UsageError(
        "--extrapolate linear works on the plane only; use --extrapolate nearest");
  }
  if (settings.method == Method::nearest) {
    throw UsageError(
        "--extrapolate linear does not go with --method nearest; use --extrapolate "
        "nearest");
  }
}

}  // namespace

void add_surface_options(CLI::App& app, SurfaceSettings& settings) {
  add_choice<Method>(app, "--method", settings.method, method_choices,
                     "linear (default) or nearest");
  add_choice<Outside>(
      app, "--extrapolate", settings.outside, outside_choices,
      "Outside the points: nearest or, on the plane, linear (default: missing)");
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
}

Surface fit(const Points& points, const Triangulated& triangulated,
            const SurfaceSettings& settings, Reporter& reporter) {
  check_extrapolation(points, settings);
  return reporter.timed(Phase::fit, [&] {
    return blaming(points, [&] { return fit_domain(points, triangulated, settings); });
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
