#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/arc_tension_cells.hpp"
#include "interp/arc_tension_checks.hpp"
#include "interp/blend_variable.hpp"
#include "interp/node_gradients.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::is_same;
using support::random_values;
using support::sampled;
using support::SpherePoints;
using support::triangulated;
using support::with_shape;

RunOptions threads(int count) { return {.num_threads = count, .progress = {}}; }

double wave(const Direction& p) { return std::cos(3 * p.x()) + p.y() * p.z(); }

Direction between(const Direction& a, const Direction& b, double part) {
  return Direction::from(a.x() + part * (b.x() - a.x()), a.y() + part * (b.y() - a.y()),
                         a.z() + part * (b.z() - a.z()));
}

/// Nodes, middles of edges and places inside triangles.
SpherePoints places_of(const stripack::Triangulation& t, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  SpherePoints places(t.points().begin(), t.points().end());
  t.adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto corners = t.adjacency().left(arc);
    const auto corner = [&](std::size_t k) { return t.points()[at(corners[k % 3])]; };
    for (std::size_t k = 0; k < 3; ++k) {
      const Direction side = between(corner(k), corner(k + 1), random.uniform());
      places.push_back(side);
      places.push_back(between(side, corner(k + 2), random.uniform()));
    }
  });
  return places;
}

bool is_inside(const stripack::Triangulation& t, const Direction& p) {
  return t.dimension() == 2 && t.adjacency().has_left(t.find(p));
}

class SphereTensionOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereTensionOnSets, GivesNodesTheirValuesBitForBitAndIsFinite) {
  const SpherePoints points = GetParam().make(50, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  const SphereTensionSpline surface(t, values, with_shape(ArcShape::convex));
  for (std::size_t row = 0; row < points.size(); ++row)
    EXPECT_TRUE(is_same(surface.value(points[row]), merged[at(t->sites()[row])]));
  for (const Direction& p : places_of(*t, 3)) {
    if (!is_inside(*t, p)) continue;
    const DerivativesSphere d = surface.derivatives(p);
    EXPECT_TRUE(std::isfinite(surface.value(p)));
    EXPECT_TRUE(std::isfinite(d.value) && std::isfinite(d.east) &&
                std::isfinite(d.north));
    EXPECT_TRUE(std::isfinite(d.east_east) && std::isfinite(d.east_north) &&
                std::isfinite(d.north_north));
  }
}

TEST_P(SphereTensionOnSets, DoesNotDependOnRowsThreadsOrTheWayItIsAsked) {
  const SpherePoints points = GetParam().make(30, 4);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, wave);
  const SpherePoints reversed(points.rbegin(), points.rend());
  const std::vector<double> reversed_values(values.rbegin(), values.rend());
  const auto options = with_shape(ArcShape::monotone);
  const SphereTensionSpline surface(t, values, options, threads(1)),
      other(triangulated(reversed), reversed_values, options, threads(3));
  const SpherePoints queries = places_of(*t, 5);
  const std::vector<double> found = surface.values(queries);
  EXPECT_EQ(support::first_difference(found, other.values(queries)), found.size());
  const Grid grid = globe_grid({-180, 180, -90, 90}, NodeCounts{7, 5});
  const Field field = surface.grid(grid, threads(2));
  const SpherePoints nodes = globe_nodes(grid);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    EXPECT_TRUE(is_same(surface.value(nodes[k]), field.values[k]));
}

TEST_P(SphereTensionOnSets, ReproducesConstantsExactly) {
  const SpherePoints points = GetParam().make(25, 6);
  const auto t = triangulated(points);
  TensionSplineOptions options = with_shape(ArcShape::convex);
  options.factor = 5;
  const SphereTensionSpline surface(t, std::vector<double>(points.size(), 0.1), options);
  for (const double v : surface.values(places_of(*t, 7)))
    EXPECT_TRUE(v == 0.1 || std::isnan(v)) << v;
}

INSTANTIATE_TEST_SUITE_P(AllSets, SphereTensionOnSets,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& param_info) {
                           return std::string(param_info.param.name);
                         });

