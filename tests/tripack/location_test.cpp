// locate, find and nearest against looking at everything.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "support/exact.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {
namespace {

using delaunay::none;
using support::PlanePoints;
using Kind = Location::Kind;

// Kind and sorted nodes.
struct Place {
  Kind kind = Kind::outside;
  std::array<Node, 3> nodes{none, none, none};
  friend bool operator==(const Place&, const Place&) = default;
  friend void PrintTo(const Place& p, std::ostream* out) {
    *out << static_cast<int>(p.kind) << " {" << p.nodes[0] << " " << p.nodes[1] << " "
         << p.nodes[2] << "}";
  }
};

Place sorted(Location location) {
  std::sort(location.nodes.begin(), location.nodes.end());
  return {location.kind, location.nodes};
}

// Which of a triangle's corners p needs, if it holds p: those opposite to sides p is not
// on.
Place place_in(const PlanePoints& points, const std::array<Node, 3>& t, Point2 p) {
  Place place;
  int num = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t i) {
      return points[static_cast<std::size_t>(t[i % 3])];
    };
    const int side = support::exact_orientation(at(k + 1), at(k + 2), p);
    if (side < 0) return {};
    if (side > 0) place.nodes[static_cast<std::size_t>(num++)] = t[k];
  }
  place.kind = num == 1 ? Kind::node : num == 2 ? Kind::edge : Kind::triangle;
  std::sort(place.nodes.begin(), place.nodes.end());
  return place;
}

Place looked_up(const PlanePoints& points, const Triangulation& t, Point2 p) {
  for (const auto& triangle : t.triangles()) {
    const Place place = place_in(points, triangle, p);
    if (place.kind != Kind::outside) return place;
  }
  return {};
}

// Nodes, midpoints of edges and of triangles, points of a grid around, and far away.
PlanePoints queries_for(const PlanePoints& points, const Triangulation& t) {
  PlanePoints queries = points;
  for (const auto& triangle : t.triangles()) {
    const auto at = [&](std::size_t k) {
      return points[static_cast<std::size_t>(triangle[k])];
    };
    queries.push_back({(at(0).x + at(1).x) / 2, (at(0).y + at(1).y) / 2});
    queries.push_back({at(0).x / 4 + at(1).x / 4 + at(2).x / 2,
                       at(0).y / 4 + at(1).y / 4 + at(2).y / 2});
  }
  for (const Point2 p : support::uniform_points(60, 19))
    queries.push_back({12 * p.x - 2, 12 * p.y - 2});
  queries.insert(queries.end(), {{1e300, -1e300}, {-1e9, 3}, {0.5, 1e-300}});
  return queries;
}

std::vector<PlanePoints> sets() {
  PlanePoints wide = support::uniform_points(40, 1);
  for (Point2& p : wide) p = {8 * p.x, 8 * p.y};
  return {wide,
          support::shuffled(support::lattice_points(64), 3),
          support::wheel_points(24),
          {{0, 0}, {8, 0}, {3, 8}},
          {{0, 0}, {3, -2}, {0, 0.008016}, {3, 3}}};
}

TEST(Locate, AgreesWithLookingAtAllTriangles) {
  for (const PlanePoints& points : sets()) {
    const Triangulation t(points);
    for (const Point2 p : queries_for(points, t)) {
      const Place expected = looked_up(points, t, p);
      for (const Node hint : {none, Node{0}, t.num_rows() - 1}) {
        EXPECT_EQ(sorted(t.locate(p, hint)), expected)
            << p.x << ", " << p.y << ", hint " << hint;
      }
    }
  }
}

TEST(Locate, ListsTrianglesCounterClockwise) {
  const PlanePoints points = support::uniform_points(50, 2);
  const Triangulation t(points);
  int num_inside = 0;
  for (const Point2 p : support::uniform_points(100, 3)) {
    const Location place = t.locate(p);
    if (place.kind != Kind::triangle) continue;
    ++num_inside;
    const auto at = [&](std::size_t k) {
      return points[static_cast<std::size_t>(place.nodes[k])];
    };
    EXPECT_GT(support::exact_orientation(at(0), at(1), at(2)), 0);
  }
  EXPECT_GT(num_inside, 50);
}

TEST(Locate, AnswersWithTheFirstOfRepeatedRows) {
  const Triangulation t(PlanePoints{{0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 0}});
  EXPECT_EQ(t.locate({1, 0}).nodes[0], 1);
  EXPECT_EQ(t.nearest({0.9, 0}), 1);
  EXPECT_EQ(t.nearest({-1, -1}), 0);
}

// scipy issue 22831: a point computed on an edge; it is on one side of it, and inside all
// the same.
TEST(Locate, FindsAPointComputedOnAnEdge) {
  const PlanePoints points{{0, 0}, {3, -2}, {0, 0.008016}, {1, -3}};
  const Triangulation t(points);
  for (int i = 1; i < 100; ++i) {
    const double f = i / 100.0;
    EXPECT_NE(t.locate({f * 3, f * -2}).kind, Kind::outside) << f;
  }
}

TEST(Find, StopsAtATriangleThatHoldsThePointOrAtTheBoundary) {
  for (const PlanePoints& points : sets()) {
    const Triangulation t(points);
    Arc start;
    for (const Point2 p : queries_for(points, t)) {
      const Arc a = t.find(p, start);
      const auto at = [&](Site s) { return t.points()[static_cast<std::size_t>(s)]; };
      const auto& adjacency = t.adjacency();
      if (adjacency.has_left(a)) {
        const auto corners = adjacency.left(a);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_GE(
              support::exact_orientation(at(corners[k]), at(corners[(k + 1) % 3]), p), 0);
        }
      } else {
        EXPECT_GT(support::exact_orientation(at(a.origin), at(adjacency.target(a)), p),
                  0);
      }
      start = a;
    }
  }
}

double squared_distance(Point2 a, Point2 b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// The squares compared are rounded, so rivals may differ in the last places.
TEST(Nearest, AgreesWithLookingAtAllNodes) {
  for (const PlanePoints& points : sets()) {
    const Triangulation t(points);
    for (const Point2 p : queries_for(points, t)) {
      double least = std::numeric_limits<double>::infinity();
      for (const Point2 q : points) least = std::min(least, squared_distance(p, q));
      for (const Node hint : {none, Node{0}, t.num_rows() - 1}) {
        const Node row = t.nearest(p, hint);
        ASSERT_GE(row, 0);
        const double found = squared_distance(points[static_cast<std::size_t>(row)], p);
        EXPECT_LE(found, least * (1 + 1e-14)) << p.x << ", " << p.y << ", hint " << hint;
      }
    }
  }
}

TEST(Nearest, WorksAlongAChain) {
  PlanePoints points;
  for (int i = 0; i < 30; ++i) points.push_back({3.0 * i, -1.0 * i});
  const Triangulation t(support::shuffled(points, 4));
  for (int i = 0; i < 30; ++i) {
    const Node row = t.nearest({3.0 * i + 0.4, -1.0 * i + 1.2});
    EXPECT_EQ(support::shuffled(points, 4)[static_cast<std::size_t>(row)],
              points[static_cast<std::size_t>(i)]);
  }
}

}  // namespace
}  // namespace delone::tripack
