#include "interp/arc_tension_surface.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/arc_tension_cells.hpp"
#include "interp/node_gradients.hpp"
#include "interp/row_walk.hpp"
#include "interp/triangle_integral.hpp"

namespace delone::interp {

namespace {

Derivatives2 in_plane(const SecondOrder& f) {
  return {f.value, f.x, f.y, f.xx, f.xy, f.yy};
}
DerivativesSphere on_sphere(const SecondOrder& f) {
  return {f.value, f.x, f.y, f.xx, f.xy, f.yy};
}

struct PlaneKind {
  using Space = PlaneSpace;
  using C1 = PlaneC1;
  using Gradient = Gradient2;
};
struct SphereKind {
  using Space = SphereSpace;
  using C1 = SphereC1;
  using Gradient = GradientSphere;
};

/// At the nodes themselves, whatever is outside or out of reach.
C1Options without_limits(C1Options options) {
  options.outside = Outside::missing;
  options.max_distance = std::numeric_limits<double>::infinity();
  return options;
}

/// Gradients beyond the largest double are none.
template <class Vector>
Vector usable_or_none(const Vector& g) {
  return is_usable(g) ? g : Vector{};
}

template <class Kind>
struct SiteGradients {
  std::vector<typename Kind::Space::Vector> vectors;
  C1Fit fit;
};

/// Those of the C1 surface where `given` has none.
template <class Kind>
SiteGradients<Kind> fill_in(const typename Kind::C1& surface, const auto& t, double scale,
                            std::vector<typename Kind::Space::Vector> given,
                            const RunOptions& run) {
  const auto fitted = surface.gradients(t.points(), run);
  given.resize(at(t.num_sites()), part_of(typename Kind::Space::Vector{},
                                          std::numeric_limits<double>::quiet_NaN()));
  for (Site s = 0; s < t.num_sites(); ++s) {
    if (!is_usable(given[at(s)]))
      given[at(s)] = usable_or_none(scaled_gradient(t, scale, s, fitted[at(s)]));
  }
  return {std::move(given), surface.fit()};
}

template <class Triangulation>
double scale_of(const Triangulation& t) {
  if constexpr (std::same_as<Triangulation, tripack::Triangulation>) {
    return coordinate_scale(t.points());
  } else {
    return 1;
  }
}

template <class Kind, class Triangulation>
SiteGradients<Kind> fitted_gradients(const std::shared_ptr<const Triangulation>& t,
                                     std::span<const double> row_values,
                                     const C1Options& options, const RunOptions& run) {
  const typename Kind::C1 surface(t, row_values, without_limits(options), run);
  return fill_in<Kind>(surface, *t, scale_of(*t), {}, RunOptions{run.num_threads, {}});
}

template <class Kind, class Triangulation>
SiteGradients<Kind> given_gradients(
    const std::shared_ptr<const Triangulation>& t, std::span<const double> row_values,
    std::span<const typename Kind::Gradient> row_gradients, const C1Options& options,
    const RunOptions& run) {
  check(options);
  const double scale = scale_of(*t);
  auto given = gradients_at_sites<typename Kind::Space>(*t, scale, row_gradients);
  if (std::ranges::all_of(given, [](const auto& g) { return is_usable(g); }))
    return {std::move(given), {.gradients = Gradients::given}};
  const typename Kind::C1 surface(t, row_values, row_gradients, without_limits(options),
                                  run);
  return fill_in<Kind>(surface, *t, scale, std::move(given),
                       RunOptions{run.num_threads, {}});
}

}  // namespace

/// The cells, and reading them at many points.
template <class Space>
class ArcTensionSurface {
 public:
  using Cells = ArcTensionCells<Space>;
  using Triangulation = typename Space::Triangulation;
  using Point = typename Space::Point;

