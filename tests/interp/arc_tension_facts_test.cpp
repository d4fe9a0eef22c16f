#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/arc_tension_checks.hpp"
#include "interp/test_functions.hpp"

namespace delone::interp {
namespace {

using support::arcs_of;
using support::is_same;
using support::PlanePoints;
using support::points_of_the_hull;
using support::random_gradients;
using support::random_values;
using support::sampled;
using support::triangulated;
using support::with_range;
using support::with_shape;
using tripack::Point2;

constexpr double infinity = std::numeric_limits<double>::infinity();

RunOptions threads(int count) { return {.num_threads = count, .progress = {}}; }

TEST(PlaneTension, ContinuesSmoothlyBeyondTheHull) {
  // A square has many nodes on straight sides.
  PlanePoints points = support::uniform_points(40, 22);
  for (const double s : {0.0, 0.25, 0.5, 1.0}) {
    for (const Point2 p : {Point2{s, 0}, Point2{s, 1}, Point2{0, s}, Point2{1, s}})
      points.push_back(p);
  }
  TensionSplineOptions options = with_shape(ArcShape::convex);
  options.c1.outside = Outside::linear;
  const std::vector<double> values = sampled(points, support::franke);
  const PlaneTensionSpline surface(triangulated(points), values, options);
  const auto at_angle = [](double angle, double radius) {
    return Point2{0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)};
  };
  const auto jump = [&](Point2 p, Point2 q) {
    const Gradient2 g = surface.gradient(p), h = surface.gradient(q);
    return std::hypot(g.x - h.x, g.y - h.y);
  };
  for (int k = 0; k < 32; ++k) {
    // Along rays, and round circles beyond the hull.
    for (int i = 0; i < 20; ++i) {
      double near = 0.05 * i, far = 0.05 * (i + 1);
      const bool is_ray = k < 16;
      const auto place = [&](double s) {
        return is_ray ? at_angle(2 * std::numbers::pi * k / 16, 1.5 * s)
                      : at_angle(2 * std::numbers::pi * s, 0.75 + 0.05 * (k - 16));
      };
      for (int halving = 0; halving < 30; ++halving) {
        const double middle = 0.5 * (near + far);
        const bool is_nearer =
            jump(place(near), place(middle)) > jump(place(middle), place(far));
        (is_nearer ? far : near) = middle;
      }
      EXPECT_LT(jump(place(near), place(far)), 1e-4) << k << " " << near;
    }
  }
}

TEST(PlaneTension, FactorsAreThoseAskedFor) {
  const PlanePoints points = support::uniform_points(60, 23);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, support::franke);
  const auto arcs = tension_arcs(*t);
  EXPECT_EQ(arcs.size(), at(t->adjacency().num_arcs()) / 2);
  EXPECT_TRUE(std::ranges::is_sorted(arcs));
  for (const auto& [from, to] : arcs) EXPECT_LT(from, to);
  TensionSplineOptions options;
  for (std::size_t k = 0; k < arcs.size(); ++k)
    options.factors.push_back(static_cast<double>(k % 50));
  options.factor = 3;
  const PlaneTensionSpline surface(t, values, options);
  const std::vector<double> found = surface.tension_factors();
  for (std::size_t k = 0; k < arcs.size(); ++k)
    EXPECT_EQ(found[k], std::max(3.0, static_cast<double>(k % 50)));
  EXPECT_EQ(surface.fit().num_arcs, std::ssize(arcs));
  EXPECT_EQ(surface.fit().num_tightened, std::ssize(arcs));
  EXPECT_EQ(surface.fit().largest, 49);
  EXPECT_EQ(surface.fit().num_limited, 0);
  EXPECT_EQ(surface.fit().num_shortened, 0);
}

TEST(PlaneTension, FactorsOfValuesAndGradientsAreThoseOfTheSurface) {
  const PlanePoints points = support::uniform_points(300, 24);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, support::cliff);
  const std::vector<Gradient2> gradients = random_gradients(300, 25, 1);
  for (const ArcShape shape : {ArcShape::free, ArcShape::monotone, ArcShape::convex}) {
    const std::vector<double> factors =
        tension_factors(*t, values, gradients, {.shape = shape}, threads(2));
    EXPECT_EQ(
        factors,
        PlaneTensionSpline(t, values, gradients, with_shape(shape)).tension_factors());
    const bool is_zero = std::ranges::all_of(factors, [](double f) { return f == 0; });
    EXPECT_EQ(is_zero, shape == ArcShape::free);
  }
}

