// The order of distances against exact rationals, over all families.

#include "tripack/neighbor_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "support/exact_distance.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/distance_order.hpp"

namespace delone::tripack {
namespace {

using support::PlaneFamily;
using support::PlanePoints;

int sign(int value) { return static_cast<int>(value > 0) - static_cast<int>(value < 0); }

// All nodes in exact order, ties by x, then y.
std::vector<Node> sorted_nodes(const PlanePoints& points, const Triangulation& t,
                               Point2 p) {
  std::vector<Node> nodes(t.rows().begin(), t.rows().end());
  std::sort(nodes.begin(), nodes.end(), [&](Node a, Node b) {
    const Point2 u = points[static_cast<std::size_t>(a)],
                 v = points[static_cast<std::size_t>(b)];
    const int order = support::exact_compare_distances(p, u, v);
    return order != 0 ? order < 0 : (u.x != v.x ? u.x < v.x : u.y < v.y);
  });
  return nodes;
}

std::vector<Node> rows_of(const std::vector<Neighbor>& neighbors) {
  std::vector<Node> rows;
  for (const Neighbor& n : neighbors) rows.push_back(n.row);
  return rows;
}

std::vector<Node> first(std::vector<Node> nodes, std::size_t k) {
  nodes.resize(std::min(k, nodes.size()));
  return nodes;
}

// Nodes, midpoints, centres of fours (ties), and points beyond.
PlanePoints queries_for(const PlanePoints& points) {
  PlanePoints queries;
  const std::size_t step = points.size() / 6 + 1;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Point2 a = points[i], b = points[(i + 1) % points.size()],
                 c = points[(i + 7) % points.size()];
    queries.push_back(a);
    queries.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
    queries.push_back({a.x / 2 + c.x / 2, b.y / 2 + c.y / 2});
    queries.push_back({3 * (c.x / 4), -(a.y / 2)});
  }
  queries.push_back({0, 0});
  return queries;
}

class PlaneNeighbors : public testing::TestWithParam<PlaneFamily> {};

template <class F>
void for_each_query(const PlaneFamily& family, F check) {
  for (const std::size_t n : {1, 2, 3, 4, 9, 40}) {
    const PlanePoints points = family.make(n, 3);
    if (points.empty()) continue;
    const Triangulation t(points);
    for (const Point2 p : queries_for(points)) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", query " + std::to_string(p.x) + " " +
                   std::to_string(p.y));
      check(points, t, p);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST_P(PlaneNeighbors, NearestKAreTheFirstOfAllNodesInExactOrder) {
  for_each_query(GetParam(),
                 [](const PlanePoints& points, const Triangulation& t, Point2 p) {
                   const std::vector<Node> expected = sorted_nodes(points, t, p);
                   for (const int k : {1, 2, 8, 24, 25, 1000}) {
                     const Node hint = k % 2 == 0 ? delaunay::none : t.num_rows() - 1;
                     EXPECT_EQ(rows_of(nearest_k(t, p, k, hint)),
                               first(expected, static_cast<std::size_t>(k)))
                         << "k = " << k;
                   }
                   EXPECT_EQ(nearest_exact(t, p), expected[0]);
                 });
}

TEST_P(PlaneNeighbors, OneAfterTheOtherIsTheSameOrder) {
  for_each_query(GetParam(),
                 [](const PlanePoints& points, const Triangulation& t, Point2 p) {
                   NearestNodes nodes(t);
                   nodes.start({7, 7});
                   nodes.start(p);
                   std::vector<Node> rows;
                   for (auto n = nodes.next(); n; n = nodes.next())
                     rows.push_back(n->row);
                   EXPECT_EQ(rows, sorted_nodes(points, t, p));
                 });
}

TEST_P(PlaneNeighbors, WithinARadiusAreExactlyThoseOfTheClosedCircle) {
  for_each_query(
      GetParam(), [](const PlanePoints& points, const Triangulation& t, Point2 p) {
        const std::vector<Node> all = sorted_nodes(points, t, p);
        // Through a node, so that the circle's edge decides.
        const double radius =
            distance(p, points[static_cast<std::size_t>(all[all.size() / 2])]);
        std::vector<Node> expected;
        for (const Node row : all) {
          if (support::exact_is_within(p, points[static_cast<std::size_t>(row)], radius))
            expected.push_back(row);
        }
        EXPECT_EQ(rows_of(nodes_within(t, p, radius)), expected);
      });
}

TEST_P(PlaneNeighbors, DoNotDependOnTheOrderOfRows) {
  const PlanePoints points = GetParam().make(70, 5);
  const PlanePoints mixed = support::shuffled(points, 9);
  const Triangulation t(points), u(mixed);
  for (const Point2 p : queries_for(points)) {
    const auto a = nearest_k(t, p, 9), b = nearest_k(u, p, 9);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(points[static_cast<std::size_t>(a[i].row)],
                mixed[static_cast<std::size_t>(b[i].row)]);
      EXPECT_EQ(a[i].distance, b[i].distance);
    }
  }
}

TEST_P(PlaneNeighbors, ManyAtOnceAreTheSameOnEveryNumberOfThreads) {
  const PlanePoints points = GetParam().make(300, 2);
  const Triangulation t(points);
  PlanePoints queries;
  for (int i = 0; i < 40; ++i) {
    for (const Point2 p : queries_for(points)) queries.push_back(p);
  }
  for (const int k : {1, 6, 40}) {
    const NeighborTable table =
        nearest_k(t, queries, k, {.num_threads = 1, .progress = {}});
    EXPECT_TRUE(table == nearest_k(t, queries, k, {.num_threads = 3, .progress = {}}));
    ASSERT_EQ(table.num_queries(), std::ssize(queries));
    for (std::size_t i = 0; i < queries.size(); i += 13) {
      const auto expected = nearest_k(t, queries[i], k);
      EXPECT_TRUE(
          std::ranges::equal(table.rows_of(static_cast<int>(i)), rows_of(expected)));
      EXPECT_EQ(table.distances_of(static_cast<int>(i)).back(), expected.back().distance);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneNeighbors,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(CompareDistances, AgreesWithExactRationalsWhereRoundingDoesNot) {
  support::SplitMix64 random(4);
  int num_ties = 0, num_close = 0;
  for (int i = 0; i < 3000; ++i) {
    // Directions of equal length times powers of two, moved by a few ulps.
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(2000)) - 1000);
    const auto nudge = [&](double v) {
      return v * scale * (1 + static_cast<double>(random.below(3)) * 0x1p-52);
    };
    const Point2 p{scale * static_cast<double>(random.below(4)), 0};
    const Point2 a{nudge(3), nudge(4)}, b{nudge(-4), nudge(3)};
    const int expected = sign(support::exact_compare_distances(p, a, b));
    EXPECT_EQ(compare_distances(p, a, b), expected);
    EXPECT_EQ(compare_distances(p, b, a), -expected);
    num_ties += expected == 0 ? 1 : 0;
    num_close += expected != 0 && p.x == 0 ? 1 : 0;
  }
  EXPECT_GT(num_ties, 20);
  EXPECT_GT(num_close, 200);
}

TEST(PlaneNeighbors, OverflowAndUnderflowDoNotChangeTheOrder) {
  for (const double scale : {1e-320, 1e-300, 1.0, 1e300}) {
    PlanePoints points;
    for (int i = 0; i < 40; ++i)
      points.push_back({scale * ((i * 37) % 41), scale * ((i * 17) % 43)});
    const Triangulation t(points);
    for (int i = 0; i < 20; ++i) {
      const Point2 p{scale * i, scale * ((i * 29) % 31)};
      EXPECT_EQ(rows_of(nearest_k(t, p, 40)), sorted_nodes(points, t, p)) << scale;
    }
  }
}

TEST(PlaneNeighbors, DistancesNeverDecreaseAndAreEuclidean) {
  const PlanePoints points = support::uniform_points(500, 1);
  const Triangulation t(points);
  for (const Point2 p : support::uniform_points(50, 2)) {
    const auto all = nearest_k(t, p, 500);
    ASSERT_EQ(all.size(), 500u);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Point2 q = points[static_cast<std::size_t>(all[i].row)];
      EXPECT_NEAR(all[i].distance, std::hypot(p.x - q.x, p.y - q.y),
                  4e-16 * all[i].distance);
      if (i > 0) {
        EXPECT_GE(all[i].distance, all[i - 1].distance);
      }
    }
  }
}

TEST(PlaneNeighbors, OfTheNodesThemselvesLeaveOutTheNodeAndServeRepeatedRows) {
  PlanePoints points = support::lattice_points(49);
  points.push_back(points[10]);
  const Triangulation t(points);
  const NeighborTable table = nearest_k_of_nodes(t, 4);
  ASSERT_EQ(table.num_queries(), 50);
  for (Node row = 0; row < 50; ++row) {
    auto expected = rows_of(nearest_k(t, points[static_cast<std::size_t>(row)], 5));
    expected.erase(expected.begin());
    EXPECT_TRUE(std::ranges::equal(table.rows_of(row), expected)) << row;
  }
  EXPECT_TRUE(std::ranges::equal(table.rows_of(49), table.rows_of(10)));
  EXPECT_EQ(nearest_k_of_nodes(Triangulation(PlanePoints{{1, 1}}), 3).rows.size(), 0u);
}

TEST(PlaneNeighbors, ManyCirclesGiveWhatOneGives) {
  const PlanePoints points = support::clustered_points(400, 1);
  const Triangulation t(points);
  const PlanePoints queries = support::uniform_points(9000, 3);
  const NeighborTable table = nodes_within(t, queries, 0.02);
  EXPECT_TRUE(table ==
              nodes_within(t, queries, 0.02, {.num_threads = 1, .progress = {}}));
  std::size_t num_empty = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto expected = rows_of(nodes_within(t, queries[i], 0.02));
    const auto found = table.rows_of(static_cast<std::int64_t>(i));
    EXPECT_TRUE(std::ranges::equal(found, expected)) << i;
    num_empty += found.empty() ? 1 : 0;
  }
  EXPECT_GT(num_empty, 100u);
  EXPECT_LT(num_empty, 8900u);
}

