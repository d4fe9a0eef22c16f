#include "stripack/visible_neighbors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/neighbor_search.hpp"
#include "stripack/path_oracle.hpp"
#include "stripack/predicates.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using oracle::index;
using oracle::never;
using oracle::Pair;
using oracle::PathOracle;
using oracle::pi;
using support::SpherePoints;
using support::SplitMix64;

Direction at(double lon, double lat) { return Direction::from(LonLat{lon, lat}); }

ConstrainedTriangulation with_walls(const SpherePoints& points, std::vector<Pair> walls) {
  return ConstrainedTriangulation({.points = points, .arcs = std::move(walls)},
                                  {.domain = Domain::hull});
}

std::vector<Node> nodes_of(const std::vector<PathNeighbor>& found) {
  std::vector<Node> nodes;
  for (const PathNeighbor& v : found) nodes.push_back(v.node);
  return nodes;
}

struct Tally {
  int walls = 0, pairs = 0, detours = 0, unreachable = 0, half_circles = 0, far = 0;
};

// Counts what the random sets hold, so that it is known what was tested.
Tally expect_shortest_paths(const SpherePoints& points, const std::vector<Pair>& walls) {
  Tally tally;
  const auto t = with_walls(points, walls);
  const PathOracle oracle(points, t.constraint_edges());
  for (Node from = 0; std::cmp_less(from, points.size()); ++from) {
    const std::vector<double> expected = oracle.distances(from);
    std::vector<double> found(points.size(), never);
    found[index(from)] = 0;
    double last = 0;
    for (const PathNeighbor& v :
         nearest_k_visible(t, from, static_cast<std::int32_t>(points.size()))) {
      EXPECT_EQ(found[index(v.node)], never);
      EXPECT_GE(v.distance, last);
      last = found[index(v.node)] = v.distance;
      const double direct = angle(points[index(from)], points[index(v.node)]);
      ++tally.pairs;
      if (v.distance > direct + 1e-9) ++tally.detours;
      if (v.distance > pi + 1e-9) ++tally.far;
      if (v.from == from && direct > 3.14159265) ++tally.half_circles;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (expected[i] == never) {
        ++tally.unreachable;
        EXPECT_EQ(found[i], never) << from << " to " << i;
      } else {
        EXPECT_NEAR(found[i], expected[i], 1e-9) << from << " to " << i;
      }
    }
  }
  return tally;
}

// As many of the pairs as cross no other.
std::vector<Pair> walls_between(const SpherePoints& points, std::size_t num_tries,
                                SplitMix64& random) {
  std::vector<Pair> walls;
  for (std::size_t i = 0; i < num_tries; ++i) {
    walls.push_back({static_cast<Node>(random.below(points.size())),
                     static_cast<Node>(random.below(points.size()))});
    try {
      static_cast<void>(with_walls(points, walls));
    } catch (const Error&) {
      walls.pop_back();
    }
  }
  return walls;
}

Tally expect_shortest_paths_of(int num_trials,
                               const std::function<SpherePoints(SplitMix64&)>& make) {
  SplitMix64 random(6);
  Tally sum;
  for (int trial = 0; trial < num_trials; ++trial) {
    SCOPED_TRACE(trial);
    const SpherePoints points = make(random);
    const auto walls = walls_between(points, 1 + random.below(10), random);
    const Tally tally = expect_shortest_paths(points, walls);
    sum.walls += static_cast<int>(walls.size());
    sum.pairs += tally.pairs;
    sum.detours += tally.detours;
    sum.unreachable += tally.unreachable;
    sum.half_circles += tally.half_circles;
    sum.far += tally.far;
    if (testing::Test::HasFailure()) break;
  }
  return sum;
}

