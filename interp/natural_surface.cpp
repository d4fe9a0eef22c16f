#include "interp/natural_surface.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/cursor.hpp"
#include "interp/natural_cells.hpp"
#include "interp/natural_gradients.hpp"
#include "interp/row_walk.hpp"

namespace delone::interp {

namespace {

using PlaneStar = NaturalCells<PlaneView>;
using SphereStar = NaturalCells<SphereView>;

Gradient2 as_gradient(Point2 g) { return {g.x, g.y}; }

// Towards east and north; at a pole the longitude counts as 0.
struct Compass {
  Vector3 east, north;
  explicit Compass(const Direction& p) {
    const double across = std::hypot(p.x(), p.y());
    const double cosine = across == 0 ? 1 : p.x() / across,
                 sine = across == 0 ? 0 : p.y() / across;
    east = {-sine, cosine, 0};
    north = {-p.z() * cosine, -p.z() * sine, across};
  }
};
GradientSphere as_gradient(Vector3 g, const Direction& p) {
  const Compass compass(p);
  return {dot(g, compass.east), dot(g, compass.north)};
}

template <class Triangulation>
std::vector<double> checked_values(const Triangulation& t,
                                   std::span<const double> row_values,
                                   const NaturalOptions& options) {
  check_natural(options);
  return values_at_sites(t.sites(), t.num_sites(), row_values, options.duplicates);
}

bool is_finite(const Gradient2& g) { return std::isfinite(g.x) && std::isfinite(g.y); }
bool is_finite(const GradientSphere& g) {
  return std::isfinite(g.east) && std::isfinite(g.north);
}

template <class Triangulation, class Gradient>
void check_gradients(const Triangulation& t, std::span<const Gradient> row_gradients) {
  if (row_gradients.size() != t.sites().size()) {
    throw Error("there are " + std::to_string(row_gradients.size()) + " gradients for " +
                std::to_string(t.sites().size()) + " points; give one a point");
  }
  for (std::size_t i = 0; i < row_gradients.size(); ++i) {
    if (is_finite(row_gradients[i])) continue;
    const auto row = static_cast<std::int64_t>(i);
    throw Error("row " + std::to_string(row) +
                    ": the gradient is not a finite number; remove the row",
                {row});
  }
}

Pair<double> as_slope(const Gradient2& g, Point2, double scale) {
  return {g.x / scale, g.y / scale};
}
Vector3 as_slope(const GradientSphere& g, const Direction& p, double) {
  const Compass compass(p);
  return g.east * compass.east + g.north * compass.north;
}

template <class View, class Triangulation, class Gradient>
std::vector<typename View::Slope> slopes_from(const Triangulation& t,
                                              std::span<const Gradient> row_gradients,
                                              double scale) {
  check_gradients(t, row_gradients);
  std::vector<typename View::Slope> slopes(at(t.num_sites()));
  for (Site s = 0; s < t.num_sites(); ++s)
    slopes[at(s)] =
        as_slope(row_gradients[at(t.rows()[at(s)])], t.points()[at(s)], scale);
  return slopes;
}

double scale_of(std::span<const Point2> points) { return coordinate_scale(points); }
double scale_of(std::span<const Direction>) { return 1; }

bool needs_slopes(const NaturalOptions& options, int dimension) {
  return options.kind == NaturalKind::sibson_c1 && dimension == 2;
}

template <class View, class Triangulation>
std::shared_ptr<const NaturalCells<View>> make_cells(
    std::shared_ptr<const Triangulation> t, std::span<const double> row_values,
    const NaturalOptions& options) {
  std::vector<double> values = checked_values(*t, row_values, options);
  const double scale = scale_of(t->points());
  std::vector<typename View::Slope> slopes;
  if (needs_slopes(options, t->dimension()))
    slopes = natural_gradients(*t, scale, values, options.slope_limit);
  return std::make_shared<NaturalCells<View>>(std::move(t), std::move(values),
                                              std::move(slopes), scale, options);
}

template <class View, class Triangulation, class Gradient>
std::shared_ptr<const NaturalCells<View>> make_cells(
    std::shared_ptr<const Triangulation> t, std::span<const double> row_values,
    std::span<const Gradient> row_gradients, const NaturalOptions& options) {
  std::vector<double> values = checked_values(*t, row_values, options);
  const double scale = scale_of(t->points());
  std::vector<typename View::Slope> slopes = slopes_from<View>(*t, row_gradients, scale);
  if (!needs_slopes(options, t->dimension())) slopes.clear();
  return std::make_shared<NaturalCells<View>>(std::move(t), std::move(values),
                                              std::move(slopes), scale, options);
}

template <class Result, class Cells, class Point, class Ask>
std::vector<Result> along_curve(const Cells& cells, std::span<const Point> points,
                                const RunOptions& run, Ask ask) {
  return evaluate_along_curve<Result>(points, cells.triangulation().adjacency(), run,
                                      ask);
}

}  // namespace

void check_natural(const NaturalOptions& options) {
  check(options.surface());
  if (options.outside == Outside::linear) {
    throw Error(
        "natural neighbours have no linear continuation; take nearest or missing");
  }
}

PlaneNatural::PlaneNatural(std::shared_ptr<const tripack::Triangulation> triangulation,
                           std::span<const double> row_values,
                           const NaturalOptions& options)
    : cells_(make_cells<PlaneView>(std::move(triangulation), row_values, options)) {}

PlaneNatural::PlaneNatural(std::shared_ptr<const tripack::Triangulation> triangulation,
                           std::span<const double> row_values,
                           std::span<const Gradient2> row_gradients,
                           const NaturalOptions& options)
    : cells_(make_cells<PlaneView>(std::move(triangulation), row_values, row_gradients,
                                   options)) {}

double PlaneNatural::value(tripack::Point2 p) const {
  Cursor cursor;
  return cells_->value(p, cursor);
}

Gradient2 PlaneNatural::gradient(tripack::Point2 p) const {
  Cursor cursor;
  return as_gradient(cells_->gradient(p, cursor));
}

NaturalWeights PlaneNatural::weights(tripack::Point2 p) const {
  Cursor cursor;
  return cells_->weights(p, cursor);
}

std::vector<double> PlaneNatural::values(std::span<const tripack::Point2> points,
                                         const RunOptions& run) const {
  return along_curve<double>(*cells_, points, run, [&](Point2 p, Cursor& cursor) {
    return cells_->value(p, cursor);
  });
}

std::vector<Gradient2> PlaneNatural::gradients(std::span<const tripack::Point2> points,
                                               const RunOptions& run) const {
  return along_curve<Gradient2>(*cells_, points, run, [&](Point2 p, Cursor& cursor) {
    return as_gradient(cells_->gradient(p, cursor));
  });
}

std::vector<NaturalWeights> PlaneNatural::weights(std::span<const tripack::Point2> points,
                                                  const RunOptions& run) const {
  return along_curve<NaturalWeights>(*cells_, points, run, [&](Point2 p, Cursor& cursor) {
    return cells_->weights(p, cursor);
  });
}

Field PlaneNatural::grid(const Grid& grid, const RunOptions& run) const {
  return walk_plane_grid(
      grid, run, [&](Point2 p, Cursor& cursor) { return cells_->value(p, cursor); });
}

SphereNatural::SphereNatural(std::shared_ptr<const stripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const NaturalOptions& options)
    : cells_(make_cells<SphereView>(std::move(triangulation), row_values, options)) {}

SphereNatural::SphereNatural(std::shared_ptr<const stripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             std::span<const GradientSphere> row_gradients,
                             const NaturalOptions& options)
    : cells_(make_cells<SphereView>(std::move(triangulation), row_values, row_gradients,
                                    options)) {}

double SphereNatural::value(const stripack::Direction& p) const {
  Cursor cursor;
  return cells_->value(p, cursor);
}

GradientSphere SphereNatural::gradient(const stripack::Direction& p) const {
  Cursor cursor;
  return as_gradient(cells_->gradient(p, cursor), p);
}

NaturalWeights SphereNatural::weights(const stripack::Direction& p) const {
  Cursor cursor;
  return cells_->weights(p, cursor);
}

std::vector<double> SphereNatural::values(std::span<const stripack::Direction> points,
                                          const RunOptions& run) const {
  return along_curve<double>(
      *cells_, points, run,
      [&](const Direction& p, Cursor& cursor) { return cells_->value(p, cursor); });
}

std::vector<GradientSphere> SphereNatural::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return along_curve<GradientSphere>(*cells_, points, run,
                                     [&](const Direction& p, Cursor& cursor) {
                                       return as_gradient(cells_->gradient(p, cursor), p);
                                     });
}

std::vector<NaturalWeights> SphereNatural::weights(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return along_curve<NaturalWeights>(
      *cells_, points, run,
      [&](const Direction& p, Cursor& cursor) { return cells_->weights(p, cursor); });
}

Field SphereNatural::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return walk_globe_grid(lonlat_grid, run, [&](const Direction& p, Cursor& cursor) {
    return cells_->value(p, cursor);
  });
}

}  // namespace delone::interp
