#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "delaunay/error.hpp"
#include "interp/c1_surface.hpp"
#include "interp/linear_surface.hpp"
#include "interp/region_integral.hpp"
#include "interp/sphere_vector.hpp"
#include "interp/surfaces.hpp"
#include "stripack/measures.hpp"
#include "stripack/polygon.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::at_lonlat;
using support::sampled;
using support::SpherePoints;
using support::triangulated;
using Rings = std::vector<SpherePoints>;

constexpr double sphere_area = 4 * std::numbers::pi;

SphereRegion region_of_rings(const Rings& rings) { return SphereRegion(rings); }

SphereLinear constant(const SpherePoints& points, double value = 1) {
  return {triangulated(points), std::vector<double>(points.size(), value)};
}

Direction corner(const stripack::Triangulation& t, delaunay::Node row) {
  return t.points()[static_cast<std::size_t>(t.sites()[static_cast<std::size_t>(row)])];
}

SpherePoints ring_at(double lat, double step, double first_lon = 0) {
  SpherePoints ring;
  for (double lon = 0; lon < 360; lon += step)
    ring.push_back(at_lonlat(first_lon + lon, lat));
  return ring;
}

// The integral of the position over what lies left of a ring: half the sum of its sides'
// lengths times their normals (Gauss).
Vector3 moment(const SpherePoints& ring) {
  Vector3 sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector3 a = vector(ring[i]), b = vector(ring[(i + 1) % ring.size()]),
                  normal = cross(a, b);
    sum = sum +
          (0.5 * stripack::angle(ring[i], ring[(i + 1) % ring.size()]) / length(normal)) *
              normal;
  }
  return sum;
}

TEST(SphereRegionIntegral, OfOneIsTheArea) {
  const SpherePoints points = support::uniform_directions(500, 1);
  const SphereLinear surface = constant(points);
  const Rings cases[] = {
      {{at_lonlat(0, 0), at_lonlat(90, 0), at_lonlat(0, 90)}},             // an octant
      {{at_lonlat(170, -20), at_lonlat(-165, -25), at_lonlat(-170, 30)}},  // date line
      {ring_at(70, 30)},                                                   // a pole
      {ring_at(-40, 45)},                                                  // most of it
      {{at_lonlat(0, 0), at_lonlat(120, 0), at_lonlat(240, 0)}},           // half of it
      {{at_lonlat(5, 5), at_lonlat(5, 6), at_lonlat(6, 5)}},  // clockwise: the rest
      {{at_lonlat(5, 5), at_lonlat(5.001, 5), at_lonlat(5, 5.001)}},  // small
  };
  for (const Rings& rings : cases) {
    const double exact = stripack::Polygon(rings[0]).area();
    const RegionIntegral r = surface.integral(region_of_rings(rings));
    EXPECT_NEAR(r.area / exact, 1, 1e-11) << exact;
    EXPECT_NEAR(region_of_rings(rings).area() / exact, 1, 1e-11);
    EXPECT_DOUBLE_EQ(r.mean(), 1);
  }
  EXPECT_NEAR(surface.integral(SphereRegion()).area, sphere_area, 1e-11);
}

TEST(SphereRegionIntegral, OfARegionAndTheRestIsThatOfTheSphere) {
  const SpherePoints points = support::uniform_directions(300, 2);
  const auto t = triangulated(points);
  const SphereLinear linear(t, support::random_values(points.size(), 3));
  const SphereC1 smooth(t, support::random_values(points.size(), 3));
  for (SpherePoints ring : {ring_at(70, 30), ring_at(-10, 7, 3), ring_at(0, 90)}) {
    const SphereRegion region = region_of_rings({ring});
    std::reverse(ring.begin(), ring.end());
    const SphereRegion rest = region_of_rings({ring});
    EXPECT_NEAR(linear.integral(region).area + linear.integral(rest).area, sphere_area,
                1e-10);
    EXPECT_NEAR(linear.integral(region).integral + linear.integral(rest).integral,
                linear.integral(), 1e-10);
    EXPECT_NEAR(smooth.integral(region).integral + smooth.integral(rest).integral,
                smooth.integral(), 1e-5);
  }
}

