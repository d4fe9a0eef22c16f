#include "tripack/plane_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "delaunay/instruction_set.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/twofold_signs.hpp"

namespace delone::tripack {
namespace {

using Lanes = PlaneLanes<delaunay::Portable>;

support::TwofoldSigns twofold_signs(const std::vector<Point2>& p) {
  return support::twofold_signs(Lanes({p.data(), 0, 0}));
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
    const support::TwofoldSigns signs = twofold_signs(p);
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
