#include "delaunay/big_integer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "support/random.hpp"

namespace delone::delaunay {
namespace {

constexpr double smallest = 0x1p-1074;
constexpr double largest = std::numeric_limits<double>::max();

// A random integer below 2^31 in magnitude, zero and small ones included.
std::int64_t small_integer(support::SplitMix64& random) {
  const auto bits = static_cast<int>(random.below(32));
  const auto value =
      static_cast<std::int64_t>(random.next() & ((std::uint64_t{1} << bits) - 1));
  return random.below(2) == 0 ? value : -value;
}

BigInteger<1> integer(std::int64_t value) { return {static_cast<double>(value), 0}; }

TEST(Decode, GivesOddMantissaAndExponent) {
  const std::vector<double> values{1,         -6,       0.1,     smallest, 3 * smallest,
                                   0x1p-1022, -largest, 0x1p1023};
  for (const double value : values) {
    const DecodedDouble decoded = decode(value);
    EXPECT_EQ(decoded.mantissa % 2, 1u) << value;
    EXPECT_EQ(std::ldexp(decoded.sign * static_cast<double>(decoded.mantissa),
                         decoded.exponent),
              value);
  }
}

TEST(Decode, TakesBothZerosForZero) {
  EXPECT_EQ(decode(0.0).sign, 0);
  EXPECT_EQ(decode(-0.0).sign, 0);
}

TEST(CommonExponent, IsThatOfTheLowestBitInUse) {
  EXPECT_EQ(common_exponent(std::array{0.0, 12.0, 0.5}), -1);
  EXPECT_EQ(common_exponent(std::array{0.0, 12.0, 40.0}), 2);
  EXPECT_EQ(common_exponent(std::array{largest, 5e-324}), -1074);
  EXPECT_EQ(common_exponent(std::array{0.0, -0.0}), 0);
}

TEST(BigInteger, AgreesWith128BitsOnRandomExpressions) {
  support::SplitMix64 random(11);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t a = small_integer(random), b = small_integer(random);
    const std::int64_t c = small_integer(random), d = small_integer(random);
    const Int128 small = product(a, b) - product(c, d) + a;
    const auto big = integer(a) * integer(b) - integer(c) * integer(d) + integer(a);
    ASSERT_EQ(big.sign(), sign(small)) << a << ' ' << b << ' ' << c << ' ' << d;
    // Not only the sign: the value minus itself, built in another order, is zero.
    const auto other = integer(a) - integer(d) * integer(c) + integer(b) * integer(a);
    ASSERT_EQ((big - other).sign(), 0) << a << ' ' << b << ' ' << c << ' ' << d;
  }
}

TEST(BigInteger, KeepsTheDifferenceOfSquaresOverTheWholeRangeOfDoubles) {
  support::SplitMix64 random(12);
  for (int i = 0; i < 2000; ++i) {
    const auto draw = [&random] {
      return std::ldexp(random.uniform() - 0.5,
                        static_cast<int>(random.below(2098)) - 1073);
    };
    const std::array values{draw(), draw()};
    const int exponent = common_exponent(values);
    const BigInteger<33> a(values[0], exponent), b(values[1], exponent);
    ASSERT_EQ(((a + b) * (a - b) - (a * a - b * b)).sign(), 0)
        << values[0] << ' ' << values[1];
    ASSERT_EQ((a * a - b * b).sign(),
              (std::abs(values[0]) > std::abs(values[1])) ? 1 : -1);
  }
}

TEST(BigInteger, CarriesAndBorrowsThroughAllWords) {
  const BigInteger<33> high(0x1p1023, -1074), one(smallest, -1074);
  const auto below = high - one;  // 2097 one bits
  EXPECT_EQ(below.sign(), 1);
  EXPECT_EQ(below.compare_magnitude(high), -1);
  EXPECT_EQ((below + one).compare_magnitude(high), 0);
  // (h - 1)(h + 1) + 1 = h^2
  EXPECT_EQ((below * (high + one) + one).compare_magnitude(high * high), 0);
}

TEST(BigInteger, HoldsTheLargestDoubleInUnitsOfTheSmallest) {
  const BigInteger<33> a(largest, -1074), b(smallest, -1074);
  EXPECT_EQ((a + b - a - b).sign(), 0);
  EXPECT_EQ((a - b).compare_magnitude(a), -1);
  EXPECT_EQ((-a + b).sign(), -1);
}

TEST(BigInteger, MakesZeroOfZeroFactorsAndOfEqualTerms) {
  const BigInteger<2> zero(-0.0, 0), nine(9.0, 0);
  EXPECT_EQ(zero.sign(), 0);
  EXPECT_EQ((zero * nine).sign(), 0);
  EXPECT_EQ((nine - nine).sign(), 0);
  EXPECT_EQ((nine - zero).compare_magnitude(nine), 0);
  EXPECT_EQ((zero - nine).sign(), -1);
}

TEST(BigInteger, GivesItsLeading53Bits) {
  using Long = BigInteger<20>;
  const auto value = [](const auto& n) {
    const auto [mantissa, exponent] = n.leading();
    return std::ldexp(mantissa, exponent);
  };
  for (const double v : {1.0, -1.0, 3.0, 0x1.fffffffffffffp52, -0x1.fffffffffffffp200,
                         0x1p63, 0x1p64, 0x1.8p127, 0x1.0000000000001p116, 0.0}) {
    EXPECT_EQ(value(Long(v, 0)), v);
    EXPECT_EQ(value(Long(v, 0) * Long(0x1p300, 0)), v * 0x1p300);
  }
  // Further bits are cut off.
  EXPECT_EQ(value(Long(0x1p100, 0) - Long(1, 0)), 0x1.fffffffffffffp99);
  EXPECT_EQ(value(Long(0x1p100, 0) + Long(1, 0)), 0x1p100);
}

TEST(BigInteger, MultipliesNumbersThatAreMostlyZeros) {
  using Long = BigInteger<20>;
  const auto sparse = Long(0x1.8p640, 0) + Long(5, 0);
  const auto square = sparse * sparse;
  const auto expected =
      Long(0x1.2p640, 0) * Long(0x2p640, 0) + Long(0x1.ep643, 0) + Long(25, 0);
  EXPECT_TRUE(square == expected);
}

}  // namespace
}  // namespace delone::delaunay
