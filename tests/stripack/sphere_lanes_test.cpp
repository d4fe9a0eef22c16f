#include "stripack/sphere_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "delaunay/instruction_set.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/twofold_signs.hpp"

namespace delone::stripack {
namespace {

using Lanes = SphereLanes<delaunay::Portable>;

support::TwofoldSigns twofold_signs(const std::vector<Direction>& p) {
  return support::twofold_signs(Lanes({p.data()}));
}

// Four directions of one small circle, rounded.
std::vector<Direction> circle_of(support::SplitMix64& random) {
  const double radius = std::ldexp(1.0, -static_cast<int>(random.below(36)));
  const double lon = random.between(0, 6.28), z = random.between(-1, 1);
  const double r = std::sqrt(1 - z * z);
  const double axis[3] = {r * std::cos(lon), r * std::sin(lon), z};
  const double east[3] = {-std::sin(lon), std::cos(lon), 0};
  const double north[3] = {-z * std::cos(lon), -z * std::sin(lon), r};
  std::vector<Direction> p;
  for (int k = 0; k < 4; ++k) {
    const double turn = random.between(0, 6.28);
    double v[3];
    for (int i = 0; i < 3; ++i) {
      v[i] = std::cos(radius) * axis[i] +
             std::sin(radius) * (std::cos(turn) * east[i] + std::sin(turn) * north[i]);
    }
    p.push_back(Direction::from(v[0], v[1], v[2]));
  }
  return p;
}

TEST(SphereLanes, AreCertainWithTwiceThePrecisionNearCircles) {
  support::SplitMix64 random(6);
  int num_certain = 0;
  constexpr int num_sets = 4000;
  for (int i = 0; i < num_sets; ++i) {
    const std::vector<Direction> p = circle_of(random);
    const support::TwofoldSigns signs = twofold_signs(p);
    ASSERT_EQ(signs.turn, support::exact_orientation(p[0], p[1], p[2])) << i;
    if (signs.circle == 0) continue;
    ++num_certain;
    ASSERT_EQ(signs.circle, support::exact_in_circle(p[0], p[1], p[2], p[3])) << i;
  }
  EXPECT_GT(num_certain, num_sets * 99 / 100);
}

TEST(SphereLanes, AreCertainWithTwiceThePrecisionNearGreatCircles) {
  support::SplitMix64 random(7);
  for (int i = 0; i < 4000; ++i) {
    const double lon = random.between(0, 360);
    std::vector<Direction> p;
    for (int k = 0; k < 4; ++k)
      p.push_back(Direction::from(LonLat{lon, random.between(-89, 89)}));
    const int turn = twofold_signs(p).turn;
    if (turn != 0) {
      ASSERT_EQ(turn, support::exact_orientation(p[0], p[1], p[2])) << i;
    }
  }
}

TEST(SphereLanes, LeaveExactTiesOpen) {
  const auto p = [](double x, double y, double z) { return Direction::from(x, y, z); };
  EXPECT_EQ(twofold_signs({p(1, 1, 1), p(-1, 1, 1), p(-1, -1, 1), p(1, -1, 1)}).circle,
            0);
  EXPECT_EQ(twofold_signs({p(1, 0, 0), p(0, 1, 0), p(-1, 0, 0), p(0, 0, 1)}).turn, 0);
}

}  // namespace
}  // namespace delone::stripack
