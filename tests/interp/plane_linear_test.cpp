#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "delaunay/error.hpp"
#include "interp/linear_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::is_same;
using support::PlanePoints;
using support::points_of_the_hull;
using support::random_values;
using support::sampled;
using support::triangulated;
using tripack::Point2;

constexpr double infinity = std::numeric_limits<double>::infinity();

class PlaneLinearOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneLinearOnSets, GivesNodesTheirValuesBitForBit) {
  const PlanePoints points = GetParam().make(400, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  const PlaneLinear surface(t, values);
  for (std::size_t row = 0; row < points.size(); ++row) {
    const double expected = merged[static_cast<std::size_t>(t->sites()[row])];
    EXPECT_TRUE(is_same(surface.value(points[row]), expected)) << "row " << row;
  }
}

TEST_P(PlaneLinearOnSets, IsFiniteAndWithinTheDataOnTheClosedHull) {
  const PlanePoints points = GetParam().make(300, 3);
  const auto t = triangulated(points);
  const PlaneLinear surface(t, random_values(points.size(), 4));
  for (const Point2 p : points_of_the_hull(*t, 5)) {
    const double v = surface.value(p);
    if (t->locate(p).kind == delaunay::Location::Kind::outside) {
      EXPECT_TRUE(std::isnan(v));  // the midpoint of a hull edge, rounded outwards
    } else {
      EXPECT_LE(std::abs(v), 1) << p.x << ' ' << p.y;
    }
  }
}

TEST_P(PlaneLinearOnSets, ValuesDoNotDependOnOrderOrThreads) {
  const PlanePoints points = GetParam().make(300, 6);
  const auto t = triangulated(points);
  const std::vector<double> values =
      sampled(points, [](Point2 p) { return std::sin(p.x) + std::cos(p.y); });
  const PlaneLinear surface(t, values);
  const PlanePoints queries = support::shuffled(points_of_the_hull(*t, 7), 8);
  const std::vector<double> expected =
      surface.values(queries, {.num_threads = 1, .progress = {}});
  for (std::size_t i = 0; i < queries.size(); i += 7) {
    EXPECT_TRUE(is_same(surface.value(queries[i]), expected[i])) << i;
  }
  EXPECT_EQ(support::first_difference(
                surface.values(queries, {.num_threads = 5, .progress = {}}), expected),
            queries.size());
  const PlanePoints other_rows = support::shuffled(points, 9);
  const PlaneLinear same(triangulated(other_rows), sampled(other_rows, [](Point2 p) {
                           return std::sin(p.x) + std::cos(p.y);
                         }));
  EXPECT_EQ(support::first_difference(same.values(queries), expected), queries.size());
}

TEST_P(PlaneLinearOnSets, ReproducesConstantsExactly) {
  const PlanePoints points = GetParam().make(300, 10);
  const auto t = triangulated(points);
  const std::vector<double> constant(points.size(), 0.1);
  const PlaneLinear surface(t, constant, {.outside = Outside::linear});
  for (const Point2 p : points_of_the_hull(*t, 11)) EXPECT_EQ(surface.value(p), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneLinearOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(PlaneLinear, ReproducesLinearFunctionsToRounding) {
  const PlanePoints points = support::uniform_points(2000, 1);
  const auto f = [](Point2 p) { return 3 * p.x - 5 * p.y + 1; };
  for (const Outside outside : {Outside::missing, Outside::linear}) {
    const PlaneLinear surface(triangulated(points), sampled(points, f),
                              {.outside = outside});
    support::SplitMix64 random(2);
    for (int i = 0; i < 5000; ++i) {
      const Point2 p{random.between(-1, 2), random.between(-1, 2)};
      const double v = surface.value(p);
      if (outside == Outside::missing && std::isnan(v)) continue;
      // Beyond the hull the slope of a thin hull triangle, found from rounded values, is
      // multiplied.
      EXPECT_NEAR(v, f(p), outside == Outside::linear ? 1e-9 : 1e-14);
      EXPECT_NEAR(surface.gradient(p).x, 3, 1e-9);
      EXPECT_NEAR(surface.gradient(p).y, -5, 1e-9);
    }
  }
}

// (0,0) - (3,-2) at 0.6, third corner (0, 0.008016): lost by a code with a tolerance
// (scipy issue 22831).
TEST(PlaneLinear, KeepsAPointOnTheEdgeOfANeedle) {
  const PlanePoints points{{0, 0}, {3, -2}, {0, 0.008016}};
  const PlaneLinear surface(triangulated(points), std::vector<double>{1, 2, 3},
                            {.outside = Outside::nearest});
  const Point2 on_edge{0.6 * 3, 0.6 * -2};
  EXPECT_TRUE(std::isfinite(surface.value(on_edge)));
  EXPECT_NEAR(surface.value(on_edge), 1.6, 0.4001);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(surface.value(points[i]), static_cast<double>(i + 1));
}

TEST(PlaneLinear, OnAnEdgeIsLinearBetweenItsEnds) {
  const PlanePoints points{{0, 0}, {3, -2}, {0, 1}, {3, 4}};
  const PlaneLinear surface(triangulated(points), std::vector<double>{1, 2, 30, -40});
  EXPECT_EQ(surface.value({1.5, -1}), 1.5);
  EXPECT_EQ(surface.value({0, 0.25}), 1 + 0.25 * 29);
}

double franke(Point2 p) {
  const double x = 9 * p.x, y = 9 * p.y;
  return 0.75 * std::exp(-((x - 2) * (x - 2) + (y - 2) * (y - 2)) / 4) +
         0.75 * std::exp(-(x + 1) * (x + 1) / 49 - (y + 1) / 10) +
         0.5 * std::exp(-((x - 7) * (x - 7) + (y - 3) * (y - 3)) / 4) -
         0.2 * std::exp(-(x - 4) * (x - 4) - (y - 7) * (y - 7));
}

// The hill of Renka's test programs.
double renka(Point2 p) { return (std::tanh(9 * p.y - 9 * p.x) + 1) / 9; }

double root_mean_square_error(double (*f)(Point2), std::size_t n) {
  const PlanePoints points = support::uniform_points(n, 5);
  const PlaneLinear surface(triangulated(points), sampled(points, f));
  const Field field =
      surface.grid(plane_grid({0.1, 0.9, 0.1, 0.9}, NodeCounts{101, 101}));
  const PlanePoints nodes = plane_nodes(field.grid);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    sum += std::pow(field.values[i] - f(nodes[i]), 2);
  return std::sqrt(sum / static_cast<double>(nodes.size()));
}

TEST(PlaneLinear, ErrorFallsWithTheSquareOfTheSpacing) {
  for (double (*f)(Point2) : {franke, renka}) {
    // 16 times the points: a quarter of the spacing, a sixteenth of the error.
    const double ratio =
        root_mean_square_error(f, 2000) / root_mean_square_error(f, 32000);
    EXPECT_GT(ratio, 13);
    EXPECT_LT(ratio, 20);
  }
}

TEST(PlaneLinear, OutsideIsMissingUnlessToldOtherwise) {
  const PlanePoints square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<double> values{1, 2, 3, 4};
  const PlaneLinear missing(triangulated(square), values);
  EXPECT_TRUE(std::isnan(missing.value({1.0000000000000002, 0.5})));
  EXPECT_TRUE(std::isnan(missing.gradient({2, 2}).x));
  const PlaneLinear nearest(triangulated(square), values, {.outside = Outside::nearest});
  EXPECT_EQ(nearest.value({1.5, 0.2}), 2);
  EXPECT_EQ(nearest.value({-3, 9}), 4);
  EXPECT_EQ(nearest.gradient({-3, 9}), (Gradient2{0, 0}));
}

TEST(PlaneLinear, LinearContinuationIsContinuous) {
  const PlanePoints points = support::uniform_points(60, 21);
  const PlaneLinear surface(triangulated(points), random_values(60, 22),
                            {.outside = Outside::linear});
  // Around the set on circles of growing radius, and across the hull: neighbouring values
  // differ by no more than a slope times the step.
  for (const double radius : {0.5, 0.75, 1.5, 5.0}) {
    const int steps = 200000;
    double largest_jump = 0, largest_slope = 0, last = 0;
    for (int i = 0; i <= steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps;
      const Point2 p{0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)};
      const double v = surface.value(p);
      ASSERT_TRUE(std::isfinite(v));
      const Gradient2 g = surface.gradient(p);
      largest_slope = std::max(largest_slope, std::hypot(g.x, g.y));
      if (i > 0) largest_jump = std::max(largest_jump, std::abs(v - last));
      last = v;
    }
    EXPECT_LT(largest_jump, 1.1 * largest_slope * 2 * std::numbers::pi * radius / steps)
        << radius;
  }
}

TEST(PlaneLinear, GradientOfTheContinuationAgreesWithDifferences) {
  const PlanePoints points = support::uniform_points(60, 31);
  const PlaneLinear surface(triangulated(points), random_values(60, 32),
                            {.outside = Outside::linear});
  support::SplitMix64 random(33);
  const double h = 1e-6;
  int agreeing = 0;
  for (int i = 0; i < 1000; ++i) {
    const Point2 p{random.between(-1, 2), random.between(-1, 2)};
    const Gradient2 g = surface.gradient(p);
    const double x =
        (surface.value({p.x + h, p.y}) - surface.value({p.x - h, p.y})) / (2 * h);
    const double y =
        (surface.value({p.x, p.y + h}) - surface.value({p.x, p.y - h})) / (2 * h);
    const double scale = 1 + std::hypot(g.x, g.y);
    agreeing += std::abs(g.x - x) < 1e-6 * scale && std::abs(g.y - y) < 1e-6 * scale;
  }
  EXPECT_GE(agreeing, 995);  // the rest lie within 1e-6 of a fold
}

TEST(PlaneLinear, GradientAtNodesAndEdgesIsThatOfOneTriangle) {
  const PlanePoints points{{0, 0}, {2, 0}, {0, 2}, {2, 2.5}};
  const PlaneLinear surface(triangulated(points), std::vector<double>{0, 2, 4, 100});
  for (const Point2 p :
       {Point2{0, 0}, Point2{1, 1}, Point2{2, 0}, Point2{0, 2}, Point2{0, 1}}) {
    const Gradient2 g = surface.gradient(p);
    EXPECT_TRUE(g == surface.gradient({0.5, 0.5}) || g == surface.gradient({1.5, 1.5}))
        << p.x << ' ' << p.y;
  }
  EXPECT_EQ(surface.gradient({0.5, 0.5}), (Gradient2{1, 2}));
  EXPECT_EQ(surface.gradients(PlanePoints{{0.5, 0.5}, {9, 9}})[0], (Gradient2{1, 2}));
}

TEST(PlaneLinear, CollinearPointsAreLinearAlongTheirChain) {
  const PlanePoints points{{4, 4}, {0, 0}, {1, 1}, {2, 2}};
  const std::vector<double> values{8, 0, 10, 20};
  const PlaneLinear surface(triangulated(points), values);
  EXPECT_EQ(surface.value({0.5, 0.5}), 5);
  EXPECT_EQ(surface.value({3, 3}), 14);
  EXPECT_EQ(surface.value({2, 2}), 20);
  EXPECT_TRUE(std::isnan(surface.value({0.5, 0.5000001})));
  EXPECT_TRUE(std::isnan(surface.value({5, 5})));
  EXPECT_EQ(surface.gradient({0.5, 0.5}), (Gradient2{5, 5}));
  const PlaneLinear continued(triangulated(points), values, {.outside = Outside::linear});
  EXPECT_DOUBLE_EQ(continued.value({6, 6}), -4);
  EXPECT_DOUBLE_EQ(continued.value({-1, -1}), -10);
  EXPECT_DOUBLE_EQ(continued.value({1, 0}), 5);
  EXPECT_EQ(continued.gradient({1, 0}), (Gradient2{5, 5}));
  const PlaneLinear nearest(triangulated(points), values, {.outside = Outside::nearest});
  EXPECT_EQ(nearest.value({9, 3}), 8);
}

TEST(PlaneLinear, OnePositionHasItsValueThere) {
  const PlanePoints points{{1, 2}, {1, 2}};
  const PlaneLinear surface(triangulated(points), std::vector<double>{3, 5});
  EXPECT_EQ(surface.value({1, 2}), 4);
  EXPECT_TRUE(std::isnan(surface.value({1, 3})));
  for (const Outside outside : {Outside::nearest, Outside::linear}) {
    EXPECT_EQ(
        PlaneLinear(triangulated(points), std::vector<double>{3, 5}, {.outside = outside})
            .value({7, 7}),
        4);
  }
}

TEST(PlaneLinear, NoPointsAreMissingEverywhere) {
  for (const Outside outside : {Outside::missing, Outside::nearest, Outside::linear}) {
    const PlaneLinear surface(triangulated(PlanePoints{}), {}, {.outside = outside});
    EXPECT_TRUE(std::isnan(surface.value({0, 0})));
    EXPECT_TRUE(std::isnan(surface.gradient({0, 0}).x));
    EXPECT_EQ(support::count_missing(
                  surface.grid(plane_grid({0, 1, 0, 1}, Spacing{1, 1})).values),
              4u);
  }
}

TEST(PlaneLinear, QueriesThatAreNotNumbersAreMissing) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}};
  const PlaneLinear surface(triangulated(points), std::vector<double>{1, 2, 3},
                            {.outside = Outside::linear});
  const PlanePoints queries{{std::nan(""), 0}, {0, infinity}, {0, 0}};
  const std::vector<double> values = surface.values(queries);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_EQ(values[2], 1);
}

