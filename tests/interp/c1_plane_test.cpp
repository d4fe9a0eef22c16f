#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/blend_cells.hpp"
#include "interp/c1_surface.hpp"
#include "interp/surfaces.hpp"
#include "interp/test_functions.hpp"

namespace delone::interp {
namespace {

using support::is_same;
using support::PlanePoints;
using support::points_of_the_hull;
using support::random_values;
using support::sampled;
using support::triangulated;
using tripack::Point2;

RunOptions threads(int count) { return {.num_threads = count, .progress = {}}; }

class PlaneC1OnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneC1OnSets, GivesNodesTheirValuesBitForBit) {
  const PlanePoints points = GetParam().make(300, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  const PlaneC1 surface(t, values);
  for (std::size_t row = 0; row < points.size(); ++row) {
    EXPECT_TRUE(is_same(surface.value(points[row]), merged[at(t->sites()[row])]))
        << "row " << row;
  }
}

TEST_P(PlaneC1OnSets, IsFiniteAndWithinTheWidenedRangeOnTheClosedHull) {
  const PlanePoints points = GetParam().make(250, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  if (merged.empty()) return;
  const auto [least, most] = std::ranges::minmax_element(merged);
  const double wider = 0.25 * (*most - *least) + 1e-12;
  const PlaneC1 surface(t, values, {.tension = 0});
  const PlanePoints queries = points_of_the_hull(*t, 5);
  const std::vector<double> found = surface.values(queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (t->find(queries[i]) != Arc{} && !t->adjacency().has_left(t->find(queries[i])))
      continue;  // rounded to outside
    if (t->dimension() < 2 && std::isnan(found[i])) continue;
    EXPECT_TRUE(found[i] >= *least - wider && found[i] <= *most + wider)
        << found[i] << " at " << queries[i].x << " " << queries[i].y;
  }
}

TEST_P(PlaneC1OnSets, StaysAmongTheValuesAroundATriangleWithLocalBounds) {
  const PlanePoints points = GetParam().make(200, 6);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 7);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  C1Options options;
  options.tension = 0;
  options.bounds = Bounds::local;
  const PlaneC1 surface(t, values, options);
  support::SplitMix64 random(8);
  t->adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto corners = t->adjacency().left(arc);
    double least = 2, most = -2;
    for (const Site s : corners) {
      least = std::min(least, merged[at(s)]), most = std::max(most, merged[at(s)]);
      for (const Site w : t->adjacency().neighbors(s)) {
        least = std::min(least, merged[at(w)]), most = std::max(most, merged[at(w)]);
      }
    }
    const double s = random.uniform(), u = random.uniform() * (1 - s);
    const Point2 a = t->points()[at(corners[0])], b = t->points()[at(corners[1])],
                 c = t->points()[at(corners[2])];
    const Point2 p{a.x + s * (b.x - a.x) + u * (c.x - a.x),
                   a.y + s * (b.y - a.y) + u * (c.y - a.y)};
    const double found = surface.value(p);
    if (std::isnan(found) || !t->adjacency().has_left(t->find(p))) return;
    if (smallest_first(t->adjacency().left(t->find(p))) != smallest_first(corners))
      return;
    EXPECT_TRUE(found >= least - 1e-14 && found <= most + 1e-14) << found;
  });
}

TEST_P(PlaneC1OnSets, GivesTheSameBitsHoweverItIsAsked) {
  const PlanePoints points = GetParam().make(200, 9);
  const auto t = triangulated(points);
  if (t->num_sites() < 3) return;
  const std::vector<double> values = random_values(points.size(), 10);
  const PlaneC1 surface(t, values, {}, threads(1)), other(t, values, {}, threads(3));
  const Grid grid = plane_grid(support::region_of(*t), NodeCounts{37, 23});
  const Field field = surface.grid(grid, threads(1));
  EXPECT_EQ(support::first_difference(field.values, other.grid(grid, threads(3)).values),
            field.values.size());
  const PlanePoints nodes = plane_nodes(grid);
  const std::vector<double> found = surface.values(nodes);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    EXPECT_TRUE(is_same(found[k], surface.value(nodes[k])));
    EXPECT_TRUE(is_same(found[k], field.values[k]))
        << k << ": " << found[k] << " " << field.values[k];
  }
}

