#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "support/exact.hpp"
#include "support/planar_graphs.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "support/same_mesh.hpp"
#include "tripack/constrained_samples.hpp"
#include "tripack/constrained_triangulation.hpp"
#include "tripack/defect.hpp"

namespace delone::tripack {
namespace {

using samples::defect_of;
using samples::only;
using samples::splitting;
using support::SplitMix64;
using Segment = std::array<Node, 2>;

/// Triangles and regions by position.
using Corners = std::array<std::array<double, 2>, 3>;
std::set<Corners> triangle_positions(const ConstrainedTriangulation& t) {
  std::set<Corners> result;
  for (const auto& triangle : t.triangles()) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 p = t.point(triangle[k]);
      corners[k] = {p.x, p.y};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                corners.end());
    result.insert(corners);
  }
  return result;
}

PlanarGraph random_graph(std::size_t num_points, std::size_t num_segments,
                         SplitMix64& random, double range) {
  PlanarGraph graph;
  for (std::size_t i = 0; i < num_points; ++i) {
    // Whole numbers meet, line up and lie on circles; fractions do not.
    const auto coordinate = [&] {
      const double v = random.between(0, range);
      return range > 1 ? std::floor(v) : v;
    };
    const double x = coordinate();
    graph.points.push_back({x, coordinate()});
  }
  for (std::size_t i = 0; i < num_segments; ++i) {
    graph.segments.push_back({static_cast<Node>(random.below(num_points)),
                              static_cast<Node>(random.below(num_points))});
  }
  return graph;
}

// A judge that knows nothing of walks, cavities or flips in a mesh: a set of edges.
class EdgeSet {
 public:
  explicit EdgeSet(const PlanarGraph& graph) : points_(graph.points) {
    for (const auto& [i, j] : graph.segments) constraints_.insert(std::minmax(i, j));
    edges_ = constraints_;
    const auto n = static_cast<Node>(points_.size());
    for (Node i = 0; i < n; ++i) {
      for (Node j = i + 1; j < n; ++j) {
        if (!crosses_any(i, j)) edges_.emplace(i, j);
      }
    }
    while (flip_one()) {
    }
  }

