#include "stripack/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/defect.hpp"
#include "stripack/predicates.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using delaunay::none;
using support::SpherePoints;
using Rows = std::vector<Node>;
using Triangles = std::vector<std::array<Node, 3>>;
using Kind = Location::Kind;

SpherePoints at(const std::vector<LonLat>& places) {
  SpherePoints points;
  for (const LonLat p : places) points.push_back(Direction::from(p));
  return points;
}

const SpherePoints octahedron =
    at({{0, 0}, {90, 0}, {180, 0}, {-90, 0}, {0, 90}, {0, -90}});

TEST(SphereTriangulation, OfTheOctahedronHasItsEightFaces) {
  const Triangulation t(octahedron);
  const Triangles expected{{0, 1, 4}, {0, 3, 5}, {0, 4, 3}, {0, 5, 1},
                           {1, 2, 4}, {1, 5, 2}, {2, 3, 4}, {2, 5, 3}};
  EXPECT_EQ(t.triangles(), expected);
  EXPECT_EQ(t.adjacency().num_arcs(), 2 * (3 * 6 - 6));
  EXPECT_TRUE(t.boundary().empty());
}

TEST(SphereTriangulation, OfTheIcosahedralGridHasFiveNeighborsAtTwelveNodes) {
  const Triangulation t(support::icosahedral_directions(3));
  EXPECT_EQ(t.num_sites(), 642);
  EXPECT_EQ(t.num_triangles(), 1280);
  int num_five = 0;
  for (Node row = 0; row < t.num_rows(); ++row)
    num_five += t.neighbors(row).size() == 5 ? 1 : 0;
  EXPECT_EQ(num_five, 12);
}

TEST(SphereTriangulation, OfNothingIsEmpty) {
  const Triangulation t{SpherePoints{}};
  EXPECT_EQ(t.dimension(), -1);
  EXPECT_TRUE(t.triangles().empty());
  EXPECT_TRUE(t.boundary().empty());
  EXPECT_EQ(t.nearest(octahedron[0]), none);
  EXPECT_EQ(t.locate(octahedron[0]).kind, Kind::outside);
  EXPECT_EQ(t.find(octahedron[0]), Arc{});
}

TEST(SphereTriangulation, OfOnePositionIsOneSite) {
  const Triangulation t(SpherePoints(4, octahedron[1]));
  EXPECT_EQ(t.dimension(), 0);
  EXPECT_EQ(t.num_sites(), 1);
  EXPECT_EQ(t.nearest(octahedron[3]), 0);
  EXPECT_EQ(t.locate(octahedron[1]).kind, Kind::node);
  EXPECT_EQ(t.locate(octahedron[3]).kind, Kind::outside);
}

TEST(SphereTriangulation, OfPartOfAGreatCircleIsAChain) {
  const Triangulation t(at({{30, 0}, {-10, 0}, {100, 0}, {50, 0}}));
  EXPECT_EQ(t.dimension(), 1);
  EXPECT_EQ(t.num_triangles(), 0);
  EXPECT_TRUE(t.triangles().empty());
  Rows chain = t.boundary();
  if (chain.front() != 1) std::reverse(chain.begin(), chain.end());
  EXPECT_EQ(chain, (Rows{1, 0, 3, 2}));
  EXPECT_EQ(t.locate(Direction::from(LonLat{45, 0})).kind, Kind::edge);
  EXPECT_EQ(t.locate(Direction::from(LonLat{45, 1})).kind, Kind::outside);
  EXPECT_EQ(t.locate(Direction::from(LonLat{-45, 0})).kind, Kind::outside);
  EXPECT_EQ(t.nearest(Direction::from(LonLat{45, 80})), 3);
}

TEST(SphereTriangulation, OfAWholeGreatCircleIsARing) {
  const Triangulation t(at({{0, 0}, {90, 0}, {180, 0}, {-90, 0}}));
  EXPECT_EQ(t.dimension(), 1);
  for (Node row = 0; row < 4; ++row) EXPECT_EQ(t.neighbors(row).size(), 2u);
  EXPECT_EQ(t.locate(Direction::from(LonLat{-45, 0})).kind, Kind::edge);
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
}