TEST_P(PlaneC1OnSets, DoesNotDependOnTheOrderOfRows) {
  const PlanePoints points = GetParam().make(150, 11);
  const auto t = triangulated(points);
  const std::vector<double> values =
      sampled(points, [](Point2 p) { return std::cos(p.x) + std::sin(p.y); });
  const PlanePoints reversed(points.rbegin(), points.rend());
  const std::vector<double> reversed_values(values.rbegin(), values.rend());
  const PlanePoints queries = points_of_the_hull(*t, 12);
  const std::vector<double> found = PlaneC1(t, values).values(queries);
  const std::vector<double> again =
      PlaneC1(triangulated(reversed), reversed_values).values(queries);
  EXPECT_EQ(support::first_difference(found, again), found.size());
}

TEST_P(PlaneC1OnSets, ReproducesConstantsExactly) {
  const PlanePoints points = GetParam().make(100, 13);
  const auto t = triangulated(points);
  const PlaneC1 surface(t, std::vector<double>(points.size(), 0.1));
  for (const double v : surface.values(points_of_the_hull(*t, 14)))
    EXPECT_TRUE(v == 0.1 || std::isnan(v)) << v;
}

INSTANTIATE_TEST_SUITE_P(AllSets, PlaneC1OnSets,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& param_info) {
                           return std::string(param_info.param.name);
                         });

// Value and gradient of the triangles on both sides of an edge, at a point of the edge.
template <int Degree>
void expect_smooth_edges(const PlanePoints& points, std::span<const double> values,
                         double tension) {
  const auto t = triangulated(points);
  C1Options options;
  options.tension = tension;
  const BlendCells<PlaneSpace, Degree> cells(
      t, values_at_sites(t->sites(), t->num_sites(), values), options, {});
  const Adjacency& a = t->adjacency();
  for (Site v = 0; v < t->num_sites(); ++v) {
    Arc arc = a.first_arc(v);
    for (std::int32_t i = 0; i < a.degree(v); ++i, arc = a.next(arc)) {
      if (!a.has_left(arc) || !a.has_left(a.reverse(arc))) continue;
      const Point2 p = t->points()[at(v)], q = t->points()[at(a.target(arc))];
      const double s = 0.1 + 0.8 * (i % 7) / 6.0;
      const PlaneSpace::Position<SecondOrder> on_edge{
          SecondOrder(p.x + s * (q.x - p.x), 1, 0),
          SecondOrder(p.y + s * (q.y - p.y), 0, 1)};
      const SecondOrder left = cells.facet(arc)(on_edge),
                        right = cells.facet(a.reverse(arc))(on_edge);
      EXPECT_NEAR(left.value, right.value, 1e-12);
      const double steep = std::hypot(left.x, left.y) + 1;
      EXPECT_NEAR(left.x, right.x, 1e-7 * steep) << "edge of " << v;
      EXPECT_NEAR(left.y, right.y, 1e-7 * steep);
    }
  }
}

TEST(PlaneC1, GradientIsContinuousAcrossEdges) {
  const PlanePoints uniform = support::uniform_points(500, 1);
  expect_smooth_edges<3>(uniform, sampled(uniform, support::franke), 0);
  expect_smooth_edges<4>(uniform, sampled(uniform, support::franke), 0);
  expect_smooth_edges<3>(uniform, random_values(uniform.size(), 2), 0);
  expect_smooth_edges<3>(uniform, random_values(uniform.size(), 2), 0.7);
  const PlanePoints clusters = support::clustered_points(500, 3);
  expect_smooth_edges<3>(clusters, random_values(clusters.size(), 4), 0.3);
}

