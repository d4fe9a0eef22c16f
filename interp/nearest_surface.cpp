#include "interp/nearest_surface.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "interp/nearest_answer.hpp"
#include "interp/row_walk.hpp"

namespace delone::interp {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

template <class Triangulation, class Point>
double nearest_value(const Triangulation& t, std::span<const double> site_values,
                     const SurfaceOptions& options, const Point& p, Cursor& cursor) {
  const Site s = nearest_answer(t, options, p, cursor);
  return s == none ? missing : site_values[at(s)];
}

template <class Triangulation>
std::vector<double> checked_values(const Triangulation& t,
                                   std::span<const double> row_values,
                                   const SurfaceOptions& options) {
  check_nearest(options);
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
  return walk_plane_grid(grid, run, [&](tripack::Point2 p, Cursor& cursor) {
    return nearest_value(*triangulation_, values_, options_, p, cursor);
  });
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
  return walk_globe_grid(
      lonlat_grid, run, [&](const stripack::Direction& p, Cursor& cursor) {
        return nearest_value(*triangulation_, values_, options_, p, cursor);
      });
}

}  // namespace delone::interp
