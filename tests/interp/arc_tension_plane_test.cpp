#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/arc_tension_cells.hpp"
#include "interp/arc_tension_checks.hpp"
#include "interp/surfaces.hpp"
#include "interp/test_functions.hpp"

namespace delone::interp {
namespace {

using support::arcs_of;
using support::is_same;
using support::PlanePoints;
using support::points_of_the_hull;
using support::random_gradients;
using support::random_values;
using support::sampled;
using support::triangulated;
using support::with_range;
using support::with_shape;
using tripack::Point2;

constexpr double infinity = std::numeric_limits<double>::infinity();

RunOptions threads(int count) { return {.num_threads = count, .progress = {}}; }

/// Gradients of local fits: nothing is chosen by leaving out.
C1Options local_fits() {
  C1Options options;
  options.gradients = Gradients::local;
  options.tension = 0;
  return options;
}
/// The largest step against `sign` of a curve read at 200 places.
double largest_step_back(const TensionSpline& spline, double sign) {
  double worst = 0;
  for (int k = 0; k < 200; ++k)
    worst =
        std::max(worst, sign * (spline.value(k / 200.0) - spline.value((k + 1) / 200.0)));
  return worst;
}

class PlaneTensionOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneTensionOnSets, GivesNodesTheirValuesBitForBit) {
  const PlanePoints points = GetParam().make(150, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  const PlaneTensionSpline surface(t, values, with_shape(ArcShape::convex));
  for (std::size_t row = 0; row < points.size(); ++row)
    EXPECT_TRUE(is_same(surface.value(points[row]), merged[at(t->sites()[row])]));
}

TEST_P(PlaneTensionOnSets, IsFiniteOnTheClosedHullWithItsDerivatives) {
  const PlanePoints points = GetParam().make(80, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  const PlaneTensionSpline surface(t, values, with_shape(ArcShape::monotone));
  for (const Point2 p : points_of_the_hull(*t, 5)) {
    const Arc found = t->find(p);
    if (t->dimension() < 2 || !t->adjacency().has_left(found)) continue;
    const Derivatives2 d = surface.derivatives(p);
    EXPECT_TRUE(std::isfinite(surface.value(p))) << p.x << " " << p.y;
    EXPECT_TRUE(std::isfinite(d.value)) << p.x << " " << p.y;
    EXPECT_TRUE(std::isfinite(d.x) && std::isfinite(d.y)) << p.x << " " << p.y;
    EXPECT_TRUE(std::isfinite(d.xx) && std::isfinite(d.xy) && std::isfinite(d.yy));
  }
}

TEST_P(PlaneTensionOnSets, GivesTheSameBitsHoweverItIsAsked) {
  const PlanePoints points = GetParam().make(100, 9);
  const auto t = triangulated(points);
  if (t->num_sites() < 3) return;
  const std::vector<double> values = random_values(points.size(), 10);
  const PlaneTensionSpline surface(t, values, with_shape(ArcShape::convex), threads(1)),
      other(t, values, with_shape(ArcShape::convex), threads(3));
  const Grid grid = plane_grid(support::region_of(*t), NodeCounts{17, 13});
  const Field field = surface.grid(grid, threads(1));
  EXPECT_EQ(support::first_difference(field.values, other.grid(grid, threads(3)).values),
            field.values.size());
  const PlanePoints nodes = plane_nodes(grid);
  const std::vector<double> found = surface.values(nodes);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    EXPECT_TRUE(is_same(found[k], surface.value(nodes[k])));
    EXPECT_TRUE(is_same(found[k], field.values[k]));
  }
}

TEST_P(PlaneTensionOnSets, DoesNotDependOnTheOrderOfRows) {
  const PlanePoints points = GetParam().make(100, 11);
  const auto t = triangulated(points);
  const std::vector<double> values =
      sampled(points, [](Point2 p) { return std::cos(p.x) + std::sin(p.y); });
  const PlanePoints reversed(points.rbegin(), points.rend());
  const std::vector<double> reversed_values(values.rbegin(), values.rend());
  const PlanePoints queries = points_of_the_hull(*t, 12);
  const auto options = with_shape(ArcShape::convex);
  const std::vector<double> found =
      PlaneTensionSpline(t, values, options).values(queries);
  const std::vector<double> again =
      PlaneTensionSpline(triangulated(reversed), reversed_values, options)
          .values(queries);
  EXPECT_EQ(support::first_difference(found, again), found.size());
}

TEST_P(PlaneTensionOnSets, ReproducesConstantsExactly) {
  const PlanePoints points = GetParam().make(80, 13);
  const auto t = triangulated(points);
  TensionSplineOptions options = with_shape(ArcShape::convex);
  options.factor = 5;
  options.demand.least = options.demand.most = 0.1;
  const PlaneTensionSpline surface(t, std::vector<double>(points.size(), 0.1), options);
  for (const double v : surface.values(points_of_the_hull(*t, 14)))
    EXPECT_TRUE(v == 0.1 || std::isnan(v)) << v;
}

TEST_P(PlaneTensionOnSets, StaysInTheRangeOnEveryArc) {
  const PlanePoints points = GetParam().make(120, 15);
  const auto t = triangulated(points);
  if (t->dimension() < 2 || t->num_sites() != t->num_rows()) return;
  std::vector<double> values = random_values(points.size(), 16);
  for (double& v : values) v = std::clamp(2 * v, -1.0, 1.0);  // many at the ends
  const PlaneTensionSpline surface(t, values, with_range(-1, 1));
  const std::vector<double> factors = surface.tension_factors();
  const std::vector<HermiteArc> arcs = arcs_of(surface, points, values, *t);
  ASSERT_EQ(arcs.size(), factors.size());
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    EXPECT_LE(factors[k], tension_factor_max);
    const TensionSpline spline(arcs[k], factors[k]);
    const double slack =
        1e-14 * (std::abs(arcs[k].start_slope) + std::abs(arcs[k].end_slope) + 1);
    EXPECT_LE(arcs[k].start + spline.rises().most, 1 + slack);
    EXPECT_GE(arcs[k].start + spline.rises().least, -1 - slack);
  }
}

INSTANTIATE_TEST_SUITE_P(AllSets, PlaneTensionOnSets,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& param_info) {
                           return std::string(param_info.param.name);
                         });

