// The order of angles against exact rationals, over all families; the ellipsoid against
// looking at everything.

#include "stripack/neighbor_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/distance_order.hpp"
#include "support/exact_distance.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::SphereFamily;
using support::SpherePoints;

// All nodes in exact order, ties by x, y, z.
std::vector<Node> sorted_nodes(const Triangulation& t, const Direction& p) {
  const auto at = [&](Node row) -> const Direction& {
    return t.points()[static_cast<std::size_t>(t.sites()[static_cast<std::size_t>(row)])];
  };
  std::vector<Node> nodes(t.rows().begin(), t.rows().end());
  std::sort(nodes.begin(), nodes.end(), [&](Node a, Node b) {
    const int order = support::exact_compare_distances(p, at(a), at(b));
    if (order != 0) return order < 0;
    return std::array{at(a).x(), at(a).y(), at(a).z()} <
           std::array{at(b).x(), at(b).y(), at(b).z()};
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

Direction opposite(const Direction& d) { return Direction::from(-d.x(), -d.y(), -d.z()); }

// Nodes and their opposites, points between, the axes (ties), and a few anywhere.
SpherePoints queries_for(const SpherePoints& points) {
  SpherePoints queries;
  const std::size_t step = points.size() / 5 + 1;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Direction &a = points[i], &b = points[(i + 1) % points.size()];
    queries.push_back(a);
    queries.push_back(opposite(a));
    if (!(a == opposite(b)))
      queries.push_back(Direction::from(a.x() + b.x(), a.y() + b.y(), a.z() + b.z()));
  }
  queries.push_back(Direction::from(1, 0, 0));
  queries.push_back(Direction::from(0, -1, 0));
  queries.push_back(Direction::from(0, 0, 1));
  queries.push_back(Direction::from(0, 0, -1));
  for (const Direction& d : support::uniform_directions(4, 11)) queries.push_back(d);
  return queries;
}

class SphereNeighbors : public testing::TestWithParam<SphereFamily> {};

// Also what lies in the northern hemisphere only, which has neighbours through the
// outside.
template <class F>
void for_each_query(const SphereFamily& family, F check) {
  for (const std::size_t n : {1, 2, 3, 4, 9, 40}) {
    for (const bool is_half : {false, true}) {
      SpherePoints points = family.make(n, 3);
      if (is_half) std::erase_if(points, [](const Direction& d) { return d.z() < 0; });
      if (points.empty()) continue;
      const Triangulation t(points);
      for (const Direction& p : queries_for(points)) {
        SCOPED_TRACE("n = " + std::to_string(points.size()) + ", query " +
                     std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                     std::to_string(p.z()));
        check(t, p);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST_P(SphereNeighbors, NearestKAreTheFirstOfAllNodesInExactOrder) {
  for_each_query(GetParam(), [](const Triangulation& t, const Direction& p) {
    const std::vector<Node> expected = sorted_nodes(t, p);
    for (const int k : {1, 2, 8, 24, 25, 1000}) {
      const Node hint = k % 2 == 0 ? delaunay::none : t.num_rows() - 1;
      EXPECT_EQ(rows_of(nearest_k(t, p, k, hint)),
                first(expected, static_cast<std::size_t>(k)))
          << "k = " << k;
    }
    EXPECT_EQ(nearest_exact(t, p), expected[0]);
  });
}

TEST_P(SphereNeighbors, OneAfterTheOtherIsTheSameOrder) {
  for_each_query(GetParam(), [](const Triangulation& t, const Direction& p) {
    NearestNodes nodes(t);
    nodes.start(p);
    std::vector<Node> rows;
    for (auto n = nodes.next(); n; n = nodes.next()) rows.push_back(n->row);
    EXPECT_EQ(rows, sorted_nodes(t, p));
  });
}

TEST_P(SphereNeighbors, WithinARadiusAreTheFirstOfAllThatNearestGives) {
  for_each_query(GetParam(), [](const Triangulation& t, const Direction& p) {
    const auto all = nearest_k(t, p, t.num_sites());
    for (const double radius : {0.0, all[all.size() / 2].distance, 2.0, 4.0}) {
      const auto found = nodes_within(t, p, radius);
      const auto end = std::ranges::upper_bound(all, radius, {}, &Neighbor::distance);
      EXPECT_EQ(found, std::vector<Neighbor>(all.begin(), end)) << radius;
    }
  });
}

TEST_P(SphereNeighbors, OnTheEllipsoidAreTheFirstOfAllGeodesics) {
  for (const bool is_half : {false, true}) {
    SpherePoints points = GetParam().make(50, 4);
    if (is_half) std::erase_if(points, [](const Direction& d) { return d.x() < 0; });
    if (points.empty()) continue;
    const Triangulation t(points);
    for (const Direction& p : queries_for(points)) {
      std::vector<double> expected;
      for (const Direction& q : t.points())
        expected.push_back(geodesic_km(lonlat(p), lonlat(q)));
      std::ranges::sort(expected);
      const auto found = nearest_k_wgs84(t, p, 9);
      ASSERT_EQ(found.size(), std::min<std::size_t>(9, expected.size()));
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i].distance, expected[i]) << i;
      const double radius = expected[expected.size() / 3];
      EXPECT_EQ(std::ssize(nodes_within_wgs84(t, p, radius)),
                std::ranges::upper_bound(expected, radius) - expected.begin());
    }
  }
}

TEST_P(SphereNeighbors, ManyAtOnceAreTheSameOnEveryNumberOfThreads) {
  const SpherePoints points = GetParam().make(300, 2);
  const Triangulation t(points);
  SpherePoints queries;
  for (int i = 0; i < 100; ++i) {
    for (const Direction& p : queries_for(points)) queries.push_back(p);
  }
  for (const int k : {1, 6}) {
    const NeighborTable table =
        nearest_k(t, queries, k, {.num_threads = 1, .progress = {}});
    EXPECT_TRUE(table == nearest_k(t, queries, k, {.num_threads = 3, .progress = {}}));
    for (std::size_t i = 0; i < queries.size(); i += 131) {
      const auto expected = nearest_k(t, queries[i], k);
      EXPECT_TRUE(
          std::ranges::equal(table.rows_of(static_cast<int>(i)), rows_of(expected)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereNeighbors,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(SphereCompareDistances, AgreesWithExactRationalsWhereRoundingDoesNot) {
  support::SplitMix64 random(4);
  int num_certain = 0, num_ties = 0;
  for (int i = 0; i < 2000; ++i) {
    const Direction p = support::uniform_directions(1, random.next())[0];
    const Direction a = support::uniform_directions(1, random.next())[0];
    // a mirrored in the plane of p and an axis, nearly; and the same ray a bit longer.
    const double nudge = static_cast<double>(random.below(3)) * 0x1p-53;
    const Direction b = random.below(2) == 0
                            ? Direction::from(a.x() + nudge, a.y() - nudge, a.z())
                            : Direction::from(-a.x(), a.y(), a.z());
    const Direction q = random.below(2) == 0 ? p : Direction::from(0, p.y(), p.z());
    const int expected = support::exact_compare_distances(q, a, b);
    EXPECT_EQ(compare_distances(q, a, b), (expected > 0) - (expected < 0));
    EXPECT_EQ(compare_distances(q, b, a), (expected < 0) - (expected > 0));
    const int certain =
        compare_distances_filter(squared_chord(q, a), squared_chord(q, b));
    num_certain += certain != 0 ? 1 : 0;
    num_ties += expected == 0 ? 1 : 0;
    if (certain != 0) {
      EXPECT_EQ(certain, (expected > 0) - (expected < 0));
    }
  }
  EXPECT_GT(num_ties, 100);
  EXPECT_GT(num_certain, 100);
  EXPECT_LT(num_certain, 1900);
}

TEST(SphereNeighbors, DistancesAreAnglesAndNeverDecrease) {
  const SpherePoints points = support::uniform_directions(300, 1);
  const Triangulation t(points);
  for (const Direction& p : support::uniform_directions(20, 2)) {
    const auto all = nearest_k(t, p, 300);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_NEAR(all[i].distance, angle(p, points[static_cast<std::size_t>(all[i].row)]),
                  1e-15);
      if (i > 0) {
        EXPECT_GE(all[i].distance, all[i - 1].distance);
      }
    }
  }
}

TEST(SphereNeighbors, OfTheNodesThemselvesLeaveOutTheNodeAndServeRepeatedRows) {
  SpherePoints points;
  for (const LonLat p : support::global_grid(30)) points.push_back(Direction::from(p));
  const Triangulation t(points);
  const NeighborTable table = nearest_k_of_nodes(t, 4);
  ASSERT_EQ(table.num_queries(), std::ssize(points));
  for (Node row = 0; row < t.num_rows(); ++row) {
    auto expected = rows_of(nearest_k(t, points[static_cast<std::size_t>(row)], 5));
    expected.erase(expected.begin());
    EXPECT_TRUE(std::ranges::equal(table.rows_of(row), expected)) << row;
  }
}

// Flattening is 1 / 298: the order of angles and of geodesics differ.
TEST(SphereNeighbors, TheEllipsoidHasAnOrderOfItsOwn) {
  const Direction p = Direction::from(LonLat{0, 0});
  const SpherePoints points{Direction::from(LonLat{10, 0}),
                            Direction::from(LonLat{0, 10.01}),
                            Direction::from(LonLat{-20, 0})};
  const Triangulation t(points);
  EXPECT_EQ(rows_of(nearest_k(t, p, 2)), (std::vector<Node>{0, 1}));
  const auto found = nearest_k_wgs84(t, p, 2);
  EXPECT_EQ(rows_of(found), (std::vector<Node>{1, 0}));
  EXPECT_NEAR(found[1].distance, 10 * std::numbers::pi / 180 * 6378.137, 1e-9);
  const NeighborTable table = nearest_k_wgs84(t, SpherePoints{p, p}, 2);
  EXPECT_TRUE(std::ranges::equal(table.rows_of(1), rows_of(found)));
  EXPECT_EQ(nodes_within_wgs84(t, SpherePoints{p, p}, 1110.0).rows_of(0).size(), 1u);
}

TEST(SphereNeighbors, NoNodesHaveNoNeighborsAndNonsenseIsRefused) {
  const Triangulation none;
  const Direction p;
  EXPECT_TRUE(nearest_k(none, p, 3).empty());
  EXPECT_TRUE(nearest_k_wgs84(none, p, 3).empty());
  EXPECT_EQ(nearest_exact(none, p), delaunay::none);
  EXPECT_EQ(nodes_within(none, SpherePoints{p}, 1).num_queries(), 1);
  const Triangulation t(SpherePoints{p});
  EXPECT_THROW(static_cast<void>(nearest_k(t, p, -2)), Error);
  EXPECT_THROW(static_cast<void>(nearest_k_wgs84(t, p, 0)), Error);
  EXPECT_THROW(static_cast<void>(nodes_within(t, p, -1e-9)), Error);
  EXPECT_THROW(static_cast<void>(
                   nodes_within_wgs84(t, p, std::numeric_limits<double>::quiet_NaN())),
               Error);
}

}  // namespace
}  // namespace delone::stripack
