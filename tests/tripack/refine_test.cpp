#include "tripack/refine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "delaunay/error.hpp"
#include "support/planar_graphs.hpp"
#include "support/random.hpp"
#include "tripack/constrained_defect.hpp"

namespace delone::tripack {
namespace {

double length(Point2 a, Point2 b) { return std::hypot(b.x - a.x, b.y - a.y); }

double area(Point2 a, Point2 b, Point2 c) {
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

double total_area(const ConstrainedTriangulation& t) {
  double sum = 0;
  for (const auto& [i, j, k] : t.triangles())
    sum += area(t.point(i), t.point(j), t.point(k));
  return sum;
}

double smallest_angle_deg(const ConstrainedTriangulation& t) {
  double smallest = 180;
  for (const auto& triangle : t.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 a = t.point(triangle[k]), b = t.point(triangle[(k + 1) % 3]),
                   c = t.point(triangle[(k + 2) % 3]);
      const double sine = 2 * area(a, b, c) / (length(a, b) * length(a, c));
      const double cosine = ((b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y)) /
                            (length(a, b) * length(a, c));
      smallest = std::min(smallest, std::atan2(sine, cosine) * 180 / std::numbers::pi);
    }
  }
  return smallest;
}

std::string defect_of(const ConstrainedTriangulation& t) {
  return find_defect(t).value_or("none");
}

PlanarGraph square_with_hole() {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({0, 0}, 10));
  support::add_ring(graph, support::square_ring({3, 2}, 1));
  graph.holes = {{3, 2}};
  return graph;
}

TEST(Refine, ReachesTheSmallestAngleAskedFor) {
  for (const double angle : {0.0, 15.0, 20.7, 25.0, 30.0, 33.0}) {
    const Refinement r = refine(square_with_hole(), {.min_angle_deg = angle});
    EXPECT_EQ(r.num_below_angle, 0) << angle;
    EXPECT_GE(smallest_angle_deg(r.triangulation), angle - 1e-9);
    EXPECT_NEAR(r.smallest_angle_deg, smallest_angle_deg(r.triangulation), 1e-9);
    EXPECT_NEAR(total_area(r.triangulation), 400 - 4, 1e-9);
    EXPECT_EQ(defect_of(r.triangulation), "none") << angle;
    EXPECT_EQ(r.num_added, r.triangulation.num_rows() - 8);
    EXPECT_LT(r.num_added, 500);
  }
}

TEST(Refine, KeepsEverySegmentAndEveryPoint) {
  const PlanarGraph graph = square_with_hole();
  const Refinement r = refine(graph, {.max_area = 1});
  for (std::int64_t i = 0; i < 8; ++i) {
    const auto path = r.triangulation.path(i);
    const std::array<Node, 2> ends{path.front(), path.back()};
    EXPECT_EQ(ends, graph.segments[static_cast<std::size_t>(i)]);
    EXPECT_GE(path.size(), 2U);
  }
}

TEST(Refine, LeavesNoTriangleAboveTheArea) {
  const Refinement r = refine(square_with_hole(), {.max_area = 0.5});
  EXPECT_EQ(r.num_above_area, 0);
  for (const auto& [i, j, k] : r.triangulation.triangles()) {
    EXPECT_LE(area(r.triangulation.point(i), r.triangulation.point(j),
                   r.triangulation.point(k)),
              0.5);
  }
  EXPECT_EQ(defect_of(r.triangulation), "none");
}

TEST(Refine, RegionsHaveAreasOfTheirOwn) {
  PlanarGraph graph = square_with_hole();
  graph.holes.clear();
  graph.regions = {{{3, 2}, 1, 0.01}, {{9, 9}, 2, 0}};
  const Refinement r = refine(graph);
  const auto& t = r.triangulation;
  ASSERT_EQ(t.regions().size(), 2U);
  for (const DomainRegion& region : t.regions()) {
    if (region.attribute == 1) {
      EXPECT_GE(region.num_triangles, 400);
    }
  }
}

TEST(Refine, EndsAtSmallAnglesOfTheInputAndCountsWhatIsLeft) {
  for (const double width : {1.0, 0.1, 0.01, 1e-4}) {
    PlanarGraph graph;
    support::add_ring(graph, {{0, 0}, {10, -width}, {10, width}});
    const Refinement r = refine(graph, {.min_angle_deg = 25, .max_added = 100000});
    EXPECT_LT(r.num_added, 20000) << width;
    EXPECT_EQ(defect_of(r.triangulation), "none");
    EXPECT_NEAR(total_area(r.triangulation), 10 * width, 1e-9);
    EXPECT_LT(r.num_below_angle, 200) << width;
  }
}

TEST(Refine, EndsWhereManySegmentsMeet) {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({0, 0}, 10));
  graph.points.push_back({0, 0});
  for (int i = 0; i < 36; ++i) {
    const double angle = i * std::numbers::pi / 18;
    graph.points.push_back(
        {(5 + i % 3) * std::cos(angle), (5 + i % 3) * std::sin(angle)});
    graph.segments.push_back({4, 5 + i});
  }
  const Refinement r = refine(graph, {.max_added = 100000});
  EXPECT_LT(r.num_added, 20000);
  EXPECT_EQ(defect_of(r.triangulation), "none");
  EXPECT_NEAR(total_area(r.triangulation), 400, 1e-9);
}

