#include "tripack/visible_neighbors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/neighbor_search.hpp"

namespace delone::tripack {
namespace {

using support::PlanePoints;
using support::SplitMix64;
using Pair = std::array<Node, 2>;

constexpr double never = std::numeric_limits<double>::infinity();

ConstrainedTriangulation with_walls(const PlanePoints& points, std::vector<Pair> walls) {
  return ConstrainedTriangulation({.points = points, .segments = std::move(walls)},
                                  {.domain = Domain::hull});
}

std::vector<Node> nodes_of(const std::vector<PathNeighbor>& found) {
  std::vector<Node> nodes;
  for (const PathNeighbor& v : found) nodes.push_back(v.node);
  return nodes;
}

/// Shortest paths between points of integer coordinates by the definition, over all pairs
/// of points that see each other: states are such pairs and the side on which the path
/// runs, pushed off its line by nothing.
class PathOracle {
 public:
  PathOracle(PlanePoints points, std::vector<Pair> walls)
      : points_(std::move(points)), walls_(std::move(walls)) {}

  [[nodiscard]] std::vector<double> distances(Node from) const {
    const std::size_t n = points_.size();
    std::vector<double> best(2 * n * n, never);
    const auto state = [&](std::size_t a, std::size_t b, std::size_t side) {
      return 2 * (a * n + b) + side;
    };
    for (std::size_t b = 0; b < n; ++b) {
      if (!sees(at(from), b)) continue;
      for (const std::size_t side : {0UL, 1UL})
        best[state(at(from), b, side)] = length(at(from), b);
    }
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      const auto improve = [&](std::size_t i, double v) {
        if (v >= best[i] - 1e-9) return;
        best[i] = v;
        has_changed = true;
      };
      for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) {
          for (const std::size_t side : {0UL, 1UL}) {
            const double v = best[state(a, b, side)];
            if (v == never) continue;
            if (!is_wall(a, b)) improve(state(a, b, 1 - side), v);
            for (std::size_t c = 0; c < n; ++c) {
              if (sees(b, c) && turns(a, b, c, side))
                improve(state(b, c, side), v + length(b, c));
            }
          }
        }
      }
    }
    std::vector<double> result(n, never);
    result[at(from)] = 0;
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b)
        result[b] = std::min({result[b], best[state(a, b, 0)], best[state(a, b, 1)]});
    }
    result[at(from)] = 0;
    return result;
  }

 private:
  static std::size_t at(Node v) { return static_cast<std::size_t>(v); }
  [[nodiscard]] double length(std::size_t a, std::size_t b) const {
    return std::hypot(points_[a].x - points_[b].x, points_[a].y - points_[b].y);
  }
  [[nodiscard]] double cross(std::size_t a, std::size_t b, std::size_t c) const {
    return (points_[b].x - points_[a].x) * (points_[c].y - points_[a].y) -
           (points_[b].y - points_[a].y) * (points_[c].x - points_[a].x);
  }
  [[nodiscard]] bool is_inside(std::size_t a, std::size_t b, std::size_t v) const {
    const double dot = (points_[v].x - points_[a].x) * (points_[v].x - points_[b].x) +
                       (points_[v].y - points_[a].y) * (points_[v].y - points_[b].y);
    return cross(a, b, v) == 0 && dot < 0;
  }
  [[nodiscard]] bool is_wall(std::size_t a, std::size_t b) const {
    return std::any_of(walls_.begin(), walls_.end(), [&](const Pair& w) {
      return (at(w[0]) == a && at(w[1]) == b) || (at(w[0]) == b && at(w[1]) == a);
    });
  }
  [[nodiscard]] bool sees(std::size_t a, std::size_t b) const {
    if (a == b) return false;
    return std::none_of(walls_.begin(), walls_.end(), [&](const Pair& w) {
      const std::size_t c = at(w[0]), d = at(w[1]);
      if (is_inside(a, b, c) || is_inside(a, b, d)) return true;  // in two pieces
      return cross(a, b, c) * cross(a, b, d) < 0 && cross(c, d, a) * cross(c, d, b) < 0;
    });
  }
  // From b, in radians; points in line give the same.
  [[nodiscard]] double angle(std::size_t b, std::size_t c) const {
    const auto dx = static_cast<long>(points_[c].x - points_[b].x);
    const auto dy = static_cast<long>(points_[c].y - points_[b].y);
    const long g = std::gcd(dx, dy);
    return std::atan2(static_cast<double>(dy / g), static_cast<double>(dx / g));
  }
  // Clockwise from `from` to `to`, in [0, 2 pi).
  static double sweep(double from, double to) {
    const double v = from - to;
    return v < 0 ? v + 2 * std::acos(-1.0) : v;
  }
  // May a path a-b-c pass b on that side (0: b is on its right; 1: on its left)? On the
  // left of the way there, it goes clockwise round b.
  [[nodiscard]] bool turns(std::size_t a, std::size_t b, std::size_t c,
                           std::size_t side) const {
    double from = angle(b, a), to = angle(b, c);
    if (side == 1) std::swap(from, to);
    const double all = from == to ? 2 * std::acos(-1.0) : sweep(from, to);  // back again
    return std::none_of(walls_.begin(), walls_.end(), [&](const Pair& w) {
      if (at(w[0]) != b && at(w[1]) != b) return false;
      const double wall = angle(b, at(w[0]) == b ? at(w[1]) : at(w[0]));
      const double here = sweep(from, wall);
      return here > 1e-9 && here < all - 1e-9;
    });
  }

  PlanePoints points_;
  std::vector<Pair> walls_;
};

