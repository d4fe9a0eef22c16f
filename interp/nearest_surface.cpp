#include "interp/nearest_surface.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/cursor.hpp"
#include "interp/globe_table.hpp"
#include "interp/plane_reach.hpp"
#include "interp/row_walk.hpp"
#include "interp/sphere_reach.hpp"
#include "interp/spot.hpp"

namespace delone::interp {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

PlaneReach make_reach(const tripack::Triangulation& t, const SurfaceOptions& o) {
  return {t, o.max_distance};
}
SphereReach make_reach(const stripack::Triangulation& t, const SurfaceOptions& o) {
  return {t, o.max_distance, o.distance};
}

bool is_finite(tripack::Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }
bool is_finite(const stripack::Direction&) { return true; }

template <class Triangulation, class Point>
double nearest_value(const Triangulation& t, std::span<const double> site_values,
                     const SurfaceOptions& options, const Point& p, Cursor& cursor) {
  if (t.num_sites() == 0 || !is_finite(p)) return missing;
  if (options.outside == Outside::missing &&
      find_spot(t, p, cursor.arc).kind == Spot::Kind::outside) {
    return missing;
  }
  cursor.site = nearest_site(t, p, cursor.site);
  return make_reach(t, options).covers(p, cursor.site) ? site_values[at(cursor.site)]
                                                       : missing;
}

template <class Triangulation>
std::vector<double> checked_values(const Triangulation& t,
                                   std::span<const double> row_values,
                                   const SurfaceOptions& options) {
  check(options);
  if (options.outside == Outside::linear) {
    throw Error("nearest values have no linear continuation; take nearest or missing");
  }
  return values_at_sites(t.sites(), t.num_sites(), row_values, options.duplicates);
}

}  // namespace

PlaneNearest::PlaneNearest(std::shared_ptr<const tripack::Triangulation> triangulation,
                           std::span<const double> row_values,
                           const SurfaceOptions& options)
    : triangulation_(std::move(triangulation)),
      values_(checked_values(*triangulation_, row_values, options)),
      options_(options) {}

double PlaneNearest::value(tripack::Point2 p) const {
  Cursor cursor;
  return nearest_value(*triangulation_, values_, options_, p, cursor);
}

Gradient2 PlaneNearest::gradient(tripack::Point2 p) const {
  return std::isnan(value(p)) ? Gradient2{missing, missing} : Gradient2{};
}

std::vector<double> PlaneNearest::values(std::span<const tripack::Point2> points,
                                         const RunOptions& run) const {
  return evaluate_along_curve<double>(
      points, triangulation_->adjacency(), run, [&](tripack::Point2 p, Cursor& cursor) {
        return nearest_value(*triangulation_, values_, options_, p, cursor);
      });
}

std::vector<Gradient2> PlaneNearest::gradients(std::span<const tripack::Point2> points,
                                               const RunOptions& run) const {
  std::vector<Gradient2> result;
  for (const double v : values(points, run)) {
    result.push_back(std::isnan(v) ? Gradient2{missing, missing} : Gradient2{});
  }
  return result;
}

Field PlaneNearest::grid(const Grid& grid, const RunOptions& run) const {
  check(grid);
  const AxisTable x(grid.x), y(grid.y);
  return {grid, walk_rows(y.size(), x.size(), run,
                          [&](std::int64_t i, std::int64_t j, Cursor& cursor) {
                            return nearest_value(*triangulation_, values_, options_,
                                                 tripack::Point2{x[i], y[j]}, cursor);
                          })};
}

SphereNearest::SphereNearest(std::shared_ptr<const stripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const SurfaceOptions& options)
    : triangulation_(std::move(triangulation)),
      values_(checked_values(*triangulation_, row_values, options)),
      options_(options) {}

double SphereNearest::value(const stripack::Direction& p) const {
  Cursor cursor;
  return nearest_value(*triangulation_, values_, options_, p, cursor);
}

GradientSphere SphereNearest::gradient(const stripack::Direction& p) const {
  return std::isnan(value(p)) ? GradientSphere{missing, missing} : GradientSphere{};
}

std::vector<double> SphereNearest::values(std::span<const stripack::Direction> points,
                                          const RunOptions& run) const {
  return evaluate_along_curve<double>(points, triangulation_->adjacency(), run,
                                      [&](const stripack::Direction& p, Cursor& cursor) {
                                        return nearest_value(*triangulation_, values_,
                                                             options_, p, cursor);
                                      });
}

std::vector<GradientSphere> SphereNearest::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  std::vector<GradientSphere> result;
  for (const double v : values(points, run)) {
    result.push_back(std::isnan(v) ? GradientSphere{missing, missing} : GradientSphere{});
  }
  return result;
}

Field SphereNearest::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  check_globe(lonlat_grid);
  const GlobeTable table(lonlat_grid);
  return {lonlat_grid, walk_rows(table.rows(), table.columns(), run,
                                 [&](std::int64_t i, std::int64_t j, Cursor& cursor) {
                                   return nearest_value(*triangulation_, values_,
                                                        options_, table.node(i, j),
                                                        cursor);
                                 })};
}

}  // namespace delone::interp