TEST(PlaneTension, TurnsNowhereOnArcsWhoseEndsAreMonotone) {
  const PlanePoints points = support::uniform_points(200, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, support::franke);
  for (const double size : {0.0, 1.0, 5.0}) {
    const PlaneTensionSpline surface =
        size == 0 ? PlaneTensionSpline(t, values, with_shape(ArcShape::monotone))
                  : PlaneTensionSpline(t, values, random_gradients(200, 2, size),
                                       with_shape(ArcShape::monotone));
    const std::vector<double> factors = surface.tension_factors();
    const std::vector<HermiteArc> arcs = arcs_of(surface, points, values, *t);
    int num_monotone = 0, num_limited = 0;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      const double sign = arcs[k].end > arcs[k].start ? 1 : -1;
      if (sign * arcs[k].start_slope < 0 || sign * arcs[k].end_slope < 0) {
        EXPECT_EQ(factors[k], 0);
        continue;
      }
      num_limited += factors[k] == tension_factor_max ? 1 : 0;
      if (factors[k] == tension_factor_max) continue;
      ++num_monotone;
      EXPECT_LE(largest_step_back(TensionSpline(arcs[k], factors[k]), sign), 1e-15);
      // With less it would turn.
      const auto slopes = TensionSpline(arcs[k], 0.99 * factors[k]).slopes();
      if (factors[k] > 0) {
        EXPECT_LT(sign > 0 ? slopes.least : -slopes.most, 0);
      }
    }
    EXPECT_GT(num_monotone, 80);
    EXPECT_EQ(surface.fit().num_limited, num_limited);
  }
}

TEST(PlaneTension, BendsOneWayOnArcsWhoseEndsAreConvex) {
  const PlanePoints points = support::uniform_points(400, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, support::franke);
  const PlaneTensionSpline surface(t, values, with_shape(ArcShape::convex));
  const std::vector<double> factors = surface.tension_factors();
  const std::vector<HermiteArc> arcs = arcs_of(surface, points, values, *t);
  int num_convex = 0, num_tightened = 0;
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const double rise = arcs[k].end - arcs[k].start, a = rise - arcs[k].start_slope,
                 b = arcs[k].end_slope - rise;
    if (!(a * b > 0) || factors[k] == tension_factor_max) continue;
    ++num_convex;
    num_tightened += factors[k] > 0 ? 1 : 0;
    const TensionSpline spline(arcs[k], factors[k]);
    const double sign = a > 0 ? 1 : -1;
    for (int i = 0; i <= 20; ++i)
      EXPECT_GE(sign * spline.second(i / 20.0),
                -1e-9 * std::max(std::abs(a), std::abs(b)));
  }
  EXPECT_GT(num_convex, 300);
  EXPECT_GT(num_tightened, 20);
  EXPECT_GE(surface.fit().num_tightened, num_tightened);
}

