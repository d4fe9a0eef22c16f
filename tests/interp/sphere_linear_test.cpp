#include <gtest/gtest.h>

#include <cmath>

#include "delaunay/error.hpp"
#include "interp/linear_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::at_lonlat;
using support::is_same;
using support::random_values;
using support::sampled;
using support::SpherePoints;
using support::triangulated;

// Nodes, points near the middles of edges, and random points of every triangle.
SpherePoints points_of_the_region(const stripack::Triangulation& t, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  SpherePoints points(t.points().begin(), t.points().end());
  t.adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto corners = t.adjacency().left(arc);
    const auto corner = [&](std::size_t k) {
      return t.points()[static_cast<std::size_t>(corners[k % 3])];
    };
    const auto mixed = [&](double s, double u, double v, std::size_t k) {
      const Direction a = corner(k), b = corner(k + 1), c = corner(k + 2);
      points.push_back(Direction::from(s * a.x() + u * b.x() + v * c.x(),
                                       s * a.y() + u * b.y() + v * c.y(),
                                       s * a.z() + u * b.z() + v * c.z()));
    };
    for (std::size_t k = 0; k < 3; ++k) {
      mixed(0.5, 0.5, 0, k);
      const double s = random.uniform(), u = random.uniform() * (1 - s);
      mixed(s, u, 1 - s - u, k);
    }
  });
  return points;
}

class SphereLinearOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereLinearOnSets, GivesNodesTheirValuesBitForBit) {
  const SpherePoints points = support::affordable(GetParam(), 400, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  const SphereLinear surface(t, values);
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double expected = merged[static_cast<std::size_t>(t->sites()[row])];
    EXPECT_TRUE(is_same(surface.value(points[row]), expected)) << "row " << row;
  }
}

TEST_P(SphereLinearOnSets, IsFiniteAndWithinTheDataOnTheClosedRegion) {
  const SpherePoints points = support::affordable(GetParam(), 300, 3);
  const auto t = triangulated(points);
  const SphereLinear surface(t, random_values(points.size(), 4));
  for (const Direction& p : points_of_the_region(*t, 5)) {
    const double v = surface.value(p);
    if (t->locate(p).kind == delaunay::Location::Kind::outside) {
      EXPECT_TRUE(std::isnan(v));
    } else {
      EXPECT_LE(std::abs(v), 1);
    }
  }
}

TEST_P(SphereLinearOnSets, ValuesDoNotDependOnOrderOrThreads) {
  const SpherePoints points = support::affordable(GetParam(), 300, 6);
  const auto t = triangulated(points);
  const auto f = [](const Direction& p) {
    return p.x() + std::sin(3 * p.y()) - p.z() * p.x();
  };
  const SphereLinear surface(t, sampled(points, f));
  const SpherePoints queries = support::shuffled(points_of_the_region(*t, 7), 8);
  const std::vector<double> expected =
      surface.values(queries, {.num_threads = 1, .progress = {}});
  for (std::size_t i = 0; i < queries.size(); i += 7) {
    EXPECT_TRUE(is_same(surface.value(queries[i]), expected[i])) << i;
  }
  EXPECT_EQ(support::first_difference(
                surface.values(queries, {.num_threads = 5, .progress = {}}), expected),
            queries.size());
  const SpherePoints other_rows = support::shuffled(points, 9);
  const SphereLinear same(triangulated(other_rows), sampled(other_rows, f));
  EXPECT_EQ(support::first_difference(same.values(queries), expected), queries.size());
}