  /// `fit_gradients()` once all else is known to be in order.
  template <class Fit>
  static std::shared_ptr<const ArcTensionSurface> make(
      const std::shared_ptr<const Triangulation>& t, std::span<const double> row_values,
      const TensionSplineOptions& options, const RunOptions& run, Fit fit_gradients) {
    std::vector<double> values =
        values_at_sites(t->sites(), t->num_sites(), row_values, options.c1.duplicates);
    check_arcs(*t, values, options);
    typename Cells::Linear linear(t, values, options.c1);
    auto gradients = fit_gradients();
    Space space;
    if constexpr (std::same_as<Space, PlaneSpace>) space.scale = scale_of(*t);
    ArcNetwork<Space> network(t, space, std::move(values), std::move(gradients.vectors),
                              options, RunOptions{run.num_threads, {}});
    return std::make_shared<const ArcTensionSurface>(
        Cells(std::move(linear), std::move(network), gradients.fit));
  }
  explicit ArcTensionSurface(Cells cells) : cells_(std::move(cells)) {}

  [[nodiscard]] const Cells& cells() const noexcept { return cells_; }
  /// `read(cells, point, cursor)` at every point.
  template <class Result, class Read>
  [[nodiscard]] std::vector<Result> read_all(std::span<const Point> points,
                                             const RunOptions& run, Read read) const {
    return evaluate_along_curve<Result>(
        points, cells_.triangulation().adjacency(), run,
        [&](const Point& p, Cursor& cursor) { return read(cells_, p, cursor); });
  }