  static bool do_cross(const std::vector<Point2>& p, Node a, Node b, Node c, Node d) {
    const auto side = [&](Node i, Node j, Node k) {
      return support::exact_orientation(p[at(i)], p[at(j)], p[at(k)]);
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
  }

  [[nodiscard]] std::set<std::array<Node, 3>> triangles() const {
    std::set<std::array<Node, 3>> result;
    for (const auto& [i, j] : edges_) {
      for (const auto& [a, b] : {std::pair(i, j), std::pair(j, i)}) {
        if (const auto k = apex(a, b)) {
          std::array<Node, 3> t{a, b, *k};
          std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
          result.insert(t);
        }
      }
    }
    return result;
  }

 private:
  static std::size_t at(Node i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] int side(Node a, Node b, Node c) const {
    return support::exact_orientation(points_[at(a)], points_[at(b)], points_[at(c)]);
  }
  [[nodiscard]] bool crosses_any(Node i, Node j) const {
    return std::any_of(edges_.begin(), edges_.end(), [&](const auto& e) {
      return do_cross(points_, i, j, e.first, e.second);
    });
  }
  [[nodiscard]] bool has(Node i, Node j) const {
    return edges_.contains(std::minmax(i, j));
  }
  // The corner of the empty triangle on the left of a -> b.
  [[nodiscard]] std::optional<Node> apex(Node a, Node b) const {
    const auto n = static_cast<Node>(points_.size());
    for (Node k = 0; k < n; ++k) {
      if (!has(a, k) || !has(b, k) || side(a, b, k) <= 0) continue;
      bool is_empty = true;
      for (Node p = 0; p < n; ++p) {
        if (p != a && p != b && p != k && side(a, b, p) >= 0 && side(b, k, p) >= 0 &&
            side(k, a, p) >= 0)
          is_empty = false;
      }
      if (is_empty) return k;
    }
    return std::nullopt;
  }
  bool flip_one() {
    for (const auto& edge : edges_) {
      const auto& [i, j] = edge;
      const auto k = apex(i, j), l = apex(j, i);
      if (!k || !l || constraints_.contains(edge)) continue;
      if (support::exact_in_circle(points_[at(i)], points_[at(j)], points_[at(*k)],
                                   points_[at(*l)]) <= 0)
        continue;
      edges_.erase(edge);
      edges_.insert(std::minmax(*k, *l));
      return true;
    }
    return false;
  }

  std::vector<Point2> points_;
  std::set<std::pair<Node, Node>> constraints_, edges_;
};

// Keeps the segments that cross no earlier one.
PlanarGraph without_crossings(PlanarGraph graph) {
  std::vector<Segment> kept;
  for (const Segment& segment : graph.segments) {
    const Node a = segment[0], b = segment[1];
    const bool crosses = std::any_of(kept.begin(), kept.end(), [&](const Segment& s) {
      return EdgeSet::do_cross(graph.points, a, b, s[0], s[1]);
    });
    if (a != b && !crosses) kept.push_back({a, b});
  }
  graph.segments = kept;
  return graph;
}

TEST(Constrained, IsTheTriangulationThatBruteForceFinds) {
  SplitMix64 random(1);
  for (int round = 0; round < 400; ++round) {
    const std::size_t n = 4 + random.below(8);
    const PlanarGraph graph = without_crossings(random_graph(n, n, random, 1));
    const ConstrainedTriangulation t(graph, only(Domain::hull));
    const auto triangles = t.triangles();
    EXPECT_EQ(std::set(triangles.begin(), triangles.end()), EdgeSet(graph).triangles());
    EXPECT_EQ(defect_of(t), "none");
  }
}

TEST(Constrained, WithoutSegmentsIsTheDelaunayTriangulation) {
  for (const auto& family : support::plane_families()) {
    const PlanarGraph graph{.points = family.make(60, 3)};
    const ConstrainedTriangulation t(graph, only(Domain::hull));
    EXPECT_EQ(t.triangles(), Triangulation(graph.points).triangles()) << family.name;
    EXPECT_EQ(defect_of(t), "none") << family.name;
    EXPECT_EQ(ConstrainedTriangulation(graph).num_triangles(), 0) << family.name;
  }
}

// 5000 points are more than one block of the builder.
TEST(Constrained, WithoutSegmentsHasTheFacesOfTheNeighborLists) {
  for (const auto& family : support::plane_families()) {
    for (const std::size_t n : {4U, 17U, 150U, 5000U}) {
      const PlanarGraph graph{.points = family.make(n, 5)};
      const ConstrainedTriangulation t(graph, only(Domain::hull));
      const auto lists = Triangulation(graph.points).adjacency();
      EXPECT_TRUE(support::is_same_mesh(t.mesh(), ClosedMesh::from(lists)))
          << family.name << " " << n;
    }
  }
}

TEST(Constrained, SplitsAnySegmentsOfAnyPoints) {
  SplitMix64 random(2);
  for (const auto& family : support::plane_families()) {
    for (const std::size_t n : {5U, 20U, 60U}) {
      PlanarGraph graph{.points = family.make(n, n)};
      if (graph.points.empty()) continue;
      for (std::size_t i = 0; i < n / 2; ++i) {
        graph.segments.push_back({static_cast<Node>(random.below(graph.points.size())),
                                  static_cast<Node>(random.below(graph.points.size()))});
      }
      const ConstrainedTriangulation t(graph, splitting());
      EXPECT_EQ(defect_of(t), "none") << family.name << " " << n;
    }
  }
}

TEST(Constrained, SplitsSegmentsOfSmallWholeNumbers) {
  SplitMix64 random(3);
  for (int round = 0; round < 1000; ++round) {
    const PlanarGraph graph = random_graph(4 + random.below(12), 1 + random.below(12),
                                           random, 2 + random.uniform() * 5);
    const ConstrainedTriangulation t(graph, splitting());
    ASSERT_EQ(defect_of(t), "none") << round;
  }
}

TEST(Constrained, RefusesExactlyTheSegmentsThatCross) {
  SplitMix64 random(4);
  int num_refused = 0;
  for (int round = 0; round < 500; ++round) {
    const PlanarGraph graph = random_graph(8, 3, random, 6);
    const auto crosses = [&](std::size_t i, std::size_t j) {
      const auto& [a, b] = graph.segments[i];
      const auto& [c, d] = graph.segments[j];
      return EdgeSet::do_cross(graph.points, a, b, c, d);
    };
    try {
      const ConstrainedTriangulation t(graph, only(Domain::hull));
      EXPECT_EQ(defect_of(t), "none");
      EXPECT_FALSE(crosses(0, 1) || crosses(0, 2) || crosses(1, 2)) << round;
    } catch (const Error& error) {
      ++num_refused;
      ASSERT_EQ(error.rows().size(), 2U);
      EXPECT_TRUE(crosses(static_cast<std::size_t>(error.rows()[0]),
                          static_cast<std::size_t>(error.rows()[1])))
          << error.what();
    }
  }
  EXPECT_GT(num_refused, 50);
}

TEST(Constrained, DoesNotDependOnTheOrderOfPointsOrSegments) {
  SplitMix64 random(5);
  for (int round = 0; round < 100; ++round) {
    const PlanarGraph graph = random_graph(30, 12, random, round % 2 == 0 ? 1 : 9);
    PlanarGraph shuffled = graph;
    std::vector<Node> order(graph.points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Node>(i);
    order = support::shuffled(order, random.next());
    std::vector<Node> rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      shuffled.points[i] = graph.points[static_cast<std::size_t>(order[i])];
      rank[static_cast<std::size_t>(order[i])] = static_cast<Node>(i);
    }
    for (Segment& s : shuffled.segments) {
      s = {rank[static_cast<std::size_t>(s[1])], rank[static_cast<std::size_t>(s[0])]};
    }
    shuffled.segments = support::shuffled(shuffled.segments, random.next());
    const ConstrainedTriangulation a(graph, splitting()), b(shuffled, splitting());
    EXPECT_EQ(triangle_positions(a), triangle_positions(b)) << round;
  }
}

TEST(Constrained, SegmentAcrossAThousandNeedlesIsOneEdge) {
  PlanarGraph graph;
  graph.points = {{-1, 0}, {2001, 0}};
  SplitMix64 random(6);
  for (int i = 0; i < 1000; ++i) {
    graph.points.push_back({2.0 * i + random.uniform(), 1 + random.uniform()});
    graph.points.push_back({2.0 * i + 1 + random.uniform(), -1 - random.uniform()});
  }
  graph.segments = {{0, 1}};
  const ConstrainedTriangulation t(graph, only(Domain::hull));
  EXPECT_EQ(t.path(0), (std::vector<Node>{0, 1}));
  EXPECT_EQ(defect_of(t), "none");
}

// Two chains of 12,000 points that curve towards or away from the segment between them:
// the division of the cavity is as uneven as can be, and its square would take minutes.
TEST(Constrained, SegmentBetweenTwoLongChainsTakesNoSquareOfTheirLength) {
  for (const double bend : {-1.0, 1.0}) {
    constexpr int half = 6000;
    PlanarGraph graph{.points = {{-half - 1, 0}, {half + 1, 0}}, .segments = {{0, 1}}};
    for (int i = -half; i <= half; ++i) {
      const double u = static_cast<double>(i) / half, y = 1.75 + bend * u * u;
      graph.points.push_back({static_cast<double>(i), y});
      graph.points.push_back({i + 0.25, -y});
    }
    const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
    EXPECT_EQ(t.path(0), (std::vector<Node>{0, 1}));
    EXPECT_EQ(find_defect(t).value_or("none"), "none");
  }
}

TEST(Constrained, EdgeThatSticksIntoTheWayOfASegmentStays) {
  // Rows 2 - 3 hang down to the segment 0 - 1 from a fan above; both sides of the edge
  // are crossed.
  PlanarGraph graph;
  graph.points = {{-10, 0}, {10, 0},   {0, 9},  {0, 0.5}, {-4, -1},
                  {4, -1},  {0, -0.5}, {-9, 8}, {9, 8}};
  graph.segments = {{2, 3}, {0, 1}};
  const ConstrainedTriangulation t(graph, only(Domain::hull));
  EXPECT_EQ(defect_of(t), "none");
  EXPECT_EQ(t.constraint_edges(), (std::vector<Segment>{{0, 1}, {2, 3}}));
}

TEST(Constrained, PointsOnASegmentDivideIt) {
  PlanarGraph graph;
  graph.points = {{0, 0}, {4, 4}, {1, 1}, {3, 3}, {0, 4}, {4, 0}};
  graph.segments = {{0, 1}};
  const ConstrainedTriangulation t(graph, only(Domain::hull));
  EXPECT_EQ(t.path(0), (std::vector<Node>{0, 2, 3, 1}));
  ASSERT_EQ(t.report().on_segment.size(), 2U);
  EXPECT_EQ(t.report().on_segment[0].row, 2);
  EXPECT_EQ(t.report().on_segment[1].row, 3);
  EXPECT_EQ(t.num_rows(), 6);
}

TEST(Constrained, ReportsWhatIsNotClean) {
  PlanarGraph graph;
  graph.points = {{0, 0}, {4, 0}, {2, 0}, {2, 2}, {2, -2}, {0, 0}};
  graph.segments = {{0, 1}, {1, 0}, {2, 1}, {0, 5}, {3, 4}, {5, 1}};
  const ConstrainedTriangulation t(graph, only(Domain::hull));
  const SegmentReport& report = t.report();
  EXPECT_EQ(report.zero_length, (std::vector<std::int64_t>{3}));
  EXPECT_EQ(report.repeated, (std::vector<SegmentReport::Pair>{{0, 1}, {0, 5}}));
  EXPECT_EQ(report.overlapping, (std::vector<SegmentReport::Pair>{{0, 2}}));
  EXPECT_EQ(report.on_segment, (std::vector<SegmentReport::OnSegment>{{0, 2}, {4, 2}}));
  EXPECT_TRUE(report.crossing.empty());
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(defect_of(t), "none");
}

TEST(Constrained, CrossingSegmentsMeetInAnAddedVertex) {
  PlanarGraph graph;
  graph.points = {{0, 0}, {2, 2}, {0, 2}, {2, 0}};
  graph.segments = {{0, 1}, {2, 3}};
  const ConstrainedTriangulation t(graph, splitting());
  ASSERT_EQ(t.num_rows(), 5);
  EXPECT_EQ(t.point(4), (Point2{1, 1}));
  EXPECT_EQ(t.path(0), (std::vector<Node>{0, 4, 1}));
  EXPECT_EQ(t.path(1), (std::vector<Node>{2, 4, 3}));
  EXPECT_EQ(t.report().crossing, (std::vector<SegmentReport::Pair>{{0, 1}}));
  EXPECT_EQ(t.num_triangles(), 4);
}

TEST(Constrained, ErrorNamesBothCrossingSegments) {
  PlanarGraph graph;
  graph.points = {{0, 0}, {2, 2}, {0, 2}, {2, 0}, {5, 5}};
  graph.segments = {{0, 4}, {3, 2}};
  try {
    const ConstrainedTriangulation t(graph);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "segments 0 (rows 0 and 4) and 1 (rows 3 and 2) cross; divide them at a "
              "common point, or have crossings split");
  }
}

