#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

#include "delaunay/error.hpp"
#include "stripack/constrained_defect.hpp"
#include "stripack/constrained_triangulation.hpp"
#include "stripack/defect.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/same_mesh.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::SplitMix64;
constexpr double pi = std::numbers::pi;

std::string defect_of(const ConstrainedTriangulation& t) {
  return find_defect(t).value_or("none");
}

Direction at(double lon, double lat) { return Direction::from(LonLat{lon, lat}); }

/// Solid angle of a triangle (A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30
/// (1983) 125-126).
double solid_angle(const Direction& a, const Direction& b, const Direction& c) {
  const auto dot = [](const Direction& p, const Direction& q) {
    return p.x() * q.x() + p.y() * q.y() + p.z() * q.z();
  };
  const double det = a.x() * (b.y() * c.z() - b.z() * c.y()) +
                     a.y() * (b.z() * c.x() - b.x() * c.z()) +
                     a.z() * (b.x() * c.y() - b.y() * c.x());
  return 2 * std::atan2(det, 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

double area(const ConstrainedTriangulation& t) {
  double sum = 0;
  for (const auto& [i, j, k] : t.triangles())
    sum += solid_angle(t.point(i), t.point(j), t.point(k));
  return sum;
}

/// A ring of n points of one latitude, eastwards: its region is the one to the north.
void add_parallel(SphereGraph& graph, double lat, int n) {
  const auto first = static_cast<Node>(graph.points.size());
  for (int i = 0; i < n; ++i) {
    graph.points.push_back(at(360.0 * i / n - 180, lat));
    graph.arcs.push_back({first + i, first + (i + 1) % n});
  }
}

/// Area north of a ring of n great-circle arcs between points of one latitude.
double area_north_of_ring(double lat_deg, int n) {
  const double half = pi / n, lat = lat_deg * pi / 180;
  // Each arc, the two meridians of its ends and the pole form an isosceles triangle.
  const double side = pi / 2 - lat;
  const double excess =
      2 * std::atan2(std::pow(std::tan(side / 2), 2) * std::sin(2 * half),
                     1 + std::pow(std::tan(side / 2), 2) * std::cos(2 * half));
  return n * excess;
}

TEST(SphereConstrained, WithoutArcsIsTheDelaunayTriangulation) {
  for (const auto& family : support::sphere_families()) {
    const SphereGraph graph{.points = family.make(60, 3)};
    const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
    EXPECT_EQ(t.triangles(), Triangulation(graph.points).triangles()) << family.name;
    EXPECT_EQ(defect_of(t), "none") << family.name;
  }
}

// 5000 points are more than one block of the builder.
TEST(SphereConstrained, WithoutArcsHasTheFacesOfTheNeighborLists) {
  for (const auto& family : support::sphere_families()) {
    for (const std::size_t n : {4U, 17U, 150U, 5000U}) {
      const SphereGraph graph{.points = family.make(n, 5)};
      const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
      const auto lists = Triangulation(graph.points).adjacency();
      EXPECT_TRUE(support::is_same_mesh(t.mesh(), ClosedMesh::from(lists)))
          << family.name << " " << n;
    }
  }
}

TEST(SphereConstrained, SplitsAnyArcsOfAnyPoints) {
  SplitMix64 random(2);
  for (const auto& family : support::sphere_families()) {
    for (const std::size_t n : {6U, 30U, 60U}) {
      SphereGraph graph{.points = family.make(n, n)};
      const std::size_t size = graph.points.size();
      if (size == 0) continue;
      for (std::size_t i = 0; i < n / 2; ++i) {
        const std::size_t a = random.below(size), b = random.below(size);
        if (angle(graph.points[a], graph.points[b]) > 3.1) continue;
        graph.arcs.push_back({static_cast<Node>(a), static_cast<Node>(b)});
      }
      const ConstrainedTriangulation t(
          graph, {.domain = Domain::hull, .crossings = Crossings::split});
      EXPECT_EQ(defect_of(t), "none") << family.name << " " << n;
    }
  }
}

TEST(SphereConstrained, RefusesExactlyTheArcsThatCross) {
  SplitMix64 random(4);
  int num_refused = 0;
  for (int round = 0; round < 300; ++round) {
    SphereGraph graph{.points = support::uniform_directions(12, random.next())};
    for (int i = 0; i < 3; ++i) {
      graph.arcs.push_back(
          {static_cast<Node>(random.below(12)), static_cast<Node>(random.below(12))});
    }
    const auto crosses = [&](std::size_t i, std::size_t j) {
      const auto p = [&](Node k) { return graph.points[static_cast<std::size_t>(k)]; };
      const auto side = [&](Node a, Node b, Node c) {
        return support::exact_orientation(p(a), p(b), p(c));
      };
      const auto& [a, b] = graph.arcs[i];
      const auto& [c, d] = graph.arcs[j];
      // Both pairs apart, and on the same side of the sphere: not the far crossing.
      return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0 &&
             side(a, b, c) == side(c, d, b);
    };
    const bool any = crosses(0, 1) || crosses(0, 2) || crosses(1, 2);
    try {
      const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
      EXPECT_EQ(defect_of(t), "none");
      EXPECT_FALSE(any) << round;
    } catch (const Error& error) {
      ++num_refused;
      EXPECT_TRUE(crosses(static_cast<std::size_t>(error.rows()[0]),
                          static_cast<std::size_t>(error.rows()[1])))
          << error.what();
    }
  }
  EXPECT_GT(num_refused, 30);
}

TEST(SphereConstrained, DoesNotDependOnTheOrderOfPointsOrArcs) {
  SplitMix64 random(5);
  for (int round = 0; round < 30; ++round) {
    SphereGraph graph{.points = support::uniform_directions(40, random.next())};
    for (int i = 0; i < 15; ++i) {
      graph.arcs.push_back(
          {static_cast<Node>(random.below(40)), static_cast<Node>(random.below(40))});
    }
    SphereGraph backwards = graph;
    std::reverse(backwards.points.begin(), backwards.points.end());
    std::reverse(backwards.arcs.begin(), backwards.arcs.end());
    for (auto& [a, b] : backwards.arcs) a = 39 - a, b = 39 - b, std::swap(a, b);
    const auto positions = [](const SphereGraph& g) {
      const ConstrainedTriangulation t(
          g, {.domain = Domain::hull, .crossings = Crossings::split});
      std::multiset<double> result;
      for (const auto& [i, j, k] : t.triangles()) {
        result.insert(t.point(i).x() + t.point(j).x() + t.point(k).x());
      }
      return result;
    };
    const auto a = positions(graph), b = positions(backwards);
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(),
                           [](double u, double v) { return std::abs(u - v) < 1e-14; }));
  }
}

