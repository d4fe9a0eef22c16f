#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/blend_cells.hpp"
#include "interp/c1_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::is_same;
using support::random_values;
using support::sampled;
using support::SpherePoints;
using support::triangulated;

RunOptions threads(int count) { return {.num_threads = count, .progress = {}}; }

Direction between(const Direction& a, const Direction& b, const Direction& c, double s,
                  double u) {
  const Vector3 p = vector(a) + s * (vector(b) - vector(a)) + u * (vector(c) - vector(a));
  return Direction::from(p.x, p.y, p.z);
}

SpherePoints points_of_the_region(const stripack::Triangulation& t, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  SpherePoints points(t.points().begin(), t.points().end());
  t.adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto corners = t.adjacency().left(arc);
    const auto corner = [&](std::size_t k) { return t.points()[at(corners[k % 3])]; };
    for (std::size_t k = 0; k < 3; ++k) {
      const double s = random.uniform(), u = random.uniform() * (1 - s);
      points.push_back(between(corner(k), corner(k + 1), corner(k + 2), s, u));
      points.push_back(between(corner(k), corner(k + 1), corner(k + 2), 0.5, 0));
    }
  });
  return points;
}

SpherePoints spread_points(int n) {  // a spiral of equal areas
  SpherePoints points;
  for (int k = 1; k <= n; ++k) {
    const double z = 1 - (2.0 * k - 1) / n,
                 lon = k * std::numbers::pi * (3 - std::sqrt(5.0)),
                 r = std::sqrt(1 - z * z);
    points.push_back(Direction::from(r * std::cos(lon), r * std::sin(lon), z));
  }
  return points;
}

// The functions s1 .. s7 that spherical interpolants are compared on.
double s1(const Direction& p) { return (1 + 2 * p.x() + 3 * p.y() + 4 * p.z()) / 6; }
double s2(const Direction& p) {
  const double x = p.x(), y = p.y(), z = p.z();
  return (9 * x * x * x - 2 * x * x * y + 3 * x * y * y - 4 * y * y * y + 2 * z * z * z -
          x * y * z) /
         10;
}
double s3(const Direction& p) { return std::exp(p.x()) + 2 * std::exp(p.y() + p.z()); }
double s6(const Direction& p) { return 2 + p.x() * p.x() - p.y() * p.y(); }

class SphereC1OnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereC1OnSets, GivesNodesTheirValuesBitForBit) {
  const SpherePoints points = support::affordable(GetParam(), 300, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  const SphereC1 surface(t, values);
  for (std::size_t row = 0; row < points.size(); ++row) {
    EXPECT_TRUE(is_same(surface.value(points[row]), merged[at(t->sites()[row])]))
        << "row " << row;
  }
}

TEST_P(SphereC1OnSets, IsFiniteAndWithinTheWidenedRangeOnTheRegion) {
  const SpherePoints points = support::affordable(GetParam(), 250, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  if (merged.empty() || t->dimension() < 2) return;
  const auto [least, most] = std::ranges::minmax_element(merged);
  const double wider = 0.25 * (*most - *least) + 1e-12;
  const SphereC1 surface(t, values, {.tension = 0});
  const SpherePoints queries = points_of_the_region(*t, 5);
  const std::vector<double> found = surface.values(queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (!t->adjacency().has_left(t->find(queries[i]))) continue;  // rounded to outside
    EXPECT_TRUE(found[i] >= *least - wider && found[i] <= *most + wider) << found[i];
  }
}

TEST_P(SphereC1OnSets, GivesTheSameBitsHoweverItIsAsked) {
  const SpherePoints points = support::affordable(GetParam(), 200, 9);
  const auto t = triangulated(points);
  if (t->num_sites() < 3) return;
  const std::vector<double> values = random_values(points.size(), 10);
  const SphereC1 surface(t, values, {}, threads(1)), other(t, values, {}, threads(3));
  const Grid grid = globe_grid({-180, 180, -90, 90}, NodeCounts{37, 19});
  const Field field = surface.grid(grid, threads(1));
  EXPECT_EQ(support::first_difference(field.values, other.grid(grid, threads(3)).values),
            field.values.size());
  const SpherePoints nodes = globe_nodes(grid);
  const std::vector<double> found = surface.values(nodes);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    EXPECT_TRUE(is_same(found[k], surface.value(nodes[k])));
    EXPECT_TRUE(is_same(found[k], field.values[k]))
        << k << ": " << found[k] << " " << field.values[k];
  }
}

TEST_P(SphereC1OnSets, ReproducesConstantsExactly) {
  const SpherePoints points = support::affordable(GetParam(), 100, 13);
  const auto t = triangulated(points);
  const SphereC1 surface(t, std::vector<double>(points.size(), 0.1));
  for (const double v : surface.values(points_of_the_region(*t, 14)))
    EXPECT_TRUE(v == 0.1 || std::isnan(v)) << v;
}

INSTANTIATE_TEST_SUITE_P(AllSets, SphereC1OnSets,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& param_info) {
                           return std::string(param_info.param.name);
                         });

