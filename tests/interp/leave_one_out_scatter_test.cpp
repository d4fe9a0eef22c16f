// Leave-one-out errors of the meshless methods, against rebuilding.

#include "interp/leave_one_out_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delaunay/error.hpp"
#include "interp/error_report.hpp"
#include "interp/left_out_checks.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::expect_as_rebuilt;
using support::first_difference;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

// The three methods under one name each, on plane and sphere.
struct InverseDistance {
  InverseDistanceOptions method;
  auto left_out(const auto& t, const auto& v, const SurfaceOptions& o = {},
                const RunOptions& run = {}) const {
    return leave_out_inverse_distance(t, v, method, o, run);
  }
  auto surface(const std::shared_ptr<const tripack::Triangulation>& t, const auto& v,
               const SurfaceOptions& o = {}) const {
    return PlaneInverseDistance(t, v, method, o);
  }
  auto surface(const std::shared_ptr<const stripack::Triangulation>& t, const auto& v,
               const SurfaceOptions& o = {}) const {
    return SphereInverseDistance(t, v, method, o);
  }
};
struct Shepard {
  ShepardOptions method;
  auto left_out(const auto& t, const auto& v, const SurfaceOptions& o = {},
                const RunOptions& run = {}) const {
    return leave_out_shepard(t, v, method, o, run);
  }
  auto surface(const std::shared_ptr<const tripack::Triangulation>& t, const auto& v,
               const SurfaceOptions& o = {}) const {
    return PlaneShepard(t, v, method, o);
  }
  auto surface(const std::shared_ptr<const stripack::Triangulation>& t, const auto& v,
               const SurfaceOptions& o = {}) const {
    return SphereShepard(t, v, method, o);
  }
};
struct Radial {
  RadialOptions method;
  auto left_out(const auto& t, const auto& v, const SurfaceOptions& o = {},
                const RunOptions& run = {}) const {
    return leave_out_radial(t, v, method, o, run);
  }
  auto surface(const std::shared_ptr<const tripack::Triangulation>& t, const auto& v,
               const SurfaceOptions& o = {}) const {
    return PlaneRadial(t, v, method, o);
  }
  auto surface(const std::shared_ptr<const stripack::Triangulation>& t, const auto& v,
               const SurfaceOptions& o = {}) const {
    return SphereRadial(t, v, method, o);
  }
};

template <class Method, class Points>
void expect_rebuilt(const Method& method, const Points& points, double error,
                    const SurfaceOptions& options = {}) {
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  expect_as_rebuilt(
      *t, points, values, method.left_out(t, values, options), error,
      [&](auto others, const auto& v) { return method.surface(others, v, options); });
}

// A prediction does not know the datum that it is compared with.
template <class Method, class Points>
void expect_blind(const Method& method, const Points& points) {
  const auto t = triangulated(points);
  std::vector<double> values = random_values(points.size(), 4);
  const LeaveOneOut before = method.left_out(t, values);
  for (const std::size_t row : {points.size() / 2}) {
    std::vector<double> changed = values;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (t->sites()[i] == t->sites()[row]) changed[i] += 0.25;
    const double found = method.left_out(t, changed).predicted[row];
    ASSERT_EQ(std::isnan(found), std::isnan(before.predicted[row]));
    if (!std::isnan(found)) {
      ASSERT_EQ(found, before.predicted[row]) << row;
    }
  }
}

SpherePoints regional_points(std::size_t n) {
  SpherePoints points;
  for (const tripack::Point2 p : support::uniform_points(n, 5))
    points.push_back(at_lonlat(40 * p.x, 40 * p.y));
  return points;
}

