#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/scatter_makers.hpp"
#include "interp/surfaces.hpp"
#include "interp/test_functions.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;
using tripack::Point2;

// What all meshless methods promise, on plane and sphere.
template <class Maker>
class ScatterSurfaces : public testing::Test {};

using Makers =
    testing::Types<support::InverseDistances, support::QuadraticShepards,
                   support::CubicShepards, support::ThinPlates, support::LocalThinPlates,
                   support::LocalCubics, support::LocalQuintics>;
TYPED_TEST_SUITE(ScatterSurfaces, Makers);

template <class F>
void for_each_family(F f) {
  for (const support::PlaneFamily& family : support::plane_families()) {
    SCOPED_TRACE(family.name);
    f(family.make(120, 7));
  }
  for (const support::SphereFamily& family : support::sphere_families()) {
    SCOPED_TRACE(family.name);
    f(family.make(120, 7));
  }
}

Point2 centroid(Point2 a, Point2 b, Point2 c) {
  return {a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3};
}
Direction centroid(const Direction& a, const Direction& b, const Direction& c) {
  return Direction::from(a.x() + b.x() + c.x(), a.y() + b.y() + c.y(),
                         a.z() + b.z() + c.z());
}

// Points of the closed hull: the nodes and the middles of triangles that rounding has not
// put elsewhere.
template <class Points>
Points hull_points(const Points& points) {
  const auto t = triangulated(points);
  Points result = points;
  for (const auto& corner : t->triangles()) {
    const auto p = centroid(points[static_cast<std::size_t>(corner[0])],
                            points[static_cast<std::size_t>(corner[1])],
                            points[static_cast<std::size_t>(corner[2])]);
    if (t->locate(p).kind != delaunay::Location::Kind::outside) result.push_back(p);
  }
  return result;
}

std::vector<Point2> inner_points(std::size_t n) {
  PlanePoints points = support::uniform_points(n, 11);
  for (Point2& p : points) p = {0.1 + 0.8 * p.x, 0.1 + 0.8 * p.y};
  return points;
}

TYPED_TEST(ScatterSurfaces, PassThroughTheValuesBitForBit) {
  for_each_family([](const auto& points) {
    const std::vector<double> values = random_values(points.size(), 1);
    const auto t = triangulated(points);
    const auto surface =
        TypeParam::make(t, values, SurfaceOptions{.duplicates = Duplicates::first});
    const std::vector<double> found = surface.values(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto site = t->sites()[i];
      const auto first = t->rows()[static_cast<std::size_t>(site)];
      ASSERT_EQ(found[i], values[static_cast<std::size_t>(first)]) << "row " << i;
    }
  });
}

TYPED_TEST(ScatterSurfaces, AreFiniteInTheHull) {
  for_each_family([](const auto& points) {
    const auto surface =
        TypeParam::make(triangulated(points), random_values(points.size(), 2));
    for (const double v : surface.values(hull_points(points)))
      ASSERT_TRUE(std::isfinite(v));
  });
}

TYPED_TEST(ScatterSurfaces, ReproduceConstantsExactly) {
  for_each_family([](const auto& points) {
    const std::vector<double> values(points.size(), 0.1);
    const auto surface = TypeParam::make(triangulated(points), values);
    for (const double v : surface.values(hull_points(points))) ASSERT_EQ(v, 0.1);
  });
}

TYPED_TEST(ScatterSurfaces, AnswerAlikeHoweverTheyAreAsked) {
  const auto plane =
      TypeParam::make(triangulated(support::clustered_points(200, 3)),
                      random_values(200, 4), {.outside = Outside::nearest});
  const Grid grid = plane_grid({-0.1, 1.1, -0.1, 1.1}, NodeCounts{23, 31});
  const PlanePoints nodes = support::shuffled(plane_nodes(grid), 5);
  const std::vector<double> queried =
      plane.values(nodes, {.num_threads = 3, .progress = {}});
  for (std::size_t i = 0; i < nodes.size(); ++i)
    ASSERT_EQ(plane.value(nodes[i]), queried[i]);
  EXPECT_EQ(plane.grid(grid).values, plane.values(plane_nodes(grid)));

  const auto sphere = TypeParam::make(triangulated(support::track_directions(200)),
                                      random_values(200, 6));
  const Grid globe = globe_grid({-180, 180, -80, 80}, Spacing{20, 10});
  const SpherePoints directions = globe_nodes(globe);
  const std::vector<double> values =
      sphere.values(directions, {.num_threads = 3, .progress = {}});
  for (std::size_t i = 0; i < directions.size(); ++i)
    ASSERT_EQ(sphere.value(directions[i]), values[i]);
  EXPECT_EQ(sphere.grid(globe).values, values);
}