template <int Degree>
void expect_smooth_edges(const SpherePoints& points, std::span<const double> values,
                         double tension) {
  const auto t = triangulated(points);
  C1Options options;
  options.tension = tension;
  const BlendCells<SphereSpace, Degree> cells(
      t, values_at_sites(t->sites(), t->num_sites(), values), options, {});
  const Adjacency& a = t->adjacency();
  for (Site v = 0; v < t->num_sites(); ++v) {
    Arc arc = a.first_arc(v);
    for (std::int32_t i = 0; i < a.degree(v); ++i, arc = a.next(arc)) {
      if (!a.has_left(arc) || !a.has_left(a.reverse(arc))) continue;
      const Direction p = t->points()[at(v)], q = t->points()[at(a.target(arc))];
      const Direction m = between(p, q, p, 0.1 + 0.8 * (i % 7) / 6.0, 0);
      const Vector3 at_m = vector(m), e = east_at(m), n = cross(at_m, e);
      const SphereSpace::Position<SecondOrder> on_edge{SecondOrder(at_m.x, e.x, n.x),
                                                       SecondOrder(at_m.y, e.y, n.y),
                                                       SecondOrder(at_m.z, e.z, n.z)};
      const SecondOrder left = cells.facet(arc)(on_edge),
                        right = cells.facet(a.reverse(arc))(on_edge);
      EXPECT_NEAR(left.value, right.value, 1e-12);
      const double steep = std::hypot(left.x, left.y) + 1;
      EXPECT_NEAR(left.x, right.x, 1e-7 * steep) << "edge of " << v;
      EXPECT_NEAR(left.y, right.y, 1e-7 * steep);
    }
  }
}

TEST(SphereC1, GradientIsContinuousAcrossEdges) {
  const SpherePoints points = spread_points(400);
  expect_smooth_edges<3>(points, sampled(points, s3), 0);
  expect_smooth_edges<4>(points, sampled(points, s3), 0);
  expect_smooth_edges<3>(points, random_values(points.size(), 2), 0.5);
  const SpherePoints few = spread_points(9);  // sides of two radians
  expect_smooth_edges<3>(few, random_values(few.size(), 3), 0);
}

TEST(SphereC1, ReproducesConstantsAndFirstHarmonics) {
  const SpherePoints points = spread_points(400);
  const SphereC1 surface(triangulated(points), sampled(points, s1));
  const auto t = triangulated(points);
  double largest = 0;
  for (const Direction& p : points_of_the_region(*t, 5)) {
    if (s1(p) > 0.95 || s1(p) < -0.6) continue;  // kept near the range of the data
    largest = std::max(largest, std::abs(surface.value(p) - s1(p)));
  }
  EXPECT_LT(largest, 1e-11);
}