TEST(SphereRegionIntegral, OfHarmonicsIsThatOfGauss) {
  const SpherePoints points = support::uniform_directions(800, 4);
  C1Options options;  // that reproduce harmonics
  options.gradients = Gradients::local;
  options.tension = 0;
  const SphereC1 surface(
      triangulated(points),
      sampled(points, [](const Direction& p) { return 2 * p.x() - p.y() + 3 * p.z(); }),
      options);
  for (const SpherePoints& ring :
       {ring_at(55, 20), ring_at(-30, 40, 11),
        SpherePoints{at_lonlat(10, -20), at_lonlat(80, -30), at_lonlat(60, 50)}}) {
    const Vector3 m = moment(ring);
    EXPECT_NEAR(surface.integral(region_of_rings({ring})).integral,
                2 * m.x - m.y + 3 * m.z, 1e-8);
  }
}

TEST(SphereRegionIntegral, KnowsHolesIslandsAndTheOutside) {
  const SphereLinear surface = constant(support::uniform_directions(300, 5));
  const Rings rings{ring_at(30, 10), ring_at(60, 10), ring_at(80, 10)};
  double exact = 0, sign = 1;
  for (const SpherePoints& ring : rings) {
    exact += sign * stripack::Polygon(ring).area();
    sign = -sign;
  }
  EXPECT_NEAR(surface.integral(region_of_rings(rings)).area, exact, 1e-11);
  const SphereRegion turned(rings, at_lonlat(0, 85));
  EXPECT_NEAR(surface.integral(turned).area, sphere_area - exact, 1e-10);
}

TEST(SphereRegionIntegral, OnTheNodesOfALatitudeGridIsExact) {
  SpherePoints points;
  for (const auto& p : support::global_grid(15)) points.push_back(Direction::from(p));
  const SphereLinear surface = constant(points);
  const Rings cases[] = {
      {{at_lonlat(0, 0), at_lonlat(45, 0), at_lonlat(45, 90), at_lonlat(0, 45)}},
      {{at_lonlat(-180, -90), at_lonlat(30, 0), at_lonlat(90, 0)}},
      {ring_at(0, 15)},
      {{at_lonlat(-15, -15), at_lonlat(15, -15), at_lonlat(15, 15), at_lonlat(-15, 15)}},
      {{at_lonlat(170, 10), at_lonlat(190, 10), at_lonlat(190, 40), at_lonlat(170, 40)}},
  };
  for (const Rings& rings : cases) {
    const double exact = stripack::Polygon(rings[0]).area();
    EXPECT_NEAR(surface.integral(region_of_rings(rings)).area, exact, 1e-11) << exact;
  }
}

TEST(SphereRegionIntegral, CountsWhatTheTrianglesOfAHemisphereCover) {
  SpherePoints points = ring_at(10, 20);
  points.push_back(at_lonlat(0, 90));
  const SphereLinear surface = constant(points, 3);
  const double covered = surface.integral(SphereRegion()).area;
  EXPECT_NEAR(covered, stripack::Polygon(ring_at(10, 20)).area(), 1e-10);
  SpherePoints wide = ring_at(-40, 20), narrow = ring_at(50, 20);
  EXPECT_NEAR(surface.integral(region_of_rings({wide})).area, covered, 1e-10);
  EXPECT_NEAR(surface.integral(region_of_rings({narrow})).area,
              stripack::Polygon(narrow).area(), 1e-10);
  // All but the cap: both ends of every side outside of the hull, or inside.
  std::reverse(narrow.begin(), narrow.end());
  EXPECT_NEAR(surface.integral(region_of_rings({narrow})).area,
              covered - stripack::Polygon(ring_at(50, 20)).area(), 1e-10);
  std::reverse(wide.begin(), wide.end());
  EXPECT_EQ(surface.integral(region_of_rings({wide})).area, 0);
  // Sides through it, from beyond to beyond.
  const SpherePoints band{at_lonlat(-80, 0), at_lonlat(-79, -5), at_lonlat(79, -5),
                          at_lonlat(80, 0)};
  const RegionIntegral part = surface.integral(region_of_rings({band}));
  EXPECT_GE(part.area, 0);
  EXPECT_LE(part.area, covered);
}