TEST(PlaneC1, DerivativesAreThoseOfTheSurface) {
  const PlanePoints points = support::uniform_points(300, 5);
  const PlaneC1 surface(triangulated(points), sampled(points, support::franke),
                        {.tension = 0.2});
  support::SplitMix64 random(6);
  const double h = 1e-6;
  int num_checked = 0;
  for (int i = 0; i < 300; ++i) {
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
  EXPECT_GT(num_checked, 285);
}

// Root mean square error over points of the inner square.
double rms_error(const PlanePoints& points, const C1Options& options) {
  const PlaneC1 surface(triangulated(points), sampled(points, support::franke), options);
  support::SplitMix64 random(7);
  double sum = 0;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i) {
    const Point2 p{random.between(0.1, 0.9), random.between(0.1, 0.9)};
    sum += support::square(surface.value(p) - support::franke(p));
  }
  return std::sqrt(sum / count);
}

TEST(PlaneC1, ErrorFallsWithTheFourthPowerOfSpacing) {
  const double coarse = rms_error(support::uniform_points(10000, 8), {}),
               fine = rms_error(support::uniform_points(40000, 9), {});
  EXPECT_GT(coarse / fine, 16);  // half the spacing
}

TEST(PlaneC1, QuarticFitsAreMoreAccurateOnSmoothData) {
  const PlanePoints points = support::uniform_points(10000, 10);
  C1Options quartic;
  quartic.degree = FitDegree::quartic;
  EXPECT_LT(rms_error(points, quartic), rms_error(points, {}) / 3);
}

// Where some nodes at the hull are predicted by nothing: they lie far from the lines
// between the corners of the square, along which their triangles are needles.
TEST(PlaneC1, NodesAtTheHullChooseForNoOthers) {
  PlanePoints points = support::uniform_points(9996, 12);
  for (const double x : {0.0, 1.0}) points.insert(points.end(), {{x, 0}, {x, 1}});
  C1Options quartic;
  quartic.degree = FitDegree::quartic;
  EXPECT_LT(rms_error(points, quartic), 4e-7);
  EXPECT_LT(rms_error(points, {}), 2e-6);
}

TEST(PlaneC1, ReproducesQuadraticFunctions) {
  const auto quadratic = [](Point2 p) {
    return 3 - p.x + 2 * p.y + p.x * p.x - 3 * p.x * p.y + 0.5 * p.y * p.y;
  };
  const PlanePoints points = support::uniform_points(400, 11);
  const PlaneC1 surface(triangulated(points), sampled(points, quadratic));
  const auto t = triangulated(points);
  for (const Point2 p : points_of_the_hull(*t, 12)) {
    const double v = surface.value(p);
    // Near the hull polynomials are kept near the range of the data.
    if (std::max(std::abs(p.x - 0.5), std::abs(p.y - 0.5)) > 0.35) continue;
    EXPECT_NEAR(v, quadratic(p), 1e-9);
  }
}

TEST(PlaneC1, IsAsAccurateWhenMovedAndScaled) {
  const PlanePoints points = support::uniform_points(2000, 13);
  const std::vector<double> values = sampled(points, support::franke);
  const PlaneC1 surface(triangulated(points), values);
  for (const auto& [scale, shift] :
       {std::pair{1.0, 1e7}, std::pair{1e-6, 0.0}, std::pair{1e6, 0.0},
        std::pair{1e200, 0.0}, std::pair{1e-250, 0.0}}) {
    PlanePoints moved = points;
    for (Point2& p : moved) p = {p.x * scale + shift, p.y * scale + shift};
    const PlaneC1 other(triangulated(moved), values);
    support::SplitMix64 random(14);
    for (int i = 0; i < 200; ++i) {
      const Point2 p{random.between(0.1, 0.9), random.between(0.1, 0.9)};
      EXPECT_NEAR(other.value({p.x * scale + shift, p.y * scale + shift}),
                  surface.value(p), shift == 0 ? 1e-10 : 1e-6)
          << scale << " " << shift;
    }
  }
}

