// locate, find and nearest against looking at everything.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

#include "stripack/triangulation.hpp"
#include "support/exact.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using delaunay::none;
using support::SpherePoints;
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
Place place_in(const SpherePoints& points, const std::array<Node, 3>& t,
               const Direction& p) {
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

Place looked_up(const SpherePoints& points, const Triangulation& t, const Direction& p) {
  for (const auto& triangle : t.triangles()) {
    const Place place = place_in(points, triangle, p);
    if (place.kind != Kind::outside) return place;
  }
  return {};
}

Direction sum(const Direction& a, const Direction& b) {
  return Direction::from(a.x() + b.x(), a.y() + b.y(), a.z() + b.z());
}

// Nodes, their opposites, midpoints of edges, points inside triangles, points all around,
// and points of the axes, which lie exactly on edges of regular sets.
SpherePoints queries_for(const SpherePoints& points, const Triangulation& t) {
  SpherePoints queries = points;
  for (const Direction& d : points)
    queries.push_back(Direction::from(-d.x(), -d.y(), -d.z()));
  for (const auto& triangle : t.triangles()) {
    const auto at = [&](std::size_t k) {
      return points[static_cast<std::size_t>(triangle[k])];
    };
    queries.push_back(sum(at(0), at(1)));
    queries.push_back(sum(sum(at(0), at(1)), at(2)));
  }
  for (const Direction& d : support::uniform_directions(60, 19)) queries.push_back(d);
  for (int lon = -180; lon < 180; lon += 15)
    queries.push_back(Direction::from(LonLat{1.0 * lon, 0}));
  for (int lat = -90; lat <= 90; lat += 15)
    queries.push_back(Direction::from(LonLat{90, 1.0 * lat}));
  return queries;
}

SpherePoints grid(double step_deg) {
  SpherePoints points;
  for (const LonLat p : support::global_grid(step_deg))
    points.push_back(Direction::from(p));
  return points;
}

SpherePoints northern(SpherePoints points) {
  std::erase_if(points, [](const Direction& d) { return d.z() < 0; });
  return points;
}

std::vector<SpherePoints> sets() {
  return {support::uniform_directions(60, 1),
          grid(30),
          northern(support::uniform_directions(60, 2)),
          northern(grid(45)),
          support::icosahedral_directions(1),
          support::box_directions(30, 3, 1e-9),
          {Direction::from(LonLat{0, 0}), Direction::from(LonLat{90, 0}),
           Direction::from(LonLat{0, 90})}};
}

// The first row of each position stands for it.
SpherePoints different(const SpherePoints& points, const Triangulation& t) {
  SpherePoints result;
  for (const Node row : t.rows()) result.push_back(points[static_cast<std::size_t>(row)]);
  return result;
}

TEST(SphereLocate, AgreesWithLookingAtAllTriangles) {
  for (const SpherePoints& points : sets()) {
    const Triangulation t(points);
    for (const Direction& p : queries_for(points, t)) {
      const Place expected = looked_up(points, t, p);
      for (const Node hint : {none, Node{0}, t.num_rows() - 1}) {
        EXPECT_EQ(sorted(t.locate(p, hint)), expected)
            << p.x() << " " << p.y() << " " << p.z();
      }
    }
  }
}

TEST(SphereLocate, IsOutsideNowhereOnAClosedSphere) {
  const Triangulation t(support::uniform_directions(50, 4));
  ASSERT_TRUE(t.boundary().empty());
  for (const Direction& p : support::uniform_directions(500, 5)) {
    EXPECT_EQ(t.locate(p).kind, Kind::triangle);
  }
}

TEST(SphereFind, StopsAtATriangleThatHoldsThePointOrAtTheBoundary) {
  for (const SpherePoints& points : sets()) {
    const Triangulation t(points);
    Arc start;
    for (const Direction& p : queries_for(points, t)) {
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

double squared_chord(const Direction& a, const Direction& b) {
  const double x = a.x() - b.x(), y = a.y() - b.y(), z = a.z() - b.z();
  return x * x + y * y + z * z;
}

// The squares compared are rounded, so rivals may differ in the last places.
TEST(SphereNearest, AgreesWithLookingAtAllNodes) {
  for (const SpherePoints& points : sets()) {
    const Triangulation t(points);
    const SpherePoints nodes = different(points, t);
    for (const Direction& p : queries_for(points, t)) {
      double least = 10;
      for (const Direction& q : nodes) least = std::min(least, squared_chord(p, q));
      for (const Node hint : {none, Node{0}, t.num_rows() - 1}) {
        const Node row = t.nearest(p, hint);
        ASSERT_GE(row, 0);
        EXPECT_LE(squared_chord(points[static_cast<std::size_t>(row)], p),
                  least * (1 + 1e-15))
            << p.x() << " " << p.y() << " " << p.z() << ", hint " << hint;
      }
    }
  }
}

TEST(SphereNearest, AnswersWithTheFirstOfRepeatedRows) {
  const SpherePoints points = grid(30);
  const Triangulation t(points);
  EXPECT_EQ(t.nearest(Direction::from(LonLat{44, -90})), 0);
  EXPECT_EQ(t.locate(Direction::from(LonLat{180, 0})).nodes[0],
            t.nearest(Direction::from(LonLat{-180, 0})));
}

}  // namespace
}  // namespace delone::stripack