TEST(PlaneTension, LinearDataNeedNoTension) {
  const PlanePoints points = support::uniform_points(200, 26);
  const auto t = triangulated(points);
  const auto linear = [](Point2 p) { return 0.1 + 0.3 * p.x - 0.7 * p.y; };
  const PlaneTensionSpline surface(t, sampled(points, linear),
                                   std::vector<Gradient2>(200, {0.3, -0.7}),
                                   with_shape(ArcShape::convex));
  EXPECT_EQ(surface.fit().num_tightened, 0);
}

TEST(PlaneTension, PositiveDataStayPositiveOnArcs) {
  const PlanePoints points = support::uniform_points(300, 27);
  const auto t = triangulated(points);
  std::vector<double> values = sampled(points, support::steep);
  for (double& v : values) v = v < 0.02 ? 0 : v;  // level ground with a hill
  const std::vector<Gradient2> gradients = random_gradients(300, 28, 3);
  const PlaneTensionSpline surface(t, values, gradients, with_range(0, infinity));
  EXPECT_GT(surface.fit().num_shortened, 10);
  EXPECT_GT(surface.fit().num_tightened, 10);
  const std::vector<HermiteArc> arcs = arcs_of(surface, points, values, *t);
  const std::vector<double> factors = surface.tension_factors();
  for (std::size_t k = 0; k < arcs.size(); ++k)
    EXPECT_GE(arcs[k].start + TensionSpline(arcs[k], factors[k]).rises().least, -1e-14);
}

// The short edge has a slope of 1500, the rays along which it is seen a length of 5.
TEST(PlaneTension, ASteepShortEdgeDoesNotMakeLongTrianglesOvershoot) {
  const PlanePoints points{{0, 0}, {0.001, 0}, {5, 0.01}, {-5, -0.02}};
  const auto t = triangulated(points);
  const PlaneTensionSpline surface(t, std::vector<double>{0, 1, 0.5, 0.25},
                                   std::vector<Gradient2>(4, {0.1, -0.1}));
  EXPECT_EQ(surface.fit().num_tightened, 0);
  support::SplitMix64 random(35);
  for (int i = 0; i < 2000; ++i) {
    const double u = random.uniform(), v = random.uniform() * (1 - u);
    t->adjacency().for_each_triangle([&](delaunay::Arc arc) {
      const auto corners = t->adjacency().left(arc);
      const Point2 a = t->points()[at(corners[0])], b = t->points()[at(corners[1])],
                   c = t->points()[at(corners[2])];
      const double found = surface.value({a.x + u * (b.x - a.x) + v * (c.x - a.x),
                                          a.y + u * (b.y - a.y) + v * (c.y - a.y)});
      EXPECT_FALSE(found < -1 || found > 2) << found;
    });
  }
}

TEST(PlaneTension, UnknownGradientsAreThoseOfTheC1Surface) {
  const PlanePoints points = support::uniform_points(100, 29);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, support::franke);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Gradient2> gradients(100, {nan, nan});
  gradients[7] = {1, -1};
  const PlaneTensionSpline surface(t, values, gradients), fitted(t, values);
  const PlaneC1 c1(t, values), partly(t, values, gradients);
  EXPECT_EQ(surface.gradient(points[7]), (Gradient2{1, -1}));
  for (const std::size_t row : {std::size_t{0}, std::size_t{50}}) {
    EXPECT_NEAR(fitted.gradient(points[row]).x, c1.gradient(points[row]).x, 1e-12);
    EXPECT_NEAR(surface.gradient(points[row]).x, partly.gradient(points[row]).x, 1e-12);
  }
  EXPECT_EQ(fitted.fit().c1.tension, c1.fit().tension);
}

TEST(PlaneTension, IsTheSameWhenMovedAndScaled) {
  const PlanePoints points = support::uniform_points(200, 30);
  const std::vector<double> values = sampled(points, support::franke);
  const std::vector<Gradient2> gradients = random_gradients(200, 31, 2);
  const PlaneTensionSpline surface(triangulated(points), values, gradients,
                                   with_shape(ArcShape::convex));
  for (const double scale : {0x1p-20, 0x1p20, 0x1p600, 0x1p-600}) {
    PlanePoints moved = points;
    for (Point2& p : moved) p = {p.x * scale, p.y * scale};
    std::vector<Gradient2> flatter = gradients;
    for (Gradient2& g : flatter) g = {g.x / scale, g.y / scale};
    const PlaneTensionSpline other(triangulated(moved), values, flatter,
                                   with_shape(ArcShape::convex));
    support::SplitMix64 random(32);
    for (int i = 0; i < 100; ++i) {
      const Point2 p{random.between(0.1, 0.9), random.between(0.1, 0.9)};
      EXPECT_NEAR(other.value({p.x * scale, p.y * scale}), surface.value(p), 1e-12);
    }
  }
}