TEST(PlaneTension, IsTheTensionSplineAlongEveryArc) {
  const PlanePoints points = support::uniform_points(200, 5);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 6);
  const PlaneTensionSpline surface(t, values, random_gradients(200, 7, 10),
                                   with_shape(ArcShape::convex));
  const std::vector<double> factors = surface.tension_factors();
  const auto rows = tension_arcs(*t);
  const std::vector<HermiteArc> arcs = arcs_of(surface, points, values, *t);
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const Point2 a = points[at(rows[k][0])], b = points[at(rows[k][1])];
    for (const double part : {0.01, 0.3, 0.5, 0.9}) {
      const Point2 p{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
      const double v = surface.value(p);
      if (std::isnan(v)) continue;  // rounded to outside
      EXPECT_NEAR(v, TensionSpline(arcs[k], factors[k]).value(part), 1e-12);
    }
  }
}

/// Value and gradient of the triangles on both sides of an edge, at a place of the edge.
TEST(PlaneTension, GradientIsContinuousAcrossEdges) {
  for (const double factor : {0.0, 1.0, 30.0}) {
    PlanePoints points = support::uniform_points(150, 8);
    for (std::size_t i = 0; i < 150; i += 5)
      points.push_back({points[i].x + 0.002, points[i].y + 0.001});
    const auto t = triangulated(points);
    TensionSplineOptions options = with_shape(ArcShape::convex);
    options.factor = factor;
    std::vector<Point2> gradients;
    for (const Gradient2& g : random_gradients(180, 9, 3))
      gradients.push_back({g.x, g.y});
    const std::vector<double> values =
        values_at_sites(t->sites(), t->num_sites(), random_values(points.size(), 10));
    // Slivers with steep short edges among them.
    const ArcTensionCells<PlaneSpace> cells(
        PlaneCells(t, values, {}),
        ArcNetwork<PlaneSpace>(t, {}, values, gradients, options, {}), {});
    const Adjacency& a = t->adjacency();
    for (Site v = 0; v < t->num_sites(); ++v) {
      Arc arc = a.first_arc(v);
      for (std::int32_t i = 0; i < a.degree(v); ++i, arc = a.next(arc)) {
        if (!a.has_left(arc) || !a.has_left(a.reverse(arc))) continue;
        const Point2 p = t->points()[at(v)], q = t->points()[at(a.target(arc))];
        const double s = 0.05 + 0.9 * (i % 7) / 6.0;
        const PlaneSpace::Position<SecondOrder> on_edge{
            SecondOrder(p.x + s * (q.x - p.x), 1, 0),
            SecondOrder(p.y + s * (q.y - p.y), 0, 1)};
        const SecondOrder left = cells.facet(arc).derivatives(on_edge),
                          right = cells.facet(a.reverse(arc)).derivatives(on_edge);
        EXPECT_NEAR(left.value, right.value, 1e-12);
        const double steep = std::hypot(left.x, left.y) + 1;
        EXPECT_NEAR(left.x, right.x, 1e-7 * steep) << "edge of " << v;
        EXPECT_NEAR(left.y, right.y, 1e-7 * steep);
      }
    }
  }
}

TEST(PlaneTension, GradientNearsThatOfTheNodeFromEverySide) {
  const PlanePoints points = support::uniform_points(50, 11);
  const auto t = triangulated(points);
  const std::vector<Gradient2> gradients = random_gradients(50, 12, 2);
  TensionSplineOptions options;
  options.factor = 7;
  const PlaneTensionSpline surface(t, random_values(50, 13), gradients, options);
  for (std::size_t row = 0; row < points.size(); ++row) {
    EXPECT_EQ(surface.gradient(points[row]), gradients[row]);
    for (int k = 0; k < 12; ++k) {
      const double angle = 2 * std::numbers::pi * k / 12;
      for (const double distance : {1e-9, 1e-11}) {
        const Gradient2 g =
            surface.gradient({points[row].x + distance * std::cos(angle),
                              points[row].y + distance * std::sin(angle)});
        if (std::isnan(g.x)) continue;
        EXPECT_NEAR(g.x, gradients[row].x, 1e7 * distance + 1e-5);
        EXPECT_NEAR(g.y, gradients[row].y, 1e7 * distance + 1e-5);
      }
    }
  }
}

TEST(PlaneTension, DerivativesAreThoseOfTheSurface) {
  const PlanePoints points = support::uniform_points(200, 14);
  const auto t = triangulated(points);
  TensionSplineOptions options = with_shape(ArcShape::convex);
  options.factor = 1;
  const PlaneTensionSpline surface(t, sampled(points, support::franke), options);
  support::SplitMix64 random(15);
  const double h = 1e-6;
  int num_checked = 0;
  for (int i = 0; i < 200; ++i) {
    const Point2 p{random.between(0.1, 0.9), random.between(0.1, 0.9)};
    const Derivatives2 d = surface.derivatives(p);
    EXPECT_NEAR(d.value, surface.value(p), 1e-13);
    const auto slope = [&](double dx, double dy) {
      return (surface.value({p.x + dx, p.y + dy}) - surface.value({p.x - dx, p.y - dy})) /
             (2 * h);
    };
    EXPECT_NEAR(d.x, slope(h, 0), 1e-4);
    EXPECT_NEAR(d.y, slope(0, h), 1e-4);
    const Gradient2 east = surface.gradient({p.x + h, p.y}),
                    west = surface.gradient({p.x - h, p.y}),
                    north = surface.gradient({p.x, p.y + h}),
                    south = surface.gradient({p.x, p.y - h});
    // Second derivatives jump at edges; where the differences straddle none, they agree.
    const double size = std::abs(d.xx) + std::abs(d.xy) + std::abs(d.yy) + 1;
    num_checked += std::abs(d.xx - (east.x - west.x) / (2 * h)) < 1e-3 * size &&
                   std::abs(d.xy - (east.y - west.y) / (2 * h)) < 1e-3 * size &&
                   std::abs(d.yy - (north.y - south.y) / (2 * h)) < 1e-3 * size;
  }
  EXPECT_GT(num_checked, 190);
}