class PlaneNodesLeftOut : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneNodesLeftOut, InverseDistancesEqualRebuilding) {
  expect_rebuilt(InverseDistance{}, GetParam().make(60, 3), 1e-13);
}
TEST_P(PlaneNodesLeftOut, ShepardEqualsRebuilding) {
  expect_rebuilt(Shepard{}, GetParam().make(40, 3), 1e-13);
}
TEST_P(PlaneNodesLeftOut, OneSplineEqualsRebuilding) {
  expect_rebuilt(Radial{}, GetParam().make(40, 3), 1e-13);
}
TEST_P(PlaneNodesLeftOut, ShepardDoesNotKnowTheDatum) {
  expect_blind(Shepard{{.degree = ShepardDegree::quadratic}}, GetParam().make(68, 3));
}
TEST_P(PlaneNodesLeftOut, LocalSplinesDoNotKnowTheDatum) {
  expect_blind(Radial{{.most_at_once = 30, .neighbors = 12}}, GetParam().make(68, 3));
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneNodesLeftOut,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

// Of families that need long exact arithmetic fewer.
std::size_t num_points(const support::SphereFamily& family) {
  const std::string name = family.name;
  return name == "tiny_components" || name == "ulps_apart" ? 10 : 60;
}

class SphereNodesLeftOut : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereNodesLeftOut, InverseDistancesEqualRebuilding) {
  expect_rebuilt(InverseDistance{}, GetParam().make(num_points(GetParam()), 3), 1e-13);
}
TEST_P(SphereNodesLeftOut, LocalSplinesDoNotKnowTheDatum) {
  if (num_points(GetParam()) < 60) GTEST_SKIP() << "too few for local splines";
  expect_blind(Radial{{.most_at_once = 30, .neighbors = 12}}, GetParam().make(68, 3));
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereNodesLeftOut,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(NodesLeftOut, ShepardOverManyNodesEqualsRebuilding) {
  expect_rebuilt(Shepard{}, support::uniform_points(120, 5), 1e-11);
  expect_rebuilt(Shepard{{.degree = ShepardDegree::quadratic}},
                 support::rotated_lattice_points(100, 17), 1e-11);
  expect_rebuilt(Shepard{}, support::uniform_directions(100, 5), 1e-11);
}

TEST(NodesLeftOut, ShepardFitsWhatIsLeftWhenAsManyAreAsFar) {
  expect_rebuilt(Shepard{}, support::lattice_points(100), 1e-11);
}

TEST(NodesLeftOut, OneSplineThroughManyNodesEqualsRebuilding) {
  expect_rebuilt(Radial{}, support::uniform_points(70, 5), 1e-10);
  expect_rebuilt(Radial{{.kernel = RadialKernel::cubic}}, support::uniform_points(70, 6),
                 1e-10);
  expect_rebuilt(Radial{}, support::uniform_directions(70, 5), 1e-10);
}

TEST(NodesLeftOut, SplinesThatAreHeldBackEqualRebuilding) {
  PlanePoints points = support::uniform_points(70, 5);
  for (std::size_t i = 0; i < 20; ++i)
    points.push_back({points[i].x + 1e-9, points[i].y});
  expect_rebuilt(Radial{}, points, 0.03);
}

TEST(NodesLeftOut, LocalSplinesPredictAsWellAsRebuiltOnes) {
  const PlanePoints points = support::uniform_points(200, 5);
  const auto t = triangulated(points);
  const auto values = support::sampled(
      points, [](tripack::Point2 p) { return std::sin(4 * p.x) * std::cos(3 * p.y); });
  const Radial method{{.most_at_once = 100, .neighbors = 30}};
  const LeaveOneOut found = method.left_out(t, values);
  EXPECT_LT(error_report(found.residual).rms, 0.01);
  expect_as_rebuilt(*t, points, values, found, 0.005, [&](auto others, const auto& v) {
    return method.surface(others, v);
  });
}

TEST(NodesLeftOut, OfLinearFunctionsAreNought) {
  const PlanePoints points = support::uniform_points(130, 5);
  const auto t = triangulated(points);
  const auto values =
      support::sampled(points, [](tripack::Point2 p) { return 3 * p.x - 2 * p.y; });
  const auto largest = [](const LeaveOneOut& l) {
    return error_report(l.residual).largest;
  };
  EXPECT_LT(largest(Shepard{}.left_out(t, values)), 1e-9);
  EXPECT_LT(largest(Radial{{.most_at_once = 100}}.left_out(t, values)), 1e-9);
}

TEST(NodesLeftOut, FollowTheOptionsForWhatIsOutside) {
  const PlanePoints points = support::uniform_points(66, 5);
  for (const Outside outside : {Outside::missing, Outside::nearest, Outside::linear}) {
    for (const double distance : {0.1}) {
      const SurfaceOptions options{.outside = outside, .max_distance = distance};
      expect_rebuilt(InverseDistance{}, points, 1e-13, options);
      expect_rebuilt(Shepard{}, points, 1e-10, options);
      expect_rebuilt(Radial{}, points, 1e-10, options);
    }
  }
}

TEST(NodesLeftOut, FollowTheOptionsForWhatIsOutsideOnTheSphere) {
  for (const Outside outside : {Outside::missing, Outside::nearest}) {
    const SurfaceOptions options{.outside = outside,
                                 .max_distance = 300,
                                 .distance = GlobeDistance::geodesic_wgs84};
    expect_rebuilt(InverseDistance{}, regional_points(66), 1e-13, options);
    expect_rebuilt(Shepard{}, regional_points(66), 1e-10, options);
    expect_rebuilt(Radial{}, regional_points(66), 1e-9, options);
  }
}

TEST(NodesLeftOut, InverseDistancesKeepPowerAndRadius) {
  for (const double radius : {0.05, 0.2}) {
    expect_rebuilt(InverseDistance{{.power = 3.5, .radius = radius}},
                   support::uniform_points(200, 6), 1e-13);
  }
  expect_rebuilt(InverseDistance{{.neighbors = 1000}}, support::uniform_points(50, 6),
                 1e-13);
  expect_rebuilt(InverseDistance{{.radius = 2000}}, support::uniform_directions(100, 6),
                 1e-13);
}

TEST(NodesLeftOut, RepeatedRowsAreLeftOutTogether) {
  const PlanePoints points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 1}};
  const std::vector<double> values{1, 1, 1, 1, 5, 7};
  const auto t = triangulated(points);
  for (const LeaveOneOut& found :
       {InverseDistance{}.left_out(t, values), Shepard{}.left_out(t, values),
        Radial{}.left_out(t, values)}) {
    EXPECT_NEAR(found.residual[4], -4, 1e-12);
    EXPECT_NEAR(found.residual[5], -6, 1e-12);
    EXPECT_EQ(found.num_missing, 4);
  }
}

