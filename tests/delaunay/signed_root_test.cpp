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

RootTerm<3, 2> term(std::int64_t factor, std::int64_t square, int scale) {
  const auto sign = static_cast<double>(factor < 0 ? -1 : 1);
  return {
      BigInteger<2>(sign * std::ldexp(std::abs(static_cast<double>(factor)), scale), 0) +
          BigInteger<2>(0, 0),
      {static_cast<double>(square), 0}};
}

TEST(SignOfRootTerms, AgreesWithTheirSquares) {
  support::SplitMix64 random(72);
  int num_estimated = 0, num_zero = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<RootTerm<3, 2>, 4> terms{};
    std::array<SignedRoot<2>, 4> roots{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto factor = static_cast<std::int64_t>(random.below(9)) - 4;
      const auto square = 1 + static_cast<std::int64_t>(random.below(5));
      terms[k] = term(factor, square, 0);
      roots[k] = root(factor * std::abs(factor) * square);
    }
    const int expected = sign_of_sum(roots[0], roots[1], roots[2], roots[3]);
    ASSERT_EQ(sign_of_sum(terms), expected);
    const auto estimate = estimated_sign_of_sum(terms);
    ASSERT_EQ(estimate.value_or(expected), expected);
    num_estimated += estimate ? 1 : 0;
    num_zero += expected == 0 ? 1 : 0;
  }
  EXPECT_GT(num_zero, 100);
  EXPECT_GT(num_estimated, 20000 - 2 * num_zero);
}

TEST(SignOfRootTerms, IsNotEstimatedWhereOneUnitInTheLastPlaceDecides) {
  // 3 sqrt 4 - 2 sqrt 9, its first term a little larger.
  const auto nearly = [](double more) {
    return std::array<RootTerm<3, 2>, 4>{
        RootTerm<3, 2>{BigInteger<2>(0x3p60, 0) + BigInteger<2>(more, 0), {4, 0}},
        term(-2, 9, 60), term(0, 1, 0), term(0, 1, 0)};
  };
  EXPECT_FALSE(estimated_sign_of_sum(nearly(1)).has_value());
  EXPECT_EQ(sign_of_sum(nearly(1)), 1);
  EXPECT_EQ(sign_of_sum(nearly(-1)), -1);
  EXPECT_EQ(sign_of_sum(nearly(0)), 0);
  EXPECT_EQ(estimated_sign_of_sum(nearly(0x1p30)), 1);
}

TEST(SignOfRootTerms, HoldsTermsOfAnyMagnitude) {
  const auto of = [](double huge, double tiny) {
    using Term = RootTerm<17, 1>;
    return std::array<Term, 4>{Term{{huge, -1060}, {1, 0}}, Term{{tiny, -1060}, {3, 0}},
                               Term{{0, 0}, {1, 0}}, Term{{0, 0}, {1, 0}}};
  };
  EXPECT_EQ(sign_of_sum(of(1, -0x1p-1060)), 1);
  EXPECT_EQ(sign_of_sum(of(-0x1p-1060, 1)), 1);
  EXPECT_EQ(sign_of_sum(of(0, -0x1p-1060)), -1);
}

}  // namespace
}  // namespace delone::delaunay