// The equator is the boundary of half a sphere; with points on both sides there is none.
TEST(SphereTriangulation, HasABoundaryOnlyInAHemisphere) {
  SpherePoints points = octahedron;
  points.pop_back();
  EXPECT_EQ(Triangulation(points).boundary(), (Rows{0, 1, 2, 3}));
  points.push_back(Direction::from(LonLat{45, -1e-300}));
  EXPECT_TRUE(Triangulation(points).boundary().empty());
  EXPECT_EQ(Triangulation(points).num_triangles(), 8);
}

// Opposite points on the boundary, whose arc is on the outside.
TEST(SphereTriangulation, HandlesALuneBetweenThePoles) {
  const Triangulation t(at({{0, 90}, {0, -90}, {0, 0}, {40, 0}}));
  EXPECT_EQ(t.num_triangles(), 2);
  EXPECT_EQ(t.boundary().size(), 4u);
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
}

// 721 x 361 rows; through radians all of them stay apart (GMT issue 4254).
TEST(SphereTriangulation, OfAHalfDegreeGridKnowsItsDifferentNodes) {
  const auto grid = support::global_grid(0.5);
  ASSERT_EQ(grid.size(), 260281u);
  SpherePoints points, naive;
  std::set<std::array<double, 3>> through_radians;
  for (const LonLat p : grid) {
    points.push_back(Direction::from(p));
    const double lon = p.lon_deg * std::numbers::pi / 180,
                 lat = p.lat_deg * std::numbers::pi / 180;
    through_radians.insert(
        {std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)});
  }
  EXPECT_EQ(through_radians.size(), 260281u);
  const Triangulation t(points);
  EXPECT_EQ(t.num_rows(), 260281);
  EXPECT_EQ(t.num_sites(), 258482);
  EXPECT_EQ(t.num_triangles(), 2 * 258482 - 4);
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
}

TEST(SphereTriangulation, OfSmallBoxesHasNoDefect) {
  for (const double side : {1e-6, 1e-9, 1e-12}) {
    const SpherePoints points = support::box_directions(2000, 4, side);
    const Triangulation t(points);
    EXPECT_EQ(find_defect(t).value_or("none"), "none") << side;
    EXPECT_EQ(t.num_triangles(),
              2 * t.num_sites() - 2 - static_cast<Node>(t.boundary().size()));
    // Doubles are 1e-16 apart: only the smallest box makes points fall together.
    if (side > 1e-10) {
      EXPECT_EQ(t.num_sites(), 2000);
    }
  }
}

TEST(SphereTriangulation, IsTheOneOfTheDefinitionWithPerturbedTies) {
  support::SplitMix64 random(31);
  for (int trial = 0; trial < 150; ++trial) {
    SpherePoints points;
    while (points.size() < 9) {
      const Direction d =
          Direction::from(LonLat{30.0 * static_cast<double>(random.below(12)),
                                 30.0 * static_cast<double>(random.below(7)) - 90});
      if (std::find(points.begin(), points.end(), d) == points.end()) points.push_back(d);
    }
    Triangles expected;
    for (const auto& t :
         support::empty_circle_triangles(std::span<const Direction>(points))) {
      const auto corner = [&](std::size_t k) {
        return points[static_cast<std::size_t>(t[k])];
      };
      const auto is_empty_of = [&](const Direction& p) {
        return p == corner(0) || p == corner(1) || p == corner(2) ||
               in_circle_perturbed(corner(0), corner(1), corner(2), p) < 0;
      };
      if (std::all_of(points.begin(), points.end(), is_empty_of)) expected.push_back(t);
    }
    ASSERT_EQ(Triangulation(points).triangles(), expected) << "trial " << trial;
  }
}