TEST(SphereRegionIntegral, IsMeasuredInSquareKilometres) {
  const SpherePoints points = support::uniform_directions(300, 6);
  const SphereLinear surface = constant(points, 2);
  EXPECT_NEAR(surface.integral(SphereRegion(), AreaUnit::km2_wgs84).area /
                  stripack::wgs84_area_km2(),
              1, 1e-12);
  const double r2 = stripack::earth_radius_km * stripack::earth_radius_km;
  EXPECT_NEAR(surface.integral(SphereRegion(), AreaUnit::km2_sphere).area / r2,
              sphere_area, 1e-10);
  // Short sides: geodesics and arcs of the normals are nearly the same.
  SpherePoints ring;
  for (int k = 0; k < 120; ++k) {
    const double angle = k * std::numbers::pi / 60;
    ring.push_back(at_lonlat(20 + 8 * std::cos(angle), 45 + 5 * std::sin(angle)));
  }
  const RegionIntegral r = surface.integral(region_of_rings({ring}), AreaUnit::km2_wgs84);
  EXPECT_NEAR(r.area / stripack::polygon_area_km2_wgs84(ring), 1, 1e-6);
  EXPECT_DOUBLE_EQ(r.mean(), 2);
}

TEST(SphereRegionIntegral, RefusesBadRings) {
  EXPECT_THROW(region_of_rings({{at_lonlat(0, 0), at_lonlat(1, 1)}}), Error);
  EXPECT_THROW(region_of_rings({{at_lonlat(0, 0), at_lonlat(10, 10), at_lonlat(10, 0),
                                 at_lonlat(0, 10)}}),
               Error);
  EXPECT_THROW(region_of_rings({{at_lonlat(0, 0), at_lonlat(180, 0), at_lonlat(0, 40)}}),
               Error);
  EXPECT_EQ(constant({at_lonlat(0, 0), at_lonlat(1, 1), at_lonlat(0, 1)})
                .integral(region_of_rings({}))
                .area,
            0);
}

class SphereRegionOnSets : public testing::TestWithParam<support::SphereFamily> {};

// Every decision is a tie.
TEST_P(SphereRegionOnSets, TrianglesOfItsOwnAreMeasuredExactly) {
  const SpherePoints points = GetParam().make(40, 7);
  const auto t = triangulated(points);
  const SphereLinear surface = constant(points);
  int num = 0;
  for (const auto& c : t->triangles()) {
    if (++num > 5) break;
    const SpherePoints ring{corner(*t, c[0]), corner(*t, c[1]), corner(*t, c[2])};
    const double area = stripack::signed_area(ring[0], ring[1], ring[2]);
    if (!(area > 1e-200)) continue;
    const double width = stripack::angle(ring[0], ring[1]) +
                         stripack::angle(ring[1], ring[2]) +
                         stripack::angle(ring[2], ring[0]);
    EXPECT_NEAR(surface.integral(region_of_rings({ring})).area, area,
                1e-10 * area + 1e-15 * width * (width + 1e-16))
        << num;
  }
}

TEST_P(SphereRegionOnSets, PartsSumToTheWhole) {
  const SpherePoints points = GetParam().make(30, 8);
  const auto t = triangulated(points);
  if (t->dimension() < 2) return;
  const SphereLinear surface = constant(points);
  const double whole = surface.integral(SphereRegion()).area;
  // Through nodes, round the data or among them.
  SpherePoints ring{points[0], points[points.size() / 3], points[points.size() / 2]};
  double sum = 0;
  try {
    sum = surface.integral(region_of_rings({ring})).area;
    std::reverse(ring.begin(), ring.end());
    sum += surface.integral(region_of_rings({ring})).area;
  } catch (const Error&) {
    return;  // repeated or opposite
  }
  if (region_of_rings({ring}).boundary().sides.empty()) return;  // on a great circle
  EXPECT_NEAR(sum, whole, 1e-10 * whole + 1e-15 * std::sqrt(whole));
}

INSTANTIATE_TEST_SUITE_P(AllSets, SphereRegionOnSets,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& set) { return std::string(set.param.name); });

}  // namespace
}  // namespace delone::interp
