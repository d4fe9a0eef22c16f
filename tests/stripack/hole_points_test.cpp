#include "stripack/hole_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace delone::stripack {
namespace {

void add_ring(SphereGraph& graph, const std::vector<LonLat>& ring) {
  const auto first = static_cast<Node>(graph.points.size());
  const auto size = static_cast<Node>(ring.size());
  for (const LonLat p : ring) graph.points.push_back(Direction::from(p));
  for (Node i = 0; i < size; ++i)
    graph.arcs.push_back({first + i, first + (i + 1) % size});
}

std::vector<LonLat> parallel(double lat_deg) {
  return {{0, lat_deg}, {90, lat_deg}, {180, lat_deg}, {-90, lat_deg}};
}

/// What a .poly file holds of a triangulation.
SphereGraph as_poly(const ConstrainedTriangulation& t) {
  SphereGraph graph;
  for (Node row = 0; row < t.num_rows(); ++row) graph.points.push_back(t.point(row));
  graph.arcs = t.constraint_edges();
  for (const LonLat p : hole_points(t)) graph.holes.push_back(Direction::from(p));
  return graph;
}

ConstrainedTriangulation enclosed(const SphereGraph& graph) {
  return ConstrainedTriangulation(graph, {.domain = Domain::enclosed});
}

/// Rings round random places, also across one another, and points everywhere.
SphereGraph random_rings(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> lon(-180, 180), z(-1, 1), radius(5, 40);
  const auto place = [&] {
    return LonLat{lon(random), std::asin(z(random)) * 180 / std::numbers::pi};
  };
  SphereGraph graph;
  for (int i = 0; i < 5; ++i) {
    const Direction centre = Direction::from(place());
    const double r = std::tan(radius(random) * std::numbers::pi / 180);
    std::vector<LonLat> ring;
    for (int k = 0; k < 6; ++k) {
      // Two vectors that span the tangent plane, not orthogonal: an ellipse.
      const double a = k * std::numbers::pi / 3;
      const double u = r * std::cos(a), v = r * std::sin(a);
      ring.push_back(lonlat(Direction::from(centre.x() + v * centre.z() - u * centre.y(),
                                            centre.y() + u * centre.x(),
                                            centre.z() - v * centre.x())));
    }
    add_ring(graph, ring);
  }
  for (int i = 0; i < 40; ++i) graph.points.push_back(Direction::from(place()));
  return graph;
}

TEST(SphereHolePoints, LieInBothCapsOfABand) {
  SphereGraph graph;
  add_ring(graph, parallel(-30));
  add_ring(graph, parallel(40));
  graph.points.push_back(Direction::from(LonLat{0, 90}));
  graph.points.push_back(Direction::from(LonLat{0, -90}));
  const ConstrainedTriangulation t(graph, {.outside = Direction::from(LonLat{10, 80})});
  const auto points = hole_points(t);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_GT(std::max(points[0].lat_deg, points[1].lat_deg), 40);
  EXPECT_LT(std::min(points[0].lat_deg, points[1].lat_deg), -30);
  EXPECT_EQ(enclosed(as_poly(t)).triangles(), t.triangles());
}

TEST(SphereHolePoints, NameTheDomainThatRingsGave) {
  int num_holes = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const ConstrainedTriangulation t(
        random_rings(seed),
        {.crossings = Crossings::split, .outside = Direction::from(LonLat{1.5, 2.5})});
    const SphereGraph poly = as_poly(t);
    EXPECT_EQ(enclosed(poly).triangles(), t.triangles()) << seed;
    num_holes += static_cast<int>(poly.holes.size());
  }
  EXPECT_GT(num_holes, 60);
}

TEST(SphereHolePoints, LeaveOutWhatIsBeyondTheHullOfAHemisphere) {
  SphereGraph graph;
  add_ring(graph, {{0, 0}, {30, 0}, {30, 30}, {0, 30}});
  EXPECT_TRUE(hole_points(ConstrainedTriangulation(graph)).empty());
  add_ring(graph, {{10, 10}, {20, 10}, {20, 20}, {10, 20}});
  const ConstrainedTriangulation t(graph);
  const auto points = hole_points(t);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_GT(points[0].lon_deg, 10);
  EXPECT_LT(points[0].lon_deg, 20);
  EXPECT_EQ(enclosed(as_poly(t)).triangles(), t.triangles());
}

TEST(SphereHolePoints, AreNoneForTheHull) {
  EXPECT_TRUE(hole_points(ConstrainedTriangulation(
                              random_rings(3),
                              {.domain = Domain::hull, .crossings = Crossings::split}))
                  .empty());
  EXPECT_TRUE(hole_points(ConstrainedTriangulation()).empty());
}

}  // namespace
}  // namespace delone::stripack