TEST_P(SphereLinearOnSets, ReproducesConstantsExactly) {
  const SpherePoints points = support::affordable(GetParam(), 300, 10);
  const auto t = triangulated(points);
  const SphereLinear surface(t, std::vector<double>(points.size(), 0.1),
                             {.outside = Outside::nearest});
  for (const Direction& p : points_of_the_region(*t, 11))
    EXPECT_EQ(surface.value(p), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereLinearOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(SphereLinear, IsLinearOnTheFlatTriangle) {
  // On the face x + y + z = 1 of the octahedron.
  const SpherePoints points{at_lonlat(0, 0),   at_lonlat(90, 0),  at_lonlat(0, 90),
                            at_lonlat(180, 0), at_lonlat(-90, 0), at_lonlat(0, -90)};
  const SphereLinear surface(triangulated(points), std::vector<double>{1, 2, 3, 4, 5, 6});
  const Direction p = Direction::from(0.2, 0.3, 0.5);
  EXPECT_NEAR(surface.value(p), 0.2 * 1 + 0.3 * 2 + 0.5 * 3, 1e-15);
  EXPECT_DOUBLE_EQ(surface.value(at_lonlat(45, 0)), 1.5);
  EXPECT_EQ(surface.value(at_lonlat(123, 90)), 3);
  EXPECT_EQ(surface.value(at_lonlat(-77, -90)), 6);
  EXPECT_EQ(surface.value(at_lonlat(540, 0)), 4);
}

double harmonic(const Direction& p) {
  return p.x() * p.y() + p.z() * p.z() * p.z() - 0.5 * p.x();
}

TEST(SphereLinear, ErrorFallsWithTheSquareOfTheSpacing) {
  const auto error = [](std::size_t n) {
    const SpherePoints points = support::fibonacci_directions(n),
                       queries = support::uniform_directions(4000, 1);
    const std::vector<double> v =
        SphereLinear(triangulated(points), sampled(points, harmonic)).values(queries);
    double sum = 0;
    for (std::size_t i = 0; i < queries.size(); ++i)
      sum += std::pow(v[i] - harmonic(queries[i]), 2);
    return std::sqrt(sum / 4000);
  };
  const double ratio = error(2000) / error(32000);
  EXPECT_GT(ratio, 14);
  EXPECT_LT(ratio, 18);
}

TEST(SphereLinear, GradientTendsToThatOfTheFunction) {
  const SpherePoints points = support::fibonacci_directions(20000);
  const SphereLinear surface(triangulated(points),
                             sampled(points, [](const Direction& p) { return p.z(); }));
  // z is the sine of latitude: its gradient is cos(lat) to the north.
  for (const double lat : {-80.0, -45.0, 0.3, 60.0}) {
    const GradientSphere g = surface.gradient(at_lonlat(33, lat));
    EXPECT_NEAR(g.north, std::cos(lat * 0.017453292519943295), 0.02) << lat;
    EXPECT_NEAR(g.east, 0, 0.02) << lat;
  }
  const SphereLinear eastward(triangulated(points),
                              sampled(points, [](const Direction& p) { return p.y(); }));
  EXPECT_NEAR(eastward.gradient(at_lonlat(0, 0)).east, 1, 0.02);
  EXPECT_NEAR(eastward.gradient(at_lonlat(0, 90)).east, 1, 0.02);
}

TEST(SphereLinear, GradientAgreesWithDifferences) {
  const SpherePoints points = support::uniform_directions(50, 12);
  const SphereLinear surface(triangulated(points), random_values(50, 13));
  const double h = 1e-5, radians = 0.017453292519943295;
  int agreeing = 0;
  for (int i = 0; i < 200; ++i) {
    support::SplitMix64 random(static_cast<std::uint64_t>(i));
    const double lon = random.between(-180, 180), lat = random.between(-85, 85);
    const GradientSphere g = surface.gradient(at_lonlat(lon, lat));
    const double north = (surface.value(at_lonlat(lon, lat + h)) -
                          surface.value(at_lonlat(lon, lat - h))) /
                         (2 * h * radians);
    const double east = (surface.value(at_lonlat(lon + h, lat)) -
                         surface.value(at_lonlat(lon - h, lat))) /
                        (2 * h * radians * std::cos(lat * radians));
    agreeing += std::abs(g.north - north) < 1e-5 && std::abs(g.east - east) < 1e-5;
  }
  EXPECT_GE(agreeing, 198);  // the rest lie within 1e-5 degrees of an edge
}

TEST(SphereLinear, OfAHemisphereIsMissingOutsideUnlessNearest) {
  const SpherePoints points{at_lonlat(-10, 0), at_lonlat(10, 0), at_lonlat(0, 15),
                            at_lonlat(0, 5)};
  const std::vector<double> values{1, 2, 3, 4};
  const SphereLinear surface(triangulated(points), values);
  EXPECT_TRUE(std::isfinite(surface.value(at_lonlat(0, 0))));
  EXPECT_TRUE(std::isnan(surface.value(at_lonlat(0, -1e-9))));
  EXPECT_TRUE(std::isnan(surface.value(at_lonlat(180, 0))));
  EXPECT_TRUE(std::isnan(surface.gradient(at_lonlat(180, 0)).east));
  const SphereLinear nearest(triangulated(points), values, {.outside = Outside::nearest});
  EXPECT_EQ(nearest.value(at_lonlat(0, 80)), 3);
  EXPECT_EQ(nearest.value(at_lonlat(100, 0)), 2);
  EXPECT_EQ(nearest.gradient(at_lonlat(100, 0)), (GradientSphere{0, 0}));
}

TEST(SphereLinear, OnOneGreatCircleIsLinearAlongIt) {
  const SpherePoints points{at_lonlat(0, 0), at_lonlat(90, 0), at_lonlat(45, 0)};
  const std::vector<double> values{0, 10, 4};
  const SphereLinear surface(triangulated(points), values);
  EXPECT_DOUBLE_EQ(surface.value(at_lonlat(22.5, 0)), 2);
  EXPECT_DOUBLE_EQ(surface.value(at_lonlat(67.5, 0)), 7);
  EXPECT_EQ(surface.value(at_lonlat(90, 0)), 10);
  EXPECT_TRUE(std::isnan(surface.value(at_lonlat(22.5, 1e-10))));
  EXPECT_TRUE(std::isnan(surface.value(at_lonlat(91, 0))));
  EXPECT_NEAR(surface.gradient(at_lonlat(22.5, 0)).north, 0, 1e-15);
  EXPECT_GT(surface.gradient(at_lonlat(22.5, 0)).east, 4);
  const SphereLinear nearest(triangulated(points), values, {.outside = Outside::nearest});
  EXPECT_EQ(nearest.value(at_lonlat(91, 20)), 10);
}

TEST(SphereLinear, OfBoxesOfAMillimetreIsAsAccurateAsOfTheGlobe) {
  // z is linear on flat triangles up to the sagitta, side^2. Directions are rounded to
  // 1e-16.
  for (const double side : {1e-3, 1e-6, 1e-9}) {
    const SpherePoints points = support::box_directions(200, 14, side);
    const auto f = [&](const Direction& p) { return (p.z() - points[0].z()) / side; };
    const SphereLinear surface(triangulated(points), sampled(points, f));
    int inside = 0;
    for (const Direction& p : support::box_directions(500, 15, side)) {
      const double v = surface.value(p);
      if (std::isnan(v)) continue;
      ++inside;
      EXPECT_NEAR(v, f(p), 1e-14 + side + 3e-16 / side) << side;
    }
    EXPECT_GT(inside, 400);
  }
}

TEST(SphereLinear, RefusesBadInput) {
  const SpherePoints points{at_lonlat(0, 0), at_lonlat(90, 0), at_lonlat(0, 90)};
  const std::vector<double> values{1, 2, 3};
  EXPECT_THROW(SphereLinear(triangulated(points), values, {.outside = Outside::linear}),
               Error);
  EXPECT_THROW(SphereLinear(triangulated(points), values, {.max_distance = -1}), Error);
  EXPECT_THROW(SphereLinear(triangulated(points), std::vector<double>{1, 2}), Error);
  EXPECT_THROW(
      SphereLinear(triangulated(points), std::vector<double>{1, 2, std::nan("")}), Error);
}

TEST(SphereLinear, NoPointsAreMissingEverywhere) {
  const SphereLinear surface(triangulated(SpherePoints{}), {},
                             {.outside = Outside::nearest});
  EXPECT_TRUE(std::isnan(surface.value(at_lonlat(0, 0))));
  EXPECT_EQ(support::count_missing(
                surface.grid(globe_grid({0, 10, 0, 10}, Spacing{10, 10})).values),
            4u);
}

}  // namespace
}  // namespace delone::interp
