#include "delaunay/signed_root.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "support/random.hpp"

namespace delone::delaunay {
namespace {

// sign(n) * sqrt(|n|)
SignedRoot<2> root(std::int64_t n) {
  return {static_cast<int>(n > 0) - static_cast<int>(n < 0),
          {std::abs(static_cast<double>(n)), 0}};
}

long double value(int n) { return n < 0 ? -std::sqrt(-1.0L * n) : std::sqrt(1.0L * n); }

int sign_of(long double v) { return static_cast<int>(v > 0) - static_cast<int>(v < 0); }

TEST(SignOfRootSum, IsRightForAllRootsOfSmallIntegers) {
  // Four roots of integers up to 12 that do not cancel add up to more than 1e-7, so
  // extended precision is a judge.
  const int most = 12;
  for (int s = -most; s <= most; ++s) {
    for (int t = -most; t <= most; ++t) {
      for (int v = -most; v <= most; ++v) {
        for (int w = -most; w <= most; ++w) {
          const long double sum = value(s) + value(t) + value(v) + value(w);
          const int expected = std::abs(sum) < 1e-12L ? 0 : sign_of(sum);
          ASSERT_EQ(sign_of_sum(root(s), root(t), root(v), root(w)), expected)
              << s << ' ' << t << ' ' << v << ' ' << w;
        }
      }
    }
  }
}

TEST(SignOfRootSum, FindsZeroHoweverTheTermsArePaired) {
  // sqrt 2 + sqrt 18 = sqrt 32; 1 + 3 = 2 + 2; and the four terms of (1 - 1) sqrt
  // 2 + (1 - 1) sqrt 3.
  EXPECT_EQ(sign_of_sum(root(2), root(18), root(-32), root(0)), 0);
  EXPECT_EQ(sign_of_sum(root(2), root(-32), root(18), root(0)), 0);
  EXPECT_EQ(sign_of_sum(root(1), root(-4), root(9), root(-4)), 0);
  EXPECT_EQ(sign_of_sum(root(2), root(3), root(-2), root(-3)), 0);
  EXPECT_EQ(sign_of_sum(root(2), root(3), root(-3), root(-2)), 0);
  EXPECT_EQ(sign_of_sum(root(2), root(-2), root(3), root(-3)), 0);
}

TEST(SignOfRootSum, SeesASumOf1eMinus35InTermsOf1e7) {
  // sqrt(n+2) - 3 sqrt(n+1) + 3 sqrt n - sqrt(n-1) is about 3/8 n^(-5/2).
  const std::int64_t n = std::int64_t{1} << 46;
  EXPECT_EQ(sign_of_sum(root(n + 2), root(-9 * (n + 1)), root(9 * n), root(1 - n)), 1);
  EXPECT_EQ(sign_of_sum(root(-n - 2), root(9 * (n + 1)), root(-9 * n), root(n - 1)), -1);
  EXPECT_EQ(sign_of_sum(root(n + 2), root(9 * n), root(-9 * (n + 1)), root(1 - n)), 1);
}

TEST(SignOfRootSum, DoesNotDependOnTheOrderOfTheTerms) {
  support::SplitMix64 random(71);
  for (int i = 0; i < 5000; ++i) {
    std::array<SignedRoot<2>, 4> r{};
    for (auto& term : r) term = root(static_cast<std::int64_t>(random.below(200)) - 100);
    const int sum = sign_of_sum(r[0], r[1], r[2], r[3]);
    ASSERT_EQ(sign_of_sum(r[1], r[2], r[3], r[0]), sum);
    ASSERT_EQ(sign_of_sum(r[2], r[0], r[1], r[3]), sum);
    for (auto& term : r) term.sign = -term.sign;
    ASSERT_EQ(sign_of_sum(r[0], r[1], r[2], r[3]), -sum);
  }
}

}  // namespace
}  // namespace delone::delaunay
