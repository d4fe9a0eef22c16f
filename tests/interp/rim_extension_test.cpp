#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "interp/c1_surface.hpp"
#include "interp/sphere_vector.hpp"
#include "interp/surfaces.hpp"
#include "stripack/predicates.hpp"
#include "support/random.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::at_lonlat;
using support::sampled;
using support::SpherePoints;
using support::triangulated;

C1Options continued() {
  C1Options options;
  options.outside = Outside::linear;
  return options;
}

Direction direction(Vector3 v) { return Direction::from(v.x, v.y, v.z); }

// At an angle from p along the unit tangent t.
Direction stepped(const Direction& p, Vector3 t, double angle) {
  return direction(std::cos(angle) * vector(p) + std::sin(angle) * t);
}

Vector3 unit(Vector3 v) { return (1 / length(v)) * v; }

Vector3 tangent(const Direction& p, double azimuth) {
  const Vector3 east = east_at(p), north = cross(vector(p), east);
  return std::cos(azimuth) * east + std::sin(azimuth) * north;
}

Direction random_direction(support::SplitMix64& random) {
  for (;;) {
    const Vector3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (const double size = dot(v, v); size > 0.01 && size < 1) return direction(v);
  }
}

// The gradient as a vector of space, which does not turn with east and north.
Vector3 gradient_in_space(const SphereC1& surface, const Direction& p) {
  const GradientSphere g = surface.gradient(p);
  const Vector3 east = east_at(p);
  return g.east * east + g.north * cross(vector(p), east);
}

// Smooth, of unit size.
double wave(const Direction& p) {
  return std::sin(2 * p.x() + 0.3) * std::cos(1.5 * p.y()) + 0.5 * p.z();
}

SpherePoints cap(std::size_t n, double radius_deg, std::uint64_t seed) {
  SpherePoints points;
  support::SplitMix64 random(seed);
  const double least = std::cos(radius_deg * std::numbers::pi / 180);
  const Direction middle = at_lonlat(37, 21);
  while (points.size() < n) {
    const Direction p = random_direction(random);
    if (dot(vector(p), vector(middle)) > least) points.push_back(p);
  }
  return points;
}

SpherePoints northern_half() {
  SpherePoints points;
  for (int lat = 0; lat < 90; lat += 15)
    for (int lon = 0; lon < 360; lon += 15) points.push_back(at_lonlat(lon, lat));
  points.push_back(at_lonlat(0, 90));
  return points;
}

struct Set {
  const char* name;
  SpherePoints points;
  double spacing;  // radians, about
};

std::vector<Set> sets() {
  return {{"cap of 80 degrees", cap(150, 80, 1), 0.2},
          {"cap of 20 degrees", cap(100, 20, 2), 0.07},
          {"northern half", northern_half(), 0.26},
          {"box of 100 km", support::box_directions(60, 3, 0.0157), 0.002},
          {"box of 6 m", support::box_directions(60, 4, 1e-6), 1e-7},
          {"octant", {at_lonlat(0, 0), at_lonlat(90, 0), at_lonlat(0, 90)}, 1}};
}