// Of different points with coordinates in -side .. side; those in planes through many of
// them stay exactly there.
SpherePoints lattice(std::size_t n, int side, SplitMix64& random) {
  std::set<std::array<int, 3>> places;
  while (places.size() < n) {
    std::array<int, 3> p{};
    for (int& v : p)
      v = static_cast<int>(random.below(static_cast<std::size_t>(2 * side + 1))) - side;
    if (p != std::array{0, 0, 0}) places.insert(p);
  }
  SpherePoints points;
  for (const auto& [x, y, z] : places) {
    const Direction p = Direction::from(x, y, z);
    if (std::none_of(points.begin(), points.end(),
                     [&](const Direction& q) { return is_same_direction(p, q); }))
      points.push_back(p);
  }
  return points;
}

TEST(SphereVisibleNeighbors, GoRoundAWall) {
  const SpherePoints points{at(0, 0), at(20, 0), at(10, -12), at(10, 15), at(10, 40)};
  const auto found = nearest_k_visible(with_walls(points, {{2, 3}}), 0, 10);
  EXPECT_EQ(nodes_of(found), (std::vector<Node>{2, 3, 1, 4}));
  EXPECT_DOUBLE_EQ(found[2].distance, 2 * angle(points[0], points[2]));
  EXPECT_EQ(found[2].from, 2);
  EXPECT_EQ(found[3].from, 0);
}

TEST(SphereVisibleNeighbors, GoRoundTheFarSideWhereThatIsShorter) {
  // A meridian from pole to pole in two arcs; from one side of it to the other.
  const SpherePoints points{at(0, 90),  at(0, 0),   at(0, -90),
                            at(-50, 0), at(50, 10), at(180, 0)};
  const auto found = nearest_k_visible(with_walls(points, {{0, 1}, {1, 2}}), 3, 10);
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found[4].node, 4);
  EXPECT_EQ(found[4].from, 0);
  EXPECT_NEAR(found[4].distance, pi / 2 + 80 * pi / 180, 1e-15);
}

TEST(SphereVisibleNeighbors, TurnByNothingAtANodeWithAWallAndPassOneWithout) {
  // Sums of angles that round up and down.
  for (int lon = 1; lon < 40; ++lon) {
    const SpherePoints points{at(-lon, 0), at(0, 0), at(0.7 * lon, 0), at(0, 9),
                              at(0, -9)};
    for (const Node row : {0, 2}) {
      const auto from = [&](const std::vector<Pair>& walls) {
        const auto found = nearest_k_visible(with_walls(points, walls), row, 9);
        return std::ranges::find(found, 2 - row, &PathNeighbor::node)->from;
      };
      EXPECT_EQ(from({}), row);
      EXPECT_EQ(from({{1, 3}}), 1);
      EXPECT_EQ(from({{1, 4}}), 1);
    }
  }
}

TEST(SphereVisibleNeighbors, OppositeNodesSeeEachOtherAlongAnyFreeHalfCircle) {
  SpherePoints points{at(17, 35), at(-163, -35)};
  for (const Direction& p : support::uniform_directions(60, 2)) points.push_back(p);
  points[1] = Direction::from(-points[0].x(), -points[0].y(), -points[0].z());
  const auto found = nearest_k_visible(with_walls(points, {}), 0, 100);
  ASSERT_EQ(found.size(), 61U);
  EXPECT_EQ(found.back(), (PathNeighbor{1, angle(points[0], points[1]), 0}));
  EXPECT_DOUBLE_EQ(found.back().distance, pi);
}

TEST(SphereVisibleNeighbors, DoNotGetOutOfARingOnEitherSide) {
  // The region south of the ring is larger than a hemisphere.
  SpherePoints points{at(0, 90), at(0, -90), at(33, 0), at(-170, 10), at(100, 80)};
  std::vector<Pair> walls;
  for (Node i = 0; i < 6; ++i) {
    points.push_back(at(60 * i - 180, 50));
    walls.push_back({5 + i, 5 + (i + 1) % 6});
  }
  const auto t = with_walls(points, walls);
  EXPECT_EQ(nearest_k_visible(t, 0, 20).size(), 7U);
  EXPECT_EQ(nearest_k_visible(t, 1, 20).size(), 8U);
  EXPECT_EQ(nearest_k_visible(t, 5, 20).size(), 10U);
  expect_shortest_paths(points, walls);
}