 private:
  Cells cells_;
};

namespace {

constexpr auto read_value = [](const auto& cells, const auto& p, Cursor& cursor) {
  return cells.value(p, cursor);
};

/// Gradients of all rows as a network, for the factors alone.
template <class Kind, class Triangulation>
std::vector<double> factors_of(const Triangulation& t, std::span<const double> row_values,
                               std::span<const typename Kind::Gradient> row_gradients,
                               const ArcDemand& demand, const RunOptions& run) {
  using Space = typename Kind::Space;
  const double scale = scale_of(t);
  auto gradients = gradients_at_sites<Space>(t, scale, row_gradients);
  for (Site s = 0; s < t.num_sites(); ++s) {
    if (is_usable(gradients[at(s)])) continue;
    const std::int64_t row = t.rows()[at(s)];
    throw Error("row " + std::to_string(row) +
                    ": the gradient is not known; factors need that of every point",
                {row});
  }
  Space space;
  if constexpr (std::same_as<Space, PlaneSpace>) space.scale = scale;
  // Shares what the caller keeps.
  const std::shared_ptr<const Triangulation> shared(&t, [](const Triangulation*) {});
  TensionSplineOptions options;
  options.demand = demand;
  std::vector<double> values = values_at_sites(t.sites(), t.num_sites(), row_values);
  check_arcs(t, values, options);
  return ArcNetwork<Space>(shared, space, std::move(values), std::move(gradients),
                           options, run)
      .factors();
}

}  // namespace

std::vector<double> tension_factors(const tripack::Triangulation& triangulation,
                                    std::span<const double> row_values,
                                    std::span<const Gradient2> row_gradients,
                                    const ArcDemand& demand, const RunOptions& run) {
  return factors_of<PlaneKind>(triangulation, row_values, row_gradients, demand, run);
}
std::vector<double> tension_factors(const stripack::Triangulation& triangulation,
                                    std::span<const double> row_values,
                                    std::span<const GradientSphere> row_gradients,
                                    const ArcDemand& demand, const RunOptions& run) {
  return factors_of<SphereKind>(triangulation, row_values, row_gradients, demand, run);
}

PlaneTensionSpline::PlaneTensionSpline(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, const TensionSplineOptions& options,
    const RunOptions& run)
    : surface_(ArcTensionSurface<PlaneSpace>::make(
          triangulation, row_values, options, run, [&] {
            return fitted_gradients<PlaneKind>(triangulation, row_values, options.c1,
                                               run);
          })) {}

PlaneTensionSpline::PlaneTensionSpline(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const double> row_values, std::span<const Gradient2> row_gradients,
    const TensionSplineOptions& options, const RunOptions& run)
    : surface_(ArcTensionSurface<PlaneSpace>::make(
          triangulation, row_values, options, run, [&] {
            return given_gradients<PlaneKind>(triangulation, row_values, row_gradients,
                                              options.c1, run);
          })) {}

const TensionSplineFit& PlaneTensionSpline::fit() const noexcept {
  return surface_->cells().fit();
}
std::vector<double> PlaneTensionSpline::tension_factors() const {
  return surface_->cells().network().factors();
}

double PlaneTensionSpline::value(tripack::Point2 p) const {
  Cursor cursor;
  return surface_->cells().value(p, cursor);
}
Gradient2 PlaneTensionSpline::gradient(tripack::Point2 p) const {
  const Derivatives2 d = derivatives(p);
  return {d.x, d.y};
}
Derivatives2 PlaneTensionSpline::derivatives(tripack::Point2 p) const {
  Cursor cursor;
  return in_plane(surface_->cells().derivatives(p, cursor));
}

std::vector<double> PlaneTensionSpline::values(std::span<const tripack::Point2> points,
                                               const RunOptions& run) const {
  return surface_->read_all<double>(points, run, read_value);
}
std::vector<Gradient2> PlaneTensionSpline::gradients(
    std::span<const tripack::Point2> points, const RunOptions& run) const {
  return surface_->read_all<Gradient2>(
      points, run, [](const auto& cells, const Point2& p, Cursor& cursor) {
        const SecondOrder d = cells.derivatives(p, cursor);
        return Gradient2{d.x, d.y};
      });
}
std::vector<Derivatives2> PlaneTensionSpline::derivatives(
    std::span<const tripack::Point2> points, const RunOptions& run) const {
  return surface_->read_all<Derivatives2>(
      points, run, [](const auto& cells, const Point2& p, Cursor& cursor) {
        return in_plane(cells.derivatives(p, cursor));
      });
}

Field PlaneTensionSpline::grid(const Grid& grid, const RunOptions& run) const {
  return walk_plane_grid(grid, run, [&](Point2 p, Cursor& cursor) {
    return surface_->cells().value(p, cursor);
  });
}

double PlaneTensionSpline::integral(const RunOptions& run) const {
  return integral_over_triangles(surface_->cells().space(), surface_->cells(), run);
}

SphereTensionSpline::SphereTensionSpline(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, const TensionSplineOptions& options,
    const RunOptions& run)
    : surface_(ArcTensionSurface<SphereSpace>::make(
          triangulation, row_values, options, run, [&] {
            return fitted_gradients<SphereKind>(triangulation, row_values, options.c1,
                                                run);
          })) {}

SphereTensionSpline::SphereTensionSpline(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const double> row_values, std::span<const GradientSphere> row_gradients,
    const TensionSplineOptions& options, const RunOptions& run)
    : surface_(ArcTensionSurface<SphereSpace>::make(
          triangulation, row_values, options, run, [&] {
            return given_gradients<SphereKind>(triangulation, row_values, row_gradients,
                                               options.c1, run);
          })) {}

const TensionSplineFit& SphereTensionSpline::fit() const noexcept {
  return surface_->cells().fit();
}
std::vector<double> SphereTensionSpline::tension_factors() const {
  return surface_->cells().network().factors();
}

double SphereTensionSpline::value(const stripack::Direction& p) const {
  Cursor cursor;
  return surface_->cells().value(p, cursor);
}
GradientSphere SphereTensionSpline::gradient(const stripack::Direction& p) const {
  const DerivativesSphere d = derivatives(p);
  return {d.east, d.north};
}
DerivativesSphere SphereTensionSpline::derivatives(const stripack::Direction& p) const {
  Cursor cursor;
  return on_sphere(surface_->cells().derivatives(p, cursor));
}

std::vector<double> SphereTensionSpline::values(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return surface_->read_all<double>(points, run, read_value);
}
std::vector<GradientSphere> SphereTensionSpline::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return surface_->read_all<GradientSphere>(
      points, run, [](const auto& cells, const Direction& p, Cursor& cursor) {
        const SecondOrder d = cells.derivatives(p, cursor);
        return GradientSphere{d.x, d.y};
      });
}
std::vector<DerivativesSphere> SphereTensionSpline::derivatives(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return surface_->read_all<DerivativesSphere>(
      points, run, [](const auto& cells, const Direction& p, Cursor& cursor) {
        return on_sphere(cells.derivatives(p, cursor));
      });
}

Field SphereTensionSpline::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return walk_globe_grid(lonlat_grid, run, [&](const Direction& p, Cursor& cursor) {
    return surface_->cells().value(p, cursor);
  });
}

double SphereTensionSpline::integral(const RunOptions& run) const {
  return integral_over_triangles(SphereSpace{}, surface_->cells(), run);
}

}  // namespace delone::interp
