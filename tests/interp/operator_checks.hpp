#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "interp/operator.hpp"

/// What every operator must be.
namespace delone::support {

/// The same values missing, and the others equal to 1e-13 of a range of 2.
inline void expect_equal_values(const std::vector<double>& a,
                                const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::isnan(a[i]), std::isnan(b[i])) << i;
    if (!std::isnan(a[i])) {
      ASSERT_NEAR(a[i], b[i], 2e-13) << i;
    }
  }
}

/// The largest sum of magnitudes in a row.
inline double largest_magnitude(const interp::Operator& op) {
  double largest = 0;
  for (int i = 0; i < op.matrix().rows(); ++i) {
    double sum = 0;
    for (interp::Operator::Matrix::InnerIterator term(op.matrix(), i); term; ++term)
      sum += std::abs(term.value());
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Rows that are not empty sum to one.
inline void expect_rows_sum_to_one(const interp::Operator& op) {
  for (int i = 0; i < op.matrix().rows(); ++i) {
    double sum = 0, magnitude = 0;
    for (interp::Operator::Matrix::InnerIterator term(op.matrix(), i); term; ++term) {
      sum += term.value();
      magnitude += std::abs(term.value());
    }
    if (magnitude > 0) {
      ASSERT_NEAR(sum, 1, 4e-15 * magnitude) << i;
    }
  }
}

/// The product with any vector of targets is that of the matrix transposed.
inline void expect_transpose_is_adjoint(const interp::Operator& op,
                                        const std::vector<double>& values,
                                        const std::vector<double>& target_values) {
  const std::vector<double> forward = op.apply(values),
                            back = op.transposed().apply(target_values);
  double left = 0, right = 0;
  for (std::size_t i = 0; i < forward.size(); ++i)
    if (!std::isnan(forward[i])) left += target_values[i] * forward[i];
  for (std::size_t i = 0; i < back.size(); ++i) right += values[i] * back[i];
  EXPECT_NEAR(left, right, 1e-11 * (1 + std::abs(left)));
}

/// What applies to every operator whose targets are not all missing: several fields,
/// gaps, variances, constants.
inline void expect_common_behaviour(const interp::Operator& op,
                                    const std::vector<double>& values) {
  const auto n = static_cast<Eigen::Index>(values.size());
  interp::Fields fields(n, 3);
  for (Eigen::Index i = 0; i < n; ++i)
    fields.row(i) << values[static_cast<std::size_t>(i)], 7.25, static_cast<double>(i);
  const interp::Fields applied = op.apply_fields(fields);
  const std::vector<double> alone = op.apply(values),
                            variances = op.propagated_variance(
                                std::vector<double>(values.size(), 4));
  std::vector<double> gaps = values;
  for (std::size_t i = 0; i < gaps.size(); i += 4)
    gaps[i] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> propagated = op.apply(gaps),
                            shared = op.apply(
                                gaps, {.missing = interp::MissingRows::renormalise});
  for (int i = 0; i < op.matrix().rows(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (std::isnan(alone[k])) continue;
    EXPECT_EQ(applied(i, 0), alone[k]);
    EXPECT_NEAR(applied(i, 1), 7.25, 1e-13);
    double squares = 0, present = 0;
    bool is_whole = true;
    for (interp::Operator::Matrix::InnerIterator term(op.matrix(), i); term; ++term) {
      squares += term.value() * term.value();
      const bool is_present = !std::isnan(gaps[static_cast<std::size_t>(term.col())]);
      is_whole = is_whole && is_present;
      if (is_present) present += term.value();
    }
    EXPECT_NEAR(variances[k], 4 * squares, 1e-12 * squares);
    EXPECT_EQ(std::isnan(propagated[k]), !is_whole);
    if (is_whole) {
      EXPECT_EQ(shared[k], alone[k]);
    }
    if (present < 0.499) {
      EXPECT_TRUE(std::isnan(shared[k]));
    }
  }
}

}  // namespace delone::support