TEST(PlaneC1, ContinuesSmoothlyBeyondTheHullAndStaysInBounds) {
  const PlanePoints points = support::uniform_points(60, 21);
  C1Options options;
  options.outside = Outside::linear;
  options.tension = 0;
  const std::vector<double> values = sampled(points, support::franke);
  const PlaneC1 surface(triangulated(points), values, options);
  const auto [least, most] = std::ranges::minmax_element(values);
  const double wider = 0.25 * (*most - *least);
  const auto at_radius = [](double angle, double r) {
    return Point2{0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)};
  };
  const auto jump = [&](Point2 p, Point2 q) {
    const Gradient2 g = surface.gradient(p), h = surface.gradient(q);
    return std::hypot(g.x - h.x, g.y - h.y);
  };
  for (int k = 0; k < 40; ++k) {  // rays from the middle far out
    const double angle = 2 * std::numbers::pi * k / 40;
    for (int i = 0; i < 1000; ++i) {
      double near = 0.002 * i, far = 0.002 * (i + 1);
      const double v = surface.value(at_radius(angle, near));
      EXPECT_TRUE(v >= *least - wider && v <= *most + wider);
      // Of an interval the half in which the gradient changes more, again and again.
      for (int halving = 0; halving < 25; ++halving) {
        const double middle = 0.5 * (near + far);
        const bool is_nearer = jump(at_radius(angle, near), at_radius(angle, middle)) >
                               jump(at_radius(angle, middle), at_radius(angle, far));
        (is_nearer ? far : near) = middle;
      }
      EXPECT_LT(jump(at_radius(angle, near), at_radius(angle, far)), 1e-2)
          << angle << " " << near;
    }
  }
}

TEST(PlaneC1, FewPointsHaveAValue) {
  const PlanePoints three{{0, 0}, {1, 0}, {0, 1}};
  const PlaneC1 plane(triangulated(three), std::vector<double>{1, 2, 4});
  EXPECT_NEAR(plane.value({0.25, 0.25}), 2, 0.3);
  EXPECT_TRUE(std::isnan(plane.value({1, 1})));
  const PlaneC1 two(triangulated(PlanePoints{{0, 0}, {1, 0}}), std::vector<double>{1, 2});
  EXPECT_EQ(two.value({0.5, 0}), 1.5);
  const PlaneC1 one(triangulated(PlanePoints{{3, 4}}), std::vector<double>{7});
  EXPECT_EQ(one.value({3, 4}), 7);
  const PlaneC1 nothing(triangulated(PlanePoints{}), std::vector<double>{});
  EXPECT_TRUE(std::isnan(nothing.value({0, 0})));
}

TEST(PlaneC1, QueriesThatAreNotFiniteAreMissingAndNoQueriesGiveNoValues) {
  const PlanePoints points = support::uniform_points(20, 15);
  const PlaneC1 surface(triangulated(points), sampled(points, support::franke));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(surface.value({nan, 0})));
  EXPECT_TRUE(std::isnan(surface.derivatives({0, nan}).xx));
  EXPECT_TRUE(surface.values({}).empty());
}

TEST(PlaneC1, RefusesWhatItCannotUse) {
  const PlanePoints points = support::uniform_points(10, 16);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, support::franke);
  EXPECT_THROW(PlaneC1(t, std::vector<double>{1, 2}), Error);
  EXPECT_THROW(PlaneC1(t, values, {.tension = -0.1}), Error);
  EXPECT_THROW(PlaneC1(t, values, {.tension = 1.5}), Error);
  std::vector<double> bad = values;
  bad[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(PlaneC1(t, bad), Error);
}

TEST(PlaneC1, FallsBackToLinearInNoiseAndSaysSo) {
  const PlanePoints points = support::uniform_points(1500, 17);
  const PlaneC1 noise(triangulated(points), random_values(points.size(), 18));
  EXPECT_GE(noise.fit().tension, 0.8);
  EXPECT_LE(noise.fit().left_out_rms, 1.01 * noise.fit().linear_left_out_rms);
  const PlaneC1 smooth(triangulated(points), sampled(points, support::franke));
  EXPECT_EQ(smooth.fit().tension, 0);
  EXPECT_GT(smooth.fit().num_tested, 100);
}

}  // namespace
}  // namespace delone::interp
