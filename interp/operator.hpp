#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/surface_options.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// A linear interpolant as a sparse matrix, targets x rows of the observations: built
/// once, applied to any number of fields. Rows of missing targets are empty; the other
/// rows sum to one.
class Operator {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
  explicit Operator(Matrix matrix);
  [[nodiscard]] const Matrix& matrix() const noexcept { return matrix_; }
  /// One value a target, NaN for missing ones. Throws Error unless there is one value for
  /// each row of the observations.
  [[nodiscard]] std::vector<double> apply(std::span<const double> row_values) const;

 private:
  Matrix matrix_;
};

/// The operator of PlaneLinear / SphereLinear with the same options at the given targets
/// (see plane_nodes and globe_nodes for grids): applying it gives their values within
/// 1e-13 of the range of the data.
///
/// Repeated rows: `mean` spreads the weight of a position evenly over its rows, `first`
/// and `last` give it to one; the other policies are not linear in the data and are
/// refused with Error if a position repeats. Throws Error besides for more than 2^31
/// weights and for what the surfaces refuse.
[[nodiscard]] Operator linear_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const SurfaceOptions& options = {},
    const RunOptions& run = {});
[[nodiscard]] Operator linear_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const SurfaceOptions& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