TEST(SphereVisibleNeighbors, AreTheNearestNodesWithoutArcsOnTheWholeSphere) {
  for (const SpherePoints& points :
       {support::uniform_directions(300, 4), support::fibonacci_directions(300),
        support::box_directions(300, 5, 0.5), support::box_directions(200, 6, 1e-9),
        support::box_directions(200, 7, 3)}) {
    const auto t = with_walls(points, {});
    const Triangulation plain(points);
    const auto n = static_cast<Node>(points.size());
    for (Node row = 0; row < n; row += 37) {
      const auto found = nearest_k_visible(t, row, n);
      const auto expected = nearest_k(plain, points[index(row)], n, row);
      ASSERT_EQ(found.size() + 1, expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].distance, expected[i + 1].distance, 1e-15);
        EXPECT_EQ(found[i].from, row);
        EXPECT_EQ(found[i].distance,
                  angle(points[index(row)], points[index(found[i].node)]));
      }
    }
  }
}

TEST(SphereVisibleNeighbors, SeeAllOfEveryFamilyWithoutArcs) {
  for (const auto& family : support::sphere_families()) {
    const SpherePoints points = family.make(80, 3);
    if (points.empty()) continue;
    const auto t = with_walls(points, {});
    const auto found = nearest_k_visible(t, 0, 1000);
    EXPECT_EQ(found.size() + 1, t.rows().size()) << family.name;
    for (const PathNeighbor& v : found) {
      EXPECT_EQ(v.from, t.rows()[index(t.sites()[0])]) << family.name;
      EXPECT_NEAR(v.distance, angle(points[0], t.point(v.node)), 1e-15) << family.name;
    }
  }
}

TEST(SphereVisibleNeighbors, GoAlongAGreatCircleOfPoints) {
  const SpherePoints points{at(0, 0), at(90, 0), at(-170, 0), at(-60, 0), at(90, 0)};
  const auto found = nearest_k_visible(with_walls(points, {{0, 1}, {0, 3}}), 4, 9);
  EXPECT_EQ(nodes_of(found), (std::vector<Node>{0, 2, 3}));
  EXPECT_DOUBLE_EQ(found[1].distance, 100 * pi / 180);
  EXPECT_DOUBLE_EQ(found[2].distance, 150 * pi / 180);
}

TEST(SphereVisibleNeighbors, RefuseWhatIsNotThere) {
  const auto t = with_walls({at(0, 0), at(1, 0), at(0, 1)}, {});
  EXPECT_THROW(static_cast<void>(nearest_k_visible(t, 3, 1)), Error);
  EXPECT_THROW(static_cast<void>(nearest_k_visible(t, -1, 1)), Error);
  EXPECT_THROW(static_cast<void>(nearest_k_visible(t, 0, 0)), Error);
  VisibleNodes nodes(t);
  EXPECT_FALSE(nodes.next().has_value());
  nodes.start(0);
  EXPECT_TRUE(nodes.next().has_value());
}

TEST(SphereVisibleNeighbors, DoNotDependOnTheOrderOfRows) {
  SplitMix64 random(9);
  const SpherePoints points = support::uniform_directions(60, 8);
  const auto walls = walls_between(points, 40, random);
  const auto t = with_walls(points, walls);
  std::vector<Pair> reversed_walls;
  for (const Pair& w : walls) reversed_walls.push_back({59 - w[0], 59 - w[1]});
  const auto reversed =
      with_walls(SpherePoints(points.rbegin(), points.rend()), reversed_walls);
  for (Node row = 0; row < 60; ++row) {
    auto found = nearest_k_visible(reversed, 59 - row, 60);
    for (PathNeighbor& v : found) v = {59 - v.node, v.distance, 59 - v.from};
    EXPECT_EQ(nearest_k_visible(t, row, 60), found);
  }
}

// All over the sphere, where most arcs are long.
TEST(SphereVisibleNeighbors, AreThoseOfAllPathsBetweenPointsThatSeeEachOther) {
  const Tally tally = expect_shortest_paths_of(250, [](SplitMix64& random) {
    return support::uniform_directions(4 + random.below(8), random.next());
  });
  EXPECT_GT(tally.walls, 1200);
  EXPECT_GT(tally.detours, 1000);
  EXPECT_GT(tally.unreachable, 100);
  EXPECT_GT(tally.far, 10);
}

