#include "stripack/polygon.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/PolygonArea.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/arcs.hpp"
#include "stripack/predicates.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using std::numbers::pi;
using Corners = std::vector<Direction>;

Direction at(double lon, double lat) { return Direction::from(LonLat{lon, lat}); }

Corners ring(double lat, int n, double wiggle = 0) {
  Corners corners;
  for (int i = 0; i < n; ++i)
    corners.push_back(at(-180 + 360. * i / n, lat + (i % 2 == 0 ? wiggle : -wiggle)));
  return corners;
}

double judged_area(const Corners& corners) {
  GeographicLib::PolygonArea polygon(GeographicLib::Geodesic(1, 0));
  for (const Direction& d : corners)
    polygon.AddPoint(lonlat(d).lat_deg, lonlat(d).lon_deg);
  double perimeter = 0, area = 0;
  polygon.Compute(false, false, perimeter, area);
  return area;
}

TEST(SpherePolygon, AreaIsThatOfGeographicLibForEverySize) {
  for (const double lat : {89.9, 60.0, 1.0, 0.0, -30.0, -89.0}) {
    for (const int n : {3, 4, 12, 101}) {
      const Corners corners = ring(lat, n, 0.05);
      EXPECT_NEAR(Polygon(corners).area(), judged_area(corners), 1e-12)
          << lat << " " << n;
      const Corners reversed(corners.rbegin(), corners.rend());
      EXPECT_NEAR(Polygon(reversed).area(), 4 * pi - judged_area(corners), 1e-12);
    }
  }
}

TEST(SpherePolygon, PerimeterIsThatOfTheArcs) {
  const Polygon octant({at(0, 0), at(90, 0), at(0, 90)});
  EXPECT_NEAR(octant.perimeter(), 1.5 * pi, 1e-15);
  EXPECT_NEAR(octant.area(), pi / 2, 1e-15);
  EXPECT_NEAR(angle(octant.centroid(), Direction::from(1, 1, 1)), 0, 1e-15);
}

TEST(SpherePolygon, TinyOnesKeepTheirDigits) {
  for (const double size : {1e-6, 1e-9, 1e-12}) {
    const auto p = [&](double y, double z) {
      return Direction::from(1, y * size, z * size);
    };
    const Polygon l({p(0, 0), p(4, 0), p(4, 1), p(1, 1), p(1, 3), p(0, 3)});
    EXPECT_NEAR(l.area() / (6 * size * size), 1, 1e-14 + 40 * size * size);
    const Direction c = l.centroid();
    EXPECT_NEAR(c.y() / size, (4 * 2 + 2 * 0.5) / 6, 1e-12 + 40 * size);
    EXPECT_NEAR(c.z() / size, (4 * 0.5 + 2 * 2) / 6, 1e-12 + 40 * size);
  }
}

TEST(SpherePolygon, ContainsThePoleItGoesRound) {
  const Polygon arctic(ring(66, 36));
  EXPECT_EQ(arctic.locate(at(0, 90)), Containment::inside);
  EXPECT_EQ(arctic.locate(at(180, 80)), Containment::inside);
  EXPECT_EQ(arctic.locate(at(-180, 66)), Containment::boundary);
  EXPECT_EQ(arctic.locate(at(10, 0)), Containment::outside);
  EXPECT_EQ(arctic.locate(at(0, -90)), Containment::outside);
}

TEST(SpherePolygon, MayBeLargerThanAHemisphere) {
  Corners corners = ring(66, 36);
  std::reverse(corners.begin(), corners.end());
  const Polygon rest(corners);
  EXPECT_EQ(rest.locate(at(0, 90)), Containment::outside);
  EXPECT_EQ(rest.locate(at(10, 0)), Containment::inside);
  EXPECT_EQ(rest.locate(at(0, -90)), Containment::inside);
  EXPECT_GT(rest.area(), 2 * pi);
  EXPECT_NEAR(rest.centroid().z(), -1, 1e-15);
}

