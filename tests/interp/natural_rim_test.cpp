// Natural neighbours of sets near a great circle, whose circumcentres are nearly
// antipodal.

#include <gtest/gtest.h>

#include <cmath>

#include "interp/index.hpp"
#include "interp/natural_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::SpherePoints;

constexpr int num_points = 24;

SpherePoints ring(double lat_deg) {
  SpherePoints points;
  for (int i = 0; i < num_points; ++i)
    points.push_back(at_lonlat(15.0 * i + 3 * std::sin(i * i), lat_deg));
  return points;
}

SphereNatural surface_over_ring(double lat_deg) {
  return {support::triangulated(ring(lat_deg)), support::random_values(num_points, 3),
          NaturalOptions{}};
}

// As far above a ring as it is above the equator, up to ten times that.
SpherePoints places_over_ring(double lat_deg) {
  SpherePoints result;
  for (const double times : {2.0, 4.0, 10.0})
    for (int i = 0; i < 8; ++i) result.push_back(at_lonlat(41 * i + 1, times * lat_deg));
  return result;
}

// Flat rings look alike: latitudes of ring and place may be doubled, weights differ by
// the order of the latitudes only.
TEST(NaturalRim, ValuesOverFlatRingsAreAlike) {
  for (const double lat : {1e-6, 1e-7, 1e-8}) {
    const auto one = surface_over_ring(lat).values(places_over_ring(lat)),
               other = surface_over_ring(2 * lat).values(places_over_ring(2 * lat));
    for (std::size_t i = 0; i < one.size(); ++i)
      EXPECT_NEAR(one[i], other[i], 1e-12 + lat) << lat;
  }
}

TEST(NaturalRim, GradientsOverFlatRingsAreAlike) {
  for (const double lat : {1e-6, 1e-7, 1e-8}) {
    const auto one = surface_over_ring(lat).gradients(places_over_ring(lat)),
               other = surface_over_ring(2 * lat).gradients(places_over_ring(2 * lat));
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_TRUE(std::isfinite(one[i].east) && std::isfinite(one[i].north));
      EXPECT_NEAR(one[i].east, other[i].east, 1e-9 + 100 * lat) << lat;
    }
  }
}

// A ring's reflection in the equator, seen from the reflected place.
TEST(NaturalRim, IsTheSameForTheOtherHemisphere) {
  const SphereNatural north = surface_over_ring(1e-8), south = surface_over_ring(-1e-8);
  for (const auto& p : places_over_ring(1e-8)) {
    const auto mirrored = stripack::Direction::from(p.x(), p.y(), -p.z());
    EXPECT_NEAR(north.value(p), south.value(mirrored), 1e-11);
  }
}

}  // namespace
}  // namespace delone::interp
