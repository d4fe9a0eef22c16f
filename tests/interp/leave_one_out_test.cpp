#include "interp/leave_one_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "delaunay/error.hpp"
#include "interp/index.hpp"
#include "interp/left_out_checks.hpp"
#include "interp/linear_surface.hpp"
#include "interp/nearest_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using delaunay::Site;
using support::at_lonlat;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;
using support::without;

// The judge: the surface over a triangulation built without the position.
template <class Surface, class Triangulation, class Points>
std::vector<double> rebuilt_predictions(const Triangulation& t, const Points& points,
                                        std::span<const double> values,
                                        const SurfaceOptions& options) {
  std::vector<double> by_site;
  for (Site s = 0; s < t.num_sites(); ++s) {
    const auto rest = without(t, points, values, s);
    by_site.push_back(
        Surface(triangulated(rest.first), rest.second, options).value(t.points()[at(s)]));
  }
  std::vector<double> by_row;
  for (const Site s : t.sites()) by_row.push_back(by_site[at(s)]);
  return by_row;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& wanted,
                 double error) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(std::isnan(found[i]), std::isnan(wanted[i])) << "row " << i;
    if (std::isnan(wanted[i])) continue;
    ASSERT_NEAR(found[i], wanted[i], error * (1 + std::abs(wanted[i]))) << "row " << i;
  }
}

class PlaneLeaveOneOutOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneLeaveOneOutOnSets, LinearEqualsRebuildingWithoutThePosition) {
  const PlanePoints points = support::affordable(GetParam(), 120, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  const LeaveOneOut left_out = leave_out_linear(t, values);
  expect_near(left_out.predicted,
              rebuilt_predictions<PlaneLinear>(*t, points, values, {}), 2e-13);
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneLeaveOneOutOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

class SphereLeaveOneOutOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereLeaveOneOutOnSets, LinearEqualsRebuildingWithoutThePosition) {
  const SpherePoints points = support::affordable(GetParam(), 120, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  const LeaveOneOut left_out = leave_out_linear(t, values);
  expect_near(left_out.predicted,
              rebuilt_predictions<SphereLinear>(*t, points, values, {}), 2e-13);
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereLeaveOneOutOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(LeaveOneOut, FollowsTheOptionsForWhatIsOutsideInThePlane) {
  const PlanePoints points = support::uniform_points(60, 5);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(60, 6);
  for (const SurfaceOptions& options :
       {SurfaceOptions{.outside = Outside::nearest},
        SurfaceOptions{.outside = Outside::linear}, SurfaceOptions{.max_distance = 0.1},
        SurfaceOptions{.outside = Outside::linear, .max_distance = 0.15}}) {
    expect_near(leave_out_linear(t, values, options).predicted,
                rebuilt_predictions<PlaneLinear>(*t, points, values, options), 1e-11);
  }
}

TEST(LeaveOneOut, FollowsTheOptionsForWhatIsOutsideOnTheSphere) {
  SpherePoints points;
  for (const tripack::Point2 p : support::uniform_points(60, 5))
    points.push_back(at_lonlat(40 * p.x, 40 * p.y));
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(60, 6);
  for (const SurfaceOptions& options :
       {SurfaceOptions{.outside = Outside::nearest},
        SurfaceOptions{.outside = Outside::nearest, .max_distance = 300},
        SurfaceOptions{.max_distance = 300, .distance = GlobeDistance::geodesic_wgs84}}) {
    expect_near(leave_out_linear(t, values, options).predicted,
                rebuilt_predictions<SphereLinear>(*t, points, values, options), 1e-12);
  }
}

TEST(LeaveOneOut, NearestEqualsRebuildingWithoutThePosition) {
  const PlanePoints points = support::uniform_points(80, 7);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(80, 8);
  for (const SurfaceOptions& options :
       {SurfaceOptions{}, SurfaceOptions{.outside = Outside::nearest},
        SurfaceOptions{.outside = Outside::nearest, .max_distance = 0.08}}) {
    EXPECT_EQ(support::first_difference(
                  leave_out_nearest(t, values, options).predicted,
                  rebuilt_predictions<PlaneNearest>(*t, points, values, options)),
              points.size());
  }
}

TEST(LeaveOneOut, NearestOnTheSphereFindsSitesFartherThanARightAngle) {
  const SpherePoints points{at_lonlat(0, 10), at_lonlat(120, 10), at_lonlat(240, 10),
                            at_lonlat(0, -80)};
  const auto t = triangulated(points);
  const std::vector<double> values{1, 2, 3, 4};
  const SurfaceOptions options{.outside = Outside::nearest};
  EXPECT_EQ(leave_out_nearest(t, values, options).predicted,
            (rebuilt_predictions<SphereNearest>(*t, points, values, options)));
}

TEST(LeaveOneOut, RemovesRepeatedRowsTogether) {
  const PlanePoints points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 1}};
  const LeaveOneOut left_out =
      leave_out_linear(triangulated(points), std::vector<double>{1, 1, 1, 1, 5, 7});
  EXPECT_EQ(left_out.predicted[4], 1);
  EXPECT_EQ(left_out.residual[4], -4);
  EXPECT_EQ(left_out.residual[5], -6);
  EXPECT_EQ(left_out.num_missing, 4);
}

TEST(LeaveOneOut, InterpolatesAlongAStraightBoundary) {
  const PlanePoints points{{0, 0}, {1, 0}, {3, 0}, {0, 3}};
  const LeaveOneOut left_out =
      leave_out_linear(triangulated(points), std::vector<double>{0, 5, 3, 9});
  EXPECT_NEAR(left_out.predicted[1], 1, 1e-15);
  EXPECT_EQ(left_out.num_missing, 3);
}

TEST(LeaveOneOut, IsMissingWhereTheOthersLieInAHemisphere) {
  const SpherePoints points{at_lonlat(0, 0),   at_lonlat(90, 0), at_lonlat(180, 0),
                            at_lonlat(270, 0), at_lonlat(0, 90), at_lonlat(0, -90)};
  EXPECT_EQ(leave_out_linear(triangulated(points), random_values(6, 1)).num_missing, 6);
}

TEST(LeaveOneOut, OfAHubAmongThousandsOnACircleEqualsRebuilding) {
  PlanePoints points{{0.1, 0.2}};
  for (int i = 0; i < 3000; ++i)
    points.push_back({std::cos(i * 0.002), std::sin(i * 0.002)});
  points.push_back({-0.5, -1});
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const auto rest = without(*t, points, values, t->sites()[0]);
  const double wanted =
      PlaneLinear(triangulated(rest.first), rest.second).value(points[0]);
  EXPECT_NEAR(leave_out_linear(t, values).predicted[0], wanted, 1e-13);
}

TEST(LeaveOneOut, ReproducesLinearFunctions) {
  const PlanePoints points = support::uniform_points(2000, 9);
  const auto values =
      support::sampled(points, [](tripack::Point2 p) { return 2 * p.x - 3 * p.y; });
  const LeaveOneOut left_out = leave_out_linear(triangulated(points), values);
  for (const double r : left_out.residual) {
    if (!std::isnan(r)) {
      EXPECT_NEAR(r, 0, 1e-14);
    }
  }
  EXPECT_LT(left_out.num_missing, 100);
}

TEST(LeaveOneOut, DoesNotDependOnThreadsOrTheOrderOfRows) {
  const PlanePoints points = support::uniform_points(5000, 10);
  const std::vector<double> values = random_values(5000, 11);
  const LeaveOneOut one = leave_out_linear(triangulated(points), values, {},
                                           {.num_threads = 1, .progress = {}});
  const LeaveOneOut four = leave_out_linear(triangulated(points), values, {},
                                            {.num_threads = 4, .progress = {}});
  EXPECT_EQ(support::first_difference(one.predicted, four.predicted), points.size());
  const PlanePoints turned(points.rbegin(), points.rend());
  const LeaveOneOut back = leave_out_linear(
      triangulated(turned), std::vector<double>(values.rbegin(), values.rend()));
  EXPECT_EQ(support::first_difference(
                one.predicted,
                std::vector<double>(back.predicted.rbegin(), back.predicted.rend())),
            points.size());
}

TEST(LeaveOneOut, OfFewPointsIsMissing) {
  EXPECT_EQ(leave_out_linear(triangulated(PlanePoints{}), {}).num_missing, 0);
  EXPECT_EQ(leave_out_linear(triangulated(PlanePoints{{1, 2}}), std::vector<double>{3})
                .num_missing,
            1);
  EXPECT_EQ(leave_out_linear(triangulated(PlanePoints{{1, 2}, {3, 4}}),
                             std::vector<double>{3, 4})
                .num_missing,
            2);
}

TEST(LeaveOneOut, RefusesWhatTheSurfacesRefuse) {
  const auto t = triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}});
  EXPECT_THROW((void)leave_out_linear(t, std::vector<double>{1, 2}), Error);
  EXPECT_THROW((void)leave_out_linear(t, std::vector<double>{1, 2, NAN}), Error);
  EXPECT_THROW(
      (void)leave_out_linear(t, std::vector<double>{1, 2, 3}, {.max_distance = -1}),
      Error);
  EXPECT_THROW((void)leave_out_nearest(t, std::vector<double>{1, 2, 3},
                                       {.outside = Outside::linear}),
               Error);
}

}  // namespace
}  // namespace delone::interp