// Walls along lines of sight, through nodes, with common ends; opposite nodes; sets in a
// closed hemisphere, with nodes on its rim.
TEST(SphereVisibleNeighbors, AreThoseOfAllPathsOnLattices) {
  const Tally coarse = expect_shortest_paths_of(
      200, [](SplitMix64& random) { return lattice(3 + random.below(6), 1, random); });
  EXPECT_GT(coarse.half_circles, 30);
  EXPECT_GT(coarse.detours, 200);
  const Tally fine = expect_shortest_paths_of(
      60, [](SplitMix64& random) { return lattice(4 + random.below(5), 2, random); });
  EXPECT_GT(fine.detours, 100);
  const Tally upper = expect_shortest_paths_of(150, [](SplitMix64& random) {
    SpherePoints points;
    for (const Direction& p : lattice(10, 1, random)) {
      if (p.z() >= 0) points.push_back(p);
    }
    return points;
  });
  EXPECT_GT(upper.half_circles, 30);
  EXPECT_GT(upper.unreachable, 10);
}

TEST(SphereVisibleNeighbors, AreThoseOfAllPathsAtPolesAndTheDateLine) {
  const auto grid = [](double lon, double lat, double step) {
    return [=](SplitMix64& random) {
      std::set<std::array<double, 2>> places;
      const std::size_t n = 5 + random.below(6);
      while (places.size() < n) {
        places.insert({lon + step * static_cast<double>(random.below(5)),
                       lat + step * static_cast<double>(random.below(4))});
      }
      SpherePoints points;
      for (const auto& [x, y] : places) points.push_back(at(x, std::min(y, 90.0)));
      std::sort(points.begin(), points.end(), lexicographically_less);
      points.erase(std::unique(points.begin(), points.end()), points.end());
      return points;
    };
  };
  EXPECT_GT(expect_shortest_paths_of(50, grid(178, -2, 1)).detours, 300);
  EXPECT_GT(expect_shortest_paths_of(50, grid(0, 0, 30)).detours, 300);
  // All round the poles: meridians 72 degrees apart, and opposite parallels.
  EXPECT_GT(expect_shortest_paths_of(50, grid(0, 87, 1)).detours, 10);
  EXPECT_GT(expect_shortest_paths_of(
                200,
                [&](SplitMix64& random) {
                  std::set<std::array<int, 2>> places;
                  const std::size_t n = 5 + random.below(5);
                  while (places.size() < n) {
                    places.insert({static_cast<int>(random.below(5)) * 72,
                                   static_cast<int>(random.below(4)) * 20 + 30});
                  }
                  SpherePoints points;
                  for (const auto& [x, y] : places) points.push_back(at(x, y));
                  std::sort(points.begin(), points.end(), lexicographically_less);
                  points.erase(std::unique(points.begin(), points.end()), points.end());
                  return points;
                })
                .detours,
            300);
}

// A ring of walls and what it leaves: a hole that is larger than a hemisphere.
TEST(SphereVisibleNeighbors, AreThoseOfAllPathsBesideAHoleLargerThanAHemisphere) {
  SplitMix64 random(12);
  int num_detours = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    SpherePoints points;
    std::vector<Pair> walls;
    const auto n = static_cast<Node>(4 + random.below(4));
    const double lat = random.between(-60, 60);
    for (Node i = 0; i < n; ++i) {
      points.push_back(at(360.0 * i / n, lat + random.between(-25, 25)));
      // All but a gap in every second ring.
      if (i > 0 || trial % 2 == 0) walls.push_back({i, (i + 1) % n});
    }
    for (const Direction& p : support::uniform_directions(5, random.next()))
      points.push_back(p);
    num_detours += expect_shortest_paths(points, walls).detours;
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(num_detours, 200);
}

}  // namespace
}  // namespace delone::stripack