TEST(SphereConstrained, RingRoundAPoleEnclosesTheCap) {
  SphereGraph graph;
  add_parallel(graph, 60, 24);
  const ConstrainedTriangulation ring(graph);
  EXPECT_NEAR(area(ring), area_north_of_ring(60, 24), 1e-13);
  graph.points.push_back(at(0, 90));
  graph.points.push_back(at(0, -90));
  const ConstrainedTriangulation cap(graph);
  EXPECT_NEAR(area(cap), area_north_of_ring(60, 24), 1e-13);
  EXPECT_EQ(cap.num_triangles(), 24);
  EXPECT_EQ(cap.locate(at(12, 89)).kind, Location::Kind::triangle);
  EXPECT_EQ(cap.locate(at(12, 30)).kind, Location::Kind::outside);
  EXPECT_EQ(defect_of(cap), "none");
}

TEST(SphereConstrained, RegionLargerThanAHemisphereIsKept) {
  SphereGraph graph;
  add_parallel(graph, 60, 24);
  for (auto& [a, b] : graph.arcs) std::swap(a, b);  // westwards: the south is inside
  for (const double lat : {0.0, -90.0}) {
    for (const double lon : {0.0, 90.0, 180.0, -90.0})
      graph.points.push_back(at(lon, lat));
  }
  const ConstrainedTriangulation t(graph);
  EXPECT_NEAR(area(t), 4 * pi - area_north_of_ring(60, 24), 1e-12);
  EXPECT_EQ(t.locate(at(0, 89)).kind, Location::Kind::outside);
  EXPECT_EQ(t.locate(at(1, -60)).kind, Location::Kind::triangle);
  EXPECT_EQ(defect_of(t), "none");
  // The same region by a point outside of it.
  const ConstrainedTriangulation other(graph, {.outside = at(0, 80)});
  EXPECT_EQ(other.triangles(), t.triangles());
}

TEST(SphereConstrained, DomainBeyondTheHullOfItsPointsIsAnError) {
  SphereGraph graph;
  add_parallel(graph, 60, 24);
  for (auto& [a, b] : graph.arcs) std::swap(a, b);
  EXPECT_THROW(ConstrainedTriangulation{graph}, Error);
  EXPECT_NEAR(area(ConstrainedTriangulation(graph, {.domain = Domain::enclosed})),
              area_north_of_ring(60, 24), 1e-13);
}

TEST(SphereConstrained, RingsAcrossTheDateLineAreNothingSpecial) {
  SphereGraph graph;
  for (const auto& [lon, lat] :
       {std::pair(170.0, -10.0), {-170.0, -10.0}, {-170.0, 10.0}, {170.0, 10.0}})
    graph.points.push_back(at(lon, lat));
  graph.arcs = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  for (const double lon : {0.0, 90.0, -90.0}) graph.points.push_back(at(lon, 0));
  graph.points.push_back(at(0, 90));
  const ConstrainedTriangulation t(graph);
  EXPECT_EQ(t.num_triangles(), 2);
  EXPECT_EQ(t.locate(at(180, 1)).kind, Location::Kind::triangle);
  EXPECT_EQ(t.locate(at(160, 1)).kind, Location::Kind::outside);
}

