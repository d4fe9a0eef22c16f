#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/surface_options.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// What becomes of a target some of whose rows are missing (NaN) in a field.
enum class MissingRows : std::uint8_t {
  /// The target is missing.
  propagate,
  /// The rows that are present share its weight: their sum is divided by the sum of their
  /// weights. The target is missing if less than ApplyOptions::least_share is left.
  /// Cheap, continuous in space, and constants stay constants; but it is not the
  /// interpolant of the rows that are present (linear functions are not reproduced). That
  /// one is another operator: build it over the remaining rows and give its columns the
  /// old numbers with Operator::spread_to_rows.
  renormalise
};

struct ApplyOptions {
  MissingRows missing = MissingRows::propagate;
  /// The least part of a target's weight that must be present, 0 < least_share <= 1: of
  /// the weights as they are and of their magnitudes (the two differ if some are
  /// negative). The default: at least half of the value is observed, so a point nearer to
  /// a missing observation than to the others is missing.
  double least_share = 0.5;
};

/// Fields side by side: observations (or targets) x fields, row-major.
using Fields = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The transpose of an operator: rows of the observations x targets. What gradients of a
/// misfit at the targets by the observations need.
class TransposedOperator {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
  explicit TransposedOperator(std::shared_ptr<const Matrix> matrix)
      : matrix_(std::move(matrix)) {}
  [[nodiscard]] const Matrix& matrix() const noexcept { return *matrix_; }
  /// For each row of the observations the sum over the targets, in ascending order, of
  /// weight times target value; 0 where no target takes anything. Values at missing
  /// targets, NaN too, do not enter. The same bits for every number of threads. Throws
  /// Error unless there is one value a target.
  [[nodiscard]] std::vector<double> apply(std::span<const double> target_values,
                                          const RunOptions& run = {}) const;

 private:
  std::shared_ptr<const Matrix> matrix_;
};

/// An interpolant that is linear in the data as a sparse matrix, targets x rows of the
/// observations: built once, applied to any number of fields. Rows of missing targets are
/// empty; the other rows sum to one, up to 1e-15 a weight.
///
/// Copies share the matrix, which never changes; thread-safe for reading. Applying reads
/// the matrix once, 12 bytes a weight; results are the same bits for every number of
/// threads.
class Operator {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
  explicit Operator(Matrix matrix);
  [[nodiscard]] const Matrix& matrix() const noexcept { return *matrix_; }

  /// One value a target, NaN for missing ones. Values are not checked: infinities are
  /// carried on. Throws Error unless there is one value for each row of the observations,
  /// and for a least_share out of range; Cancelled.
  [[nodiscard]] std::vector<double> apply(std::span<const double> row_values,
                                          const ApplyOptions& options = {},
                                          const RunOptions& run = {}) const;
  /// Many fields at once, observations x fields: targets x fields, each column the bits
  /// that apply() gives for it. The matrix is read once for all fields.
  [[nodiscard]] Fields apply_fields(const Eigen::Ref<const Fields>& fields,
                                    const ApplyOptions& options = {},
                                    const RunOptions& run = {}) const;

  /// What TransposedOperator::apply gives, bit for bit, on one thread and without the
  /// memory for the transpose: for a single use.
  [[nodiscard]] std::vector<double> apply_transposed(
      std::span<const double> target_values) const;
  /// The transpose, for repeated use and for several threads. O(weights).
  [[nodiscard]] TransposedOperator transposed() const;

  /// The variance of each target from independent errors of the observations: the sum of
  /// squared weights times variances; NaN for missing targets. What the interpolant
  /// itself errs between the observations is not part of it (see leave_one_out.hpp).
  /// Throws Error naming the row for a variance that is negative, NaN or infinite, and
  /// unless there is one for each row.
  [[nodiscard]] std::vector<double> propagated_variance(
      std::span<const double> row_variances, const RunOptions& run = {}) const;
  /// The same with standard deviations in and out.
  [[nodiscard]] std::vector<double> propagated_deviation(
      std::span<const double> row_deviations, const RunOptions& run = {}) const;

  /// The operator on fields of `num_rows` rows of which it uses those in `rows`: its
  /// column k becomes rows[k]. So an operator over the observations that remain when some
  /// are missing applies to whole fields. Throws Error unless there is one row for each
  /// column, strictly ascending, below num_rows.
  [[nodiscard]] Operator spread_to_rows(std::span<const delaunay::Node> rows,
                                        delaunay::Node num_rows) const;

 private:
  std::shared_ptr<const Matrix> matrix_;
};

/// The operator of PlaneLinear / SphereLinear with the same options at the given targets
/// (see plane_nodes and globe_nodes for grids): applying it gives their values within
/// 1e-13 of the range of the data.
///
/// Repeated rows: `mean` spreads the weight of a position evenly over its rows, `first`
/// and `last` give it to one; the other policies are not linear in the data and are
/// refused with Error if a position repeats. Throws Error besides for more than 2^31
/// weights and for what the surfaces refuse. In parallel; needs the matrix twice while it
/// is built.
[[nodiscard]] Operator linear_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const SurfaceOptions& options = {},
    const RunOptions& run = {});
[[nodiscard]] Operator linear_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const SurfaceOptions& options = {},
    const RunOptions& run = {});

/// The operator of PlaneNearest / SphereNearest: one weight a target (with repeats and
/// `mean` one a row). Otherwise as linear_operator.
[[nodiscard]] Operator nearest_operator(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const SurfaceOptions& options = {},
    const RunOptions& run = {});
[[nodiscard]] Operator nearest_operator(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const SurfaceOptions& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
