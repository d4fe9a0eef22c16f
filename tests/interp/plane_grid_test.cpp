#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "delaunay/error.hpp"
#include "interp/linear_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::PlanePoints;
using support::random_values;
using support::triangulated;
using tripack::Point2;

// Every node as value() has it, bit for bit; whatever the number of threads.
void expect_grid_as_points(const PlaneLinear& surface, const Grid& grid) {
  const std::vector<double> values =
      surface.grid(grid, {.num_threads = 1, .progress = {}}).values;
  const PlanePoints nodes = plane_nodes(grid);
  const std::vector<double> expected = surface.values(nodes);
  const std::size_t i = support::first_difference(values, expected);
  ASSERT_EQ(i, nodes.size()) << "node " << nodes[i].x << ' ' << nodes[i].y << ": "
                             << values[i] << " instead of " << expected[i];
  const std::vector<double> threaded =
      surface.grid(grid, {.num_threads = 4, .progress = {}}).values;
  EXPECT_EQ(support::first_difference(threaded, values), nodes.size());
}

class PlaneGridOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneGridOnSets, EqualsPointEvaluationAtEveryNode) {
  const PlanePoints points = GetParam().make(300, 1);
  const auto t = triangulated(points);
  const Region hull = support::region_of(*t);
  const std::vector<double> values = random_values(points.size(), 2);
  for (const Outside outside : {Outside::missing, Outside::nearest, Outside::linear}) {
    const PlaneLinear surface(t, values, {.outside = outside});
    expect_grid_as_points(surface, plane_grid(hull, NodeCounts{37, 41}));
    expect_grid_as_points(surface, plane_grid(hull, NodeCounts{3, 2}));
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneGridOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(PlaneGrid, OnTheLatticeOfTheDataHasTheDataBitForBit) {
  const PlanePoints points = support::shuffled(support::lattice_points(900), 1);
  const std::vector<double> values = random_values(points.size(), 2);
  const PlaneLinear surface(triangulated(points), values);
  const Field field = surface.grid(plane_grid({0, 29, 0, 29}, Spacing{1, 1}));
  ASSERT_EQ(field.values.size(), points.size());
  for (std::size_t row = 0; row < points.size(); ++row) {
    const auto node = static_cast<std::size_t>(points[row].y * 30 + points[row].x);
    EXPECT_TRUE(support::is_same(field.values[node], values[row]));
  }
}

TEST(PlaneGrid, FinerThanTheLatticeOfTheDataMissesNoNodeOnEdges) {
  const PlanePoints points = support::lattice_points(400);
  const PlaneLinear surface(triangulated(points), random_values(points.size(), 3));
  const Grid grid = plane_grid({0, 19, 0, 19}, Spacing{0.25, 0.25});
  EXPECT_EQ(support::count_missing(surface.grid(grid).values), 0u);
  expect_grid_as_points(surface, grid);
}

TEST(PlaneGrid, OfDecimalCoordinatesHitsTheData) {
  PlanePoints points;
  for (const double x : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}) {
    for (const double y : {-0.3, -0.2, -0.1, 0.0}) points.push_back({x, y});
  }
  const std::vector<double> values = random_values(points.size(), 4);
  const PlaneLinear surface(triangulated(points), values);
  const Field field = surface.grid(plane_grid({0.1, 0.7, -0.3, 0}, Spacing{0.1, 0.1}));
  ASSERT_EQ(field.grid.x.size, 7);
  ASSERT_EQ(field.grid.y.size, 4);
  for (std::size_t row = 0; row < points.size(); ++row) {
    EXPECT_EQ(field.values[(row % 4) * 7 + row / 4], values[row]) << row;
  }
}

TEST(PlaneGrid, WiderThanTheDataFollowsTheOutsidePolicy) {
  const PlanePoints points = support::uniform_points(200, 5);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(200, 6);
  const Grid grid = plane_grid({-1, 2, -1, 2}, NodeCounts{61, 61});
  for (const Outside outside : {Outside::missing, Outside::nearest, Outside::linear}) {
    const PlaneLinear surface(t, values, {.outside = outside});
    expect_grid_as_points(surface, grid);
    const std::size_t missing = support::count_missing(surface.grid(grid).values);
    if (outside == Outside::missing) {
      EXPECT_GT(missing, 61u * 61u * 8 / 10);
    } else {
      EXPECT_EQ(missing, 0u);
    }
  }
}

TEST(PlaneGrid, FarFromTheOriginAndFineEqualsPointEvaluation) {
  PlanePoints points = support::uniform_points(300, 7);
  for (Point2& p : points) p = {5.1e6 + p.x, 7.5e6 + p.y};
  const PlaneLinear surface(triangulated(points), random_values(300, 8));
  expect_grid_as_points(
      surface, plane_grid({5.1e6, 5.1e6 + 1, 7.5e6, 7.5e6 + 1}, NodeCounts{200, 200}));
  // Steps of a few units in the last place, so that several nodes coincide.
  const Grid tiny =
      plane_grid({5.1e6 + 0.5, 5.1e6 + 0.5 + 1e-8, 7.5e6 + 0.5, 7.5e6 + 0.5 + 1e-8},
                 NodeCounts{40, 40});
  expect_grid_as_points(surface, tiny);
}

TEST(PlaneGrid, OfOneNodeAndOfOneRow) {
  const PlanePoints points{{0, 0}, {2, 0}, {0, 2}};
  const PlaneLinear surface(triangulated(points), std::vector<double>{0, 2, 4});
  EXPECT_EQ(surface.grid(plane_grid({0.5, 0.5, 0.5, 0.5}, NodeCounts{1, 1})).values,
            std::vector<double>{1.5});
  EXPECT_EQ(surface.grid(plane_grid({0, 2, 0, 0}, NodeCounts{3, 1})).values,
            (std::vector<double>{0, 1, 2}));
}

TEST(PlaneGrid, OfCollinearPointsHasTheNodesOnTheirLine) {
  const PlanePoints points{{0, 0}, {4, 4}};
  const PlaneLinear surface(triangulated(points), std::vector<double>{0, 4});
  const std::vector<double> values =
      surface.grid(plane_grid({0, 4, 0, 4}, Spacing{1, 1})).values;
  for (std::size_t j = 0; j < 5; ++j) {
    for (std::size_t i = 0; i < 5; ++i) {
      if (i == j) {
        EXPECT_EQ(values[5 * j + i], static_cast<double>(i));
      } else {
        EXPECT_TRUE(std::isnan(values[5 * j + i]));
      }
    }
  }
}

TEST(PlaneGrid, AtTheEndsOfTheRangeOfDoublesEqualsPointEvaluation) {
  const double large = 1e308;
  const PlanePoints points{{-large, -large}, {large, -large}, {0, large}, {1, 1}};
  const PlaneLinear surface(triangulated(points), random_values(4, 9));
  expect_grid_as_points(
      surface,
      plane_grid({-large / 2, large / 2, -large / 2, large / 2}, NodeCounts{9, 9}));
}

TEST(PlaneGrid, RefusesGridsWithoutNodesOrDirection) {
  const PlaneLinear surface(triangulated(PlanePoints{{0, 0}, {1, 0}, {0, 1}}),
                            std::vector<double>{1, 2, 3});
  EXPECT_THROW((void)surface.grid(Grid{}), Error);
  const Axis up{.size = 3}, down{.spacing = -1, .size = 3},
      nowhere{.spacing = std::nan(""), .size = 3};
  EXPECT_THROW((void)surface.grid({down, up}), Error);
  EXPECT_THROW((void)surface.grid({up, nowhere}), Error);
  EXPECT_NO_THROW((void)surface.grid({up, up}));
}

}  // namespace
}  // namespace delone::interp
