#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "interp/factored_operator.hpp"
#include "interp/operator_checks.hpp"
#include "interp/surfaces.hpp"

/// What every factored operator must be.
namespace delone::support {

inline std::vector<std::int64_t> all_targets(const interp::FactoredOperator& op) {
  std::vector<std::int64_t> targets(static_cast<std::size_t>(op.num_targets()));
  std::iota(targets.begin(), targets.end(), 0);
  return targets;
}

/// <A x, y> = <x, A^T y>.
inline void expect_transpose_is_adjoint(const interp::FactoredOperator& op,
                                        std::uint64_t seed) {
  const std::vector<double> x = random_values(static_cast<std::size_t>(op.num_rows()),
                                              seed),
                            y = random_values(static_cast<std::size_t>(op.num_targets()),
                                              seed + 1),
                            forward = op.apply(x), back = op.apply_transposed(y);
  double left = 0, right = 0, size = 1;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (std::isnan(forward[i])) continue;
    left += y[i] * forward[i];
    size += std::abs(y[i] * forward[i]);
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    right += x[i] * back[i];
    size += std::abs(x[i] * back[i]);
  }
  EXPECT_NEAR(left, right, 1e-11 * size);
}

/// The explicit rows sum to one and give the values of apply().
inline void expect_rows_agree(const interp::FactoredOperator& op, std::uint64_t seed,
                              double most) {
  const interp::Operator rows = op.explicit_rows();
  ASSERT_EQ(rows.matrix().rows(), op.num_targets());
  ASSERT_EQ(rows.matrix().cols(), op.num_rows());
  for (int i = 0; i < rows.matrix().rows(); ++i) {
    double sum = 0, magnitude = 0;
    for (interp::Operator::Matrix::InnerIterator term(rows.matrix(), i); term; ++term) {
      sum += term.value();
      magnitude += std::abs(term.value());
    }
    if (magnitude > 0) {
      ASSERT_NEAR(sum, 1, most * (1 + magnitude)) << i;
    }
  }
  const std::vector<double> x = random_values(static_cast<std::size_t>(op.num_rows()),
                                              seed),
                            direct = op.apply(x), by_rows = rows.apply(x);
  for (std::size_t i = 0; i < direct.size(); ++i) {
    ASSERT_EQ(std::isnan(direct[i]), std::isnan(by_rows[i])) << i;
    if (!std::isnan(direct[i])) {
      ASSERT_NEAR(direct[i], by_rows[i], most) << i;
    }
  }
}

/// Several fields, missing values, variances, constants, threads.
inline void expect_common_behaviour(const interp::FactoredOperator& op) {
  const auto n = static_cast<Eigen::Index>(op.num_rows());
  const std::vector<double> values = random_values(static_cast<std::size_t>(n), 7),
                            alone = op.apply(values);
  interp::Fields fields(n, 11);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index f = 0; f < 11; ++f)
      fields(i, f) =
          f == 1 ? 7.25
                 : static_cast<double>(f + 1) * values[static_cast<std::size_t>(i)];
  interp::Fields with_gap = fields;
  with_gap(n / 2, 3) = std::numeric_limits<double>::quiet_NaN();
  const interp::Fields applied = op.apply_fields(fields),
                       on_one = op.apply_fields(fields, {}, {.num_threads = 1}),
                       propagated = op.apply_fields(with_gap),
                       shared = op.apply_fields(
                           with_gap, {.missing = interp::MissingRows::renormalise});
  EXPECT_TRUE((applied.array() == on_one.array() || applied.array().isNaN()).all());
  for (Eigen::Index i = 0; i < applied.rows(); ++i) {
    const double value = alone[static_cast<std::size_t>(i)];
    if (std::isnan(value)) {
      EXPECT_TRUE(std::isnan(applied(i, 0)) && std::isnan(shared(i, 3)));
      continue;
    }
    EXPECT_NEAR(applied(i, 0), value, 1e-13);
    EXPECT_EQ(applied(i, 1), 7.25);
    EXPECT_NEAR(applied(i, 10), 11 * value, 3e-12);
    EXPECT_TRUE(std::isnan(propagated(i, 3)));
    EXPECT_NEAR(propagated(i, 2), applied(i, 2), 1e-12);
  }
}

/// Variances are sums over the squares of the explicit rows.
inline void expect_variances_of_rows(const interp::FactoredOperator& op) {
  const std::vector<std::int64_t> targets{0, op.num_targets() - 1, op.num_targets() / 2};
  std::vector<double> variances;
  for (std::int64_t i = 0; i < op.num_rows(); ++i)
    variances.push_back(0.5 + static_cast<double>(i % 5));
  const std::vector<double> found = op.propagated_variance(targets, variances),
                            wanted = op.explicit_rows().propagated_variance(variances);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const double other = wanted[static_cast<std::size_t>(targets[i])];
    ASSERT_EQ(std::isnan(found[i]), std::isnan(other));
    if (!std::isnan(other)) {
      EXPECT_NEAR(found[i], other, 1e-12 * (1 + other));
    }
  }
}

/// What is left out changes no value by more than the tolerance times the range, and rows
/// still sum to one. Returns the part of the weights that is left.
inline double part_left_by(const interp::FactoredOperator& op, double tolerance) {
  const interp::Operator whole = op.explicit_rows(),
                         cut = op.explicit_rows({.tolerance = tolerance});
  expect_rows_sum_to_one(cut);
  for (const std::uint64_t seed : {11u, 12u, 13u}) {
    const std::vector<double> x =
        random_values(static_cast<std::size_t>(op.num_rows()), seed);
    const std::vector<double> a = whole.apply(x), b = cut.apply(x);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(std::isnan(a[i]), std::isnan(b[i]));
      if (!std::isnan(a[i])) {
        EXPECT_NEAR(a[i], b[i], 2 * tolerance);
      }
    }
  }
  return static_cast<double>(cut.matrix().nonZeros()) /
         static_cast<double>(whole.matrix().nonZeros());
}

}  // namespace delone::support
