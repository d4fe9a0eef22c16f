// Every property that holds for all point sets, over all families of tests/support.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>

#include "support/exact.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/defect.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {
namespace {

using support::PlaneFamily;
using support::PlanePoints;

class PlaneFamilies : public testing::TestWithParam<PlaneFamily> {};

constexpr std::size_t sizes[] = {1, 2, 3, 4, 5, 6, 7, 9, 12, 20, 64, 300};

template <class F>
void for_each_set(const PlaneFamily& family, F check) {
  for (const std::size_t n : sizes) {
    for (std::uint64_t seed = 1; seed <= (n < 20 ? 6 : 1); ++seed) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", seed = " + std::to_string(seed));
      check(family.make(n, seed));
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST_P(PlaneFamilies, HaveNoDefect) {
  for_each_set(GetParam(), [](const PlanePoints& points) {
    const Triangulation t(points);
    EXPECT_EQ(find_defect(t).value_or("none"), "none");
    EXPECT_EQ(find_defect(points, t.triangles()).value_or("none"), "none");
  });
}

TEST_P(PlaneFamilies, AreDelaunayInExactArithmetic) {
  for_each_set(GetParam(), [](const PlanePoints& points) {
    const Triangulation t(points);
    EXPECT_EQ(support::exact_defect(points, t.triangles()).value_or("none"), "none");
  });
}

TEST_P(PlaneFamilies, DoNotDependOnInputOrder) {
  for_each_set(GetParam(), [](const PlanePoints& points) {
    const Triangulation t(points), u(support::shuffled(points, 77));
    EXPECT_TRUE(t.adjacency() == u.adjacency());
    EXPECT_TRUE(std::equal(t.points().begin(), t.points().end(), u.points().begin(),
                           u.points().end()));
  });
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneFamilies,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

}  // namespace
}  // namespace delone::tripack