TEST(NodesLeftOut, OfFewOrCollinearPointsEqualRebuilding) {
  for (const PlanePoints& points :
       {PlanePoints{}, PlanePoints{{1, 2}}, PlanePoints{{1, 2}, {3, 4}},
        PlanePoints{{0, 0}, {1, 1}, {3, 3}}, PlanePoints{{0, 0}, {1, 0}, {0, 1}}}) {
    for (const Outside outside : {Outside::missing, Outside::nearest, Outside::linear}) {
      expect_rebuilt(InverseDistance{}, points, 1e-13, {.outside = outside});
      expect_rebuilt(Shepard{}, points, 1e-13, {.outside = outside});
      expect_rebuilt(Radial{}, points, 1e-13, {.outside = outside});
    }
  }
}

TEST(NodesLeftOut, OfALongChainEqualRebuilding) {
  PlanePoints points;
  for (int i = 0; i < 80; ++i) points.push_back({i * i * 0.01, 2.0 * i * i * 0.01});
  expect_rebuilt(InverseDistance{}, points, 1e-13);
  expect_rebuilt(Shepard{}, points, 1e-9, {.outside = Outside::nearest});
}

TEST(NodesLeftOut, DoNotDependOnThreads) {
  const PlanePoints points = support::uniform_points(80, 10);
  const std::vector<double> values = random_values(80, 11);
  const auto t = triangulated(points);
  const RunOptions one{.num_threads = 1, .progress = {}},
      three{.num_threads = 3, .progress = {}};
  const auto same = [&](const auto& method) {
    return first_difference(method.left_out(t, values, {}, one).predicted,
                            method.left_out(t, values, {}, three).predicted);
  };
  EXPECT_EQ(same(InverseDistance{}), points.size());
  EXPECT_EQ(same(Shepard{}), points.size());
  EXPECT_EQ(same(Radial{{.most_at_once = 60, .neighbors = 20}}), points.size());
}

TEST(NodesLeftOut, RefuseWhatTheSurfacesRefuse) {
  const auto t = triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}});
  const auto s = triangulated(regional_points(3));
  const std::vector<double> values{1, 2, 3}, few{1, 2}, bad{1, 2, NAN};
  const SurfaceOptions linear{.outside = Outside::linear}, negative{.max_distance = -1};
  const auto refuse = [&](const auto& method) {
    EXPECT_THROW((void)method.left_out(t, few), Error);
    EXPECT_THROW((void)method.left_out(t, bad), Error);
    EXPECT_THROW((void)method.left_out(t, values, negative), Error);
    EXPECT_THROW((void)method.left_out(s, values, linear), Error);
  };
  refuse(InverseDistance{});
  refuse(Shepard{});
  refuse(Radial{});
  EXPECT_THROW((void)InverseDistance{{.power = 0}}.left_out(t, values), Error);
  EXPECT_THROW((void)Shepard{{.fitted_neighbors = 3}}.left_out(t, values), Error);
  EXPECT_THROW((void)Radial{{.neighbors = 3}}.left_out(t, values), Error);
}

}  // namespace
}  // namespace delone::interp
