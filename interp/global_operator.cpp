#include "interp/global_operator.hpp"

#include <utility>

#include "delaunay/error.hpp"
#include "interp/blend_operator_columns.hpp"
#include "interp/blend_operator_node.hpp"
#include "interp/factored_operator_state.hpp"
#include "interp/plane_cells.hpp"

namespace delone::interp {

namespace {

PlaneSpace space_over(const tripack::Triangulation& t) {
  return {coordinate_scale(t.points())};
}
SphereSpace space_over(const stripack::Triangulation&) { return {}; }

void check_global(const C1Options& options) {
  check(options);
  check_linear(options);
  if (options.gradients == Gradients::local) {
    throw Error(
        "global_operator is of global gradients; take c1_operator for local ones");
  }
}

template <class Triangulation, class Point>
FactoredOperator make_operator(const std::shared_ptr<const Triangulation>& t,
                               std::span<const Point> targets, C1Options options,
                               const RunOptions& run) {
  check_global(options);
  const RowShares shares(*t, options.duplicates);
  options.gradients = Gradients::global;
  if (!options.choices) {
    options.choices = c1_choices(*t, options);
    options.tension = {};
  }
  Operator evaluation = operator_on_unknowns(t, targets, options, run);
  std::variant<IdentityMap, CurvatureMap, SmoothMap> map;
  if (t->dimension() == 2) map = curvature_map(space_over(*t), *t, run);
  return FactoredOperator(std::make_shared<const FactoredOperator::State>(
      FactoredOperator::State{std::move(evaluation), std::move(map),
                              shares_matrix(shares, t->num_sites(), t->num_rows())}));
}

}  // namespace

FactoredOperator global_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const C1Options& options,
    const RunOptions& run) {
  return make_operator(triangulation, targets, options, run);
}

FactoredOperator global_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const C1Options& options,
    const RunOptions& run) {
  return make_operator(triangulation, targets, options, run);
}

}  // namespace delone::interp