TEST(SpherePolygon, IsWhereAPointGivenLies) {
  const Corners corners = ring(66, 36);
  const Polygon south(corners, at(20, -40));
  EXPECT_FALSE(south.contains(at(0, 90)));
  EXPECT_TRUE(south.contains(at(0, -90)));
  EXPECT_NEAR(south.area() + Polygon(corners).area(), 4 * pi, 1e-13);
  EXPECT_NEAR(south.centroid().z(), -1, 1e-15);
  EXPECT_THROW(Polygon(corners, corners[3]), Error);
}

TEST(SpherePolygon, CrossesTheDateLine) {
  const Polygon fiji({at(175, -20), at(-175, -20), at(-175, -10), at(175, -10)});
  EXPECT_TRUE(fiji.contains(at(180, -15)));
  EXPECT_TRUE(fiji.contains(at(-180, -15)));
  EXPECT_TRUE(fiji.contains(at(-179, -12)));
  EXPECT_FALSE(fiji.contains(at(0, -15)));
  EXPECT_FALSE(fiji.contains(at(0, 15)));
  EXPECT_FALSE(fiji.contains(at(0, 15.5)));
}

// Oracle: the sum of the angles under which the sides are seen.
TEST(SpherePolygon, AgreesWithTheWindingNumber) {
  const Corners corners = ring(20, 25, 15);
  const Polygon polygon(corners);
  for (const Direction& q : support::uniform_directions(3000, 4)) {
    double turn = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Direction &a = corners[i], &b = corners[(i + 1) % corners.size()];
      const auto dot = [](const Direction& u, const Direction& v) {
        return u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
      };
      const double det = q.x() * (a.y() * b.z() - a.z() * b.y()) +
                         q.y() * (a.z() * b.x() - a.x() * b.z()) +
                         q.z() * (a.x() * b.y() - a.y() * b.x());
      turn += std::atan2(det, dot(a, b) - dot(q, a) * dot(q, b));
    }
    // Seen from a point in the cap the boundary turns once, from the rest not at all; but
    // opposite points see it as well: the north side is the one that counts.
    if (q.z() < 0) continue;
    EXPECT_EQ(polygon.locate(q) == Containment::inside, turn > pi) << lonlat(q).lat_deg;
  }
}

TEST(SpherePolygon, QueriesOnTheCirclesOfItsSidesAreExact) {
  // A square whose sides, continued, pass through the query and through corners.
  const Polygon square({at(0, 0), at(10, 0), at(10, 10), at(0, 10)});
  EXPECT_EQ(square.locate(at(20, 0)), Containment::outside);
  EXPECT_EQ(square.locate(at(-170, 0)), Containment::outside);
  EXPECT_EQ(square.locate(at(0, -10)), Containment::outside);
  EXPECT_EQ(square.locate(at(0, 90)), Containment::outside);
  EXPECT_EQ(square.locate(at(5, 0)), Containment::boundary);
  EXPECT_EQ(square.locate(at(0, 5)), Containment::boundary);
  EXPECT_EQ(square.locate(at(5, 5)), Containment::inside);
}

TEST(SpherePolygon, RefusesWhatIsNone) {
  EXPECT_THROW(Polygon({at(0, 0), at(1, 0)}), Error);
  EXPECT_THROW(Polygon({at(0, 0), at(1, 0), at(1, 0)}), Error);
  EXPECT_THROW(Polygon({at(0, 0), at(90, 0), at(-90, 0)}), Error);
  EXPECT_THROW(Polygon({at(0, 0), at(10, 0), at(0, 0), at(10, 0)}), Error);
}

