#include "interp/operator.hpp"

#include <cmath>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/operator_assembly.hpp"
#include "interp/plane_cells.hpp"
#include "interp/sphere_cells.hpp"

namespace delone::interp {

namespace {

template <class Cells, class Triangulation, class Point>
Operator make_linear(const std::shared_ptr<const Triangulation>& triangulation,
                     std::span<const Point> targets, const SurfaceOptions& options,
                     const RunOptions& run) {
  const RowShares shares(*triangulation, options.duplicates);
  const Cells cells(triangulation, {}, options);
  return assemble_operator(
      targets, triangulation->adjacency(), shares, triangulation->num_rows(), run,
      [&](const Point& p, Cursor& cursor) { return cells.combination(p, cursor); });
}

bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }
bool is_finite(const Direction&) { return true; }

PlaneReach make_reach(const tripack::Triangulation& t, const SurfaceOptions& o) {
  return {t, o.max_distance};
}
SphereReach make_reach(const stripack::Triangulation& t, const SurfaceOptions& o) {
  return {t, o.max_distance, o.distance};
}

template <class Triangulation, class Point>
Combination nearest_combination(const Triangulation& t, const SurfaceOptions& options,
                                const Point& p, Cursor& cursor) {
  Combination sum;
  if (t.num_sites() == 0 || !is_finite(p)) return sum;
  if (options.outside == Outside::missing &&
      find_spot(t, p, cursor.arc).kind == Spot::Kind::outside)
    return sum;
  cursor.site = nearest_site(t, p, cursor.site);
  if (make_reach(t, options).covers(p, cursor.site)) sum.add(cursor.site, 1);
  return sum;
}

template <class Triangulation, class Point>
Operator make_nearest(const Triangulation& t, std::span<const Point> targets,
                      const SurfaceOptions& options, const RunOptions& run) {
  check(options);
  if (options.outside == Outside::linear) {
    throw Error("nearest values have no linear continuation; take nearest or missing");
  }
  const RowShares shares(t, options.duplicates);
  return assemble_operator(targets, t.adjacency(), shares, t.num_rows(), run,
                           [&](const Point& p, Cursor& cursor) {
                             return nearest_combination(t, options, p, cursor);
                           });
}

}  // namespace

Operator linear_operator(std::shared_ptr<const tripack::Triangulation> triangulation,
                         std::span<const tripack::Point2> targets,
                         const SurfaceOptions& options, const RunOptions& run) {
  return make_linear<PlaneCells>(triangulation, targets, options, run);
}

Operator linear_operator(std::shared_ptr<const stripack::Triangulation> triangulation,
                         std::span<const stripack::Direction> targets,
                         const SurfaceOptions& options, const RunOptions& run) {
  return make_linear<SphereCells>(triangulation, targets, options, run);
}

Operator nearest_operator(std::shared_ptr<const tripack::Triangulation> triangulation,
                          std::span<const tripack::Point2> targets,
                          const SurfaceOptions& options, const RunOptions& run) {
  return make_nearest(*triangulation, targets, options, run);
}

Operator nearest_operator(std::shared_ptr<const stripack::Triangulation> triangulation,
                          std::span<const stripack::Direction> targets,
                          const SurfaceOptions& options, const RunOptions& run) {
  return make_nearest(*triangulation, targets, options, run);
}

}  // namespace delone::interp