TEST(PlaneTension, IntegralIsThatOfTheSurface) {
  const PlanePoints points{{0, 0}, {2, 0}, {2, 1}, {0, 1}, {1, 0.4}};
  const auto quadratic = [](Point2 p) { return p.x * p.x + p.x * p.y; };
  std::vector<Gradient2> gradients;
  for (const Point2 p : points) gradients.push_back({2 * p.x + p.y, p.x});
  const PlaneTensionSpline surface(triangulated(points), sampled(points, quadratic),
                                   gradients);
  EXPECT_NEAR(surface.integral(), 8.0 / 3 + 1, 1e-13);
}

TEST(PlaneTension, FewPointsHaveAValue) {
  const PlanePoints three{{0, 0}, {1, 0}, {0, 1}};
  const auto options = with_shape(ArcShape::convex);
  const PlaneTensionSpline plane(triangulated(three), std::vector<double>{1, 2, 4},
                                 options);
  EXPECT_NEAR(plane.value({0.25, 0.25}), 2, 0.3);
  EXPECT_EQ(plane.tension_factors().size(), 3);
  EXPECT_TRUE(std::isnan(plane.value({1, 1})));
  const PlaneTensionSpline two(triangulated(PlanePoints{{0, 0}, {1, 0}}),
                               std::vector<double>{1, 2}, options);
  EXPECT_EQ(two.value({0.5, 0}), 1.5);
  EXPECT_TRUE(two.tension_factors().empty());
  const PlaneTensionSpline one(triangulated(PlanePoints{{3, 4}}), std::vector<double>{7},
                               options);
  EXPECT_EQ(one.value({3, 4}), 7);
  const PlaneTensionSpline nothing(triangulated(PlanePoints{}), std::vector<double>{},
                                   options);
  EXPECT_TRUE(std::isnan(nothing.value({0, 0})));
  EXPECT_EQ(nothing.integral(), 0);
  EXPECT_TRUE(nothing.values({}).empty());
}

TEST(PlaneTension, MissingQueriesAndReachAreAsForOtherSurfaces) {
  const PlanePoints points = support::uniform_points(20, 33);
  TensionSplineOptions options;
  options.c1.max_distance = 0.1;
  const std::vector<double> values = sampled(points, support::franke);
  const PlaneTensionSpline surface(triangulated(points), values, options);
  const PlaneLinear linear(triangulated(points), values, options.c1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(surface.value({nan, 0})));
  EXPECT_TRUE(std::isnan(surface.derivatives({0, nan}).xx));
  for (int i = 0; i < 100; ++i) {
    const Point2 p{0.01 * i, 0.5};
    EXPECT_EQ(std::isnan(surface.value(p)), std::isnan(linear.value(p)));
  }
}

TEST(PlaneTension, RefusesWhatItCannotUse) {
  const PlanePoints points = support::uniform_points(10, 34);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, support::franke);
  const auto refused = [&](const TensionSplineOptions& options) {
    EXPECT_THROW(PlaneTensionSpline(t, values, options), Error);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double factor : {-1.0, 85.5, infinity, nan}) {
    TensionSplineOptions options;
    options.factor = factor;
    refused(options);
    options.factor = 0;
    options.factors.assign(tension_arcs(*t).size(), 1);
    options.factors[3] = factor;
    refused(options);
  }
  TensionSplineOptions options;
  options.factors = {1, 2, 3};
  refused(options);
  refused(with_range(2, 1));
  refused(with_range(nan, 1));
  refused(with_range(0, 0.5));  // a value is larger
  try {
    const PlaneTensionSpline surface(t, values, with_range(infinity, infinity));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.rows().size(), 1);
  }
  TensionSplineOptions bad_c1;
  bad_c1.c1.tension = 2;
  refused(bad_c1);
  EXPECT_THROW(PlaneTensionSpline(t, values, std::vector<Gradient2>(9)), Error);
  EXPECT_THROW(PlaneTensionSpline(t, values, std::vector<Gradient2>(10, {infinity, 0})),
               Error);
  EXPECT_THROW(static_cast<void>(
                   tension_factors(*t, values, std::vector<Gradient2>(10, {nan, 0}), {})),
               Error);
  EXPECT_THROW(PlaneTensionSpline(t, std::vector<double>(9)), Error);
}

}  // namespace
}  // namespace delone::interp