TEST(Wgs84Polygon, OfAnOctantIsAnEighthOfTheEllipsoid) {
  const Corners octant{at(0, 0), at(90, 0), at(0, 90)};
  EXPECT_NEAR(polygon_area_km2_wgs84(octant) / wgs84_area_km2(), 0.125, 1e-14);
  EXPECT_NEAR(wgs84_area_km2(), 510065621.724, 1e-3);
  const Corners rest(octant.rbegin(), octant.rend());
  EXPECT_NEAR(polygon_area_km2_wgs84(rest) / wgs84_area_km2(), 0.875, 1e-14);
  EXPECT_NEAR(polygon_perimeter_km_wgs84(octant), 2 * 10001.965729 + 10018.754171, 1e-5);
}

TEST(Arcs, CrossTouchOverlapOrMiss) {
  const auto kind = [](const Direction& a, const Direction& b, const Direction& c,
                       const Direction& d) { return intersect(a, b, c, d).kind; };
  EXPECT_EQ(kind(at(0, -10), at(0, 10), at(-10, 0), at(10, 0)), Meeting::cross);
  EXPECT_EQ(kind(at(180, -10), at(180, 10), at(-10, 0), at(10, 0)), Meeting::none);
  EXPECT_EQ(kind(at(0, 0), at(0, 10), at(-10, 0), at(10, 0)), Meeting::touch);
  EXPECT_EQ(kind(at(0, 0), at(20, 0), at(10, 0), at(30, 0)), Meeting::overlap);
  EXPECT_EQ(kind(at(0, 0), at(20, 0), at(20, 0), at(30, 0)), Meeting::touch);
  EXPECT_EQ(kind(at(0, 0), at(20, 0), at(25, 0), at(30, 0)), Meeting::none);
  EXPECT_EQ(kind(at(0, 0), at(0, 0), at(-10, 0), at(30, 0)), Meeting::touch);
  EXPECT_THROW((void)intersect(at(0, 0), at(180, 0), at(0, 10), at(0, 20)), Error);
}

TEST(Arcs, MeetInOnePointHoweverShort) {
  support::SplitMix64 random(3);
  for (const double size : {1.0, 1e-4, 1e-8, 1e-11}) {
    int num_crossings = 0;
    for (const Direction& p : support::uniform_directions(300, 8)) {
      const auto near = [&] {
        return Direction::from(p.x() + size * random.between(-1, 1),
                               p.y() + size * random.between(-1, 1),
                               p.z() + size * random.between(-1, 1));
      };
      const Direction a = near(), b = near(), c = near(), d = near();
      const ArcIntersection i = intersect(a, b, c, d);
      if (i.kind != Meeting::cross) continue;
      ++num_crossings;
      const Direction q = i.points[0];
      EXPECT_NEAR(angle(a, q) + angle(q, b), angle(a, b), 1e-15);
      EXPECT_NEAR(angle(c, q) + angle(q, d), angle(c, d), 1e-15);
    }
    EXPECT_GT(num_crossings, 20) << size;
  }
}

TEST(Arcs, GreatCircleMeetsAnArcOnce) {
  const Direction pole = at(0, 90);
  const auto p = intersect_great_circle(pole, at(30, -10), at(30, 20));
  ASSERT_TRUE(p);
  EXPECT_NEAR(angle(*p, at(30, 0)), 0, 1e-15);
  EXPECT_FALSE(intersect_great_circle(pole, at(30, 10), at(40, 20)));
  EXPECT_FALSE(intersect_great_circle(pole, at(30, 0), at(40, 0)));
  EXPECT_EQ(intersect_great_circle(pole, at(30, 0), at(40, 20)), at(30, 0));
  EXPECT_THROW((void)intersect_great_circle(pole, at(0, 10), at(180, -10)), Error);
}

TEST(Arcs, PoleIsOnTheLeft) {
  EXPECT_EQ(pole_of(at(0, 0), at(10, 0)), at(0, 90));
  EXPECT_EQ(pole_of(at(10, 0), at(0, 0)), at(0, -90));
  EXPECT_THROW((void)pole_of(at(10, 0), at(10, 0)), Error);
}

}  // namespace
}  // namespace delone::stripack