TEST(PlaneNeighbors, NoNodesHaveNoNeighbors) {
  const Triangulation t;
  EXPECT_TRUE(nearest_k(t, {0, 0}, 3).empty());
  EXPECT_EQ(nearest_exact(t, {0, 0}), delaunay::none);
  EXPECT_TRUE(nodes_within(t, {0, 0}, 3).empty());
  const PlanePoints queries{{0, 0}, {1, 1}};
  EXPECT_EQ(nearest_k(t, queries, 3).num_queries(), 2);
  EXPECT_EQ(nodes_within(t, queries, 3).num_queries(), 2);
  EXPECT_EQ(nearest_k_of_nodes(t, 3).num_queries(), 0);
  NearestNodes nodes(t);
  nodes.start({0, 0});
  EXPECT_FALSE(nodes.next().has_value());
}

TEST(PlaneNeighbors, RefuseWhatCannotBe) {
  const Triangulation t(PlanePoints{{0, 0}, {1, 0}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(nearest_k(t, {0, 0}, 0)), Error);
  EXPECT_THROW(static_cast<void>(nearest_k(t, {nan, 0}, 1)), Error);
  EXPECT_THROW(static_cast<void>(nodes_within(t, {0, 0}, -1)), Error);
  EXPECT_THROW(static_cast<void>(nodes_within(t, {0, 0}, nan)), Error);
  const PlanePoints queries{{0, 0}, {0, HUGE_VAL}};
  try {
    static_cast<void>(nearest_k(t, queries, 1));
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.rows().size(), 1u);
    EXPECT_EQ(error.rows()[0], 1);
  }
  EXPECT_EQ(nodes_within(t, {0, 0}, HUGE_VAL).size(), 2u);
}

}  // namespace
}  // namespace delone::tripack
