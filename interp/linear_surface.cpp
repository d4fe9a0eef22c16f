#include "interp/linear_surface.hpp"

#include <utility>

#include "interp/east_north.hpp"
#include "interp/plane_cells.hpp"
#include "interp/region_sum.hpp"
#include "interp/sphere_cells.hpp"
#include "interp/triangle_integral.hpp"

namespace delone::interp {

namespace {

Gradient2 as_gradient(Point2 g) { return {g.x, g.y}; }

template <class Triangulation>
std::vector<double> site_values(const Triangulation& t,
                                std::span<const double> row_values,
                                const SurfaceOptions& options) {
  return values_at_sites(t.sites(), t.num_sites(), row_values, options.duplicates);
}

}  // namespace

PlaneLinear::PlaneLinear(std::shared_ptr<const tripack::Triangulation> triangulation,
                         std::span<const double> row_values,
                         const SurfaceOptions& options) {
  std::vector<double> values = site_values(*triangulation, row_values, options);
  cells_ =
      std::make_shared<PlaneCells>(std::move(triangulation), std::move(values), options);
}

double PlaneLinear::value(tripack::Point2 p) const {
  Cursor cursor;
  return cells_->value(p, cursor);
}

Gradient2 PlaneLinear::gradient(tripack::Point2 p) const {
  Cursor cursor;
  return as_gradient(cells_->gradient(p, cursor));
}

std::vector<double> PlaneLinear::values(std::span<const tripack::Point2> points,
                                        const RunOptions& run) const {
  return evaluate_along_curve<double>(
      points, cells_->triangulation().adjacency(), run,
      [&](Point2 p, Cursor& cursor) { return cells_->value(p, cursor); });
}

std::vector<Gradient2> PlaneLinear::gradients(std::span<const tripack::Point2> points,
                                              const RunOptions& run) const {
  return evaluate_along_curve<Gradient2>(
      points, cells_->triangulation().adjacency(), run,
      [&](Point2 p, Cursor& cursor) { return as_gradient(cells_->gradient(p, cursor)); });
}

Field PlaneLinear::grid(const Grid& grid, const RunOptions& run) const {
  return {grid, scan(*cells_, grid, run)};
}

double PlaneLinear::integral(const RunOptions& run) const {
  return integral_over_triangles(PlaneSpace{cells_->scale()}, *cells_, run);
}

RegionIntegral PlaneLinear::integral(const PlaneRegion& region,
                                     const RunOptions& run) const {
  return integral_over_region(PlaneSpace{cells_->scale()}, *cells_, region, PlaneArea{},
                              run);
}

SphereLinear::SphereLinear(std::shared_ptr<const stripack::Triangulation> triangulation,
                           std::span<const double> row_values,
                           const SurfaceOptions& options) {
  std::vector<double> values = site_values(*triangulation, row_values, options);
  cells_ =
      std::make_shared<SphereCells>(std::move(triangulation), std::move(values), options);
}

double SphereLinear::value(const stripack::Direction& p) const {
  Cursor cursor;
  return cells_->value(p, cursor);
}

GradientSphere SphereLinear::gradient(const stripack::Direction& p) const {
  Cursor cursor;
  return east_and_north(cells_->gradient(p, cursor), p);
}

std::vector<double> SphereLinear::values(std::span<const stripack::Direction> points,
                                         const RunOptions& run) const {
  return evaluate_along_curve<double>(
      points, cells_->triangulation().adjacency(), run,
      [&](const Direction& p, Cursor& cursor) { return cells_->value(p, cursor); });
}

std::vector<GradientSphere> SphereLinear::gradients(
    std::span<const stripack::Direction> points, const RunOptions& run) const {
  return evaluate_along_curve<GradientSphere>(
      points, cells_->triangulation().adjacency(), run,
      [&](const Direction& p, Cursor& cursor) {
        return east_and_north(cells_->gradient(p, cursor), p);
      });
}

Field SphereLinear::grid(const Grid& lonlat_grid, const RunOptions& run) const {
  return {lonlat_grid, scan(*cells_, lonlat_grid, run)};
}

double SphereLinear::integral(const RunOptions& run) const {
  return integral_over_triangles(SphereSpace{}, *cells_, run);
}

RegionIntegral SphereLinear::integral(const SphereRegion& region, AreaUnit unit,
                                      const RunOptions& run) const {
  return integral_over_region(SphereSpace{}, *cells_, region, SphereArea(unit), run);
}

}  // namespace delone::interp