TEST(RimExtension, MeetsTheSurfaceWithItsGradientAtTheHull) {
  for (const Set& set : sets()) {
    const auto t = triangulated(set.points);
    const std::vector<double> values = support::random_values(set.points.size(), 5);
    const SphereC1 surface(t, values, continued());
    const auto hull = t->boundary();
    ASSERT_FALSE(hull.empty());
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vector3
          a = vector(set.points[static_cast<std::size_t>(hull[i])]),
          b = vector(set.points[static_cast<std::size_t>(hull[(i + 1) % hull.size()])]);
      for (const double part : {0.1, 0.5, 0.8}) {
        const Direction on = direction((1 - part) * a + part * b);
        const Vector3 outwards = unit(cross(b - a, a));
        // Triangles at the hull are thin: what differs falls with the step.
        double jumps[2] = {0, 0};
        for (int k = 0; k < 2; ++k) {
          const double step = (k == 0 ? 1e-6 : 1e-8) * length(b - a);
          const Direction in = stepped(on, outwards, -step),
                          out = stepped(on, outwards, step);
          const Vector3 slope = gradient_in_space(surface, out);
          const double rise = step * (length(slope) + 1 / set.spacing);
          EXPECT_NEAR(surface.value(in), surface.value(out), 100 * rise) << set.name;
          jumps[k] = length(gradient_in_space(surface, in) - slope) /
                     (length(slope) + 1 / set.spacing);
        }
        if (set.spacing < 1e-4) continue;  // too near for slopes
        EXPECT_LT(jumps[1], 0.1 * jumps[0] + 1e-7)
            << set.name << ", edge " << i << ", part " << part;
      }
    }
  }
}

// Along great circles through everything: where the surface, or its gradient, changes
// most between neighbouring places, ever nearer ones.
TEST(RimExtension, IsContinuousWithItsGradientAllRoundTheGlobe) {
  support::SplitMix64 random(6);
  for (const Set& set : sets()) {
    if (set.spacing < 1e-4) continue;  // beyond the rim it is as steep
    const auto t = triangulated(set.points);
    const SphereC1 surface(t, sampled(set.points, wave), continued());
    const auto hull = t->boundary();
    for (int k = 0; k < 12; ++k) {
      const Direction from =
          k % 2 == 0
              ? random_direction(random)
              : set.points[static_cast<std::size_t>(hull[random.below(hull.size())])];
      const Vector3 along = tangent(from, random.between(0, 6.3));
      const auto jump = [&](double low, double high) {
        const Direction p = stepped(from, along, low), q = stepped(from, along, high);
        return std::abs(surface.value(p) - surface.value(q)) +
               set.spacing *
                   length(gradient_in_space(surface, p) - gradient_in_space(surface, q));
      };
      constexpr int num = 720;
      double low = 0, high = 0, most = -1;
      for (int i = 0; i < num; ++i) {
        const double a = i * 2 * std::numbers::pi / num,
                     b = (i + 1) * 2 * std::numbers::pi / num;
        if (const double j = jump(a, b); j > most) most = j, low = a, high = b;
      }
      while (high - low > 1e-7) {
        const double middle = (low + high) / 2;
        (jump(low, middle) > jump(middle, high) ? high : low) = middle;
      }
      EXPECT_LT(jump(low, high), 1e-3) << set.name << ", circle " << k << " at " << low;
    }
  }
}

TEST(RimExtension, HasTheDerivativesOfItsValues) {
  support::SplitMix64 random(7);
  for (const Set& set : sets()) {
    if (set.spacing < 0.05) continue;
    const auto t = triangulated(set.points);
    const SphereC1 surface(t, sampled(set.points, wave), continued());
    int num = 0;
    for (int k = 0; k < 300; ++k) {
      const Direction p = random_direction(random);
      const DerivativesSphere d = surface.derivatives(p);
      EXPECT_NEAR(d.value, surface.value(p), 1e-14);
      const double h = 1e-5;
      const auto at = [&](double azimuth, double step) {
        return surface.value(stepped(p, tangent(p, azimuth), step));
      };
      const double north = std::numbers::pi / 2;
      const double size = 1 + std::abs(d.east_east) + std::abs(d.north_north);
      const double east = (at(0, h) - at(0, -h)) / (2 * h);
      EXPECT_NEAR(d.east, east, 1e-5 * size) << set.name;
      EXPECT_NEAR(d.north, (at(north, h) - at(north, -h)) / (2 * h), 1e-5 * size);
      const double second =
          (at(0, 10 * h) - 2 * d.value + at(0, -10 * h)) / (100 * h * h);
      // Second derivatives jump at the borders of zones and triangles; few are near.
      if (std::abs(d.east_east - second) > 1e-2 * size) ++num;
    }
    EXPECT_LT(num, 12) << set.name;
  }
}

