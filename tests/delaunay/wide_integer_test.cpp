#include "delaunay/wide_integer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "support/random.hpp"

namespace delone::delaunay {
namespace {

// Sums of products are compared modulo this prime and by their leading digits.
constexpr std::int64_t prime = (std::int64_t{1} << 61) - 1;

std::int64_t residue(Int128 value) {
  const auto r = static_cast<std::int64_t>(value % prime);
  return r < 0 ? r + prime : r;
}
std::int64_t times(std::int64_t a, std::int64_t b) { return residue(product(a, b)); }
std::int64_t plus(std::int64_t a, std::int64_t b) {
  return residue(static_cast<Int128>(a) + b);
}

constexpr std::int64_t two_to_64 = 8;  // 2^64 = 2^3 modulo 2^61 - 1

std::int64_t residue(const Integer192& value) {
  return plus(times(residue(value.high), two_to_64),
              residue(static_cast<Int128>(value.low)));
}
std::int64_t residue(const Integer256& value) {
  const std::int64_t high = times(residue(value.high), two_to_64 * two_to_64);
  const std::int64_t middle =
      times(residue(static_cast<Int128>(value.low >> 64)), two_to_64);
  const auto low = static_cast<std::uint64_t>(value.low);
  return plus(plus(high, middle), residue(static_cast<Int128>(low)));
}

// |value| < 2^bits
Int128 draw(support::SplitMix64& random, int bits) {
  const auto raw = static_cast<UnsignedInt128>(random.next()) << 64 | random.next();
  const auto value = static_cast<Int128>(raw >> (128 - bits));
  return random.below(2) == 0 ? value : -value;
}

template <class Vector>
std::int64_t dot_residue(const Vector& a, const std::array<Int128, 3>& b) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum = plus(sum, times(residue(a[i]), residue(b[i])));
  return sum;
}

template <class Vector>
long double dot_estimate(const Vector& a, const std::array<Int128, 3>& b) {
  long double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += static_cast<long double>(a[i]) * static_cast<long double>(b[i]);
  }
  return sum;
}

TEST(Dot192, IsExactForRandomFactors) {
  support::SplitMix64 random(21);
  for (int i = 0; i < 20000; ++i) {
    std::array<std::int64_t, 3> a{};
    std::array<Int128, 3> b{};
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = static_cast<std::int64_t>(draw(random, 61));
      b[k] = draw(random, 1 + static_cast<int>(random.below(124)));
    }
    const Integer192 value = dot(a, b);
    ASSERT_EQ(residue(value), dot_residue(a, b));
    const long double estimate = dot_estimate(a, b);
    if (std::abs(estimate) > 0x1p140L) {
      ASSERT_EQ(value.sign(), estimate > 0 ? 1 : -1);
    }
  }
}

TEST(Dot256, IsExactForRandomFactors) {
  support::SplitMix64 random(22);
  for (int i = 0; i < 20000; ++i) {
    std::array<Int128, 3> a{}, b{};
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = draw(random, 1 + static_cast<int>(random.below(124)));
      if (a[k] < 0) a[k] = -a[k];
      b[k] = draw(random, 1 + static_cast<int>(random.below(124)));
    }
    const Integer256 value = dot(a, b);
    ASSERT_EQ(residue(value), dot_residue(a, b));
    const long double estimate = dot_estimate(a, b);
    if (std::abs(estimate) > 0x1p200L) {
      ASSERT_EQ(value.sign(), estimate > 0 ? 1 : -1);
    }
  }
}

TEST(Dot256, HoldsAtTheEndsOfItsRange) {
  const Int128 most = (static_cast<Int128>(1) << 124) - 1;
  const std::array all{most, most, most};
  EXPECT_EQ(dot(all, std::array{most, most, most}).sign(), 1);
  EXPECT_EQ(dot(all, std::array{-most, -most, -most}).sign(), -1);
  EXPECT_EQ(residue(dot(all, std::array{-most, -most, -most})),
            dot_residue(all, std::array{-most, -most, -most}));
}

TEST(Dot, SeesOneUnitInACancellingSum) {
  const Int128 a = (static_cast<Int128>(1) << 123) + 12345,
               b = (static_cast<Int128>(1) << 122) + 678;
  for (const int unit : {-1, 0, 1}) {
    EXPECT_EQ(
        dot(std::array<Int128, 3>{a, b, 1}, std::array<Int128, 3>{b, -a, unit}).sign(),
        unit);
  }
  const std::int64_t c = (std::int64_t{1} << 61) - 3, d = (std::int64_t{1} << 60) + 7;
  for (const int unit : {-1, 0, 1}) {
    EXPECT_EQ(
        dot(std::array<std::int64_t, 3>{c, d, 1}, std::array<Int128, 3>{d, -c, unit})
            .sign(),
        unit);
  }
}

TEST(ExactDifference, LosesNothing) {
  const TwoTerms d = exact_difference(1.0, 0x1p-80);
  EXPECT_EQ(d.value, 1.0);
  EXPECT_EQ(d.tail, -0x1p-80);
  const TwoTerms swapped = exact_difference(-0x1p-80, -1.0);
  EXPECT_EQ(swapped.value, 1.0);
  EXPECT_EQ(swapped.tail, -0x1p-80);
}

TEST(ToScaledIntegers, KeepsRatiosExactly) {
  const auto scaled =
      to_scaled_integers(std::array<TwoTerms, 3>{{{3.5, 0}, {-0.25, 0}, {0, 0}}});
  ASSERT_TRUE(scaled.is_exact);
  EXPECT_EQ(scaled.values[0], -14 * scaled.values[1]);
  EXPECT_EQ(scaled.values[2], 0);
  EXPECT_EQ(static_cast<double>(scaled.values[0]), 3.5 * scaled.scale);
}

TEST(ToScaledIntegers, AddsTails) {
  const auto scaled =
      to_scaled_integers(std::array<TwoTerms, 2>{{{1, -0x1p-60}, {0x1p-60, 0}}});
  ASSERT_TRUE(scaled.is_exact);
  EXPECT_EQ(scaled.values[0], (std::int64_t{1} << 60) - 1);
  EXPECT_EQ(scaled.values[1], 1);
}

TEST(ToScaledIntegers, StaysWithin61BitsForTheLargestMantissa) {
  const double below_two = 2 - 0x1p-52;
  const auto scaled =
      to_scaled_integers(std::array<TwoTerms, 1>{{{-below_two, -0x1p-53}}});
  ASSERT_TRUE(scaled.is_exact);
  EXPECT_GE(scaled.values[0], -(std::int64_t{1} << 61));
}

TEST(ToScaledIntegers, RefusesWhatDoesNotFit) {
  const auto fits = [](double a, double b) {
    return to_scaled_integers(std::array<TwoTerms, 2>{{{a, 0}, {b, 0}}}).is_exact;
  };
  EXPECT_TRUE(fits(1, 0x1p-60));
  EXPECT_FALSE(fits(1, 0x1p-61));
  EXPECT_FALSE(fits(1, 1e-300));
  EXPECT_FALSE(fits(0x1p900, 5e-324));  // the small one must not vanish by underflow
  EXPECT_FALSE(fits(0, 0));
  EXPECT_FALSE(fits(1e300, 1));
  EXPECT_FALSE(fits(0, 1e-300));
  EXPECT_FALSE(fits(std::numeric_limits<double>::infinity(), 1));
  EXPECT_FALSE(fits(std::numeric_limits<double>::quiet_NaN(), 0));
}

}  // namespace
}  // namespace delone::delaunay
