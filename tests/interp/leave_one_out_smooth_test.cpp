// Leave-one-out errors of natural neighbours and of the C1 surface, against rebuilding.

#include "interp/leave_one_out_smooth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delaunay/error.hpp"
#include "interp/c1_surface.hpp"
#include "interp/leave_one_out_natural.hpp"
#include "interp/left_out_checks.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::expect_as_rebuilt;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

template <class Surface, class Points>
void expect_natural_as_rebuilt(const Points& points, const NaturalOptions& options,
                               double error) {
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  expect_as_rebuilt(
      *t, points, values, leave_out_natural(t, values, options), error,
      [&](auto others, const auto& v) { return Surface(others, v, options); });
}

template <class Surface, class Points>
void expect_c1_as_rebuilt(const Points& points, const C1Options& options, double error) {
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  expect_as_rebuilt(
      *t, points, values, leave_out_c1(t, values, options), error,
      [&](auto others, const auto& v) { return Surface(others, v, options); });
}

C1Options with_tension(double tension) {
  C1Options options;
  options.tension = tension;
  options.gradients = Gradients::local;
  return options;
}

class PlaneLeftOutOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneLeftOutOnSets, SibsonEqualsRebuilding) {
  expect_natural_as_rebuilt<PlaneNatural>(GetParam().make(50, 3), {}, 1e-11);
}
TEST_P(PlaneLeftOutOnSets, LaplaceEqualsRebuilding) {
  expect_natural_as_rebuilt<PlaneNatural>(GetParam().make(50, 3),
                                          {.kind = NaturalKind::laplace}, 1e-11);
}
TEST_P(PlaneLeftOutOnSets, SmoothNaturalEqualsRebuilding) {
  expect_natural_as_rebuilt<PlaneNatural>(GetParam().make(50, 3),
                                          {.kind = NaturalKind::sibson_c1}, 1e-6);
}
TEST_P(PlaneLeftOutOnSets, C1EqualsRebuilding) {
  expect_c1_as_rebuilt<PlaneC1>(GetParam().make(50, 3), with_tension(0), 1e-5);
}
TEST_P(PlaneLeftOutOnSets, ContinuedC1EqualsRebuilding) {
  C1Options options = with_tension(0.3);
  options.outside = Outside::linear;
  expect_c1_as_rebuilt<PlaneC1>(GetParam().make(50, 3), options, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneLeftOutOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

// Of families that need long exact arithmetic fewer.
std::size_t num_points(const support::SphereFamily& family) {
  const std::string name = family.name;
  return name == "tiny_components" || name == "ulps_apart" ? 10 : 50;
}

// Without those whose sites are apart by a few roundings or by lengths whose squares
// underflow: which gradients fit them best is decided by the order of the sums.
std::vector<support::SphereFamily> well_separated_families() {
  std::vector<support::SphereFamily> families;
  for (const support::SphereFamily& family : support::sphere_families()) {
    const std::string name = family.name;
    if (name != "ulps_apart" && name != "tiny_components") families.push_back(family);
  }
  return families;
}

class SphereLeftOutOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereLeftOutOnSets, SibsonEqualsRebuilding) {
  expect_natural_as_rebuilt<SphereNatural>(GetParam().make(num_points(GetParam()), 3), {},
                                           1e-10);
}
TEST_P(SphereLeftOutOnSets, LaplaceEqualsRebuilding) {
  expect_natural_as_rebuilt<SphereNatural>(GetParam().make(num_points(GetParam()), 3),
                                           {.kind = NaturalKind::laplace}, 1e-10);
}
INSTANTIATE_TEST_SUITE_P(Sphere, SphereLeftOutOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

class SphereGradientsLeftOutOnSets
    : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereGradientsLeftOutOnSets, SmoothNaturalEqualsRebuilding) {
  expect_natural_as_rebuilt<SphereNatural>(GetParam().make(num_points(GetParam()), 3),
                                           {.kind = NaturalKind::sibson_c1}, 1e-6);
}
TEST_P(SphereGradientsLeftOutOnSets, C1EqualsRebuilding) {
  expect_c1_as_rebuilt<SphereC1>(GetParam().make(num_points(GetParam()), 3),
                                 with_tension(0), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereGradientsLeftOutOnSets,
                         testing::ValuesIn(well_separated_families()),
                         [](const auto& set) { return std::string(set.param.name); });

SpherePoints regional_points(std::size_t n) {
  SpherePoints points;
  for (const tripack::Point2 p : support::uniform_points(n, 5))
    points.push_back(at_lonlat(40 * p.x, 40 * p.y));
  return points;
}

TEST(LeaveOneOutSmooth, FollowsTheOptionsForWhatIsOutside) {
  const PlanePoints points = support::uniform_points(60, 5);
  C1Options options = with_tension(0.5);
  for (const Outside outside : {Outside::missing, Outside::nearest, Outside::linear}) {
    for (const double distance : {0.08, 0.15}) {
      options.outside = outside;
      options.max_distance = distance;
      expect_c1_as_rebuilt<PlaneC1>(points, options, 1e-8);
      if (outside == Outside::linear) continue;
      expect_natural_as_rebuilt<PlaneNatural>(
          points, {.outside = outside, .max_distance = distance}, 1e-12);
    }
  }
}

TEST(LeaveOneOutSmooth, FollowsTheOptionsForWhatIsOutsideOnTheSphere) {
  const SpherePoints points = regional_points(60);
  C1Options options = with_tension(0.5);
  options.distance = GlobeDistance::geodesic_wgs84;
  for (const Outside outside : {Outside::missing, Outside::nearest}) {
    options.outside = outside;
    options.max_distance = 300;
    expect_c1_as_rebuilt<SphereC1>(points, options, 1e-8);
    expect_natural_as_rebuilt<SphereNatural>(
        points, {.outside = outside, .max_distance = 300}, 1e-12);
  }
}

TEST(LeaveOneOutSmooth, KeepsDegreeAndBounds) {
  C1Options options = with_tension(0.1);
  options.degree = FitDegree::quartic;
  expect_c1_as_rebuilt<PlaneC1>(support::uniform_points(200, 5), options, 1e-8);
  options.bounds = Bounds::local;
  expect_c1_as_rebuilt<SphereC1>(regional_points(200), options, 1e-8);
}

TEST(LeaveOneOutSmooth, TakesTheTensionThatTheWholeSurfaceChooses) {
  const PlanePoints points = support::uniform_points(300, 7);
  const auto t = triangulated(points);
  const auto values =
      support::sampled(points, [](tripack::Point2 p) { return std::sin(5 * p.x) * p.y; });
  const PlaneC1 surface(t, values);
  EXPECT_EQ(surface.fit().tension, 0);
  const LeaveOneOut found = leave_out_c1(t, values);
  double sum = 0;
  for (const double r : found.residual) sum += std::isnan(r) ? 0 : r * r;
  const double rms =
      std::sqrt(sum / static_cast<double>(points.size() -
                                          static_cast<std::size_t>(found.num_missing)));
  EXPECT_LT(rms, 0.004);
  EXPECT_NEAR(rms, surface.fit().left_out_rms, 0.2 * rms);
}

TEST(LeaveOneOutSmooth, TakesGlobalGradientsFromTheSurroundings) {
  const PlanePoints points = support::uniform_points(100, 7);
  const auto t = triangulated(points);
  const auto values = support::sampled(
      points, [](tripack::Point2 p) { return std::sin(9 * p.x) * std::cos(7 * p.y); });
  C1Options options = with_tension(0);
  options.gradients = Gradients::global;
  expect_as_rebuilt(
      *t, points, values, leave_out_c1(t, values, options), 1e-3,
      [&](auto others, const auto& v) { return PlaneC1(others, v, options); });
}

TEST(LeaveOneOutSmooth, OfQuadraticFunctionsIsNought) {
  const PlanePoints points = support::uniform_points(500, 9);
  const auto values = support::sampled(
      points, [](tripack::Point2 p) { return 2 * p.x * p.x - 3 * p.x * p.y + p.y; });
  C1Options options = with_tension(0);
  options.outside = Outside::nearest;
  const LeaveOneOut found = leave_out_c1(triangulated(points), values, options);
  EXPECT_EQ(found.num_missing, 0);
  std::size_t num_exact = 0;
  for (const double r : found.residual) num_exact += std::abs(r) < 1e-7 ? 1 : 0;
  EXPECT_GT(num_exact, 440U);
}

TEST(LeaveOneOutSmooth, OfAHubAmongManyOnACircleEqualsRebuilding) {
  const PlanePoints points = support::wheel_points(300);
  expect_natural_as_rebuilt<PlaneNatural>(points, {.kind = NaturalKind::sibson_c1}, 1e-6);
  C1Options options = with_tension(0);
  options.outside = Outside::linear;
  const auto t = triangulated(points);
  EXPECT_EQ(leave_out_c1(t, random_values(points.size(), 2), options).num_missing, 0);
}

TEST(LeaveOneOutSmooth, DoesNotDependOnThreads) {
  const PlanePoints points = support::uniform_points(1100, 10);
  const std::vector<double> values = random_values(1100, 11);
  const auto t = triangulated(points);
  const RunOptions one{.num_threads = 1, .progress = {}},
      three{.num_threads = 3, .progress = {}};
  const C1Options options = with_tension(0.2);
  EXPECT_EQ(support::first_difference(leave_out_c1(t, values, options, one).predicted,
                                      leave_out_c1(t, values, options, three).predicted),
            points.size());
  EXPECT_EQ(support::first_difference(leave_out_natural(t, values, {}, one).predicted,
                                      leave_out_natural(t, values, {}, three).predicted),
            points.size());
}

TEST(LeaveOneOutSmooth, OfFewOrCollinearPointsIsThatOfTheLinearSurface) {
  for (const PlanePoints& points :
       {PlanePoints{}, PlanePoints{{1, 2}}, PlanePoints{{1, 2}, {3, 4}},
        PlanePoints{{0, 0}, {1, 1}, {3, 3}}, PlanePoints{{0, 0}, {1, 0}, {0, 1}}}) {
    const auto t = triangulated(points);
    const std::vector<double> values = random_values(points.size(), 1);
    const LeaveOneOut linear = leave_out_linear(t, values);
    EXPECT_EQ(
        support::first_difference(leave_out_c1(t, values).predicted, linear.predicted),
        points.size());
    EXPECT_EQ(support::first_difference(leave_out_natural(t, values).predicted,
                                        linear.predicted),
              points.size());
  }
}

TEST(LeaveOneOutSmooth, RemovesRepeatedRowsTogether) {
  const PlanePoints points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 1}};
  const std::vector<double> values{1, 1, 1, 1, 5, 7};
  const LeaveOneOut natural = leave_out_natural(triangulated(points), values);
  EXPECT_EQ(natural.residual[4], -4);
  EXPECT_EQ(natural.residual[5], -6);
  EXPECT_EQ(leave_out_c1(triangulated(points), values).residual[5], -6);
}

TEST(LeaveOneOutSmooth, RefusesWhatTheSurfacesRefuse) {
  const auto t = triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}});
  const std::vector<double> values{1, 2, 3}, few{1, 2}, bad{1, 2, NAN};
  EXPECT_THROW((void)leave_out_natural(t, few), Error);
  EXPECT_THROW((void)leave_out_natural(t, bad), Error);
  EXPECT_THROW((void)leave_out_natural(t, values, {.outside = Outside::linear}), Error);
  EXPECT_THROW((void)leave_out_natural(t, values, {.max_distance = -1}), Error);
  EXPECT_THROW((void)leave_out_c1(t, few), Error);
  EXPECT_THROW((void)leave_out_c1(t, bad), Error);
  EXPECT_THROW((void)leave_out_c1(t, values, with_tension(2)), Error);
}

}  // namespace
}  // namespace delone::interp
