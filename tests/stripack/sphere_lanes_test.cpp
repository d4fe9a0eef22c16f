#include "stripack/sphere_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "delaunay/instruction_set.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace delone::stripack {
namespace {

using delaunay::Double4;
using Lanes = SphereLanes<delaunay::Portable>;

int sign_beyond(double value, double error) {
  return static_cast<int>(value > error) - static_cast<int>(value < -error);
}

// Base 0 -> 1 and the candidates 2 and 3, in numbers of twice the precision.
struct Signs {
  int turn, circle;
};
Signs twofold_signs(const std::vector<Direction>& p) {
  const Lanes g({p.data()});
  const std::int32_t s[4] = {2, 3, 2, 3};
  const auto a = g.corner(0), b = g.corner(1), x = g.corners(s);
  const auto lanes = Lanes::twofold_lanes(a, b, x);
  const Double4 size = g.sizes(0, 1, Lanes::lanes(a, b, x));
  using Arithmetic = Lanes::Arithmetic;
  const auto lane = [](const delaunay::Twofold4& v, int i) {
    return delaunay::Twofold4{delaunay::four(v.high[i]), delaunay::four(v.low[i])};
  };
  const auto det = Arithmetic::difference(
      Arithmetic::product(lane(lanes.dot, 0), lane(lanes.cross, 1)),
      Arithmetic::product(lane(lanes.dot, 1), lane(lanes.cross, 0)));
  const Double4 error =
      g.twofold_circle_error(delaunay::four(size[0]), delaunay::four(size[1]));
  return {sign_beyond(lanes.cross.rounded()[0], g.twofold_cross_error(size)[0]),
          sign_beyond(det.rounded()[0], error[0])};
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
    const Signs signs = twofold_signs(p);
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