// Every set of up to six directions of a cube's corners and axes.
TEST(SphereTriangulation, IsRightForEverySmallSetOfCubeDirections) {
  SpherePoints all = octahedron;
  for (int i = 0; i < 8; ++i) {
    all.push_back(Direction::from(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  int num_sets = 0;
  for (unsigned subset = 0; subset < (1u << 14); ++subset) {
    SpherePoints points;
    for (unsigned i = 0; i < 14; ++i) {
      if (subset >> i & 1u) points.push_back(all[i]);
    }
    if (points.size() > 6) continue;
    ++num_sets;
    const Triangulation t(points);
    ASSERT_EQ(find_defect(t).value_or("none"), "none") << "subset " << subset;
    ASSERT_EQ(support::exact_defect(points, t.triangles()).value_or("none"), "none");
  }
  EXPECT_EQ(num_sets, 1 + 14 + 91 + 364 + 1001 + 2002 + 3003);
}

TEST(SphereTriangulation, DoesNotDependOnTheLengthOfVectors) {
  const SpherePoints points = support::uniform_directions(500, 5);
  SpherePoints scaled;
  for (const Direction& d : points)
    scaled.push_back(Direction::from(4 * d.x(), 4 * d.y(), 4 * d.z()));
  EXPECT_EQ(Triangulation(scaled).triangles(), Triangulation(points).triangles());
}

// Where there are no ties the triangulation is unique, so it turns and mirrors with the
// points.
TEST(SphereTriangulation, TurnsAndMirrorsWithPointsInGeneralPosition) {
  const SpherePoints points = support::uniform_directions(600, 6);
  const Triangles triangles = Triangulation(points).triangles();
  SpherePoints turned, mirrored;
  for (const Direction& d : points) {
    turned.push_back(Direction::from(d.y(), d.z(), d.x()));
    mirrored.push_back(Direction::from(d.y(), d.x(), d.z()));
  }
  EXPECT_EQ(Triangulation(turned).triangles(), triangles);
  Triangles reversed = Triangulation(mirrored).triangles();
  for (auto& t : reversed) std::swap(t[1], t[2]);
  std::sort(reversed.begin(), reversed.end());
  EXPECT_EQ(reversed, triangles);
}

TEST(SphereTriangulation, DoesNotDependOnTheNumberOfThreads) {
  const SpherePoints points = support::track_directions(20000);
  const Triangulation one(points, {.num_threads = 1, .progress = {}});
  for (const int num_threads : {2, 3, 8}) {
    const Triangulation many(points, {.num_threads = num_threads, .progress = {}});
    EXPECT_TRUE(many.adjacency() == one.adjacency()) << num_threads;
  }
}

TEST(SphereTriangulation, MergesPolesAndTheDateLine) {
  const Triangulation t(
      at({{0, 90}, {77, 90}, {180, 5}, {-180, 5}, {540, 5}, {0, 0}, {90, -30}}));
  EXPECT_EQ(t.num_sites(), 4);
  EXPECT_EQ(t.sites()[0], t.sites()[1]);
  EXPECT_EQ(t.sites()[2], t.sites()[3]);
  EXPECT_EQ(t.sites()[2], t.sites()[4]);
  for (const auto& triangle : t.triangles()) {
    for (const Node row : triangle) EXPECT_TRUE(row == 0 || row == 2 || row >= 5);
  }
}

TEST(SphereTriangulation, HandlesAHubAtThePole) {
  SpherePoints points;
  for (int i = 0; i < 1000; ++i) points.push_back(Direction::from(LonLat{0.36 * i, 60}));
  points.push_back(Direction::from(LonLat{0, 90}));
  points.push_back(Direction::from(LonLat{0, -90}));
  const Triangulation t(points);
  EXPECT_EQ(t.neighbors(1000).size(), 1000u);
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
  EXPECT_TRUE(from_renka(to_renka(t.adjacency())) == t.adjacency());
}

}  // namespace
}  // namespace delone::stripack
