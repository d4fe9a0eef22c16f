#include "interp/global_operator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "delaunay/error.hpp"
#include "interp/c1_operator.hpp"
#include "interp/c1_surface.hpp"
#include "interp/factored_checks.hpp"

namespace delone::interp {
namespace {

using support::expect_equal_values;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

template <class Triangulation>
C1Options global_choices(const Triangulation& t, FitDegree degree = FitDegree::cubic) {
  C1Options options;
  options.degree = degree;
  options.gradients = Gradients::global;
  options.choices = c1_choices(t, options);
  return options;
}

PlanePoints targets_of(const tripack::Triangulation& t) {
  PlanePoints targets = support::points_of_the_hull(t, 2);
  for (const tripack::Point2 p :
       plane_nodes(plane_grid(support::region_of(t), NodeCounts{6, 5})))
    targets.push_back(p);
  return targets;
}

class PlaneGlobalOperatorOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneGlobalOperatorOnSets, AppliedEqualsTheSurfaceWithTheSameChoices) {
  const PlanePoints points = GetParam().make(60, 1);
  const auto t = triangulated(points);
  const PlanePoints targets = targets_of(*t);
  const std::vector<double> values = random_values(points.size(), 3);
  for (const FitDegree degree : {FitDegree::cubic, FitDegree::quartic}) {
    const C1Options options = global_choices(*t, degree);
    const FactoredOperator op = global_operator(t, targets, options);
    expect_equal_values(op.apply(values), PlaneC1(t, values, options).values(targets));
    support::expect_rows_agree(op, 5, 2e-13);
    support::expect_transpose_is_adjoint(op, 7);
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneGlobalOperatorOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

class SphereGlobalOperatorOnSets : public testing::TestWithParam<support::SphereFamily> {
};

TEST_P(SphereGlobalOperatorOnSets, AppliedEqualsTheSurfaceWithTheSameChoices) {
  const SpherePoints points = GetParam().make(60, 1);
  const auto t = triangulated(points);
  SpherePoints targets = globe_nodes(globe_grid({-180, 180, -90, 90}, Spacing{30, 30}));
  targets.insert(targets.end(), t->points().begin(), t->points().end());
  const std::vector<double> values = random_values(points.size(), 3);
  const C1Options options = global_choices(*t);
  const FactoredOperator op = global_operator(t, targets, options);
  expect_equal_values(op.apply(values), SphereC1(t, values, options).values(targets));
  support::expect_rows_agree(op, 5, 2e-13);
  support::expect_transpose_is_adjoint(op, 7);
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereGlobalOperatorOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(GlobalOperator, HasWhatFactoredOperatorsHave) {
  const auto t = triangulated(support::uniform_points(200, 1));
  const FactoredOperator op = global_operator(t, support::uniform_points(150, 2));
  support::expect_common_behaviour(op);
  support::expect_variances_of_rows(op);
}

TEST(GlobalOperator, RowsReachAsFarAsTheIterationAndFallOff) {
  const auto t = triangulated(support::uniform_points(2000, 1));
  const PlanePoints targets{{0.5, 0.5}, {0.21, 0.77}};
  const FactoredOperator op = global_operator(t, targets);
  support::expect_rows_agree(op, 3, 2e-13);
  const double left = support::part_left_by(op, 1e-6);
  EXPECT_LT(left, 0.2);
  EXPECT_GT(left, 0.01);
}

TEST(GlobalOperator, NoValueIsChangedByMoreThanTheTolerance) {
  const auto t = triangulated(support::uniform_points(300, 1));
  const FactoredOperator op = global_operator(t, support::uniform_points(60, 2));
  double before = 1;
  for (const double tolerance : {1e-9, 1e-6, 1e-3}) {
    const double left = support::part_left_by(op, tolerance);
    EXPECT_LT(left, before);
    before = left;
  }
}

TEST(GlobalOperator, IsAboutAsAccurateAsTheSurfaceThatAdapts) {
  const auto t = triangulated(support::uniform_points(200, 3));
  PlanePoints targets;
  for (const tripack::Point2 p : support::uniform_points(400, 4))
    targets.push_back({0.15 + 0.7 * p.x, 0.15 + 0.7 * p.y});
  const auto f = [](tripack::Point2 p) { return std::sin(5 * p.x) * std::cos(4 * p.y); };
  const std::vector<double> values = support::sampled(support::uniform_points(200, 3), f),
                            exact = support::sampled(targets, f);
  C1Options adapting;
  adapting.gradients = Gradients::global;
  const std::vector<double> adapted = PlaneC1(t, values, adapting).values(targets),
                            applied = global_operator(t, targets).apply(values);
  double error = 0, adapted_error = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    error += (applied[i] - exact[i]) * (applied[i] - exact[i]);
    adapted_error += (adapted[i] - exact[i]) * (adapted[i] - exact[i]);
  }
  EXPECT_LT(error, 4 * adapted_error);
}

TEST(GlobalOperator, SpreadsRepeatedRowsAndMissingRowsAreRemovedExactly) {
  PlanePoints points = support::uniform_points(80, 1);
  points.push_back(points[7]);
  std::vector<double> values = random_values(points.size(), 2);
  const auto t = triangulated(points);
  const PlanePoints targets = support::uniform_points(40, 3);
  const C1Options options = global_choices(*t);
  const FactoredOperator op = global_operator(t, targets, options);
  expect_equal_values(op.apply(values), PlaneC1(t, values, options).values(targets));

  // Row 3 is missing: an operator over the others, for whole fields.
  PlanePoints others = points;
  others.erase(others.begin() + 3);
  std::vector<double> other_values = values;
  other_values.erase(other_values.begin() + 3);
  std::vector<delaunay::Node> rows;
  for (delaunay::Node row = 0; row < 81; ++row)
    if (row != 3) rows.push_back(row);
  const FactoredOperator without = global_operator(triangulated(others), targets);
  values[3] = std::numeric_limits<double>::quiet_NaN();
  expect_equal_values(without.spread_to_rows(rows, 81).apply(values),
                      without.apply(other_values));
}

TEST(GlobalOperator, ContinuedBeyondTheHullEqualsTheSurface) {
  const auto t = triangulated(support::uniform_points(60, 1));
  const PlanePoints targets =
      plane_nodes(plane_grid({-0.3, 1.3, -0.3, 1.3}, NodeCounts{12, 12}));
  const std::vector<double> values = random_values(60, 2);
  for (const Outside outside : {Outside::nearest, Outside::linear}) {
    C1Options options = global_choices(*t);
    options.outside = outside;
    options.max_distance = 0.35;
    const std::vector<double> applied =
                                  global_operator(t, targets, options).apply(values),
                              direct = PlaneC1(t, values, options).values(targets);
    EXPECT_GT(support::count_missing(direct), 0u);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      ASSERT_EQ(std::isnan(applied[i]), std::isnan(direct[i])) << i;
      if (!std::isnan(direct[i])) {
        EXPECT_NEAR(applied[i], direct[i], 1e-12 * (1 + std::abs(direct[i])));
      }
    }
  }
}

TEST(GlobalOperator, RefusesWhatItCannotBe) {
  const auto t = triangulated(support::uniform_points(30, 1));
  const PlanePoints targets{{0.5, 0.5}};
  const auto refuses = [&](const C1Options& options) {
    EXPECT_THROW((void)global_operator(t, targets, options), Error);
  };
  C1Options options;
  options.gradients = Gradients::local;
  refuses(options);
  options = {};
  options.choices = c1_choices(*t);  // for local ones
  refuses(options);
  options = {};
  options.bounds = Bounds::local;
  refuses(options);
  options = {};
  options.duplicates = Duplicates::median;
  EXPECT_NO_THROW((void)global_operator(t, targets, options));
  PlanePoints repeated = support::uniform_points(30, 1);
  repeated.push_back(repeated[0]);
  EXPECT_THROW((void)global_operator(triangulated(repeated), targets, options), Error);

  const C1Options global = global_choices(*t);
  EXPECT_THROW((void)c1_operator(t, targets, global), Error);
  const FactoredOperator op = global_operator(t, targets);
  EXPECT_THROW((void)op.apply(random_values(29, 1)), Error);
  EXPECT_THROW((void)op.apply_transposed(random_values(2, 1)), Error);
  EXPECT_THROW((void)op.explicit_rows(std::vector<std::int64_t>{1}), Error);
  EXPECT_THROW((void)op.explicit_rows({.tolerance = 0.5}), Error);
  EXPECT_THROW((void)op.explicit_rows({.tolerance = -1}), Error);
  EXPECT_THROW((void)op.apply(random_values(30, 1), {.least_share = 0}), Error);
}

TEST(C1Surface, WithGivenGradientsTakesChoicesForKnownOnesOnly) {
  const auto t = triangulated(support::uniform_points(60, 1));
  const std::vector<double> values = random_values(60, 2);
  std::vector<Gradient2> gradients;
  for (const tripack::Point2 p : support::uniform_points(60, 1))
    gradients.push_back({p.x, -p.y});
  C1Options local;
  local.choices = c1_choices(*t);
  EXPECT_THROW((void)PlaneC1(t, values, gradients, local), Error);
  const PlaneC1 surface(t, values, gradients, global_choices(*t));
  EXPECT_EQ(surface.fit().gradients, Gradients::given);
  const tripack::Point2 p = support::uniform_points(60, 1)[17];
  EXPECT_NEAR(surface.gradient(p).x, gradients[17].x, 1e-12);
  EXPECT_NEAR(surface.gradient(p).y, gradients[17].y, 1e-12);
}

TEST(GlobalOperator, OfFewPointsIsTheLinearOne) {
  const PlanePoints targets{{0.25, 0.25}, {0, 0}, {3, 3}};
  for (const PlanePoints& points :
       {PlanePoints{}, PlanePoints{{0, 0}}, PlanePoints{{0, 0}, {0.5, 0.5}}}) {
    const auto t = triangulated(points);
    const std::vector<double> values = random_values(points.size(), 1);
    const FactoredOperator op = global_operator(t, targets);
    expect_equal_values(op.apply(values), linear_operator(t, targets).apply(values));
    expect_equal_values(op.explicit_rows().apply(values), op.apply(values));
    EXPECT_EQ(op.apply_transposed(random_values(3, 1)).size(), points.size());
  }
}

}  // namespace
}  // namespace delone::interp
