#include "io/axis_ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace delone::io {
namespace {

using Labels = std::vector<std::string>;

/// The number that a label stands for; its minus sign is not the ASCII one.
double label_value(const std::string& label, int exponent) {
  const std::string minus = "\u2212";
  const bool is_negative = label.starts_with(minus);
  const std::string digits = is_negative ? label.substr(minus.size()) : label;
  // Read as a whole, because scaling afterwards would round twice.
  const double size = std::stod(digits + "e" + std::to_string(exponent));
  return is_negative ? -size : size;
}

bool is_one_two_or_five(double step) {
  const double mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
  for (const double round : {1.0, 2.0, 5.0, 10.0})
    if (std::abs(mantissa - round) < 1e-6) return true;
  return false;
}

struct Range {
  double low, high;
};

std::vector<Range> random_ranges() {
  std::mt19937_64 random(20261122);
  std::uniform_real_distribution<double> exponent(-12, 12), sign(-1, 1);
  std::vector<Range> ranges;
  for (int i = 0; i < 2000; ++i) {
    const double low = sign(random) * std::pow(10, exponent(random));
    ranges.push_back({low, low + std::abs(low) * std::pow(10, 0.3 * exponent(random))});
  }
  return ranges;
}

TEST(LinearTicks, AreRoundAndLieInTheRange) {
  for (const auto [low, high] : random_ranges()) {
    const Ticks ticks = linear_ticks(low, high, 8);
    ASSERT_GE(ticks.values.size(), 2u) << low << ' ' << high;
    ASSERT_LE(ticks.values.size(), 8u) << low << ' ' << high;
    const double length = high - low, step = ticks.values[1] - ticks.values[0];
    EXPECT_TRUE(is_one_two_or_five(step)) << low << ' ' << high << ' ' << step;
    EXPECT_GE(ticks.values.front(), low - 1e-8 * length);
    EXPECT_LE(ticks.values.back(), high + 1e-8 * length);
  }
}

TEST(LinearTicks, LeaveLessThanAStepAtEitherEnd) {
  for (const auto [low, high] : random_ranges()) {
    const Ticks ticks = linear_ticks(low, high, 8);
    const double step = ticks.values[1] - ticks.values[0];
    EXPECT_LT(ticks.values.front() - low, step) << low << ' ' << high;
    EXPECT_LT(high - ticks.values.back(), step) << low << ' ' << high;
  }
}

TEST(LinearTicks, HaveTheValuesThatTheirLabelsSay) {
  for (const auto [low, high] : random_ranges()) {
    const Ticks ticks = linear_ticks(low, high, 8);
    ASSERT_EQ(ticks.labels.size(), ticks.values.size());
    for (std::size_t i = 0; i < ticks.values.size(); ++i)
      EXPECT_EQ(label_value(ticks.labels[i], ticks.exponent), ticks.values[i]);
  }
}

TEST(LinearTicks, ShareTheNumberOfDecimals) {
  EXPECT_EQ(linear_ticks(0, 1, 6).labels,
            (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(linear_ticks(-100, 50, 5).labels,
            (Labels{"\u2212100", "\u221250", "0", "50"}));
}

TEST(LinearTicks, TakeACommonPowerOfTenOutOfHugeAndTinyValues) {
  const Ticks huge = linear_ticks(0, 5e300, 6);
  EXPECT_EQ(huge.exponent, 300);
  EXPECT_EQ(huge.labels, (Labels{"0", "1", "2", "3", "4", "5"}));
  const Ticks tiny = linear_ticks(0, 5e-7, 6);
  EXPECT_EQ(tiny.exponent, -9);
  EXPECT_EQ(tiny.labels.back(), "500");
  EXPECT_EQ(linear_ticks(5000000, 5000400, 5).exponent, 0);
}

TEST(LinearTicks, CoverTheWholeRangeOfDoubles) {
  constexpr double largest = std::numeric_limits<double>::max();
  const Ticks ticks = linear_ticks(-largest, largest, 7);
  EXPECT_EQ(ticks.exponent, 306);
  EXPECT_EQ(ticks.labels,
            (Labels{"\u2212150", "\u2212100", "\u221250", "0", "50", "100", "150"}));
}

TEST(LinearTicks, AreTheEndsWhereNoRoundNumbersAreBetween) {
  const double high = std::nextafter(1.0, 2.0);
  const Ticks ticks = linear_ticks(1, high, 8);
  EXPECT_EQ(ticks.values, (std::vector<double>{1, high}));
  EXPECT_EQ(ticks.labels, (Labels{"1", "1.0000000000000002"}));
  EXPECT_EQ(linear_ticks(3, 3, 8).values, std::vector<double>{3});
}

TEST(LongitudeTicks, NameTheHemisphere) {
  EXPECT_EQ(longitude_ticks(-180, 180, 7).labels,
            (Labels{"180°", "120°W", "60°W", "0°", "60°E", "120°E", "180°"}));
}

TEST(LongitudeTicks, WrapEastOfTheDateLine) {
  EXPECT_EQ(longitude_ticks(0, 360, 5).labels,
            (Labels{"0°", "90°E", "180°", "90°W", "0°"}));
  EXPECT_EQ(longitude_ticks(170, 190, 5).labels,
            (Labels{"170°E", "175°E", "180°", "175°W", "170°W"}));
}

TEST(LongitudeTicks, HaveDecimalsBelowOneDegree) {
  EXPECT_EQ(longitude_ticks(-0.5, 0.5, 5).labels,
            (Labels{"0.4°W", "0.2°W", "0°", "0.2°E", "0.4°E"}));
}

TEST(LatitudeTicks, NameTheHemisphere) {
  EXPECT_EQ(latitude_ticks(-90, 90, 7).labels,
            (Labels{"90°S", "60°S", "30°S", "0°", "30°N", "60°N", "90°N"}));
  EXPECT_EQ(latitude_ticks(60.25, 90, 7).values,
            (std::vector<double>{65, 70, 75, 80, 85, 90}));
}

TEST(PowerOfTen, IsWrittenWithSuperscripts) {
  EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
  EXPECT_EQ(power_of_ten(306), "10³⁰⁶");
}

}  // namespace
}  // namespace delone::io