TEST(RimExtension, HasOneValueOnTheFarSideTheMeanAlongTheRim) {
  const SpherePoints points = cap(80, 50, 8);
  const auto t = triangulated(points);
  const std::vector<double> values = support::random_values(points.size(), 9);
  const SphereC1 surface(t, values, continued());
  const auto hull = t->boundary();
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const auto a = static_cast<std::size_t>(hull[i]),
               b = static_cast<std::size_t>(hull[(i + 1) % hull.size()]);
    const double size = stripack::angle(points[a], points[b]);
    sum += size * (values[a] + values[b]) / 2;
    total += size;
  }
  const double far = surface.value(at_lonlat(37 + 180, -21));
  EXPECT_NEAR(far, sum / total, 1e-14);
  support::SplitMix64 random(10);
  int num_far = 0;
  for (int k = 0; k < 2000; ++k) {
    const Direction p = random_direction(random);
    const bool is_far = std::ranges::all_of(points, [&](const Direction& q) {
      return stripack::angle(p, q) > std::numbers::pi / 2 + 1e-12;
    });
    if (!is_far) continue;
    ++num_far;
    EXPECT_EQ(surface.value(p), far);
    EXPECT_EQ(surface.gradient(p), (GradientSphere{0, 0}));
  }
  EXPECT_GT(num_far, 50);
}

TEST(RimExtension, ReproducesConstantsExactlyEverywhere) {
  support::SplitMix64 random(11);
  for (const Set& set : sets()) {
    const SphereC1 surface(triangulated(set.points),
                           std::vector<double>(set.points.size(), 0.1), continued());
    for (int k = 0; k < 200; ++k) {
      const Direction p = k % 2 == 0 ? random_direction(random)
                                     : stepped(set.points[0], tangent(set.points[0], k),
                                               set.spacing * random.between(0, 20));
      EXPECT_EQ(surface.value(p), 0.1) << set.name;
    }
  }
}

TEST(RimExtension, ContinuesHarmonicsOfFirstDegreeNearTheRim) {
  const SpherePoints points = cap(300, 30, 12);
  const auto harmonic = [](const Direction& p) { return 2 + p.x() - 3 * p.y() + p.z(); };
  const auto t = triangulated(points);
  C1Options options = continued();
  options.tension = 0;
  const SphereC1 surface(t, sampled(points, harmonic), options);
  const auto hull = t->boundary();
  for (const auto row : hull) {
    const Direction p = points[static_cast<std::size_t>(row)];
    const Vector3 out = unit(vector(p) - dot(vector(p), vector(at_lonlat(37, 21))) *
                                             vector(at_lonlat(37, 21)));
    const Direction q = direction(vector(p) + 0.03 * out);
    EXPECT_NEAR(surface.value(q), harmonic(q), 5e-3);
  }
}

TEST(RimExtension, DoesNotDependOnWhereThePolesAre) {
  support::SplitMix64 random(13);
  const Vector3 u = unit(vector(random_direction(random)));
  const Vector3 v = unit(cross(u, {0.3, -0.8, 0.5})), w = cross(u, v);
  const auto turned = [&](const Direction& p) {
    return direction(p.x() * u + p.y() * v + p.z() * w);
  };
  for (const Set& set : {sets()[0], sets()[1]}) {
    SpherePoints points;
    for (const Direction& p : set.points) points.push_back(turned(p));
    const std::vector<double> values = sampled(set.points, wave);
    const SphereC1 surface(triangulated(set.points), values, continued()),
        other(triangulated(points), values, continued());
    for (int k = 0; k < 200; ++k) {
      const Direction p = random_direction(random);
      // Polynomials of rim nodes go on for twenty spacings: rounding grows by their cube.
      EXPECT_NEAR(surface.value(p), other.value(turned(p)), 1e-6) << set.name;
    }
  }
}