TEST(Constrained, StarOfSegmentsThatAllCrossIsSplit) {
  // All but at one point, to within rounding: no two crossings need fall together.
  for (const double offset : {0.0, 0.1, 1e6}) {
    PlanarGraph graph;
    const int n = 24;
    for (int i = 0; i < n; ++i) {
      const double angle = i * 3.14159265358979 / n;
      const double x = std::cos(angle), y = std::sin(angle);
      graph.points.push_back({offset + x, y});
      graph.points.push_back({offset - x, -y});
      graph.segments.push_back({2 * i, 2 * i + 1});
    }
    const ConstrainedTriangulation t(graph, splitting());
    EXPECT_EQ(defect_of(t), "none");
    EXPECT_LT(t.num_rows(), 2 * n + n * n);
  }
}

TEST(Constrained, AlmostParallelSegmentsAreSplit) {
  SplitMix64 random(7);
  for (int round = 0; round < 200; ++round) {
    PlanarGraph graph;
    for (int i = 0; i < 12; ++i) {
      const double jitter = std::ldexp(static_cast<double>(random.below(5)) - 2, -52);
      graph.points.push_back(
          {random.below(2) == 0 ? random.uniform() : 2.0 * (i % 2), 1 + jitter});
    }
    for (Node i = 0; i < 12; i += 2) graph.segments.push_back({i, i + 1});
    const ConstrainedTriangulation t(graph, splitting());
    ASSERT_EQ(defect_of(t), "none") << round;
  }
}

