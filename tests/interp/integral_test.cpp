#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "interp/c1_surface.hpp"
#include "interp/linear_surface.hpp"
#include "interp/surfaces.hpp"
#include "interp/test_functions.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::PlanePoints;
using support::sampled;
using support::SpherePoints;
using support::triangulated;
using tripack::Point2;

constexpr double sphere_area = 4 * std::numbers::pi;

// The unit square's corners and points inside.
PlanePoints points_of_the_square(std::size_t n, std::uint64_t seed) {
  PlanePoints points = support::uniform_points(n, seed);
  for (const Point2 corner : {Point2{0, 0}, Point2{1, 0}, Point2{0, 1}, Point2{1, 1}})
    points.push_back(corner);
  return points;
}

TEST(Integral, OfLinearFunctionsIsExactWhateverTheUnits) {
  for (const double unit : {1.0, 1e-6, 1e150}) {
    PlanePoints points = points_of_the_square(200, 1);
    const std::vector<double> values =
        sampled(points, [](Point2 p) { return 1 + 2 * p.x - p.y; });
    for (Point2& p : points) p = {p.x * unit, p.y * unit};
    const PlaneLinear surface(triangulated(points), values);
    EXPECT_NEAR(surface.integral() / unit / unit, 1.5, 1e-13) << unit;
  }
}

TEST(Integral, OfASmoothSurfaceIsTheMeanOfItsValues) {
  const PlanePoints points = points_of_the_square(300, 2);
  const PlaneC1 surface(triangulated(points),
                        sampled(points, [](Point2 p) { return p.x * p.x - p.x * p.y; }));
  // The midpoint rule, with cells whose middles are the nodes.
  constexpr std::int64_t n = 400;
  constexpr double half = 0.5 / n;
  const Field field =
      surface.grid(plane_grid({half, 1 - half, half, 1 - half}, NodeCounts{n, n}));
  double sum = 0;
  for (const double v : field.values) sum += v;
  EXPECT_NEAR(surface.integral(), sum / (n * n), 1e-6);
  EXPECT_NEAR(surface.integral(), 1.0 / 3 - 0.25, 1e-6);
  EXPECT_EQ(surface.integral({.num_threads = 1, .progress = {}}),
            surface.integral({.num_threads = 3, .progress = {}}));
}

TEST(Integral, ComesNearThatOfTheFunctionWithTheFourthPowerOfSpacing) {
  const auto wave = [](Point2 p) { return std::sin(4 * p.x) * std::cos(3 * p.y); };
  const double exact = (1 - std::cos(4.0)) / 4 * std::sin(3.0) / 3;
  double before = 0;
  for (const int n : {10, 20, 40}) {
    PlanePoints points;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) points.push_back({i * 1.0 / n, j * 1.0 / n});
    const PlaneC1 surface(triangulated(points), sampled(points, wave));
    const double error = std::abs(surface.integral() - exact);
    EXPECT_TRUE(before == 0 || error < before / 8) << n << ": " << error;
    before = error;
  }
  EXPECT_LT(before, 1e-6);
}

TEST(Integral, OverTheWholeSphereIsTheMeanTimesItsArea) {
  const SpherePoints points = support::uniform_directions(400, 3);
  const auto t = triangulated(points);
  const SphereLinear constant(t, std::vector<double>(points.size(), 2));
  EXPECT_NEAR(constant.integral(), 2 * sphere_area, 1e-11);
  const SphereC1 harmonic(
      t, sampled(points, [](const Direction& p) { return 1 + p.x() - 2 * p.z(); }));
  EXPECT_NEAR(harmonic.integral(), sphere_area, 1e-9);
}

TEST(Integral, OverWideTrianglesIsTheirSolidAngle) {
  const SpherePoints octant{Direction::from(1, 0, 0), Direction::from(0, 1, 0),
                            Direction::from(0, 0, 1)};
  const SphereLinear surface(triangulated(octant), std::vector<double>(3, 1));
  EXPECT_NEAR(surface.integral(), sphere_area / 8, 1e-12);
}

TEST(Integral, IsZeroWithoutTriangles) {
  const PlanePoints line{{0, 0}, {1, 0}, {2, 0}};
  EXPECT_EQ(PlaneLinear(triangulated(line), std::vector<double>{1, 2, 3}).integral(), 0);
  EXPECT_EQ(PlaneC1(triangulated(PlanePoints{}), std::vector<double>{}).integral(), 0);
}

}  // namespace
}  // namespace delone::interp
