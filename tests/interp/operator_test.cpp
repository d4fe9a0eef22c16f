#include "interp/operator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delaunay/error.hpp"
#include "interp/linear_surface.hpp"
#include "interp/operator_checks.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::expect_equal_values;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

void expect_rows_sum_to_one(const Operator& op) {
  for (int i = 0; i < op.matrix().rows(); ++i) {
    double sum = 0;
    int terms = 0;
    for (Operator::Matrix::InnerIterator term(op.matrix(), i); term; ++term, ++terms)
      sum += term.value();
    if (terms > 0) {
      EXPECT_NEAR(sum, 1, 1e-14);
    }
  }
}

class PlaneOperatorOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneOperatorOnSets, AppliedEqualsTheSurface) {
  const PlanePoints points = GetParam().make(300, 1);
  const auto t = triangulated(points);
  const PlanePoints targets =
      plane_nodes(plane_grid(support::region_of(*t), NodeCounts{30, 31}));
  for (const Outside outside : {Outside::missing, Outside::nearest}) {
    const Operator op = linear_operator(t, targets, {.outside = outside});
    expect_rows_sum_to_one(op);
    for (std::uint64_t seed = 2; seed < 4; ++seed) {
      const std::vector<double> values = random_values(points.size(), seed);
      expect_equal_values(op.apply(values),
                          PlaneLinear(t, values, {.outside = outside}).values(targets));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneOperatorOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

class SphereOperatorOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereOperatorOnSets, AppliedEqualsTheSurface) {
  const SpherePoints points = GetParam().make(300, 1);
  const auto t = triangulated(points);
  const SpherePoints targets =
      globe_nodes(globe_grid({-180, 180, -90, 90}, Spacing{10, 10}));
  for (const Outside outside : {Outside::missing, Outside::nearest}) {
    const Operator op = linear_operator(t, targets, {.outside = outside});
    expect_rows_sum_to_one(op);
    const std::vector<double> values = random_values(points.size(), 2);
    expect_equal_values(op.apply(values),
                        SphereLinear(t, values, {.outside = outside}).values(targets));
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereOperatorOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(LinearOperator, ContinuedLinearlyEqualsTheSurface) {
  const PlanePoints points = support::uniform_points(40, 1);
  const auto t = triangulated(points);
  const PlanePoints targets = plane_nodes(plane_grid({-1, 2, -1, 2}, NodeCounts{20, 20}));
  const SurfaceOptions options{.outside = Outside::linear, .max_distance = 0.8};
  const Operator op = linear_operator(t, targets, options);
  const std::vector<double> values = random_values(40, 2);
  const std::vector<double> applied = op.apply(values),
                            direct = PlaneLinear(t, values, options).values(targets);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    ASSERT_EQ(std::isnan(applied[i]), std::isnan(direct[i]));
    if (!std::isnan(direct[i])) {
      EXPECT_NEAR(applied[i], direct[i], 1e-11 * (1 + std::abs(direct[i])));
    }
  }
  EXPECT_GT(support::count_missing(direct), 0u);
}

TEST(LinearOperator, DistributesRepeatedRowsAsThePolicySays) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}, {0, 0}};
  const PlanePoints target{{0, 0}};
  const std::vector<double> values{1, 5, 6, 3};
  const auto apply = [&](Duplicates policy) {
    return linear_operator(triangulated(points), target, {.duplicates = policy})
        .apply(values)[0];
  };
  EXPECT_EQ(apply(Duplicates::mean), 2);
  EXPECT_EQ(apply(Duplicates::first), 1);
  EXPECT_EQ(apply(Duplicates::last), 3);
  for (const Duplicates policy :
       {Duplicates::median, Duplicates::min, Duplicates::max, Duplicates::error}) {
    EXPECT_THROW((void)apply(policy), Error);
  }
}

TEST(LinearOperator, TakesAnyPolicyIfNothingRepeats) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_NO_THROW((void)linear_operator(triangulated(points), points,
                                        {.duplicates = Duplicates::median}));
}

TEST(LinearOperator, RowsOfMissingTargetsAreEmpty) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}}, targets{{5, 5}, {0.25, 0.25}};
  const Operator op = linear_operator(triangulated(points), targets);
  EXPECT_EQ(op.matrix().nonZeros(), 3);
  EXPECT_EQ(op.matrix().rows(), 2);
  EXPECT_EQ(op.matrix().cols(), 3);
  const std::vector<double> applied = op.apply(std::vector<double>{1, 2, 3});
  EXPECT_TRUE(std::isnan(applied[0]));
  EXPECT_EQ(applied[1], 1.75);
}

TEST(LinearOperator, RefusesWrongNumbersOfValuesAndLinearContinuationOnTheSphere) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_THROW((void)linear_operator(triangulated(points), points)
                   .apply(std::vector<double>{1, 2}),
               Error);
  const SpherePoints directions{at_lonlat(0, 0)};
  EXPECT_THROW((void)linear_operator(triangulated(directions), directions,
                                     {.outside = Outside::linear}),
               Error);
}

}  // namespace
}  // namespace delone::interp