TYPED_TEST(ScatterSurfaces, DoNotDependOnTheOrderOfRows) {
  const auto f = [](Point2 p) { return support::franke(p); };
  const PlanePoints points = support::uniform_points(150, 8),
                    other = support::shuffled(points, 9);
  const auto a = TypeParam::make(triangulated(points), support::sampled(points, f));
  const auto b = TypeParam::make(triangulated(other), support::sampled(other, f));
  const PlanePoints queries = inner_points(300);
  EXPECT_EQ(a.values(queries), b.values(queries));
}

TYPED_TEST(ScatterSurfaces, HaveTheirOwnGradient) {
  const PlanePoints points = support::uniform_points(150, 12);
  const auto plane =
      TypeParam::make(triangulated(points), support::sampled(points, support::franke));
  const double h = 1e-6;
  for (const Point2 p : inner_points(100)) {
    const Gradient2 g = plane.gradient(p);
    const double x = (plane.value({p.x + h, p.y}) - plane.value({p.x - h, p.y})) /
                     (2 * h),
                 y = (plane.value({p.x, p.y + h}) - plane.value({p.x, p.y - h})) /
                     (2 * h);
    EXPECT_NEAR(g.x, x, 1e-3);
    EXPECT_NEAR(g.y, y, 1e-3);
  }
}

TYPED_TEST(ScatterSurfaces, HaveTheirOwnGradientOnTheSphere) {
  const SpherePoints points = support::uniform_directions(150, 13);
  const auto surface = TypeParam::make(triangulated(points),
                                       support::sampled(points, [](const Direction& p) {
                                         return std::sin(3 * p.x()) + p.y() * p.z();
                                       }));
  const double h = 1e-6, degrees = 180 / std::numbers::pi;
  const auto at = [&](double lon, double lat) {
    return surface.value(support::at_lonlat(lon, lat));
  };
  for (const Direction& p : support::uniform_directions(100, 14)) {
    const stripack::LonLat q = lonlat(p);
    const GradientSphere g = surface.gradient(p);
    const double along = h * degrees / std::hypot(p.x(), p.y()), up = h * degrees;
    EXPECT_NEAR(
        g.east,
        (at(q.lon_deg + along, q.lat_deg) - at(q.lon_deg - along, q.lat_deg)) / (2 * h),
        1e-3);
    EXPECT_NEAR(g.north,
                (at(q.lon_deg, q.lat_deg + up) - at(q.lon_deg, q.lat_deg - up)) / (2 * h),
                1e-3);
  }
}

TYPED_TEST(ScatterSurfaces, KeepTheirDigitsWhenMovedAndScaled) {
  const PlanePoints points = support::uniform_points(150, 15),
                    queries = inner_points(200);
  const std::vector<double> values = support::sampled(points, support::franke);
  const std::vector<double> expected =
      TypeParam::make(triangulated(points), values).values(queries);
  const auto values_after = [&](double scale, double move) {
    PlanePoints there = points, asked = queries;
    for (PlanePoints* set : {&there, &asked}) {
      for (Point2& p : *set) p = {p.x * scale + move, p.y * scale + 2 * move};
    }
    return TypeParam::make(triangulated(there), values).values(asked);
  };
  // Positions 1e7 away are rounded by 2e-9: the values change by no more than slopes
  // times that.
  for (const auto& [scale, move, tolerance] :
       {std::array{1.0, 1e7, 1e-6}, {1e6, 0.0, 1e-11}, {1e-6, 0.0, 1e-11}}) {
    const std::vector<double> found = values_after(scale, move);
    for (std::size_t i = 0; i < queries.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], tolerance);
  }
}

