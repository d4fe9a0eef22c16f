#include "stripack/voronoi.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/PolygonArea.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/back_faces.hpp"
#include "stripack/polygon.hpp"
#include "stripack/predicates.hpp"
#include "support/corpus.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"
#include "tripack/voronoi.hpp"

namespace delone::stripack {
namespace {

using std::numbers::pi;
using support::SphereFamily;
using support::SpherePoints;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

Voronoi diagram(const SpherePoints& points) {
  return Voronoi(std::make_shared<const Triangulation>(points));
}

double sum_of(const std::vector<double>& numbers) {
  long double sum = 0;
  for (const double v : numbers) sum += v;
  return static_cast<double>(sum);
}

SpherePoints lonlats(std::initializer_list<LonLat> points) {
  SpherePoints result;
  for (const LonLat p : points) result.push_back(Direction::from(p));
  return result;
}

// The driver of R. J. Renka's STRIPACK: the pole and eight points at 60 degrees north.
SpherePoints pole_and_ring() {
  SpherePoints points{Direction::from(LonLat{0, 90})};
  for (int i = 0; i < 8; ++i) points.push_back(Direction::from(LonLat{i * 45.0, 60}));
  return points;
}

TEST(SphereVoronoi, CellOfThePoleIsThatOfRenkasDriver) {
  const Voronoi v = diagram(pole_and_ring());
  const Site pole = v.triangulation().sites()[0];
  ASSERT_EQ(v.cell(pole).size(), 8U);
  for (const std::int32_t vertex : v.cell(pole)) {
    const LonLat p = lonlat(v.vertices()[at(vertex)]);
    EXPECT_NEAR(p.lat_deg, 73.82646074, 1e-8);
    EXPECT_NEAR(std::remainder(p.lon_deg - 22.5, 45), 0, 1e-12);
    EXPECT_NEAR(angle(v.vertices()[at(vertex)], v.triangulation().points()[at(pole)]),
                0.28228151, 1e-8);
  }
}

TEST(SphereVoronoi, ClosesTheCellsOfAHemisphereBehind) {
  const Voronoi v = diagram(pole_and_ring());
  EXPECT_EQ(v.num_front_vertices(), 8);
  ASSERT_GT(v.vertices().size(), 8U);  // the ring is a circle but for rounding
  for (std::size_t i = 8; i < v.vertices().size(); ++i)
    EXPECT_NEAR(v.vertices()[i].z(), -1, 1e-15);
  EXPECT_NEAR(sum_of(voronoi_areas(v.triangulation())), 4 * pi, 1e-14);
}

TEST(SphereVoronoi, NoPointsHaveNoCells) {
  EXPECT_TRUE(diagram({}).vertices().empty());
  EXPECT_TRUE(voronoi_areas(Triangulation()).empty());
}

TEST(SphereVoronoi, OnePointHasTheSphere) {
  const Voronoi v = diagram(lonlats({{10, 20}, {10, 20}}));
  EXPECT_TRUE(v.cell(0).empty());
  EXPECT_TRUE(v.outline(0, 1).empty());
  const CellMeasure cell = voronoi_measures(v.triangulation())[0];
  EXPECT_EQ(cell.area, 4 * pi);
  EXPECT_EQ(cell.centroid, v.triangulation().points()[0]);
}

TEST(SphereVoronoi, TwoPointsHaveAHemisphereEach) {
  for (const auto& points :
       {lonlats({{10, 20}, {40, 50}}), lonlats({{0, 0}, {180, 0}}),
        lonlats({{0, 90}, {0, -90}}), lonlats({{0, 0}, {1e-12, 0}})}) {
    const Voronoi v = diagram(points);
    ASSERT_EQ(v.edges().size(), 1U);
    EXPECT_EQ(v.edges()[0].vertices[0], delaunay::none);
    const auto measures = voronoi_measures(v.triangulation());
    const Direction a = measures[0].centroid, b = measures[1].centroid;
    EXPECT_NEAR(measures[0].area, 2 * pi, 1e-15);
    EXPECT_NEAR(measures[1].area, 2 * pi, 1e-15);
    EXPECT_NEAR(angle(a, b), pi, 1e-7);
    for (const Direction& p : v.outline(0, 0.1))
      EXPECT_NEAR(angle(p, v.triangulation().points()[0]),
                  angle(p, v.triangulation().points()[1]), 1e-14);
  }
}

TEST(SphereVoronoi, PointsOfAGreatCircleHaveLunes) {
  const SpherePoints points = lonlats({{0, 0}, {30, 0}, {90, 0}, {200, 0}});
  const Voronoi v = diagram(points);
  ASSERT_EQ(v.triangulation().dimension(), 1);
  ASSERT_EQ(v.vertices().size(), 2U);
  EXPECT_NEAR(std::abs(v.vertices()[0].z()), 1, 1e-15);
  const std::vector<double> areas = voronoi_areas(v.triangulation());
  const auto degrees = [&](Node row) {
    return areas[at(v.triangulation().sites()[at(row)])] / 2 * 180 / pi;
  };
  EXPECT_NEAR(degrees(0), (30 + 160) / 2., 1e-12);
  EXPECT_NEAR(degrees(1), (30 + 60) / 2., 1e-12);
  EXPECT_NEAR(degrees(2), (60 + 110) / 2., 1e-12);
  EXPECT_NEAR(degrees(3), (110 + 160) / 2., 1e-12);
}

TEST(SphereVoronoi, ChainWithAGapOfMoreThanHalfACircleHasLunesToo) {
  const Voronoi v = diagram(lonlats({{0, 0}, {10, 0}, {30, 0}}));
  const std::vector<double> areas = voronoi_areas(v.triangulation());
  const auto degrees = [&](Node row) {
    return areas[at(v.triangulation().sites()[at(row)])] / 2 * 180 / pi;
  };
  EXPECT_NEAR(degrees(0), (10 + 330) / 2., 1e-12);
  EXPECT_NEAR(degrees(1), (10 + 20) / 2., 1e-12);
  EXPECT_NEAR(degrees(2), (20 + 330) / 2., 1e-12);
}

TEST(SphereVoronoi, CubesCellsAreTheFacesOfAnOctahedron) {
  SpherePoints cube;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      for (const double z : {-1, 1}) cube.push_back(Direction::from(x, y, z));
    }
  }
  const Voronoi v = diagram(cube);
  EXPECT_EQ(v.vertices().size(), 6U);  // each face's two triangles share one
  for (Site s = 0; s < 8; ++s) {
    EXPECT_EQ(v.cell(s).size(), 3U);
    EXPECT_NEAR(voronoi_areas(v.triangulation())[at(s)], pi / 2, 1e-15);
  }
  EXPECT_EQ(v.edges().size(), 12U);
}