std::vector<GradientSphere> random_gradients(std::size_t n, std::uint64_t seed,
                                             double size) {
  support::SplitMix64 random(seed);
  std::vector<GradientSphere> result(n);
  for (auto& g : result) g = {random.between(-size, size), random.between(-size, size)};
  return result;
}

/// The rate of a surface's values from `a` towards `b`, by radians, at a part of the arc.
double angle_between(const Direction& a, const Direction& b) {
  return 2 * std::atan2(std::hypot(a.x() - b.x(), a.y() - b.y(), a.z() - b.z()),
                        std::hypot(a.x() + b.x(), a.y() + b.y(), a.z() + b.z()));
}
Direction along(const Direction& a, const Direction& b, double part) {
  const double angle = angle_between(a, b), s = std::sin((1 - part) * angle),
               t = std::sin(part * angle);
  return Direction::from(s * a.x() + t * b.x(), s * a.y() + t * b.y(),
                         s * a.z() + t * b.z());
}

TEST(SphereTension, IsTheTensionSplineInTheAngleAlongEveryArc) {
  const SpherePoints points = support::uniform_directions(150, 8);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 9);
  const SphereTensionSpline surface(t, values, random_gradients(150, 10, 5),
                                    with_shape(ArcShape::convex));
  const std::vector<double> factors = surface.tension_factors();
  const auto arcs = tension_arcs(*t);
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const Direction &a = points[at(arcs[k][0])], &b = points[at(arcs[k][1])];
    const double angle = angle_between(a, b), step = 1e-6;
    const auto slope = [&](double part, double sign) {
      return sign *
             (surface.value(along(a, b, part + sign * step)) -
              surface.value(along(a, b, part))) /
             (step * angle);
    };
    const HermiteArc arc{values[at(arcs[k][0])], values[at(arcs[k][1])], slope(0, 1),
                         slope(1, -1), angle};
    const TensionSpline spline(arc, factors[k]);
    for (const double part : {0.1, 0.4, 0.8})
      EXPECT_NEAR(surface.value(along(a, b, part)), spline.value(part), 2e-3);
  }
}

TEST(SphereTension, KeepsTheShapeAlongArcs) {
  const SpherePoints points = support::uniform_directions(300, 11);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, wave);
  const std::vector<GradientSphere> gradients = random_gradients(300, 12, 3);
  const SphereTensionSpline surface(t, values, gradients, with_shape(ArcShape::monotone)),
      free(t, values, gradients);
  EXPECT_EQ(surface.tension_factors(),
            tension_factors(*t, values, gradients, {.shape = ArcShape::monotone}));
  EXPECT_EQ(free.fit().num_tightened, 0);
  const auto arcs = tension_arcs(*t);
  const std::vector<double> factors = surface.tension_factors();
  int num_monotone = 0, num_turning = 0;
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    if (factors[k] == 0 || factors[k] == tension_factor_max) continue;
    const Direction &a = points[at(arcs[k][0])], &b = points[at(arcs[k][1])];
    const double sign = values[at(arcs[k][1])] > values[at(arcs[k][0])] ? 1 : -1;
    double worst = 0, freely = 0;
    for (int i = 0; i < 50; ++i) {
      const Direction p = along(a, b, i / 50.0), q = along(a, b, (i + 1) / 50.0);
      worst = std::max(worst, sign * (surface.value(p) - surface.value(q)));
      freely = std::max(freely, sign * (free.value(p) - free.value(q)));
    }
    EXPECT_LE(worst, 1e-12);
    ++num_monotone;
    num_turning += freely > 1e-9 ? 1 : 0;
  }
  EXPECT_GT(num_monotone, 30);
  EXPECT_GT(num_turning, num_monotone / 2);
}

