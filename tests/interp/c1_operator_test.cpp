#include "interp/c1_operator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "delaunay/error.hpp"
#include "interp/c1_surface.hpp"
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

constexpr std::array degrees{FitDegree::cubic, FitDegree::quartic};

C1Options with_degree(FitDegree degree) {
  C1Options options;
  options.degree = degree;
  return options;
}

template <class Triangulation>
C1Options with_choices(const Triangulation& t, C1Options options) {
  options.choices = c1_choices(t, options);
  options.tension = {};
  return options;
}

class PlaneC1OperatorOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneC1OperatorOnSets, AppliedEqualsTheSurfaceWithTheSameChoices) {
  const PlanePoints points = GetParam().make(60, 1);
  const auto t = triangulated(points);
  PlanePoints targets = support::points_of_the_hull(*t, 2);
  for (const tripack::Point2 p :
       plane_nodes(plane_grid(support::region_of(*t), NodeCounts{6, 5})))
    targets.push_back(p);
  const std::vector<double> values = random_values(points.size(), 3);
  for (const FitDegree degree : degrees) {
    const C1Options options = with_choices(*t, with_degree(degree));
    const Operator op = c1_operator(t, targets, options);
    expect_rows_sum_to_one(op);
    EXPECT_LT(support::largest_magnitude(op), 24);
    expect_equal_values(op.apply(values), PlaneC1(t, values, options).values(targets));
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneC1OperatorOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

class SphereC1OperatorOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereC1OperatorOnSets, AppliedEqualsTheSurfaceWithTheSameChoices) {
  const SpherePoints points = GetParam().make(60, 1);
  const auto t = triangulated(points);
  SpherePoints targets = globe_nodes(globe_grid({-180, 180, -90, 90}, Spacing{30, 30}));
  targets.insert(targets.end(), t->points().begin(), t->points().end());
  const std::vector<double> values = random_values(points.size(), 3);
  for (const FitDegree degree : degrees) {
    const C1Options options = with_choices(*t, with_degree(degree));
    const Operator op = c1_operator(t, targets, options);
    expect_rows_sum_to_one(op);
    EXPECT_LT(support::largest_magnitude(op), 24);
    expect_equal_values(op.apply(values), SphereC1(t, values, options).values(targets));
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereC1OperatorOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(C1Operator, HasWhatOperatorsHave) {
  const PlanePoints points = support::uniform_points(200, 1),
                    targets = support::uniform_points(300, 2);
  const Operator op = c1_operator(triangulated(points), targets);
  expect_common_behaviour(op, random_values(200, 3));
  expect_transpose_is_adjoint(op, random_values(200, 4), random_values(300, 5));
}

TEST(C1Operator, ReproducesQuadraticFunctionsWhereNodesDetermineThem) {
  const PlanePoints points = support::uniform_points(800, 1);
  const auto t = triangulated(points);
  PlanePoints targets;
  for (const tripack::Point2 p : support::uniform_points(300, 2))
    targets.push_back({0.25 + 0.5 * p.x, 0.25 + 0.5 * p.y});
  const auto f = [](tripack::Point2 p) {
    return 1 + 2 * p.x - p.y + 3 * p.x * p.x - 4 * p.x * p.y + 2 * p.y * p.y;
  };
  for (const FitDegree degree : degrees) {
    const Operator op = c1_operator(t, targets, with_degree(degree));
    const std::vector<double> applied = op.apply(support::sampled(points, f));
    std::size_t num_exact = 0;
    for (std::size_t i = 0; i < targets.size(); ++i)
      if (std::abs(applied[i] - f(targets[i])) < 1e-11) ++num_exact;
    EXPECT_GT(num_exact, targets.size() * 95 / 100);
  }
}

TEST(C1Operator, ReproducesFirstDegreeHarmonicsOnTheSphere) {
  const SpherePoints points = support::uniform_directions(500, 1);
  const auto f = [](const stripack::Direction& p) {
    return 0.5 + p.x() - 2 * p.y() + 3 * p.z();
  };
  const SpherePoints targets = support::uniform_directions(300, 2);
  const std::vector<double> applied =
      c1_operator(triangulated(points), targets).apply(support::sampled(points, f));
  std::size_t num_exact = 0;
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (std::abs(applied[i] - f(targets[i])) < 1e-11) ++num_exact;
  EXPECT_GT(num_exact, targets.size() * 95 / 100);
}

double rms_error(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(C1Operator, IsAboutAsAccurateOnSmoothDataAsTheSurfaceThatAdapts) {
  const SpherePoints points = support::uniform_directions(700, 3),
                     targets = support::uniform_directions(600, 4);
  const auto t = triangulated(points);
  const auto f = [](const stripack::Direction& p) {
    return std::sin(3 * p.x()) * std::cos(2 * p.y()) + p.z() * p.z();
  };
  const std::vector<double> values = support::sampled(points, f),
                            exact = support::sampled(targets, f);
  const double adapted = rms_error(SphereC1(t, values).values(targets), exact);
  EXPECT_LT(rms_error(c1_operator(t, targets).apply(values), exact), 3 * adapted);
  C1Options options;
  options.choices = c1_choices(t, values, {});
  EXPECT_LT(rms_error(c1_operator(t, targets, options).apply(values), exact),
            1.5 * adapted);
}

TEST(C1Operator, WithTheChoicesOfAFieldIsTheSurfaceThatAdaptsToIt) {
  const PlanePoints points = support::uniform_points(300, 1),
                    targets = support::uniform_points(400, 2);
  const auto t = triangulated(points);
  const std::vector<double> values = support::sampled(
      points, [](tripack::Point2 p) { return std::sin(3 * p.x) * std::cos(2 * p.y); });
  C1Options options, adapting;
  adapting.gradients = Gradients::local;
  options.choices = c1_choices(t, values, adapting);
  const std::vector<double> direct = PlaneC1(t, values, options).values(targets),
                            adapted = PlaneC1(t, values, adapting).values(targets);
  expect_equal_values(c1_operator(t, targets, options).apply(values), direct);
  std::size_t num_same = 0, num_values = 0;
  for (std::size_t i = 0; i < direct.size(); ++i) {
    if (std::isnan(direct[i])) continue;
    ++num_values;
    if (std::abs(direct[i] - adapted[i]) < 1e-9) ++num_same;
  }
  EXPECT_GT(num_same, num_values * 8 / 10);
  // Another field: the same operator, still the surface with these choices.
  const std::vector<double> other = random_values(300, 5);
  expect_equal_values(c1_operator(t, targets, options).apply(other),
                      PlaneC1(t, other, options).values(targets));
}

TEST(C1Surface, WithChoicesIsSmoothAndPassesThroughTheValues) {
  const PlanePoints points = support::uniform_points(100, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(100, 2);
  const PlaneC1 surface(t, values, with_choices(*t, {}));
  EXPECT_EQ(support::first_difference(surface.values(points), values), 100u);
  const tripack::Point2 p{0.41, 0.52};
  const Derivatives2 d = surface.derivatives(p);
  constexpr double h = 1e-5;
  EXPECT_NEAR((surface.value({p.x + h, p.y}) - surface.value({p.x - h, p.y})) / (2 * h),
              d.x, 1e-5 * (1 + std::abs(d.x)));
  const Grid grid = plane_grid({0, 1, 0, 1}, NodeCounts{20, 20});
  EXPECT_EQ(support::first_difference(surface.grid(grid).values,
                                      surface.values(plane_nodes(grid))),
            400u);
}

TEST(C1Operator, ContinuedBeyondTheHullEqualsTheSurface) {
  const PlanePoints points = support::uniform_points(60, 1);
  const auto t = triangulated(points);
  const PlanePoints targets =
      plane_nodes(plane_grid({-0.3, 1.3, -0.3, 1.3}, NodeCounts{20, 20}));
  const std::vector<double> values = random_values(60, 2);
  for (const Outside outside : {Outside::nearest, Outside::linear}) {
    C1Options options;
    options.outside = outside;
    options.max_distance = 0.35;
    options = with_choices(*t, options);
    const std::vector<double> applied = c1_operator(t, targets, options).apply(values),
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

TEST(C1Operator, TensionBringsItNearerToTheLinearOne) {
  const PlanePoints points = support::uniform_points(200, 1),
                    targets = support::uniform_points(300, 2);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(200, 3),
                            linear = linear_operator(t, targets).apply(values);
  double before = 1e300;
  for (const double tension : {0.0, 0.5, 0.9}) {
    C1Options options;
    options.tension = tension;
    const std::vector<double> applied = c1_operator(t, targets, options).apply(values);
    double distance = 0;
    for (std::size_t i = 0; i < linear.size(); ++i)
      if (!std::isnan(linear[i])) distance += std::abs(applied[i] - linear[i]);
    EXPECT_LT(distance, before);
    before = distance;
  }
}

TEST(C1Operator, RefusesWhatIsNotLinearAndChoicesThatDoNotFit) {
  const auto t = triangulated(support::uniform_points(30, 1)),
             other = triangulated(support::uniform_points(31, 1));
  const PlanePoints targets{{0.5, 0.5}};
  const auto refuses = [&](const C1Options& options) {
    EXPECT_THROW((void)c1_operator(t, targets, options), Error);
  };
  C1Options options;
  options.bounds = Bounds::local;
  refuses(options);
  options = {};
  options.gradients = Gradients::global;
  refuses(options);
  options = {};
  options.tension = 2;
  refuses(options);
  options = {};
  options.choices = c1_choices(*other);
  refuses(options);
  EXPECT_THROW((void)PlaneC1(t, random_values(30, 1), options), Error);
  options.choices = c1_choices(*t);
  options.degree = FitDegree::quartic;
  refuses(options);
  options.degree = FitDegree::cubic;
  options.tension = 0.5;
  refuses(options);
  C1Choices bad = *c1_choices(*t);
  bad.nodes[7].parts[1] = 3;
  options = {};
  options.choices = std::make_shared<const C1Choices>(bad);
  refuses(options);
}

TEST(C1Operator, OfFewPointsIsTheLinearOne) {
  const PlanePoints targets{{0.25, 0.25}, {0, 0}, {3, 3}};
  for (const PlanePoints& points :
       {PlanePoints{}, PlanePoints{{0, 0}}, PlanePoints{{0, 0}, {0.5, 0.5}},
        PlanePoints{{0, 0}, {1, 0}, {0, 1}}}) {
    const auto t = triangulated(points);
    const std::vector<double> values = random_values(points.size(), 1);
    expect_equal_values(c1_operator(t, targets).apply(values),
                        linear_operator(t, targets).apply(values));
  }
}

}  // namespace
}  // namespace delone::interp
