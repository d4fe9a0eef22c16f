#include <gtest/gtest.h>

#include <cmath>

#include "delaunay/error.hpp"
#include "interp/circle_gaps.hpp"
#include "interp/linear_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::at_lonlat;
using support::random_values;
using support::SpherePoints;
using support::triangulated;

constexpr Region globe{-180, 180, -90, 90};

// Every node as value() has it, bit for bit; whatever the number of threads.
void expect_grid_as_points(const SphereLinear& surface, const Grid& grid) {
  const std::vector<double> values =
      surface.grid(grid, {.num_threads = 1, .progress = {}}).values;
  const SpherePoints nodes = globe_nodes(grid);
  const std::vector<double> expected = surface.values(nodes);
  const std::size_t i = support::first_difference(values, expected);
  ASSERT_EQ(i, nodes.size()) << "node " << stripack::lonlat(nodes[i]).lon_deg << ' '
                             << stripack::lonlat(nodes[i]).lat_deg << ": " << values[i]
                             << " instead of " << expected[i];
  const std::vector<double> threaded =
      surface.grid(grid, {.num_threads = 4, .progress = {}}).values;
  EXPECT_EQ(support::first_difference(threaded, values), nodes.size());
}

class SphereGridOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereGridOnSets, EqualsPointEvaluationAtEveryNode) {
  const SpherePoints points = GetParam().make(300, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  for (const Outside outside : {Outside::missing, Outside::nearest}) {
    const SphereLinear surface(t, values, {.outside = outside});
    expect_grid_as_points(surface, globe_grid(globe, Spacing{5, 5}));
    expect_grid_as_points(surface, globe_grid({0, 360, -90, 90}, NodeCounts{31, 17}));
  }
  const SphereLinear surface(t, values);
  const Region region = covering_region(*t);
  if (region.east > region.west && region.north > region.south) {
    expect_grid_as_points(surface, globe_grid(region, NodeCounts{41, 37}));
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereGridOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(SphereGrid, OnTheNodesOfTheDataHasTheDataBitForBit) {
  SpherePoints points;
  for (const auto& p : support::global_grid(5)) points.push_back(Direction::from(p));
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 3);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  const Field field = SphereLinear(t, values).grid(globe_grid(globe, Spacing{5, 5}));
  ASSERT_EQ(field.grid.x.size, 72);
  ASSERT_EQ(field.grid.y.size, 37);
  for (std::size_t j = 0; j < 37; ++j) {
    for (std::size_t i = 0; i < 72; ++i) {
      const std::size_t row = 73 * j + i;
      EXPECT_TRUE(support::is_same(field.values[72 * j + i],
                                   merged[static_cast<std::size_t>(t->sites()[row])]));
    }
  }
}

TEST(SphereGrid, FinerThanAGlobalGridOfDataMissesNoNode) {
  SpherePoints points;
  for (const auto& p : support::global_grid(15)) points.push_back(Direction::from(p));
  const SphereLinear surface(triangulated(points), random_values(points.size(), 4));
  const Grid grid = globe_grid(globe, Spacing{2.5, 2.5});
  EXPECT_EQ(support::count_missing(surface.grid(grid).values), 0u);
  expect_grid_as_points(surface, grid);
}

TEST(SphereGrid, GivesAPoleOneValueWhateverTheLongitude) {
  const SpherePoints points = support::uniform_directions(100, 5);
  const SphereLinear surface(triangulated(points), random_values(100, 6));
  const std::vector<double> values =
      surface.grid(globe_grid(globe, Spacing{10, 10})).values;
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_EQ(values[i], surface.value(at_lonlat(0, -90)));
    EXPECT_EQ(values[values.size() - 1 - i], surface.value(at_lonlat(0, 90)));
  }
}

TEST(SphereGrid, DoesNotDependOnTheWrapOfLongitudes) {
  const SpherePoints points = support::uniform_directions(200, 7);
  const SphereLinear surface(triangulated(points), random_values(200, 8));
  const std::vector<double> west =
      surface.grid(globe_grid({-180, 180, -90, 90}, Spacing{10, 10})).values;
  const std::vector<double> east =
      surface.grid(globe_grid({0, 360, -90, 90}, Spacing{10, 10})).values;
  for (std::size_t j = 0; j < 19; ++j) {
    for (std::size_t i = 0; i < 36; ++i)
      EXPECT_EQ(west[36 * j + i], east[36 * j + (i + 18) % 36]);
  }
}

TEST(SphereGrid, MayShowAMeridianTwice) {
  const SpherePoints points = support::uniform_directions(200, 9);
  const SphereLinear surface(triangulated(points), random_values(200, 10));
  const Grid grid{{.spacing = 10, .size = 40},
                  {.spacing = 10, .first_step = -9, .size = 19}};
  const std::vector<double> values = surface.grid(grid).values;
  EXPECT_EQ(support::count_missing(values), 0u);
  for (std::size_t j = 0; j < 19; ++j) {
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(values[40 * j + i], values[40 * j + 36 + i]);
  }
}

TEST(SphereGrid, OfOneTriangleAroundAPoleOrAcrossTheDateLine) {
  const std::vector<double> values{1, 2, 4};
  const SpherePoints polar{at_lonlat(10, 70), at_lonlat(130, 60), at_lonlat(250, 80)};
  expect_grid_as_points(SphereLinear(triangulated(polar), values),
                        globe_grid(globe, Spacing{3, 1}));
  const SpherePoints southern{at_lonlat(10, -1), at_lonlat(130, -1), at_lonlat(250, -1)};
  expect_grid_as_points(SphereLinear(triangulated(southern), values),
                        globe_grid(globe, Spacing{3, 1}));
  const SpherePoints dateline{at_lonlat(170, -20), at_lonlat(-160, 0),
                              at_lonlat(175, 30)};
  expect_grid_as_points(SphereLinear(triangulated(dateline), values),
                        globe_grid({150, 210, -40, 40}, Spacing{1, 1}));
  expect_grid_as_points(SphereLinear(triangulated(dateline), values),
                        globe_grid(globe, Spacing{1, 1}));
}

TEST(SphereGrid, HoldsBothEndsOfARowThatAnEdgeBulgesInto) {
  // The edge along 60 N reaches 73.9 N halfway; the rows between hold the triangle in two
  // pieces.
  const SpherePoints points{at_lonlat(-60, 60), at_lonlat(60, 60), at_lonlat(180, 60)};
  const SphereLinear surface(triangulated(points), std::vector<double>{1, 2, 3});
  const Grid grid = globe_grid({-180, 180, 55, 90}, Spacing{1, 1});
  expect_grid_as_points(surface, grid);
  const std::vector<double> row =
      surface.grid({grid.x, {.first_step = 70, .size = 1}}).values;
  int pieces = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    pieces += std::isnan(row[i]) && !std::isnan(row[(i + 1) % row.size()]);
  }
  EXPECT_EQ(pieces, 3);
}