TEST(SphereConstrained, IslandsInLakesInIslandsAlternate) {
  SphereGraph graph;
  for (const double lat : {-30.0, 0.0, 30.0, 60.0}) add_parallel(graph, lat, 36);
  graph.points.push_back(at(0, -90));
  graph.points.push_back(at(0, 90));
  const ConstrainedTriangulation t(graph, {.outside = at(10, -60)});
  const auto north = [](double lat) { return area_north_of_ring(lat, 36); };
  EXPECT_NEAR(area(t), north(-30) - north(0) + north(30) - north(60), 1e-12);
  EXPECT_EQ(t.regions().size(), 2U);
  const ConstrainedTriangulation whole(graph, {.domain = Domain::hull});
  EXPECT_NEAR(area(whole), 4 * pi, 1e-13 * 4 * pi);
  EXPECT_EQ(whole.regions().size(), 5U);
}

TEST(SphereConstrained, HolesAndRegionsAreNamedByPoints) {
  SphereGraph graph;
  add_parallel(graph, 0, 12);
  add_parallel(graph, 60, 12);
  graph.points.push_back(at(0, -90));
  graph.holes = {at(7, 80)};
  graph.regions = {{at(7, 30), 3}, {at(7, 85), 4}};
  const ConstrainedTriangulation t(graph,
                                   {.domain = Domain::enclosed, .outside = at(7, -40)});
  EXPECT_NEAR(area(t), area_north_of_ring(0, 12) - area_north_of_ring(60, 12), 1e-12);
  ASSERT_EQ(t.regions().size(), 1U);
  EXPECT_EQ(t.regions()[0].attribute, 3);
}

TEST(SphereConstrained, AntipodalEndsAreAnErrorThatNamesTheArc) {
  SphereGraph graph{.points = {at(10, 20), at(-170, -20), at(0, 90)},
                    .arcs = {{2, 0}, {0, 1}}};
  try {
    const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.rows()[0], 1);
    EXPECT_NE(std::string(error.what()).find("antipodes"), std::string::npos);
  }
}

TEST(SphereConstrained, PointsOnAnArcDivideIt) {
  SphereGraph graph;
  for (const double lon : {0.0, 10.0, 20.0, 30.0}) graph.points.push_back(at(lon, 0));
  graph.points.push_back(at(15, 20));
  graph.points.push_back(at(15, -20));
  graph.arcs = {{3, 0}};
  const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
  EXPECT_EQ(t.path(0), (std::vector<Node>{3, 2, 1, 0}));
  EXPECT_EQ(t.report().on_segment.size(), 2U);
  EXPECT_EQ(defect_of(t), "none");
}

TEST(SphereConstrained, PointsOfOneGreatCircleHaveDividedArcsAndNoTriangles) {
  for (const double step : {10.0, 60.0}) {  // an open chain and a closed one
    SphereGraph graph;
    for (int i = 0; i < 6; ++i) graph.points.push_back(at(170 + step * i, 0));
    graph.arcs = {{0, 2}, {5, 4}};
    const ConstrainedTriangulation t(graph, {.domain = Domain::hull});
    EXPECT_EQ(t.num_triangles(), 0);
    EXPECT_EQ(t.path(0), (std::vector<Node>{0, 1, 2}));
    EXPECT_EQ(t.path(1), (std::vector<Node>{5, 4}));
  }
}

TEST(SphereConstrained, CoastlinesOfTheWorldEncloseItsLand) {
  const auto path =
      std::filesystem::path(DELONE_SHARED_DATA_DIR) / "coast" / "gshhg_low.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  SphereGraph graph;
  std::string last_id;
  Node first = 0;
  const auto close = [&] {
    const auto end = static_cast<Node>(graph.points.size());
    for (Node i = first; i < end; ++i)
      graph.arcs.push_back({i, i + 1 < end ? i + 1 : first});
    first = end;
  };
  while (std::getline(file, line)) {
    std::istringstream stream(line);
    std::string id, level, parent, lon, lat;
    std::getline(stream, id, ','), std::getline(stream, level, ',');
    std::getline(stream, parent, ','), std::getline(stream, lon, ',');
    std::getline(stream, lat, ',');
    if (id != last_id) close();
    last_id = id;
    graph.points.push_back(at(std::stod(lon), std::stod(lat)));
  }
  close();
  const Direction pacific = at(-150, 0);
  const ConstrainedTriangulation land(
      graph, {.crossings = Crossings::split, .outside = pacific});
  EXPECT_EQ(defect_of(land), "none");
  // Land is 29 % of the globe; lakes of 300 km2 and more are left out.
  EXPECT_NEAR(area(land) / (4 * pi), 0.29, 0.005);
  EXPECT_EQ(land.locate(pacific).kind, Location::Kind::outside);
  EXPECT_EQ(land.locate(at(0, -89.9)).kind, Location::Kind::triangle);     // Antarctica
  EXPECT_EQ(land.locate(at(178.5, 66.5)).kind, Location::Kind::triangle);  // Chukotka
  EXPECT_EQ(land.locate(at(-87, 44)).kind, Location::Kind::outside);  // Lake Michigan
  const ConstrainedTriangulation all(
      graph, {.domain = Domain::hull, .crossings = Crossings::split});
  EXPECT_NEAR(area(all), 4 * pi, 1e-12);
}

}  // namespace
}  // namespace delone::stripack