TEST(SphereVoronoi, SmallCellsAreThoseOfTheTangentPlane) {
  for (const double side : {1e-3, 1e-6, 1e-9, 1e-12}) {
    support::SplitMix64 random(8);
    SpherePoints points;
    for (int i = 0; i < 200; ++i) {
      const double y = random.between(-side, side), z = random.between(-side, side);
      points.push_back(Direction::from(1, y, z));
    }
    const Triangulation t(points);
    std::vector<tripack::Point2> projected;
    for (const Direction& p : t.points())
      projected.push_back({p.y() / p.x(), p.z() / p.x()});
    const tripack::Triangulation plane(projected);
    const std::vector<CellMeasure> cells = voronoi_measures(t);
    const std::vector<tripack::CellMeasure> flat = tripack::voronoi_measures(plane);
    int num_compared = 0;
    for (Site s = 0; s < t.num_sites(); ++s) {
      const tripack::CellMeasure& f = flat[at(plane.sites()[at(s)])];
      if (t.adjacency().is_boundary(s) || f.area > side * side) continue;
      ++num_compared;
      // The plane's own curvature is left out: that of order side^2.
      EXPECT_NEAR(cells[at(s)].area / f.area, 1, 1e-12 + 30 * side * side) << side;
      const Direction& c = cells[at(s)].centroid;
      EXPECT_NEAR(c.y() / c.x(), f.centroid.x, side * (1e-12 + 30 * side * side)) << side;
      EXPECT_NEAR(c.z() / c.x(), f.centroid.y, side * (1e-12 + 30 * side * side)) << side;
    }
    EXPECT_GT(num_compared, 100);
  }
}