TEST(RimExtension, GivesGridsTheSameBits) {
  const SpherePoints points = northern_half();
  const SphereC1 surface(triangulated(points), sampled(points, wave), continued());
  const Field field = surface.grid(globe_grid({-180, 180, -90, 90}, NodeCounts{25, 19}));
  for (std::int64_t j = 0; j < field.grid.y.size; ++j) {
    for (std::int64_t i = 0; i < field.grid.x.size; ++i) {
      const double v = field.values[static_cast<std::size_t>(j * field.grid.x.size + i)];
      const Direction p =
          at_lonlat(field.grid.x.coordinate(i), field.grid.y.coordinate(j));
      EXPECT_TRUE(support::is_same(v, surface.value(p))) << i << ", " << j;
    }
  }
}

TEST(RimExtension, OfPointsOnAGreatCircleIsThatOfTheNearestPlace) {
  const SpherePoints arc{at_lonlat(10, 0), at_lonlat(40, 0), at_lonlat(80, 0)};
  const SphereC1 surface(triangulated(arc), std::vector<double>{1, 3, 2}, continued());
  const double far = (30 * 2 + 40 * 2.5) / 70;
  EXPECT_DOUBLE_EQ(surface.value(at_lonlat(45, 90)), far);
  EXPECT_DOUBLE_EQ(surface.value(at_lonlat(-135, 0)), far);
  const double c = std::cos(std::numbers::pi / 6), part = c * c * (3 - 2 * c);
  EXPECT_NEAR(surface.value(at_lonlat(25, 30)), far + part * (2 - far), 1e-14);
  EXPECT_NEAR(surface.value(at_lonlat(110, 0)), far + part * (2 - far), 1e-14);
  EXPECT_NEAR(surface.value(at_lonlat(25, 1e-9)), 2, 1e-14);
  const SpherePoints one{at_lonlat(3, 4)};
  const SphereC1 constant(triangulated(one), std::vector<double>{7}, continued());
  for (const double lon : {0.0, 100.0, 183.0})
    EXPECT_EQ(constant.value(at_lonlat(lon, -4)), 7);
  EXPECT_TRUE(std::isnan(
      SphereC1(triangulated(SpherePoints{}), std::vector<double>{}, continued())
          .value(at_lonlat(0, 0))));
}

TEST(RimExtension, EndsWhereNoNodeIsNear) {
  const SpherePoints points = cap(80, 20, 14);
  C1Options options = continued();
  options.max_distance = 500;
  const SphereC1 surface(triangulated(points), sampled(points, wave), options);
  EXPECT_TRUE(std::isnan(surface.value(at_lonlat(217, -21))));
  EXPECT_TRUE(std::isnan(surface.derivatives(at_lonlat(217, -21)).east_east));
  EXPECT_TRUE(std::isfinite(surface.value(points[0])));
}

class RimExtensionOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(RimExtensionOnSets, IsFiniteEverywhereWithinTheWidenedRange) {
  const SpherePoints points = GetParam().make(60, 15);
  const std::vector<double> values = support::random_values(points.size(), 16);
  const SphereC1 surface(triangulated(points), values, continued());
  support::SplitMix64 random(17);
  for (int k = 0; k < 150; ++k) {
    const Direction p =
        k % 3 == 0 ? random_direction(random)
                   : stepped(points[random.below(points.size())], tangent(points[0], 0),
                             std::pow(10, random.between(-12, 0)));
    const DerivativesSphere d = surface.derivatives(p);
    EXPECT_TRUE(std::abs(d.value) <= 1.5 + 1e-12) << d.value;
    EXPECT_TRUE(std::isfinite(d.east) && std::isfinite(d.north));
  }
}

INSTANTIATE_TEST_SUITE_P(AllSets, RimExtensionOnSets,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& set) { return std::string(set.param.name); });

}  // namespace
}  // namespace delone::interp
