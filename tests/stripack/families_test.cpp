// Every property that holds for all point sets, over all families of tests/support.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "stripack/defect.hpp"
#include "stripack/triangulation.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::SphereFamily;
using support::SpherePoints;

class SphereFamilies : public testing::TestWithParam<SphereFamily> {};

constexpr std::size_t sizes[] = {1, 2, 3, 4, 5, 6, 7, 9, 12, 20, 64, 300};

template <class F>
void for_each_set(const SphereFamily& family, F check) {
  for (const std::size_t n : sizes) {
    for (std::uint64_t seed = 1; seed <= (n < 20 ? 6 : 1); ++seed) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", seed = " + std::to_string(seed));
      check(family.make(n, seed));
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST_P(SphereFamilies, HaveNoDefect) {
  for_each_set(GetParam(), [](const SpherePoints& points) {
    const Triangulation t(points);
    EXPECT_EQ(find_defect(t).value_or("none"), "none");
    EXPECT_EQ(find_defect(points, t.triangles()).value_or("none"), "none");
  });
}

TEST_P(SphereFamilies, AreDelaunayInExactArithmetic) {
  for_each_set(GetParam(), [](const SpherePoints& points) {
    const Triangulation t(points);
    EXPECT_EQ(support::exact_defect(points, t.triangles()).value_or("none"), "none");
  });
}

TEST_P(SphereFamilies, DoNotDependOnInputOrder) {
  for_each_set(GetParam(), [](const SpherePoints& points) {
    const Triangulation t(points), u(support::shuffled(points, 77));
    EXPECT_TRUE(t.adjacency() == u.adjacency());
  });
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereFamilies,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

}  // namespace
}  // namespace delone::stripack
