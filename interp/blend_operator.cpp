#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "interp/blend_operator_columns.hpp"
#include "interp/blend_operator_node.hpp"
#include "interp/blend_operator_rows.hpp"
#include "interp/c1_operator.hpp"
#include "interp/operator_assembly.hpp"

namespace delone::interp {

namespace {

template <BlendSpace Space, class Triangulation, class Point>
Operator assembled(const std::shared_ptr<const Triangulation>& t,
                   std::span<const Point> targets, const C1Options& options,
                   const C1Choices& choices, const RowShares& shares,
                   delaunay::Node num_columns, const RunOptions& run) {
  const typename LinearCellsOf<Space>::Type linear(t, {}, options);
  const auto assemble = [&](auto rows_of_chunk) {
    return assemble_operator_in_chunks(targets, t->adjacency(), shares, num_columns, run,
                                       rows_of_chunk);
  };
  if (choices.degree == FitDegree::quartic)
    return assemble([&] { return BlendRows<Space, 4>(linear, choices); });
  return assemble([&] { return BlendRows<Space, 3>(linear, choices); });
}

template <BlendSpace Space, class Triangulation, class Point>
Operator make_operator(const std::shared_ptr<const Triangulation>& t,
                       std::span<const Point> targets, const C1Options& options,
                       const RunOptions& run) {
  check_choices(options, t->num_sites());
  check_linear(options);
  const RowShares shares(*t, options.duplicates);
  if (options.choices ? options.choices->gradients != Gradients::local
                      : options.gradients == Gradients::global) {
    throw Error(
        "global gradients take values from everywhere; take global_operator, or local "
        "gradients");
  }
  const auto choices = options.choices ? options.choices : c1_choices(*t, options);
  return assembled<Space>(t, targets, options, *choices, shares, t->num_rows(), run);
}

template <BlendSpace Space, class Triangulation, class Point>
Operator make_columns(const std::shared_ptr<const Triangulation>& t,
                      std::span<const Point> targets, const C1Options& options,
                      const RunOptions& run) {
  check_choices(options, t->num_sites());
  if (!options.choices || options.choices->gradients == Gradients::local)
    throw Error(
        "the choices are for local gradients; make them with global or given ones");
  const Columns columns(3 * t->num_sites());
  return assembled<Space>(t, targets, options, *options.choices,
                          RowShares(columns, Duplicates::mean), 3 * t->num_sites(), run);
}

}  // namespace

Operator operator_on_unknowns(std::shared_ptr<const tripack::Triangulation> triangulation,
                              std::span<const tripack::Point2> targets,
                              const C1Options& options, const RunOptions& run) {
  return make_columns<PlaneSpace>(triangulation, targets, options, run);
}

Operator operator_on_unknowns(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const C1Options& options,
    const RunOptions& run) {
  return make_columns<SphereSpace>(triangulation, targets, options, run);
}

Operator c1_operator(std::shared_ptr<const tripack::Triangulation> triangulation,
                     std::span<const tripack::Point2> targets, const C1Options& options,
                     const RunOptions& run) {
  return make_operator<PlaneSpace>(triangulation, targets, options, run);
}

Operator c1_operator(std::shared_ptr<const stripack::Triangulation> triangulation,
                     std::span<const stripack::Direction> targets,
                     const C1Options& options, const RunOptions& run) {
  return make_operator<SphereSpace>(triangulation, targets, options, run);
}

}  // namespace delone::interp