TEST(SphereTension, StaysInTheRangeAlongArcs) {
  const SpherePoints points = support::uniform_directions(200, 13);
  const auto t = triangulated(points);
  std::vector<double> values = random_values(200, 14);
  for (double& v : values) v = std::clamp(2 * v, -1.0, 1.0);
  TensionSplineOptions options;
  options.demand.least = -1;
  options.demand.most = 1;
  const SphereTensionSpline surface(t, values, random_gradients(200, 15, 4), options);
  EXPECT_GT(surface.fit().num_shortened, 50);
  for (const auto& [from, to] : tension_arcs(*t)) {
    for (int i = 0; i <= 40; ++i) {
      const double v = surface.value(along(points[at(from)], points[at(to)], i / 40.0));
      EXPECT_TRUE(v >= -1 - 1e-12 && v <= 1 + 1e-12) << v;
    }
  }
}

TEST(SphereTension, GradientIsContinuousAcrossEdges) {
  for (const double factor : {0.0, 25.0}) {
    for (const std::size_t count : {std::size_t{6}, std::size_t{200}}) {  // wide ones too
      const SpherePoints points = support::uniform_directions(count, 16);
      const auto t = triangulated(points);
      TensionSplineOptions options = with_shape(ArcShape::convex);
      options.factor = factor;
      std::vector<Vector3> gradients;
      for (Site s = 0; s < t->num_sites(); ++s)
        gradients.push_back(scaled_gradient(*t, 1, s, {0.3 * s - 1, 1 - 0.01 * s}));
      const std::vector<double> values = random_values(count, 17);
      const ArcTensionCells<SphereSpace> cells(
          SphereCells(t, values, {}),
          ArcNetwork<SphereSpace>(t, {}, values, gradients, options, {}), {});
      const Adjacency& a = t->adjacency();
      for (Site v = 0; v < t->num_sites(); ++v) {
        Arc arc = a.first_arc(v);
        for (std::int32_t i = 0; i < a.degree(v); ++i, arc = a.next(arc)) {
          if (!a.has_left(arc) || !a.has_left(a.reverse(arc))) continue;
          const Direction p = along(t->points()[at(v)], t->points()[at(a.target(arc))],
                                    0.05 + 0.9 * (i % 7) / 6.0);
          const auto place = variable(SphereSpace{}, p);
          const SecondOrder left = cells.facet(arc).derivatives(place),
                            right = cells.facet(a.reverse(arc)).derivatives(place);
          EXPECT_NEAR(left.value, right.value, 1e-11);
          const double steep = std::hypot(left.x, left.y) + 1;
          EXPECT_NEAR(left.x, right.x, 1e-9 * steep) << "edge of " << v;
          EXPECT_NEAR(left.y, right.y, 1e-9 * steep);
        }
      }
    }
  }
}

TEST(SphereTension, DerivativesAreThoseOfTheSurface) {
  const SpherePoints points = support::uniform_directions(150, 18);
  TensionSplineOptions options = with_shape(ArcShape::convex);
  options.factor = 1;
  const SphereTensionSpline surface(triangulated(points), sampled(points, wave), options);
  support::SplitMix64 random(19);
  const double h = 1e-6;
  int num_checked = 0;
  for (int i = 0; i < 200; ++i) {
    const Direction p =
        support::at_lonlat(random.between(-180, 180), random.between(-80, 80));
    const Vector3 at_p = vector(p), east = east_at(p), north = cross(at_p, east);
    const auto step = [&](double e, double n) {
      const double cosine = std::sqrt(1 - e * e - n * n);
      const Vector3 q = cosine * at_p + e * east + n * north;
      return Direction::from(q.x, q.y, q.z);
    };
    const DerivativesSphere d = surface.derivatives(p);
    EXPECT_NEAR(d.value, surface.value(p), 1e-13);
    EXPECT_NEAR(d.east,
                (surface.value(step(h, 0)) - surface.value(step(-h, 0))) / (2 * h), 1e-5);
    EXPECT_NEAR(d.north,
                (surface.value(step(0, h)) - surface.value(step(0, -h))) / (2 * h), 1e-5);
    const double wide = 1e-4;
    const auto second = [&](double e, double n) {
      return (surface.value(step(e, n)) - 2 * d.value + surface.value(step(-e, -n))) /
             (wide * wide);
    };
    num_checked += std::abs(second(wide, 0) - d.east_east) < 1e-2 &&
                   std::abs(second(0, wide) - d.north_north) < 1e-2;
  }
  EXPECT_GT(num_checked, 190);
}