TEST(SphereVoronoi, DoesNotDependOnThreads) {
  for (const SpherePoints& points :
       {support::uniform_directions(20000, 5), support::track_directions(20000),
        support::box_directions(20000, 5, 0.5)}) {
    const Triangulation t(points);
    const std::vector<double> areas =
        voronoi_areas(t, {.num_threads = 1, .progress = {}});
    for (const int num_threads : {2, 3, 8})
      EXPECT_EQ(areas, voronoi_areas(t, {.num_threads = num_threads, .progress = {}}));
  }
}

TEST(SphereVoronoi, EllipsoidsCellsSumToItsSurface) {
  for (const auto& points :
       {support::uniform_directions(500, 3), pole_and_ring(),
        support::box_directions(30, 1, 0.1),
        lonlats({{0, 0}, {30, 0}, {90, 0}, {200, 0}}), lonlats({{0, 0}, {120, 10}}),
        lonlats({{0, 90}}),
        lonlats({{0, 90}, {0, 80}, {120, 80}, {240, 80}, {0, -90}})}) {
    const Voronoi v = diagram(points);
    const double sum = sum_of(voronoi_areas_km2_wgs84(v));
    EXPECT_NEAR(sum / 510065621.724, 1, 1e-12) << points.size();
  }
}

// The edges on the ellipsoid are geodesics, which keep a hemisphere only about.
TEST(SphereVoronoi, EllipsoidsCellsAreLikeTheSpheres) {
  const Voronoi v = diagram(support::fibonacci_directions(400));
  const std::vector<double> areas = voronoi_areas_km2_wgs84(v),
                            angles = voronoi_areas(v.triangulation());
  for (std::size_t i = 0; i < areas.size(); ++i)
    EXPECT_NEAR(areas[i] / (angles[i] * earth_radius_km * earth_radius_km), 1, 0.015);
}

class SphereVoronoiFamilies : public testing::TestWithParam<SphereFamily> {};

