// Sites whose distances are subnormal numbers, which only exist beside the axes.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "stripack/voronoi.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::SpherePoints;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Some on the axes up to `reach` smallest doubles beside them, some anywhere.
SpherePoints beside_axes(std::size_t n, std::uint64_t seed, double unit, int reach) {
  support::SplitMix64 random(seed);
  const auto steps = [&] {
    return static_cast<int>(random.below(static_cast<std::uint64_t>(2 * reach + 1))) -
           reach;
  };
  SpherePoints points;
  while (points.size() < n) {
    std::array<double, 3> v{unit * steps(), unit * steps(), unit * steps()};
    v[random.below(3)] = (random.below(2) == 0 ? 1 : -1) *
                         (1 + static_cast<double>(steps() % 2) * 0x1p-52);
    if (random.below(4) == 0)
      for (double& c : v) c = random.between(-1, 1);
    points.push_back(Direction::from(v[0], v[1], v[2]));
  }
  return points;
}

// All on one axis, with a neighbour somewhere else at most.
SpherePoints on_one_axis(std::size_t n, std::uint64_t seed, double unit) {
  support::SplitMix64 random(seed);
  SpherePoints points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(Direction::from(1, unit * static_cast<double>(random.below(9)),
                                     unit * static_cast<double>(random.below(9))));
  if (seed % 2 == 0) points.push_back(Direction::from(-0.3, 0.5, 0.7));
  return points;
}

// Points of a great circle through no axis but one.
SpherePoints beside_a_circle(std::size_t n, std::uint64_t seed, double unit) {
  support::SplitMix64 random(seed);
  SpherePoints points;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = unit * (static_cast<double>(random.below(9)) - 4);
    points.push_back(random.below(2) == 0 ? Direction::from(0.6, 0.8, z)
                                          : Direction::from(-0.28, 0.96, z));
  }
  return points;
}

void check(const SpherePoints& points) {
  const auto t = std::make_shared<const Triangulation>(points);
  const std::vector<CellMeasure> cells = voronoi_measures(*t);
  const std::vector<double> areas = voronoi_areas(*t);
  double sum = 0;
  for (Site s = 0; s < t->num_sites(); ++s) {
    EXPECT_EQ(areas[at(s)], cells[at(s)].area);
    EXPECT_GE(areas[at(s)], 0);
    sum += areas[at(s)];
  }
  EXPECT_NEAR(sum / (4 * std::numbers::pi), 1, 1e-13);
  const Voronoi v(t);
  for (Site s = 0; s < t->num_sites(); ++s) {
    for (const std::int32_t k : v.cell(s)) {
      const Direction& c = v.vertices()[at(k)];
      double nearest = 4;
      for (const Direction& p : t->points()) nearest = std::min(nearest, angle(c, p));
      EXPECT_NEAR(angle(c, t->points()[at(s)]), nearest, 4e-15) << s;
    }
  }
}

TEST(SubnormalVoronoi, CellsBesideTheAxesFillTheSphere) {
  for (const double unit : {0x1p-1074, 0x1p-1040, 0x1p-1022, 0x1p-950, 0x1p-500, 0x1p-300,
                            0x1p-90, 0x1p-60}) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      SCOPED_TRACE(std::to_string(unit) + " " + std::to_string(seed));
      check(beside_axes(5 + seed % 20, seed, unit, 3));
      check(on_one_axis(12, seed, unit));
      check(beside_a_circle(12, seed, unit));
      if (HasFailure()) return;
    }
  }
}

// Four around the first at the smallest distances: its cell is their square, and theirs
// are quarters of the sphere, but for the far ones.
TEST(SubnormalVoronoi, FourNeighborsAtTheSmallestDistanceShareTheSphere) {
  constexpr double d = 0x1p-1074;
  const Triangulation t(SpherePoints{Direction::from(1, 0, 0), Direction::from(1, d, 0),
                                     Direction::from(1, 0, d), Direction::from(1, -d, 0),
                                     Direction::from(1, 0, -d)});
  const std::vector<double> areas = voronoi_areas(t);
  EXPECT_EQ(areas[at(t.sites()[0])], 0);
  for (Node row = 1; row < 5; ++row)
    EXPECT_NEAR(areas[at(t.sites()[at(row)])], std::numbers::pi, 1e-14);
}

}  // namespace
}  // namespace delone::stripack