TEST(SphereTension, GradientAtNodesIsTheOneGivenPolesIncluded) {
  SpherePoints points = support::uniform_directions(40, 20);
  points.push_back(support::at_lonlat(0, 90));
  points.push_back(support::at_lonlat(0, -90));
  const std::vector<GradientSphere> gradients = random_gradients(points.size(), 21, 2);
  const SphereTensionSpline surface(triangulated(points),
                                    random_values(points.size(), 22), gradients);
  for (std::size_t row = 0; row < points.size(); ++row) {
    const GradientSphere g = surface.gradient(points[row]);
    EXPECT_NEAR(g.east, gradients[row].east, 1e-14);
    EXPECT_NEAR(g.north, gradients[row].north, 1e-14);
  }
}

double rms_error(std::size_t count) {
  const SpherePoints points = support::uniform_directions(count, 23);
  const SphereTensionSpline surface(triangulated(points), sampled(points, wave));
  double sum = 0;
  const SpherePoints places = support::uniform_directions(500, 24);
  for (const Direction& p : places) sum += std::pow(surface.value(p) - wave(p), 2);
  return std::sqrt(sum / 500);
}

TEST(SphereTension, ErrorFallsWithTheCubeOfSpacingWithoutTension) {
  EXPECT_GT(rms_error(400) / rms_error(1600), 8);
}

TEST(SphereTension, TinyTrianglesKeepTheirDigits) {
  // The same picture at any size: values over a patch of 1 m and of 1,000 km.
  const auto error = [](double degrees) {
    support::SplitMix64 random(25);
    SpherePoints points;
    std::vector<double> values;
    const auto f = [&](double x, double y) { return x * x - 2 * x * y + y; };
    std::vector<GradientSphere> gradients;
    const double per_radian = 180 / std::numbers::pi / degrees;
    for (int i = 0; i < 60; ++i) {
      const double x = random.uniform(), y = random.uniform();
      points.push_back(support::at_lonlat(x * degrees, y * degrees));
      values.push_back(f(x, y));
      gradients.push_back({(2 * x - 2 * y) * per_radian, (1 - 2 * x) * per_radian});
    }
    const SphereTensionSpline surface(triangulated(points), values, gradients);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const double x = random.between(0.2, 0.8), y = random.between(0.2, 0.8);
      worst = std::max(
          worst, std::abs(surface.value(support::at_lonlat(x * degrees, y * degrees)) -
                          f(x, y)));
    }
    return worst;
  };
  EXPECT_LT(error(1e-5), 1e-6);
  EXPECT_LT(error(1e-2), 1e-6);
}

TEST(SphereTension, IntegralOfAConstantIsTheArea) {
  const SpherePoints points = support::uniform_directions(50, 26);
  const SphereTensionSpline surface(triangulated(points), std::vector<double>(50, 2.0));
  EXPECT_NEAR(surface.integral(), 8 * std::numbers::pi, 1e-9);
}

TEST(SphereTension, FewPointsHaveAValueAndWhatIsUnusableIsRefused) {
  const SpherePoints two{support::at_lonlat(0, 0), support::at_lonlat(90, 0)};
  const SphereTensionSpline surface(triangulated(two), std::vector<double>{1, 2});
  EXPECT_NEAR(surface.value(support::at_lonlat(45, 0)), 1.5, 1e-15);
  EXPECT_TRUE(surface.tension_factors().empty());
  const SphereTensionSpline nothing(triangulated(SpherePoints{}), std::vector<double>{});
  EXPECT_TRUE(std::isnan(nothing.value(two[0])));
  const SpherePoints points = support::uniform_directions(10, 27);
  TensionSplineOptions options;
  options.c1.outside = Outside::linear;
  EXPECT_THROW(SphereTensionSpline(triangulated(points), random_values(10, 28), options),
               Error);
  options = {};
  options.factor = 86;
  EXPECT_THROW(SphereTensionSpline(triangulated(points), random_values(10, 28), options),
               Error);
}

}  // namespace
}  // namespace delone::interp