template <class F>
void for_each_set(const SphereFamily& family, F check) {
  for (const std::size_t n : {1U, 2U, 3U, 4U, 5U, 7U, 12U, 40U, 300U}) {
    for (std::uint64_t seed = 1; seed <= (n < 20 ? 4 : 1); ++seed) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", seed = " + std::to_string(seed));
      const SpherePoints points = family.make(n, seed);
      check(points);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST_P(SphereVoronoiFamilies, AreasSumToTheSphere) {
  for_each_set(GetParam(), [](const SpherePoints& points) {
    const Triangulation t(points);
    if (t.num_sites() == 0) return;
    EXPECT_NEAR(sum_of(voronoi_areas(t)) / (4 * pi), 1, 1e-13);
  });
}

// The integral of the position over the sphere is 0.
TEST_P(SphereVoronoiFamilies, VerticesAreAsFarFromTheirSitesAsFromNoOther) {
  for_each_set(GetParam(), [](const SpherePoints& points) {
    const Voronoi v = diagram(points);
    const auto sites = v.triangulation().points();
    for (Site s = 0; s < v.triangulation().num_sites(); ++s) {
      for (const std::int32_t k : v.cell(s)) {
        const Direction c = v.vertices()[at(k)];
        double nearest = 4;
        for (const Direction& p : sites) nearest = std::min(nearest, angle(c, p));
        EXPECT_NEAR(angle(c, sites[at(s)]), nearest, 4e-15);
      }
    }
  });
}

// GeographicLib on a sphere of radius 1 is the judge.
TEST_P(SphereVoronoiFamilies, AreasAreThoseOfTheirOutlines) {
  const GeographicLib::Geodesic sphere(1, 0);
  for_each_set(GetParam(), [&](const SpherePoints& points) {
    const Voronoi v = diagram(points);
    const std::vector<double> areas = voronoi_areas(v.triangulation());
    for (Site s = 0; s < v.triangulation().num_sites(); ++s) {
      GeographicLib::PolygonArea polygon(sphere);
      for (const Direction& p : v.outline(s, 1.5)) {
        const LonLat q = lonlat(p);
        polygon.AddPoint(q.lat_deg, q.lon_deg);
      }
      double perimeter = 0, area = 0;
      polygon.Compute(false, true, perimeter, area);
      if (area < -1e-9) area += 4 * pi;
      if (v.triangulation().num_sites() == 1) area = 4 * pi;
      EXPECT_NEAR(areas[at(s)], area, 2e-13);
    }
  });
}

TEST_P(SphereVoronoiFamilies, CentroidsAreThoseOfTheirOutlines) {
  for_each_set(GetParam(), [](const SpherePoints& points) {
    const Voronoi v = diagram(points);
    const std::vector<CellMeasure> cells = voronoi_measures(v.triangulation());
    const std::vector<double> areas = voronoi_areas(v.triangulation());
    for (Site s = 0; s < v.triangulation().num_sites(); ++s) {
      EXPECT_EQ(cells[at(s)].area, areas[at(s)]);
      const std::vector<Direction> outline = v.outline(s, 1.5);
      if (outline.size() < 3 || areas[at(s)] < 1e-6) continue;
      SpherePoints corners;  // without repeats of positions closer than rounding
      for (const Direction& p : outline) {
        if (corners.empty() || angle(corners.back(), p) > 1e-12) corners.push_back(p);
      }
      if (angle(corners.back(), corners.front()) < 1e-12) corners.pop_back();
      if (corners.size() < 3) continue;
      EXPECT_NEAR(angle(Polygon(corners).centroid(), cells[at(s)].centroid), 0,
                  4e-12 / areas[at(s)]);
    }
  });
}

TEST_P(SphereVoronoiFamilies, SatisfyEulersFormula) {
  for_each_set(GetParam(), [](const SpherePoints& points) {
    const Voronoi v = diagram(points);
    const auto n = v.triangulation().num_sites();
    if (n < 3) return;
    EXPECT_EQ(
        n + static_cast<long>(v.vertices().size()) - static_cast<long>(v.edges().size()),
        2);
  });
}

// Every face sees no site, with ties broken as everywhere, and front and back close.
TEST_P(SphereVoronoiFamilies, BackFacesCompleteThePolyhedron) {
  for_each_set(GetParam(), [](const SpherePoints& points) {
    const Triangulation t(points);
    const BackFaces back(t);
    if (t.dimension() < 2) return;
    EXPECT_EQ(t.num_triangles() + static_cast<std::int64_t>(back.faces().size()),
              2 * t.num_sites() - 4);
    const auto p = t.points();
    for (const auto& [a, b, c] : back.faces()) {
      EXPECT_LE(orientation(p[at(a)], p[at(b)], p[at(c)]), 0);
      for (Site s = 0; s < t.num_sites(); ++s) {
        if (s == a || s == b || s == c) continue;
        EXPECT_LT(in_circle_perturbed(p[at(a)], p[at(b)], p[at(c)], p[at(s)]), 0);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereVoronoiFamilies,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(SphereVoronoiCorpus, AreasSumToTheSphere) {
  const auto cases = support::sphere_corpus(DELONE_CORPUS_DIR);
  ASSERT_FALSE(cases.empty());
  for (const auto& c : cases) {
    const Triangulation t(c.sphere);
    if (t.num_sites() == 0) continue;
    EXPECT_NEAR(sum_of(voronoi_areas(t)) / (4 * pi), 1, 1e-13) << c.name;
  }
}

TEST(BackFaces, OfALongParallelAreBuiltInLinearTime) {
  SpherePoints ring;
  for (int i = 0; i < 20000; ++i)
    ring.push_back(Direction::from(LonLat{i * 360. / 20000, 30}));
  const Triangulation t(ring);
  EXPECT_EQ(BackFaces(t).faces().size() + static_cast<std::size_t>(t.num_triangles()),
            39996U);
}

}  // namespace
}  // namespace delone::stripack
