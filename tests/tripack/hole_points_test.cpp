#include "tripack/hole_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "support/planar_graphs.hpp"

namespace delone::tripack {
namespace {

using support::add_ring;
using support::square_ring;

ConstrainedTriangulation even_odd(const PlanarGraph& graph) {
  return ConstrainedTriangulation(
      graph, {.domain = Domain::even_odd, .crossings = Crossings::split});
}

/// What a .poly file holds of a triangulation.
PlanarGraph as_poly(const ConstrainedTriangulation& t) {
  PlanarGraph graph;
  for (Node row = 0; row < t.num_rows(); ++row) graph.points.push_back(t.point(row));
  graph.segments = t.constraint_edges();
  graph.holes = hole_points(t);
  return graph;
}

PlanarGraph nested_squares(int count) {
  PlanarGraph graph;
  for (int i = 0; i < count; ++i) add_ring(graph, square_ring({5, 5}, 1 + i));
  return graph;
}

/// Polygons that lie anywhere, also across one another, and points.
PlanarGraph random_rings(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 10), angle(0, 2 * std::numbers::pi);
  PlanarGraph graph;
  for (int i = 0; i < 5; ++i) {
    std::vector<double> angles(3 + random() % 6);
    for (double& a : angles) a = angle(random);
    std::ranges::sort(angles);
    const Point2 centre{place(random), place(random)};
    const double radius = place(random) / 2;
    support::PlanePoints ring;
    for (const double a : angles)
      ring.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
    add_ring(graph, ring);
  }
  for (int i = 0; i < 20; ++i) graph.points.push_back({place(random), place(random)});
  return graph;
}

TEST(HolePoints, LieInEveryPartBetweenRingsThatIsLeftOut) {
  EXPECT_TRUE(hole_points(even_odd(nested_squares(1))).empty());
  for (int count = 2; count < 7; ++count) {
    // Counted from outside every second band is a hole, the innermost square too.
    const auto points = hole_points(even_odd(nested_squares(count)));
    ASSERT_EQ(std::ssize(points), count / 2);
    for (const Point2 p : points) {
      const double ring = std::max(std::abs(p.x - 5), std::abs(p.y - 5));
      EXPECT_EQ((count - static_cast<int>(std::floor(ring))) % 2, 0) << ring;
    }
  }
}

TEST(HolePoints, NameTheDomainThatRingsGave) {
  int num_holes = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const ConstrainedTriangulation t = even_odd(random_rings(seed));
    const PlanarGraph poly = as_poly(t);
    const ConstrainedTriangulation again(poly);
    EXPECT_EQ(again.triangles(), t.triangles()) << seed;
    num_holes += static_cast<int>(poly.holes.size());
  }
  EXPECT_GT(num_holes, 60);
}

TEST(HolePoints, DoNotDependOnTheOrderOfPointsAndSegments) {
  std::size_t num_holes = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const PlanarGraph graph = random_rings(seed);
    PlanarGraph turned;
    turned.points.assign(graph.points.rbegin(), graph.points.rend());
    const auto last = static_cast<Node>(graph.points.size()) - 1;
    for (const auto& [from, to] : graph.segments)
      turned.segments.insert(turned.segments.begin(), {last - to, last - from});
    const auto points = hole_points(even_odd(graph));
    EXPECT_EQ(hole_points(even_odd(turned)), points) << seed;
    num_holes += points.size();
  }
  EXPECT_GT(num_holes, 20U);
}

TEST(HolePoints, LieInTheHolesOfSegmentsToo) {
  PlanarGraph graph = nested_squares(3);
  graph.holes = {{5, 5}};
  const ConstrainedTriangulation t(graph);
  const auto points = hole_points(t);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_LT(std::max(std::abs(points[0].x - 5), std::abs(points[0].y - 5)), 1);
}

TEST(HolePoints, AreNoneForTheHullAndForCollinearPoints) {
  EXPECT_TRUE(
      hole_points(ConstrainedTriangulation(nested_squares(4), {.domain = Domain::hull}))
          .empty());
  EXPECT_TRUE(hole_points(ConstrainedTriangulation()).empty());
  PlanarGraph line;
  line.points = {{0, 0}, {1, 1}, {2, 2}};
  line.segments = {{0, 2}};
  EXPECT_TRUE(hole_points(ConstrainedTriangulation(line)).empty());
}

TEST(HolePoints, AreFoundWhereSumsAndAreasOverflow) {
  for (const double scale : {0x1p-500, 0x1p510, 0x1p1019}) {
    PlanarGraph graph = nested_squares(2);
    for (Point2& p : graph.points) p = {p.x * scale, p.y * scale};
    const ConstrainedTriangulation t = even_odd(graph);
    ASSERT_EQ(hole_points(t).size(), 1U) << scale;
    EXPECT_EQ(ConstrainedTriangulation(as_poly(t)).triangles(), t.triangles());
  }
}

TEST(HolePoints, HoleWithoutRoomForAPointIsAnErrorThatNamesARow) {
  PlanarGraph graph;
  add_ring(graph, square_ring({1, 1}, 2));
  add_ring(graph, {{1, 1}, {1 + 0x1p-52, 1}, {1, 1 + 0x1p-52}});
  const ConstrainedTriangulation t = even_odd(graph);
  try {
    static_cast<void>(hole_points(t));
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.rows().size(), 1U);
    EXPECT_GE(error.rows()[0], 4);
    EXPECT_NE(std::string(error.what()).find("row " + std::to_string(error.rows()[0])),
              std::string::npos);
  }
}

}  // namespace
}  // namespace delone::tripack