TEST(Constrained, SplitsAtBothEndsOfTheRangeOfDoubles) {
  for (const double scale :
       {0x1p-1074, 0x1p-1000, 0x1p-300, 0x1p300, 0x1p1000, 0x1p1019}) {
    SplitMix64 random(8);
    PlanarGraph graph = random_graph(16, 10, random, 16);
    for (Point2& p : graph.points) p = {p.x * scale, p.y * scale};
    const ConstrainedTriangulation t(graph, splitting());
    EXPECT_EQ(defect_of(t), "none") << scale;
  }
}

TEST(Constrained, CollinearPointsHaveDividedSegmentsAndNoTriangles) {
  PlanarGraph graph;
  graph.points = {{3, 3}, {0, 0}, {1, 1}, {2, 2}};
  graph.segments = {{0, 1}, {2, 2}};
  const ConstrainedTriangulation t(graph);
  EXPECT_EQ(t.num_triangles(), 0);
  EXPECT_EQ(t.path(0), (std::vector<Node>{0, 3, 2, 1}));
  EXPECT_EQ(t.path(1), (std::vector<Node>{2}));
  EXPECT_EQ(t.report().on_segment.size(), 2U);
  EXPECT_EQ(t.locate({1, 1}).kind, Location::Kind::outside);
}

