#include "io/colormap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace delone::io {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

TEST(SequentialColormap, GrowsLighterFromEntryToEntry) {
  const Colormap& map = sequential_colormap();
  // Eight bits a channel: a step of lightness is about 0.0025, rounding costs up to half
  // of that.
  for (std::size_t i = 1; i < map.size(); ++i)
    EXPECT_GT(lightness(map[i]), lightness(map[i - 1]) - 0.0005) << i;
  for (std::size_t i = 4; i < map.size(); ++i)
    EXPECT_GT(lightness(map[i]), lightness(map[i - 4])) << i;
}

TEST(SequentialColormap, HasTheEndsOfViridis) {
  EXPECT_EQ(sequential_colormap().front(), (Color{0x44, 0x01, 0x54}));
  EXPECT_EQ(sequential_colormap().back(), (Color{0xfd, 0xe7, 0x25}));
}

TEST(DivergingColormap, GrowsDarkerFromTheMiddleToBothEnds) {
  const Colormap& map = diverging_colormap();
  for (std::size_t i = 128; i + 1 < map.size(); ++i) {
    EXPECT_LT(lightness(map[i + 1]), lightness(map[i])) << i;
    EXPECT_LT(lightness(map[254 - i]), lightness(map[255 - i])) << 254 - i;
  }
}

TEST(DivergingColormap, IsAsLightOnOneSideAsOnTheOther) {
  const Colormap& map = diverging_colormap();
  // Two units of the eight bits a channel.
  for (std::size_t i = 0; i < 128; ++i)
    EXPECT_NEAR(lightness(map[i]), lightness(map[255 - i]), 0.006) << i;
}

TEST(DivergingColormap, IsBlueBelowAndRedAbove) {
  const Colormap& map = diverging_colormap();
  for (std::size_t i = 0; i < 100; ++i) EXPECT_GT(map[i].blue, map[i].red) << i;
  for (std::size_t i = 156; i < 256; ++i) EXPECT_GT(map[i].red, map[i].blue) << i;
}

TEST(Lightness, IsOneForWhiteAndZeroForBlack) {
  EXPECT_NEAR(lightness({255, 255, 255}), 1, 1e-6);
  EXPECT_EQ(lightness({0, 0, 0}), 0);
}

TEST(ColorScale, IsSymmetricAboutZeroIfBothSignsAreLarge) {
  const ColorScale scale = ColorScale::choose(-106.3, 85.4);
  EXPECT_EQ(&scale.colormap(), &diverging_colormap());
  EXPECT_EQ(scale.low(), -106.3);
  EXPECT_EQ(scale.high(), 106.3);
  EXPECT_EQ(scale.position(0), 0.5);
}

TEST(ColorScale, IsSequentialIfOneSignPrevails) {
  for (const auto& [min, max] :
       {std::pair{0.0, 5.0}, {-1.0, 3.5}, {-8.0, -2.0}, {-3.5, 1.0}}) {
    const ColorScale scale = ColorScale::choose(min, max);
    EXPECT_EQ(&scale.colormap(), &sequential_colormap());
    EXPECT_EQ(scale.low(), min);
    EXPECT_EQ(scale.high(), max);
  }
}

TEST(ColorScale, GivesTheEndsOfTheRangeTheEndsOfTheMap) {
  const ColorScale scale = ColorScale::choose(2, 4);
  EXPECT_EQ(scale.color(2), sequential_colormap().front());
  EXPECT_EQ(scale.color(4), sequential_colormap().back());
  EXPECT_EQ(scale.color(3), sequential_colormap()[128]);
  EXPECT_EQ(scale.color(-1e300), sequential_colormap().front());
  EXPECT_EQ(scale.color(1e300), sequential_colormap().back());
}

TEST(ColorScale, PutsASingleValueInTheMiddle) {
  for (const double value : {0.0, 7.0, -7.0, 1e300, 1e-300}) {
    const ColorScale scale = ColorScale::choose(value, value);
    EXPECT_LT(scale.low(), scale.high()) << value;
    EXPECT_NEAR(scale.position(value), 0.5, 1e-12) << value;
  }
}

TEST(ColorScale, NeitherOverflowsNorLosesDenormals) {
  EXPECT_EQ(ColorScale::choose(-largest, largest).position(0), 0.5);
  EXPECT_EQ(ColorScale::choose(-largest, largest).position(largest), 1);
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(ColorScale::choose(0, 2 * smallest).position(smallest), 0.5);
  const ColorScale single = ColorScale::choose(largest, largest);
  EXPECT_TRUE(std::isfinite(single.high()) && single.low() < single.high());
  const ColorScale tiny = ColorScale::choose(smallest, smallest);
  EXPECT_LT(tiny.low(), tiny.high());
}

}  // namespace
}  // namespace delone::io
