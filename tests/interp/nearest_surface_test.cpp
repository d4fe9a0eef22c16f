#include "interp/nearest_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delaunay/error.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;
using tripack::Point2;

TEST(PlaneNearest, AgreesWithBruteForceWhereOneSiteIsNearest) {
  const PlanePoints points = support::clustered_points(300, 1);
  const std::vector<double> values = random_values(300, 2);
  const PlaneNearest surface(triangulated(points), values, {.outside = Outside::nearest});
  for (const Point2 q : support::uniform_points(2000, 3)) {
    std::size_t best = 0;
    const auto distance = [&](std::size_t i) {
      return std::hypot(points[i].x - q.x, points[i].y - q.y);
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (distance(i) < distance(best)) best = i;
    }
    EXPECT_EQ(surface.value(q), values[best]);
  }
}

// The middle of a lattice cell is as far from four nodes: whichever is taken must not
// depend on the way.
TEST(PlaneNearest, BreaksTiesAlikeHoweverItIsAsked) {
  const PlanePoints points = support::lattice_points(400),
                    other_rows = support::shuffled(points, 4);
  const auto f = [](Point2 p) { return 100 * p.x + p.y; };
  const PlaneNearest surface(triangulated(points), support::sampled(points, f));
  const PlaneNearest same(triangulated(other_rows), support::sampled(other_rows, f));
  const Grid grid = plane_grid({0, 19, 0, 19}, Spacing{0.5, 0.5});
  const std::vector<double> values =
      surface.grid(grid, {.num_threads = 1, .progress = {}}).values;
  EXPECT_EQ(support::count_missing(values), 0u);
  EXPECT_EQ(support::first_difference(
                surface.grid(grid, {.num_threads = 3, .progress = {}}).values, values),
            values.size());
  EXPECT_EQ(support::first_difference(same.grid(grid).values, values), values.size());
  const PlanePoints nodes = support::shuffled(plane_nodes(grid), 5);
  const std::vector<double> queried = surface.values(nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    EXPECT_EQ(surface.value(nodes[i]), queried[i]);
}

TEST(PlaneNearest, IsMissingOutsideUnlessToldOtherwise) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}};
  const std::vector<double> values{1, 2, 3};
  const PlaneNearest missing(triangulated(points), values);
  EXPECT_TRUE(std::isnan(missing.value({2, 2})));
  EXPECT_TRUE(std::isnan(missing.gradient({2, 2}).x));
  EXPECT_TRUE(std::isnan(missing.value({std::nan(""), 2})));
  EXPECT_EQ(missing.gradients(PlanePoints{{0.2, 0.2}})[0], (Gradient2{0, 0}));
  EXPECT_EQ(PlaneNearest(triangulated(points), values, {.outside = Outside::nearest})
                .value({2, 1}),
            2);
  EXPECT_THROW(PlaneNearest(triangulated(points), values, {.outside = Outside::linear}),
               Error);
}

TEST(SphereNearest, AgreesWithBruteForce) {
  const SpherePoints points = support::uniform_directions(200, 6);
  const std::vector<double> values = random_values(200, 7);
  const SphereNearest surface(triangulated(points), values);
  const SpherePoints queries =
      globe_nodes(globe_grid({-180, 180, -85, 85}, Spacing{10, 10}));
  const std::vector<double> field =
      surface.grid(globe_grid({-180, 180, -85, 85}, Spacing{10, 10})).values;
  for (std::size_t k = 0; k < queries.size(); ++k) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (stripack::angle(points[i], queries[k]) <
          stripack::angle(points[best], queries[k]))
        best = i;
    }
    EXPECT_EQ(surface.value(queries[k]), values[best]);
    EXPECT_EQ(field[k], values[best]);
  }
}

TEST(SphereNearest, ReachesTheFarSideIfAsked) {
  const SpherePoints points{at_lonlat(-10, 0), at_lonlat(10, 0), at_lonlat(0, 15)};
  const std::vector<double> values{1, 2, 3};
  EXPECT_TRUE(
      std::isnan(SphereNearest(triangulated(points), values).value(at_lonlat(180, 0))));
  const SphereNearest surface(triangulated(points), values,
                              {.outside = Outside::nearest});
  EXPECT_EQ(surface.value(at_lonlat(120, -10)), 2);
  EXPECT_EQ(surface.value(at_lonlat(-120, -10)), 1);
  EXPECT_EQ(surface.value(at_lonlat(175, 0)), 3);
  EXPECT_EQ(surface.value(at_lonlat(0, 89)), 3);
}

}  // namespace
}  // namespace delone::interp
