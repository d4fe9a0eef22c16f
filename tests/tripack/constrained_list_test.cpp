#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "support/planar_graphs.hpp"
#include "support/random.hpp"
#include "tripack/constrained_list_defect.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {
namespace {

using support::SplitMix64;
using Triangles = std::vector<std::array<Node, 3>>;

std::string defect_of(const ConstrainedTriangulation& t, const Triangles& triangles) {
  return find_defect(t, triangles).value_or("none");
}

void expect_words(const std::string& sentence, const std::string& words) {
  EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
}

/// A square of side 4 with a square hole of side 2 and a point in the frame.
PlanarGraph frame() {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({2, 2}, 2));
  support::add_ring(graph, support::square_ring({2, 2}, 1));
  graph.points.push_back({0.5, 0.75});
  graph.holes = {{2, 2}};
  return graph;
}

TEST(ConstrainedList, OwnTrianglesHaveNoDefectHoweverTheyAreListed) {
  const ConstrainedTriangulation t(frame());
  Triangles triangles = t.triangles();
  ASSERT_EQ(triangles.size(), 10U);
  EXPECT_EQ(defect_of(t, triangles), "none");
  std::ranges::reverse(triangles);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    std::rotate(triangles[i].begin(), triangles[i].begin() + i % 3, triangles[i].end());
    if (i % 2 == 0) std::swap(triangles[i][0], triangles[i][1]);
  }
  EXPECT_EQ(defect_of(t, triangles), "none");
}

TEST(ConstrainedList, NamesWhatIsNoTriangle) {
  const ConstrainedTriangulation t(frame());
  Triangles triangles = t.triangles();
  triangles.push_back({0, 1, 99});
  expect_words(defect_of(t, triangles), "(0, 1, 99)");
  triangles.back() = {0, 1, -1};
  expect_words(defect_of(t, triangles), "(0, 1, -1)");
  triangles.back() = {0, 1, 1};
  expect_words(defect_of(t, triangles), "has no area");
}

TEST(ConstrainedList, EveryMissingAndEveryDoubledTriangleIsADefect) {
  const ConstrainedTriangulation t(frame());
  const Triangles triangles = t.triangles();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangles without = triangles, doubled = triangles;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    doubled.push_back(triangles[i]);
    EXPECT_NE(defect_of(t, without), "none") << i;
    expect_words(defect_of(t, doubled), "two triangles on one side");
  }
  EXPECT_NE(defect_of(t, {}), "none");
}

TEST(ConstrainedList, TheHullIsNotTheDomain) {
  const ConstrainedTriangulation domain(frame()), hull(frame(), {.domain = Domain::hull});
  EXPECT_EQ(defect_of(hull, hull.triangles()), "none");
  expect_words(defect_of(domain, hull.triangles()), "boundary of the domain");
  EXPECT_NE(defect_of(hull, domain.triangles()), "none");
}

TEST(ConstrainedList, APointThatIsNoCornerIsNamed) {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({0, 0}, 1));
  graph.points.push_back({0.25, 0.125});
  const ConstrainedTriangulation t(graph);
  EXPECT_EQ(defect_of(t, {{0, 1, 2}, {0, 2, 3}}),
            "row 4 lies in the domain, but no triangle has it as a corner");
}

TEST(ConstrainedList, SegmentThatIsCrossedIsNamed) {
  // Delaunay without the segment takes the other diagonal.
  const PlanarGraph graph{.points = {{0, 0}, {4, -1}, {8, 0}, {4, 1}},
                          .segments = {{0, 2}}};
  const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
  EXPECT_EQ(defect_of(t, {{0, 1, 2}, {0, 2, 3}}), "none");
  expect_words(defect_of(t, {{0, 1, 3}, {1, 2, 3}}), "a piece of a segment");
}

TEST(ConstrainedList, TiesMayBeBrokenEitherWayAndRepeatsNamedByAnyRow) {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({0, 0}, 1));
  graph.points.push_back(graph.points[2]);
  const ConstrainedTriangulation t(graph);
  EXPECT_EQ(defect_of(t, {{0, 1, 2}, {0, 2, 3}}), "none");
  EXPECT_EQ(defect_of(t, {{0, 1, 4}, {0, 2, 3}}), "none");
  EXPECT_EQ(defect_of(t, {{0, 1, 3}, {1, 2, 3}}), "none");
}

