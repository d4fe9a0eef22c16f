#include "interp/natural_operator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "delaunay/error.hpp"
#include "interp/operator_checks.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::expect_common_behaviour;
using support::expect_equal_values;
using support::expect_rows_sum_to_one;
using support::expect_transpose_is_adjoint;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

constexpr std::array kinds{NaturalKind::sibson, NaturalKind::laplace,
                           NaturalKind::sibson_c1};

NaturalOptions options(NaturalKind kind, Outside outside = Outside::missing) {
  NaturalOptions result;
  result.kind = kind;
  result.slope_limit = SlopeLimit::positions;
  result.outside = outside;
  return result;
}

class PlaneNaturalOperatorOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneNaturalOperatorOnSets, AppliedEqualsTheSurface) {
  const PlanePoints points = GetParam().make(80, 1);
  const auto t = triangulated(points);
  PlanePoints targets = support::points_of_the_hull(*t, 2);
  for (const tripack::Point2 p :
       plane_nodes(plane_grid(support::region_of(*t), NodeCounts{7, 8})))
    targets.push_back(p);
  const std::vector<double> values = random_values(points.size(), 3);
  for (const NaturalKind kind : kinds) {
    for (const Outside outside : {Outside::missing, Outside::nearest}) {
      const NaturalOptions with = options(kind, outside);
      const Operator op = natural_operator(t, targets, with);
      expect_rows_sum_to_one(op);
      expect_equal_values(op.apply(values),
                          PlaneNatural(t, values, with).values(targets));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneNaturalOperatorOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

class SphereNaturalOperatorOnSets : public testing::TestWithParam<support::SphereFamily> {
};

TEST_P(SphereNaturalOperatorOnSets, AppliedEqualsTheSurface) {
  const SpherePoints points = GetParam().make(80, 1);
  const auto t = triangulated(points);
  SpherePoints targets = globe_nodes(globe_grid({-180, 180, -90, 90}, Spacing{30, 30}));
  targets.insert(targets.end(), t->points().begin(), t->points().end());
  const std::vector<double> values = random_values(points.size(), 3);
  for (const NaturalKind kind : kinds) {
    for (const Outside outside : {Outside::missing, Outside::nearest}) {
      const NaturalOptions with = options(kind, outside);
      const Operator op = natural_operator(t, targets, with);
      expect_rows_sum_to_one(op);
      expect_equal_values(op.apply(values),
                          SphereNatural(t, values, with).values(targets));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereNaturalOperatorOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(NaturalOperator, HasWhatOperatorsHave) {
  const PlanePoints points = support::uniform_points(150, 1),
                    targets = support::uniform_points(300, 2);
  for (const NaturalKind kind : kinds) {
    const Operator op = natural_operator(triangulated(points), targets, options(kind));
    expect_common_behaviour(op, random_values(150, 3));
    expect_transpose_is_adjoint(op, random_values(150, 4), random_values(300, 5));
  }
}

TEST(NaturalOperator, OfTheSmoothSurfaceReproducesLinearFunctionsWhereNeighboursAreWell) {
  const PlanePoints points = support::uniform_points(600, 1);
  PlanePoints targets;
  for (const tripack::Point2 p : support::uniform_points(300, 2))
    targets.push_back({0.25 + 0.5 * p.x, 0.25 + 0.5 * p.y});
  const auto f = [](tripack::Point2 p) { return 3 + 2 * p.x - 5 * p.y; };
  const Operator op =
      natural_operator(triangulated(points), targets, options(NaturalKind::sibson_c1));
  const std::vector<double> applied = op.apply(support::sampled(points, f));
  for (std::size_t i = 0; i < targets.size(); ++i)
    EXPECT_NEAR(applied[i], f(targets[i]), 1e-12);
  EXPECT_LT(support::largest_magnitude(op), 16);
}

TEST(NaturalOperator, SlopesLimitedByPositionsAreThoseOfTheFitOnGoodSets) {
  const PlanePoints points = support::uniform_points(300, 1),
                    targets = support::uniform_points(300, 2);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(300, 3);
  NaturalOptions by_values = options(NaturalKind::sibson_c1);
  by_values.slope_limit = SlopeLimit::values;
  const auto a = PlaneNatural(t, values, by_values).values(targets),
             b = PlaneNatural(t, values, options(NaturalKind::sibson_c1)).values(targets);
  std::size_t num_same = 0, num_values = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i])) continue;
    ++num_values;
    if (std::abs(a[i] - b[i]) < 1e-12) ++num_same;
  }
  EXPECT_GT(num_same, num_values * 8 / 10);
}

TEST(NaturalOperator, RefusesWhatTheSurfaceRefuses) {
  const auto t = triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}, {0, 0}});
  const PlanePoints targets{{0.2, 0.2}};
  NaturalOptions with = options(NaturalKind::sibson, Outside::linear);
  EXPECT_THROW((void)natural_operator(t, targets, with), Error);
  with = options(NaturalKind::sibson);
  with.max_distance = -1;
  EXPECT_THROW((void)natural_operator(t, targets, with), Error);
  with = options(NaturalKind::sibson);
  with.duplicates = Duplicates::median;
  EXPECT_THROW((void)natural_operator(t, targets, with), Error);
}

TEST(NaturalOperator, SpreadsRepeatedRowsEvenly) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 0}};
  const PlanePoints targets{{0.3, 0.4}, {0, 0}, {5, 5}};
  const auto t = triangulated(points);
  for (const NaturalKind kind : kinds) {
    const Operator op = natural_operator(t, targets, options(kind));
    EXPECT_EQ(op.matrix().coeff(0, 0), op.matrix().coeff(0, 4));
    const std::vector<double> values{1, 2, 3, 5, 2};
    expect_equal_values(op.apply(values),
                        PlaneNatural(t, values, options(kind)).values(targets));
  }
}

}  // namespace
}  // namespace delone::interp
