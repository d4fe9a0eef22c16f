#include "interp/operator.hpp"

#include <utility>

#include "interp/nearest_answer.hpp"
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

template <class Triangulation, class Point>
Operator make_nearest(const Triangulation& t, std::span<const Point> targets,
                      const SurfaceOptions& options, const RunOptions& run) {
  check_nearest(options);
  const RowShares shares(t, options.duplicates);
  return assemble_operator(targets, t.adjacency(), shares, t.num_rows(), run,
                           [&](const Point& p, Cursor& cursor) {
                             Combination sum;
                             const Site s = nearest_answer(t, options, p, cursor);
                             if (s != none) sum.add(s, 1);
                             return sum;
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
