#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/operator.hpp"

namespace delone::interp {

/// How explicit rows of a factored operator are made.
struct RowOptions {
  /// The smallest weights of a row are left out as long as their magnitudes add up to no
  /// more than this, and their sum is given to the largest one. So rows sum to one as
  /// before, and no value changes by more than this part of the range of the data,
  /// whatever the field. 0: nothing is left out. At most 0.01.
  double tolerance = 0;
};

/// An interpolant that is linear in the data but takes every value from (nearly) all of
/// them: as a product of matrices that are not multiplied out. The values at the nodes
/// and their gradients are a linear function of the data that needs equations solved
/// (smooth_operator, global_operator); the targets are a sparse matrix times these.
///
/// Applied to any number of fields, and transposed, without the dense matrix of targets x
/// rows. That matrix, or some of its rows, can be made (explicit_rows): an Operator like
/// any other, to be looked at, written to files, or for variances.
///
/// Copies share everything, which never changes; thread-safe for reading. Results are the
/// same bits for every number of threads. Equal to the surface with the same choices
/// within 1e-13 of the range of the data.
class FactoredOperator {
 public:
  struct State;  ///< internal
  explicit FactoredOperator(std::shared_ptr<const State> state)
      : state_(std::move(state)) {}

  [[nodiscard]] std::int64_t num_targets() const noexcept;
  [[nodiscard]] std::int64_t num_rows() const noexcept;  ///< of the observations

  /// One value a target, NaN for missing ones.
  ///
  /// A value that is missing in the field: with MissingRows::propagate every target is
  /// missing, since all depend on all rows. With renormalise the others share its weight:
  /// the sum over those that are present is divided by the sum of their weights, and the
  /// target is missing if that is less than ApplyOptions::least_share (magnitudes are not
  /// looked at). The interpolant of the rows that are present, by exact removal, is
  /// another operator: build it over these and spread_to_rows.
  ///
  /// Throws Error unless there is one value for each row, and for a least_share out of
  /// range; Cancelled.
  [[nodiscard]] std::vector<double> apply(std::span<const double> row_values,
                                          const ApplyOptions& options = {},
                                          const RunOptions& run = {}) const;
  /// Many fields at once, observations x fields: targets x fields, each column what
  /// apply() gives for it up to rounding. Eight fields are solved together.
  [[nodiscard]] Fields apply_fields(const Eigen::Ref<const Fields>& fields,
                                    const ApplyOptions& options = {},
                                    const RunOptions& run = {}) const;

  /// For each row of the observations the sum over the targets of weight times target
  /// value. Values at missing targets do not enter. Throws Error unless there is one
  /// value a target.
  [[nodiscard]] std::vector<double> apply_transposed(
      std::span<const double> target_values, const RunOptions& run = {}) const;

  /// The weights of some targets, one transposed solution each: an operator of as many
  /// targets, in the order given. Dense in principle, targets x rows weights of 12 bytes
  /// with tolerance 0; rows of missing targets are empty. Throws Error for a target that
  /// there is not, a tolerance out of range, once there are more than 2^31 weights, and
  /// for a row that does not give the value of apply() within 1e-9 of the range for a
  /// field that all are tried on: smoothing's equations may be so nearly singular, on
  /// points that are nearly collinear, that single rows cannot be solved for. Cancelled.
  [[nodiscard]] Operator explicit_rows(std::span<const std::int64_t> targets,
                                       const RowOptions& options = {},
                                       const RunOptions& run = {}) const;
  /// Of all targets.
  [[nodiscard]] Operator explicit_rows(const RowOptions& options = {},
                                       const RunOptions& run = {}) const;

  /// The variance of some targets from independent errors of the observations, from their
  /// explicit rows, some at a time; otherwise as Operator::propagated_variance.
  [[nodiscard]] std::vector<double> propagated_variance(
      std::span<const std::int64_t> targets, std::span<const double> row_variances,
      const RunOptions& run = {}) const;

  /// As Operator::spread_to_rows.
  [[nodiscard]] FactoredOperator spread_to_rows(std::span<const delaunay::Node> rows,
                                                delaunay::Node num_rows) const;

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace delone::interp