TEST(SphereC1, DerivativesAreThoseOfTheSurface) {
  const SpherePoints points = spread_points(500);
  const SphereC1 surface(triangulated(points), sampled(points, s3), {.tension = 0});
  support::SplitMix64 random(6);
  const double h = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const double lon = random.between(-180, 180), lat = random.between(-80, 80);
    const DerivativesSphere d = surface.derivatives(support::at_lonlat(lon, lat));
    EXPECT_NEAR(d.value, surface.value(support::at_lonlat(lon, lat)), 1e-13);
    const double degrees = h * 180 / std::numbers::pi;
    const double across = degrees / std::cos(lat * std::numbers::pi / 180);
    EXPECT_NEAR(d.east,
                (surface.value(support::at_lonlat(lon + across, lat)) -
                 surface.value(support::at_lonlat(lon - across, lat))) /
                    (2 * h),
                1e-4);
    EXPECT_NEAR(d.north,
                (surface.value(support::at_lonlat(lon, lat + degrees)) -
                 surface.value(support::at_lonlat(lon, lat - degrees))) /
                    (2 * h),
                1e-4);
  }
}

TEST(SphereC1, LaplacianOfAHarmonicIsItsEigenvalueTimesIt) {
  const SpherePoints points = spread_points(6400);
  const SphereC1 surface(triangulated(points), sampled(points, s6), {.tension = 0});
  for (const Direction& p : spread_points(50))
    EXPECT_NEAR(surface.derivatives(p).laplacian(), -6 * (s6(p) - 2), 0.05);
}

// Points between those of spread_points(n).
double rms_error(int n, double (*f)(const Direction&), const C1Options& options) {
  const SpherePoints points = spread_points(n);
  const SphereC1 surface(triangulated(points), sampled(points, f), options);
  double sum = 0;
  constexpr int count = 5000;
  for (const Direction& q : spread_points(count)) {
    const Direction p =
        Direction::from(q.x() * std::cos(0.5) - q.y() * std::sin(0.5),
                        q.x() * std::sin(0.5) + q.y() * std::cos(0.5), q.z());
    const double error = surface.value(p) - f(p);
    sum += error * error;
  }
  return std::sqrt(sum / count);
}

struct PeerFigures {
  const char* name;
  double (*f)(const Direction&);
  int n;
  double best;  ///< RMS of the better of SSRFPACK's local and global gradients
};

TEST(SphereC1, IsThreeTimesAsAccurateAsSsrfpackOnSmoothFunctions) {
  for (const PeerFigures& peer :
       std::initializer_list<PeerFigures>{{"s2", s2, 400, 2.002e-4},
                                          {"s2", s2, 1600, 3.285e-5},
                                          {"s2", s2, 6400, 3.829e-6},
                                          {"s3", s3, 400, 5.889e-4},
                                          {"s3", s3, 1600, 6.315e-5},
                                          {"s3", s3, 6400, 7.266e-6},
                                          {"s6", s6, 400, 3.274e-4},
                                          {"s6", s6, 1600, 3.478e-5},
                                          {"s6", s6, 6400, 4.190e-6}})
    EXPECT_LT(rms_error(peer.n, peer.f, {}), 0.3 * peer.best)
        << peer.name << " " << peer.n;
}

TEST(SphereC1, ErrorFallsWithTheFourthPowerOfSpacing) {
  EXPECT_GT(rms_error(1600, s3, {}) / rms_error(6400, s3, {}), 16);
}

TEST(SphereC1, DoesNotDependOnTheAxes) {
  const SpherePoints points = spread_points(300);
  const auto turned = [](const Direction& p) {
    return Direction::from(p.z(), 0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
  };
  SpherePoints turned_points;
  for (const Direction& p : points) turned_points.push_back(turned(p));
  const std::vector<double> values = sampled(points, s3);
  const SphereC1 a(triangulated(points), values, {.tension = 0.1}),
      b(triangulated(turned_points), values, {.tension = 0.1});
  for (const Direction& p : spread_points(777))
    EXPECT_NEAR(a.value(p), b.value(turned(p)), 1e-9);
}

TEST(SphereC1, RefusesWhatItCannotUse) {
  const SpherePoints points = spread_points(10);
  const auto t = triangulated(points);
  EXPECT_THROW(SphereC1(t, std::vector<double>{1, 2}), Error);
  EXPECT_THROW(SphereC1(t, sampled(points, s1), {.tension = 2}), Error);
}

}  // namespace
}  // namespace delone::interp