TEST(PlaneTension, SecondDerivativesAtANodeAreThoseTowardsTheMiddleOfATriangle) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}};
  const auto f = [](Point2 p) { return p.x * p.x + 3 * p.x * p.y - 2 * p.y * p.y; };
  const std::vector<Gradient2> gradients{{0, 0}, {2, 3}, {3, -4}};
  const PlaneTensionSpline surface(triangulated(points), sampled(points, f), gradients);
  for (const Point2 p : points) {
    const Derivatives2 d = surface.derivatives(p);
    EXPECT_NEAR(d.xx, 2, 1e-4);
    EXPECT_NEAR(d.xy, 3, 1e-4);
    EXPECT_NEAR(d.yy, -4, 1e-4);
  }
}

TEST(PlaneTension, ReproducesLinearFunctionsWithTensionAndQuadraticOnesWithout) {
  const PlanePoints points = support::uniform_points(300, 16);
  const auto t = triangulated(points);
  const auto linear = [](Point2 p) { return 3 - p.x + 2 * p.y; };
  const auto quadratic = [](Point2 p) { return p.x * p.x - 3 * p.x * p.y + p.y; };
  std::vector<Gradient2> constant(300, {-1, 2}), growing;
  for (const Point2 p : points) growing.push_back({2 * p.x - 3 * p.y, 1 - 3 * p.x});
  TensionSplineOptions tight;
  tight.factor = 20;
  tight.c1.outside = Outside::linear;
  const PlaneTensionSpline plane(t, sampled(points, linear), constant, tight),
      paraboloid(t, sampled(points, quadratic), growing);
  for (const Point2 p : points_of_the_hull(*t, 17)) {
    const double v = paraboloid.value(p);
    if (!std::isnan(v)) {
      EXPECT_NEAR(v, quadratic(p), 1e-13);
    }
    EXPECT_NEAR(plane.value(p), linear(p), 1e-13);
    EXPECT_NEAR(plane.value({3 * p.x - 1, 3 * p.y - 1}),
                linear({3 * p.x - 1, 3 * p.y - 1}), 1e-13);
    EXPECT_NEAR(plane.gradient(p).x, -1, 1e-8);
  }
}

double rms_error(int count, double factor) {
  const PlanePoints points = support::uniform_points(static_cast<std::size_t>(count), 18);
  TensionSplineOptions options;
  options.factor = factor;
  options.c1 = local_fits();
  const PlaneTensionSpline surface(triangulated(points), sampled(points, support::franke),
                                   options);
  support::SplitMix64 random(19);
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    const Point2 p{random.between(0.1, 0.9), random.between(0.1, 0.9)};
    sum += support::square(surface.value(p) - support::franke(p));
  }
  return std::sqrt(sum / 1000);
}

TEST(PlaneTension, ErrorFallsWithTheCubeOfSpacingWithoutTension) {
  EXPECT_GT(rms_error(500, 0) / rms_error(2000, 0), 8);
  EXPECT_GT(rms_error(500, 10) / rms_error(2000, 10), 3);
}

TEST(PlaneTension, NearsTheLinearSurfaceWithTension) {
  const PlanePoints points = support::uniform_points(150, 20);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, support::franke);
  const PlaneLinear linear(t, values);
  double last = infinity;
  for (const double factor : {0.0, 5.0, 20.0, 85.0}) {
    TensionSplineOptions options;
    options.factor = factor;
    options.c1 = local_fits();
    const PlaneTensionSpline surface(t, values, options);
    double largest = 0;
    for (const Point2 p : points_of_the_hull(*t, 21)) {
      const double difference = std::abs(surface.value(p) - linear.value(p));
      if (!std::isnan(difference)) largest = std::max(largest, difference);
    }
    EXPECT_LT(largest, last);
    last = largest;
  }
  EXPECT_LT(last, 0.02);
}

}  // namespace
}  // namespace delone::interp