TEST(ConstrainedList, CollinearPointsHaveNoTriangles) {
  const ConstrainedTriangulation t({.points = {{0, 0}, {1, 0}, {2, 0}}},
                                   {.domain = Domain::hull});
  EXPECT_EQ(defect_of(t, {}), "none");
  expect_words(defect_of(t, {{0, 1, 2}}), "has no area");
}

/// Random points of few coordinates, so that many line up and lie on circles, with
/// segments that do not cross: edges of a triangulation of some of the points.
PlanarGraph random_graph(SplitMix64& random) {
  PlanarGraph graph;
  const std::size_t num_points = 4 + random.below(30);
  for (std::size_t i = 0; i < num_points; ++i) {
    const double x = std::floor(random.between(0, 7));
    graph.points.push_back({x, std::floor(random.between(0, 7))});
  }
  const std::span<const Point2> some(graph.points.data(),
                                     4 + random.below(num_points - 3));
  for (const auto& [a, b, c] : Triangulation(some).triangles())
    if (random.below(3) == 0) graph.segments.push_back({a, b});
  return graph;
}

/// The pairs of triangles at a common side, as indices.
std::vector<std::array<std::size_t, 2>> pairs_of(const Triangles& triangles) {
  std::map<std::array<Node, 2>, std::size_t> owner;
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Node a = triangles[i][k], b = triangles[i][(k + 1) % 3];
      if (const auto found = owner.find({b, a}); found != owner.end())
        pairs.push_back({found->second, i});
      owner[{a, b}] = i;
    }
  return pairs;
}

/// Turns triangles (a, b, c), (b, a, d) into (d, b, c), (a, d, c); false if they are not
/// convex together or may not be turned.
bool flip(const ConstrainedTriangulation& t, std::array<Node, 3>& one,
          std::array<Node, 3>& two) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Node a = one[k], b = one[(k + 1) % 3], c = one[(k + 2) % 3];
    if (std::ranges::count(two, a) == 0 || std::ranges::count(two, b) == 0) continue;
    const Node d = *std::ranges::find_if(two, [&](Node n) { return n != a && n != b; });
    one = {d, b, c};
    two = {a, d, c};
    const auto turn = [&](const std::array<Node, 3>& n) {
      return orientation(t.point(n[0]), t.point(n[1]), t.point(n[2]));
    };
    return turn(one) > 0 && turn(two) > 0;
  }
  return false;
}

TEST(ConstrainedList, TurnedEdgesOfRandomGraphsAreDefectsUnlessTied) {
  SplitMix64 random(4711);
  int num_defects = 0, num_ties = 0;
  for (int round = 0; round < 300; ++round) {
    const PlanarGraph graph = random_graph(random);
    const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
    const Triangles triangles = t.triangles();
    ASSERT_EQ(defect_of(t, triangles), "none") << round;
    const auto constraints = t.constraint_edges();
    for (const auto& [i, j] : pairs_of(triangles)) {
      Triangles turned = triangles;
      if (!flip(t, turned[i], turned[j])) continue;
      std::vector<Node> side;
      for (const Node n : triangles[i])
        if (std::ranges::count(triangles[j], n) > 0) side.push_back(n);
      std::ranges::sort(side);
      const auto& [a, b, c] = triangles[i];
      const Node d = *std::ranges::find_if(
          triangles[j], [&](Node n) { return std::ranges::count(side, n) == 0; });
      const bool is_piece =
          std::ranges::binary_search(constraints, std::array{side[0], side[1]});
      const bool is_tied =
          !is_piece && in_circle(t.point(a), t.point(b), t.point(c), t.point(d)) == 0;
      EXPECT_EQ(defect_of(t, turned) == "none", is_tied) << round;
      ++(is_tied ? num_ties : num_defects);
    }
  }
  EXPECT_GT(num_defects, 1000);
  EXPECT_GT(num_ties, 100);
}

}  // namespace
}  // namespace delone::tripack
