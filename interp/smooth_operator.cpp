#include "interp/smooth_operator.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "interp/blend_operator_columns.hpp"
#include "interp/factored_operator_state.hpp"
#include "interp/smooth_fit.hpp"

namespace delone::interp {

namespace {

void check_fixed(const SmoothOptions& options, std::size_t num_rows) {
  check(options, num_rows);
  if (options.by != SmoothBy::wavelength) {
    throw Error(
        "smoothing is linear in the data for a given wavelength only; give it (that of "
        "a surface's fit, for instance)");
  }
}

/// What values and weights of the sites are made of; with errors by their inverse
/// squares.
Operator::Matrix row_shares(const RowShares& shares, delaunay::Site num_sites,
                            delaunay::Node num_rows, const SmoothOptions& options) {
  Operator::Matrix matrix = shares_matrix(shares, num_sites, num_rows);
  if (options.errors.empty()) return matrix;
  const double least = std::ranges::min(options.errors);
  for (delaunay::Site s = 0; s < num_sites; ++s) {
    double sum = 0;
    for (Operator::Matrix::InnerIterator share(matrix, s); share; ++share) {
      const double ratio = least / options.errors[at(static_cast<Site>(share.col()))];
      share.valueRef() = std::max(1e-30, ratio * ratio);
      sum += share.value();
    }
    for (Operator::Matrix::InnerIterator share(matrix, s); share; ++share)
      share.valueRef() /= sum;
  }
  return matrix;
}

template <class Triangulation>
C1Options surface_options(const Triangulation& t, const SmoothOptions& options,
                          const RunOptions& run) {
  C1Options result;
  static_cast<SurfaceOptions&>(result) = options;
  result.gradients = Gradients::given;
  result.choices = options.choices ? options.choices : c1_choices(t, result, run);
  result.gradients = Gradients::automatic;
  return result;
}

template <BlendSpace Space, class Triangulation, class Point>
FactoredOperator make_operator(const std::shared_ptr<const Triangulation>& t,
                               std::span<const Point> targets,
                               const SmoothOptions& options, const RunOptions& run) {
  const RunOptions quiet{run.num_threads, {}};
  check_fixed(options, t->sites().size());
  const RowShares shares(*t, options.duplicates);
  Operator evaluation =
      operator_on_unknowns(t, targets, surface_options(*t, options, quiet), run);
  std::variant<IdentityMap, CurvatureMap, SmoothMap> map;
  if (t->num_sites() >= 3) {
    const std::vector<double> zeros(t->sites().size());
    SmoothSystem system = smooth_system<Space>(
        *t, smooth_data(t->sites(), t->num_sites(), zeros, options).weights);
    const double wavelength = options.wavelength * system.scale;
    map = SmoothMap(std::move(system), wavelength, quiet);
  }
  return FactoredOperator(
      std::make_shared<const FactoredOperator::State>(FactoredOperator::State{
          std::move(evaluation), std::move(map),
          row_shares(shares, t->num_sites(), t->num_rows(), options)}));
}

}  // namespace

FactoredOperator smooth_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const SmoothOptions& options,
    const RunOptions& run) {
  return make_operator<PlaneSpace>(triangulation, targets, options, run);
}

FactoredOperator smooth_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const SmoothOptions& options,
    const RunOptions& run) {
  return make_operator<SphereSpace>(triangulation, targets, options, run);
}

}  // namespace delone::interp
