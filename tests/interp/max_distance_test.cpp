#include <gtest/gtest.h>

#include <cmath>

#include "interp/linear_surface.hpp"
#include "interp/nearest_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::PlanePoints;
using support::random_values;
using support::SpherePoints;
using support::triangulated;
using tripack::Point2;

TEST(MaxDistance, InThePlaneAgreesWithBruteForce) {
  const PlanePoints points = support::clustered_points(300, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(300, 2);
  const Grid grid = plane_grid({-0.5, 1.5, -0.5, 1.5}, NodeCounts{50, 50});
  const PlanePoints nodes = plane_nodes(grid);
  for (const Outside outside : {Outside::missing, Outside::nearest, Outside::linear}) {
    const double limit = 0.11;
    const PlaneLinear everywhere(t, values, {.outside = outside});
    const PlaneLinear surface(t, values, {.outside = outside, .max_distance = limit});
    const std::vector<double> all = everywhere.grid(grid).values,
                              masked = surface.grid(grid).values;
    const std::vector<double> queried = surface.values(nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      double nearest = 10;
      for (const Point2 p : points)
        nearest = std::min(nearest, std::hypot(p.x - nodes[i].x, p.y - nodes[i].y));
      const double expected = nearest <= limit ? all[i] : std::nan("");
      EXPECT_TRUE(support::is_same(masked[i], expected)) << i;
      EXPECT_TRUE(support::is_same(queried[i], expected)) << i;
      EXPECT_EQ(std::isnan(surface.gradient(nodes[i]).x), std::isnan(expected));
    }
  }
}

TEST(MaxDistance, OfZeroLeavesTheNodes) {
  const PlanePoints points = support::lattice_points(25);
  const PlaneLinear surface(triangulated(points), random_values(25, 3),
                            {.max_distance = 0});
  const Field field = surface.grid(plane_grid({0, 4, 0, 4}, Spacing{0.5, 0.5}));
  EXPECT_EQ(support::count_missing(field.values), 81u - 25u);
}

// A few stations, so that limits of hundreds of kilometres matter.
class GlobeMaxDistance : public testing::TestWithParam<GlobeDistance> {};

TEST_P(GlobeMaxDistance, AgreesWithBruteForce) {
  const SpherePoints points = support::uniform_directions(60, 4);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(60, 5);
  const Grid grid = globe_grid({-180, 180, -90, 90}, Spacing{10, 10});
  const SpherePoints nodes = globe_nodes(grid);
  const auto distance_km = [](const stripack::Direction& a,
                              const stripack::Direction& b) {
    return GetParam() == GlobeDistance::great_circle
               ? stripack::earth_radius_km * stripack::angle(a, b)
               : stripack::geodesic_km(stripack::lonlat(a), stripack::lonlat(b));
  };
  for (const double limit : {300.0, 1200.0, 2500.0}) {
    const SurfaceOptions options{.max_distance = limit, .distance = GetParam()};
    const SphereLinear everywhere(t, values), surface(t, values, options);
    const SphereNearest nearest_surface(t, values, options);
    const std::vector<double> all = everywhere.grid(grid).values,
                              masked = surface.grid(grid).values;
    const std::vector<double> queried = surface.values(nodes),
                              near_values = nearest_surface.grid(grid).values;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      double nearest = 1e9;
      for (const auto& p : points) nearest = std::min(nearest, distance_km(p, nodes[i]));
      const double expected = nearest <= limit ? all[i] : std::nan("");
      EXPECT_TRUE(support::is_same(masked[i], expected)) << i << ' ' << nearest;
      EXPECT_TRUE(support::is_same(queried[i], expected)) << i;
      EXPECT_EQ(std::isnan(near_values[i]), std::isnan(expected)) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Globe, GlobeMaxDistance,
                         testing::Values(GlobeDistance::great_circle,
                                         GlobeDistance::geodesic_wgs84));

// One degree of the equator is 111.319 km on WGS84, 111.195 on the sphere; of the
// meridian there 110.574.
TEST(MaxDistance, OnTheEllipsoidDiffersFromTheSphere) {
  const SpherePoints points{support::at_lonlat(0, 0)};
  const auto covers = [&](double lon, double lat, double limit, GlobeDistance distance) {
    const SphereLinear surface(
        triangulated(points), std::vector<double>{1},
        {.outside = Outside::nearest, .max_distance = limit, .distance = distance});
    return !std::isnan(surface.value(support::at_lonlat(lon, lat)));
  };
  EXPECT_TRUE(covers(1, 0, 111.2, GlobeDistance::great_circle));
  EXPECT_FALSE(covers(1, 0, 111.2, GlobeDistance::geodesic_wgs84));
  EXPECT_TRUE(covers(1, 0, 111.32, GlobeDistance::geodesic_wgs84));
  EXPECT_FALSE(covers(0, 1, 110.6, GlobeDistance::great_circle));
  EXPECT_TRUE(covers(0, 1, 110.6, GlobeDistance::geodesic_wgs84));
}

}  // namespace
}  // namespace delone::interp
