#include "cli/derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "interp/ellipsoid_derivatives.hpp"

namespace delone::cli {
namespace {

using interp::Derivatives2;
using interp::DerivativesSphere;
using interp::Gradient2;
using interp::GradientSphere;
using stripack::Direction;
using tripack::Point2;

template <class T>
concept PlaneSurface = requires(const T& surface, Point2 p) {
  surface.value(p);
};
template <class T, class Point>
concept TwiceDifferentiable = requires(const T& surface, std::span<const Point> points,
                                       const RunOptions& run) {
  surface.derivatives(points, run);
};

/// First derivatives, second ones and the Laplacian, as far as there are.
struct Rates {
  std::array<double, 6> all{};
};

Rates rates(const Gradient2& g, Point2, Domain) { return {{g.x, g.y}}; }
Rates rates(const Derivatives2& d, Point2, Domain) {
  return {{d.x, d.y, d.xx, d.xy, d.yy, d.laplacian()}};
}

Rates rates(const GradientSphere& g, const Direction& p, Domain domain) {
  if (domain == Domain::ellipsoid) {
    const GradientSphere m = interp::per_metre_wgs84(g, lonlat(p).lat_deg);
    return {{1000 * m.east, 1000 * m.north}};
  }
  return {{g.east / stripack::earth_radius_km, g.north / stripack::earth_radius_km}};
}

Rates rates(const DerivativesSphere& d, const Direction& p, Domain domain) {
  const bool is_ellipsoid = domain == Domain::ellipsoid;
  const DerivativesSphere m =
      is_ellipsoid ? interp::per_metre_wgs84(d, lonlat(p).lat_deg) : d;
  const double per_km = is_ellipsoid ? 1000 : 1 / stripack::earth_radius_km,
               squared = per_km * per_km;
  return {{per_km * m.east, per_km * m.north, squared * m.east_east,
           squared * m.east_north, squared * m.north_north, squared * m.laplacian()}};
}

std::vector<io::GridVariable> plane_columns(const std::string& name) {
  return {
      {fmt::format("d{}_dx", name), "", {}},   {fmt::format("d{}_dy", name), "", {}},
      {fmt::format("d2{}_dx2", name), "", {}}, {fmt::format("d2{}_dxdy", name), "", {}},
      {fmt::format("d2{}_dy2", name), "", {}}, {name + "_laplacian", "", {}}};
}

std::vector<io::GridVariable> globe_columns(const std::string& name,
                                            const std::string& units) {
  const std::string first = units.empty() ? "" : units + " km-1",
                    second = units.empty() ? "" : units + " km-2";
  return {{name + "_east_per_km", first, {}},
          {name + "_north_per_km", first, {}},
          {name + "_east_east_per_km2", second, {}},
          {name + "_east_north_per_km2", second, {}},
          {name + "_north_north_per_km2", second, {}},
          {name + "_laplacian_per_km2", second, {}}};
}

/// Progress of one part of a longer call.
RunOptions part_of(const RunOptions& run, double begin, double end) {
  if (!run.progress) return run;
  return {run.num_threads, [&run, begin, end](double fraction) {
            return run.progress(begin + fraction * (end - begin));
          }};
}

/// At `places`, some at a time: derivatives take more memory than what is kept of them.
template <class S, class Point>
std::vector<io::GridVariable> evaluate(const S& surface, std::span<const Point> places,
                                       std::vector<io::GridVariable> columns,
                                       Domain domain, const RunOptions& run) {
  constexpr std::size_t most = std::size_t{1} << 18;
  constexpr bool has_second = TwiceDifferentiable<S, Point>;
  if (!has_second) columns.resize(2);
  for (auto& column : columns) column.values.reserve(places.size());
  const auto part_done = [&](std::size_t i) {
    return static_cast<double>(i) / static_cast<double>(places.size());
  };
  for (std::size_t first = 0; first < places.size(); first += most) {
    const auto part = places.subspan(first, std::min(most, places.size() - first));
    const RunOptions part_run =
        part_of(run, part_done(first), part_done(first + part.size()));
    const auto found = [&] {
      if constexpr (has_second) {
        return surface.derivatives(part, part_run);
      } else {
        return surface.gradients(part, part_run);
      }
    }();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Rates r = rates(found[i], part[i], domain);
      for (std::size_t k = 0; k < columns.size(); ++k)
        columns[k].values.push_back(r.all[k]);
    }
  }
  return columns;
}

/// `places(plane)` and `places(globe)` give the points of either kind.
template <class PlanePlaces, class GlobePlaces>
std::vector<io::GridVariable> evaluate_any(const Surface& surface, const Points& points,
                                           const std::string& units,
                                           PlanePlaces plane_places,
                                           GlobePlaces globe_places, Reporter& reporter) {
  const std::string& name = points.table.value_name;
  return reporter.timed(Phase::evaluate, [&] {
    const RunOptions run = reporter.run_options("derivatives");
    auto columns = std::visit(
        [&]<class S>(const S& s) {
          if constexpr (PlaneSurface<S>) {
            const std::vector<Point2> places = plane_places();
            return evaluate<S, Point2>(s, places, plane_columns(name), points.domain,
                                       run);
          } else {
            const std::vector<Direction> places = globe_places();
            return evaluate<S, Direction>(s, places, globe_columns(name, units),
                                          points.domain, run);
          }
        },
        surface);
    if (columns.size() == 2)
      reporter.say(
          "derivatives: first ones only; second ones and the Laplacian are --method "
          "c1's");
    return columns;
  });
}

}  // namespace

std::vector<io::GridVariable> derivatives_at(const Surface& surface, const Points& points,
                                             const std::string& units,
                                             const Points& queries, Reporter& reporter) {
  return evaluate_any(
      surface, points, units, [&] { return plane_points(queries); },
      [&] { return directions(queries); }, reporter);
}

std::vector<io::GridVariable> derivatives_on(const Surface& surface, const Points& points,
                                             const std::string& units,
                                             const interp::Grid& grid,
                                             Reporter& reporter) {
  return evaluate_any(
      surface, points, units, [&] { return interp::plane_nodes(grid); },
      [&] { return interp::globe_nodes(grid); }, reporter);
}

}  // namespace delone::cli