TEST(Refine, StopsAtTheLargestNumberOfVertices) {
  const Refinement r = refine(square_with_hole(), {.max_area = 1e-9, .max_added = 1000});
  EXPECT_EQ(r.num_added, 1000);
  EXPECT_GT(r.num_above_area, 0);
  EXPECT_EQ(defect_of(r.triangulation), "none");
}

TEST(Refine, DoesNotDependOnTheOrderOfPoints) {
  const PlanarGraph graph = square_with_hole();
  PlanarGraph turned = graph;
  std::reverse(turned.points.begin(), turned.points.end());
  std::reverse(turned.segments.begin(), turned.segments.end());
  for (auto& [a, b] : turned.segments) a = 7 - a, b = 7 - b;
  const Refinement one = refine(graph, {.max_area = 2});
  const Refinement other = refine(turned, {.max_area = 2});
  const auto p = one.triangulation.points(), q = other.triangulation.points();
  EXPECT_TRUE(std::equal(p.begin(), p.end(), q.begin(), q.end()));
}

TEST(Refine, EndsWhereLengthsAreBeyondTheRangeOfDoubles) {
  PlanarGraph graph;
  support::add_ring(
      graph,
      std::vector<Point2>{{-1.7e308, -1.7e308}, {1.7e308, -1.6e308}, {1.7e308, 1.7e308}});
  const Refinement r = refine(graph, {.max_added = 50});
  EXPECT_EQ(defect_of(r.triangulation), "none");
  EXPECT_LE(r.triangulation.points().size(), 53u);
}

TEST(Refine, EmptyDomainsStayEmpty) {
  EXPECT_EQ(refine(PlanarGraph{}).num_added, 0);
  PlanarGraph graph{.points = {{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_EQ(refine(graph).triangulation.num_triangles(), 0);
  graph.points = {{0, 0}, {1, 1}, {2, 2}};
  EXPECT_EQ(refine(graph).num_added, 0);
}

TEST(Refine, RefusesWhatNoMeshHas) {
  EXPECT_THROW((void)refine(PlanarGraph{}, {.min_angle_deg = 60}), Error);
  EXPECT_THROW((void)refine(PlanarGraph{}, {.min_angle_deg = -1}), Error);
  EXPECT_THROW((void)refine(PlanarGraph{}, {.max_area = -1}), Error);
}

}  // namespace
}  // namespace delone::tripack