void expect_shortest_paths(const PlanePoints& points, const std::vector<Pair>& walls) {
  const auto t = with_walls(points, walls);
  const PathOracle oracle(points, t.constraint_edges());
  for (Node from = 0; std::cmp_less(from, points.size()); ++from) {
    const std::vector<double> expected = oracle.distances(from);
    std::vector<double> found(points.size(), never);
    found[static_cast<std::size_t>(from)] = 0;
    double last = 0;
    for (const PathNeighbor& v :
         nearest_k_visible(t, from, static_cast<std::int32_t>(points.size()))) {
      ASSERT_EQ(found[static_cast<std::size_t>(v.node)], never);
      ASSERT_GE(v.distance, last);
      last = found[static_cast<std::size_t>(v.node)] = v.distance;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (expected[i] == never) {
        ASSERT_EQ(found[i], never) << from << " to " << i;
      } else {
        ASSERT_NEAR(found[i], expected[i], 1e-9) << from << " to " << i;
      }
    }
  }
}

TEST(VisibleNeighbors, GoRoundAWall) {
  const PlanePoints points{{0, 0}, {4, 0}, {2, -3}, {2, 3}, {2, 9}};
  const auto t = with_walls(points, {{2, 3}});
  const auto found = nearest_k_visible(t, 0, 10);
  EXPECT_EQ(nodes_of(found), (std::vector<Node>{2, 3, 1, 4}));
  EXPECT_DOUBLE_EQ(found[2].distance, 2 * std::sqrt(13.0));
  EXPECT_EQ(found[2].from, 2);
  EXPECT_EQ(found[3].from, 0);
}

TEST(VisibleNeighbors, DoNotGetOutOfAClosedCurve) {
  const PlanePoints points{{0, 0}, {4, 0}, {4, 4}, {0, 4},
                           {2, 1}, {1, 3}, {9, 2}, {9, 9}};
  const auto t = with_walls(points, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  EXPECT_EQ(nodes_of(nearest_k_visible(t, 4, 10)).size(), 5U);
  EXPECT_EQ(nodes_of(nearest_k_visible(t, 6, 10)).size(), 5U);
  EXPECT_EQ(nodes_of(nearest_k_visible(t, 0, 10)).size(), 7U);
}

TEST(VisibleNeighbors, AreTheNearestNodesWithoutSegments) {
  const PlanePoints points = support::uniform_points(500, 4);
  const auto t = with_walls(points, {});
  const Triangulation plain(points);
  for (Node row = 0; row < 500; row += 7) {
    const auto found = nearest_k_visible(t, row, 20);
    const auto expected =
        nearest_k(plain, points[static_cast<std::size_t>(row)], 21, row);
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].node, expected[i + 1].row);
      EXPECT_EQ(found[i].distance, expected[i + 1].distance);
      EXPECT_EQ(found[i].from, row);
    }
  }
}

TEST(VisibleNeighbors, GoAlongALineOfPoints) {
  const auto t = with_walls({{0, 0}, {3, 0}, {1, 0}, {7, 0}, {1, 0}}, {{0, 3}});
  EXPECT_EQ(nodes_of(nearest_k_visible(t, 1, 9)), (std::vector<Node>{2, 0, 3}));
  EXPECT_EQ(nodes_of(nearest_k_visible(t, 4, 9)), (std::vector<Node>{0, 1, 3}));
}

TEST(VisibleNeighbors, RefuseWhatIsNotThere) {
  const auto t = with_walls({{0, 0}, {1, 0}, {0, 1}}, {});
  EXPECT_THROW(static_cast<void>(nearest_k_visible(t, 3, 1)), Error);
  EXPECT_THROW(static_cast<void>(nearest_k_visible(t, -1, 1)), Error);
  EXPECT_THROW(static_cast<void>(nearest_k_visible(t, 0, 0)), Error);
  VisibleNodes nodes(t);
  EXPECT_FALSE(nodes.next().has_value());
  nodes.start(0);
  EXPECT_TRUE(nodes.next().has_value());
}

TEST(VisibleNeighbors, PassAFreeEndButNotAClosedCorner) {
  expect_shortest_paths({{0, 0}, {2, 2}, {4, 0}, {2, 4}, {2, 1}, {0, 4}, {4, 4}},
                        {{0, 1}, {1, 2}});
  expect_shortest_paths({{0, 0}, {2, 2}, {4, 0}, {2, 4}, {2, 1}, {0, 4}, {4, 4}},
                        {{0, 1}, {1, 2}, {1, 3}});
}

// Lattices: walls along lines of sight, through nodes, with common ends; rings.
TEST(VisibleNeighbors, AreThoseOfAllPathsBetweenPointsThatSeeEachOther) {
  SplitMix64 random(6);
  int num_walls = 0;
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE(trial);
    std::set<std::array<int, 2>> places;
    const std::size_t n = 4 + random.below(7), side = 3 + random.below(6);
    while (places.size() < std::min(n, side * side))
      places.insert(
          {static_cast<int>(random.below(side)), static_cast<int>(random.below(side))});
    PlanePoints points;
    for (const auto& [x, y] : places)
      points.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (Triangulation(points).dimension() < 2) continue;
    std::vector<Pair> walls;
    for (std::size_t i = 0; i < 8; ++i) {
      walls.push_back({static_cast<Node>(random.below(points.size())),
                       static_cast<Node>(random.below(points.size()))});
      try {
        static_cast<void>(with_walls(points, walls));
        ++num_walls;
      } catch (const Error&) {
        walls.pop_back();
      }
    }
    expect_shortest_paths(points, walls);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_GT(num_walls, 800);
}

}  // namespace
}  // namespace delone::tripack