TEST(SphereGrid, AlongTheEquatorDecidesNodesOnEdgesExactly) {
  const SpherePoints points{at_lonlat(0, 0), at_lonlat(100, 0), at_lonlat(50, 40),
                            at_lonlat(50, -40)};
  const SphereLinear surface(triangulated(points), std::vector<double>{1, 2, 3, 4});
  expect_grid_as_points(surface, globe_grid({-20, 120, -50, 50}, Spacing{0.5, 0.5}));
  const SpherePoints north{at_lonlat(0, 0), at_lonlat(100, 0), at_lonlat(50, 40)};
  const SphereLinear half(triangulated(north), std::vector<double>{1, 2, 3});
  const std::vector<double> row =
      half.grid({{.spacing = 1, .size = 101}, {.size = 1}}).values;
  EXPECT_EQ(support::count_missing(row), 0u);
}

TEST(SphereGrid, OfTinyBoxesEqualsPointEvaluation) {
  for (const double side : {1e-6, 1e-9}) {
    const SpherePoints points = support::box_directions(60, 11, side);
    const auto t = triangulated(points);
    expect_grid_as_points(SphereLinear(t, random_values(60, 12)),
                          globe_grid(covering_region(*t), NodeCounts{25, 25}));
  }
}

TEST(SphereGrid, AroundThePoleAtMicrodegreesEqualsPointEvaluation) {
  SpherePoints points;
  support::SplitMix64 random(13);
  for (int i = 0; i < 40; ++i)
    points.push_back(at_lonlat(random.between(-180, 180), 90 - 1e-6 * random.uniform()));
  const SphereLinear surface(triangulated(points), random_values(40, 14));
  expect_grid_as_points(surface,
                        globe_grid({-180, 180, 90 - 1e-6, 90}, NodeCounts{36, 30}));
}

TEST(SphereGrid, OfPointsOnAGreatCircleHasTheNodesOnIt) {
  const SpherePoints points{at_lonlat(0, 0), at_lonlat(40, 0)};
  const SphereLinear surface(triangulated(points), std::vector<double>{0, 4});
  expect_grid_as_points(surface, globe_grid({-10, 50, -10, 10}, Spacing{10, 10}));
}

TEST(SphereGrid, RefusesLatitudesBeyondThePoles) {
  const SphereLinear surface(triangulated(SpherePoints{at_lonlat(0, 0)}),
                             std::vector<double>{1});
  EXPECT_THROW((void)surface.grid({{.size = 3}, {.first_step = 89, .size = 3}}), Error);
  EXPECT_THROW((void)surface.grid(Grid{}), Error);
}

TEST(CircleGaps, AreWhatTheArcsLeave) {
  CircleGaps gaps(360);
  EXPECT_TRUE(gaps.is_whole_circle());
  gaps.exclude(-10, 20);  // 330 .. 10
  gaps.exclude(100, 10);  // 90 .. 110
  gaps.exclude(465, 10);  // 95 .. 115
  std::vector<std::pair<double, double>> found;
  gaps.for_each_gap(0, [&](double begin, double end) { found.emplace_back(begin, end); });
  EXPECT_EQ(found, (std::vector<std::pair<double, double>>{
                       {115, 330}, {370, 450}}));  // 370 is 10, one turn on
}

TEST(CircleGaps, OfArcsThatCoverTheCircleAreNone) {
  CircleGaps gaps(360);
  gaps.exclude(0, 100);
  gaps.exclude(180, 100);
  int count = 0;
  gaps.for_each_gap(0, [&](double, double) { ++count; });
  EXPECT_EQ(count, 0);
}

TEST(CircleGaps, OfArcsThatTouchAreOnesOfNoLength) {
  CircleGaps gaps(360);
  gaps.exclude(90, 90);
  gaps.exclude(270, 90);
  std::vector<double> lengths;
  gaps.for_each_gap(1e-9,
                    [&](double begin, double end) { lengths.push_back(end - begin); });
  EXPECT_EQ(lengths, (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace delone::interp
