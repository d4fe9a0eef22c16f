#include "tripack/plane_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "delaunay/instruction_set.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace delone::tripack {
namespace {

using delaunay::Double4;
using Lanes = PlaneLanes<delaunay::Portable>;

int sign_beyond(double value, double error) {
  return static_cast<int>(value > error) - static_cast<int>(value < -error);
}

// Base 0 -> 1 and the candidates 2 and 3, in numbers of twice the precision.
struct Signs {
  int turn, circle;
};
Signs twofold_signs(const std::vector<Point2>& p) {
  const Lanes g({p.data(), 0, 0});
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

TEST(PlaneLanes, AreCertainWithTwiceThePrecisionNearCirclesAndLines) {
  support::SplitMix64 random(5);
  int num_certain = 0;
  constexpr int num_sets = 4000;
  for (int i = 0; i < num_sets; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(400)) - 200);
    const double x = random.between(-1, 1) * 100, y = random.between(-1, 1) * 100;
    std::vector<Point2> p;
    for (int k = 0; k < 4; ++k) {
      const double turn = random.between(0, 6.28);
      p.push_back({scale * (x + std::cos(turn)), scale * (y + std::sin(turn))});
    }
    const Signs signs = twofold_signs(p);
    ASSERT_EQ(signs.turn, support::exact_orientation(p[0], p[1], p[2])) << i;
    if (signs.circle == 0) continue;
    ++num_certain;
    ASSERT_EQ(signs.circle, support::exact_in_circle(p[0], p[1], p[2], p[3])) << i;
  }
  EXPECT_GT(num_certain, num_sets * 99 / 100);
}

TEST(PlaneLanes, LeaveExactTiesOpen) {
  for (const double scale : {1.0, 0.1, 1e100, 1e-100}) {
    const auto p = [scale](double x, double y) { return Point2{scale * x, scale * y}; };
    EXPECT_EQ(twofold_signs({p(0, 0), p(1, 0), p(1, 1), p(0, 1)}).circle, 0);
    EXPECT_EQ(twofold_signs({p(0, 0), p(1, 0), p(3, 0), p(0, 1)}).turn, 0);
  }
}

// Beside a point 1e30 away all products of the others vanish.
TEST(PlaneLanes, AreNotCertainOfWhatUnderflows) {
  const std::vector<Point2> p{
      {0, 0}, {3e-162, 1e-162}, {1e-162, 2e-162}, {2e-162, 3e-162}};
  EXPECT_EQ(twofold_signs(p).turn, 0);
}

}  // namespace
}  // namespace delone::tripack