TEST(Constrained, FewPointsAreValues) {
  EXPECT_EQ(ConstrainedTriangulation(PlanarGraph{}).num_triangles(), 0);
  PlanarGraph graph{.points = {{1, 1}}, .segments = {{0, 0}}};
  const ConstrainedTriangulation t(graph);
  EXPECT_EQ(t.report().zero_length.size(), 1U);
}

TEST(Constrained, RefusesRowsThatAreNotThere) {
  PlanarGraph graph{.points = {{0, 0}, {1, 0}, {0, 1}}, .segments = {{0, 1}, {1, 3}}};
  try {
    const ConstrainedTriangulation t(graph);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.rows()[0], 1);
    EXPECT_STREQ(error.what(),
                 "segment 1 ends at row 3, but there are 3 points; correct its ends");
  }
  graph.segments = {{-1, 0}};
  EXPECT_THROW(ConstrainedTriangulation{graph}, Error);
  graph.segments = {};
  graph.holes = {{std::nan(""), 0}};
  EXPECT_THROW(ConstrainedTriangulation{graph}, Error);
}

TEST(Constrained, DefectIsFoundWhereATriangulationIsNotTheRightOne) {
  // A graph whose segment is not a Delaunay edge against one without it: the check must
  // tell them apart through the triangles of a foreign list.
  PlanarGraph graph;
  graph.points = {{0, 0}, {4, 0}, {2, 1}, {2, -1}};
  graph.segments = {{0, 1}};
  const ConstrainedTriangulation t(graph, only(Domain::hull));
  EXPECT_EQ(defect_of(t), "none");
  EXPECT_NE(find_defect(graph.points, t.triangles()), std::nullopt);
}

}  // namespace
}  // namespace delone::tripack