TYPED_TEST(ScatterSurfaces, TurnWithTheSphere) {
  const auto turned = [](const Direction& p) {  // about (1, 1, 1) by 120 degrees, then x
    const double c = 0.6, s = 0.8;
    return Direction::from(p.z(), c * p.x() - s * p.y(), s * p.x() + c * p.y());
  };
  const SpherePoints points = support::uniform_directions(150, 16),
                     queries = support::uniform_directions(200, 17);
  SpherePoints other_points, other_queries;
  for (const Direction& p : points) other_points.push_back(turned(p));
  for (const Direction& p : queries) other_queries.push_back(turned(p));
  const std::vector<double> values = support::sampled(
      points, [](const Direction& p) { return std::sin(3 * p.x()) + p.y() * p.z(); });
  const auto a = TypeParam::make(triangulated(points), values);
  const auto b = TypeParam::make(triangulated(other_points), values);
  const std::vector<double> here = a.values(queries), there = b.values(other_queries);
  for (std::size_t i = 0; i < here.size(); ++i)
    EXPECT_NEAR(here[i], there[i], TypeParam::turning_tolerance);
}

TYPED_TEST(ScatterSurfaces, AreMissingOutsideUnlessToldOtherwise) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}, {1, 1.5}};
  const std::vector<double> values{1, 2, 3, 5};
  const auto t = triangulated(points);
  const auto missing = TypeParam::make(t, values);
  EXPECT_TRUE(std::isnan(missing.value({2, 2})));
  EXPECT_TRUE(std::isnan(missing.gradient({2, 2}).x));
  EXPECT_TRUE(std::isnan(missing.value({std::nan(""), 2})));
  EXPECT_TRUE(std::isnan(missing.gradient({0.5, INFINITY}).y));
  EXPECT_TRUE(missing.values(PlanePoints{}).empty());
  const auto nearest = TypeParam::make(t, values, {.outside = Outside::nearest});
  EXPECT_EQ(nearest.value({2, 2}), 5);
  EXPECT_EQ(nearest.gradients(PlanePoints{{2, 2}})[0], (Gradient2{0, 0}));
  const auto own = TypeParam::make(t, values, {.outside = Outside::linear});
  EXPECT_TRUE(std::isfinite(own.value({2, 2})));
  EXPECT_TRUE(std::isfinite(own.value({2e9, -2e9})));
  EXPECT_NEAR(own.value({0.5, -1e-9}), own.value({0.5, 1e-9}), 1e-7);
  const auto limited = TypeParam::make(t, values, {.max_distance = 0.3});
  EXPECT_TRUE(std::isnan(limited.value({0.5, 0.5})));
  EXPECT_TRUE(std::isfinite(limited.value({0.1, 0.1})));
  EXPECT_THROW(
      TypeParam::make(triangulated(SpherePoints{}), {}, {.outside = Outside::linear}),
      Error);
}

TYPED_TEST(ScatterSurfaces, HaveValuesOnFewNodes) {
  EXPECT_TRUE(std::isnan(TypeParam::make(triangulated(PlanePoints{}), {}).value({0, 0})));
  const auto one = TypeParam::make(triangulated(PlanePoints{{1, 2}}), std::array{7.0});
  EXPECT_EQ(one.value({1, 2}), 7);
  EXPECT_TRUE(std::isnan(one.value({1, 3})));
  const PlanePoints pair{{0, 0}, {2, 0}};
  const auto two = TypeParam::make(triangulated(pair), std::array{1.0, 3.0});
  EXPECT_NEAR(two.value({1, 0}), 2, 1e-12);
  EXPECT_TRUE(std::isnan(two.value({1, 1})));
  const auto far = TypeParam::make(triangulated(pair), std::array{1.0, 3.0},
                                   {.outside = Outside::linear});
  EXPECT_TRUE(std::isfinite(far.value({1, 1})));
  const SpherePoints poles{support::at_lonlat(0, 90), support::at_lonlat(0, -90)};
  const auto both = TypeParam::make(triangulated(poles), std::array{1.0, 3.0});
  EXPECT_EQ(both.value(poles[0]), 1);
  EXPECT_EQ(both.value(poles[1]), 3);
}

TYPED_TEST(ScatterSurfaces, RefuseBadValues) {
  const auto t = triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}});
  EXPECT_THROW(TypeParam::make(t, std::array{1.0, 2.0}), Error);
  EXPECT_THROW(TypeParam::make(t, std::array{1.0, 2.0, std::nan("")}), Error);
  EXPECT_THROW(TypeParam::make(t, std::array{1.0, 2.0, 3.0}, {.max_distance = -1}),
               Error);
}

}  // namespace
}  // namespace delone::interp