TEST(PlaneLinear, StaysFiniteAtTheEndsOfTheRangeOfDoubles) {
  const double large = std::numeric_limits<double>::max(),
               tiny = std::numeric_limits<double>::denorm_min();
  const std::array<PlanePoints, 3> sets{
      PlanePoints{{-large, -large}, {large, -large}, {0, large}, {0, 0}},
      PlanePoints{{0, 0}, {4 * tiny, 0}, {0, 4 * tiny}},
      PlanePoints{{0, 0}, {4 * tiny, 0}, {0, 4 * tiny}, {large, large}}};
  for (const PlanePoints& points : sets) {
    const auto t = triangulated(points);
    const PlaneLinear surface(t, random_values(points.size(), 1));
    for (const Point2 p : points_of_the_hull(*t, 2)) {
      if (t->locate(p).kind == delaunay::Location::Kind::outside) continue;
      EXPECT_LE(std::abs(surface.value(p)), 1) << p.x << ' ' << p.y;
    }
  }
  const PlaneLinear surface(triangulated(sets[1]), std::vector<double>{0, 4, 8});
  EXPECT_EQ(surface.value({tiny, 2 * tiny}), 5);
}

TEST(PlaneLinear, RefusesBadInput) {
  const PlanePoints points{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_THROW(PlaneLinear(triangulated(points), std::vector<double>{1, 2}), Error);
  EXPECT_THROW(PlaneLinear(triangulated(points), std::vector<double>{1, 2, std::nan("")}),
               Error);
  const std::vector<double> values{1, 2, 3};
  EXPECT_THROW(PlaneLinear(triangulated(points), values, {.max_distance = -1}), Error);
  EXPECT_THROW(PlaneLinear(triangulated(points), values, {.max_distance = std::nan("")}),
               Error);
}

TEST(PlaneLinear, CanBeCancelled) {
  const PlanePoints points = support::uniform_points(100, 1);
  const PlaneLinear surface(triangulated(points), random_values(100, 2));
  const RunOptions stop{.num_threads = 2, .progress = [](double) { return false; }};
  EXPECT_THROW((void)surface.grid(plane_grid({0, 1, 0, 1}, NodeCounts{50, 50}), stop),
               Cancelled);
  EXPECT_THROW((void)surface.values(support::uniform_points(20000, 3), stop), Cancelled);
}

TEST(PlaneLinear, ReportsProgressThatGrowsToOne) {
  const PlanePoints points = support::uniform_points(100, 1);
  const PlaneLinear surface(triangulated(points), random_values(100, 2));
  std::vector<double> reported;
  const RunOptions run{.num_threads = 1, .progress = [&](double part) {
                         reported.push_back(part);
                         return true;
                       }};
  (void)surface.values(support::uniform_points(20000, 3), run);
  ASSERT_GT(reported.size(), 2u);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), 1);
}

}  // namespace
}  // namespace delone::interp
