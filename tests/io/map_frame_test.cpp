#include "io/map_frame.hpp"

#include <gtest/gtest.h>

namespace delone::io {
namespace {

TEST(PlaneFrame, HoldsTheCellsOfAllNodes) {
  const MapFrame frame = plane_frame({{2, 5, 4, 0.5}, {1, 0, 1, 0}});
  EXPECT_EQ(frame.west, 9.5);
  EXPECT_EQ(frame.east, 17.5);
  EXPECT_EQ(frame.south, -0.5);
  EXPECT_EQ(frame.north, 0.5);
}

TEST(GlobeFrame, EndsAtThePoles) {
  const MapFrame frame = globe_frame({{1, 10, 20, 0}, {1, -90, 181, 0}});
  EXPECT_EQ(frame.south, -90);
  EXPECT_EQ(frame.north, 90);
  EXPECT_EQ(frame.west, 9.5);
  EXPECT_FALSE(frame.is_closed);
}

TEST(GlobeFrame, StartsAtARoundLongitudeIfItGoesRound) {
  for (const auto& [first, spacing, size, west] :
       {std::tuple{-180.0, 0.5, 720, -180.0},  // nodes on the meridians
        {-179.75, 0.5, 720, -180.0},           // cell centres
        {0.0, 1.0, 360, 0.0},
        {20.5, 1.0, 360, 20.0},
        {21.0, 2.0, 180, 20.0},
        {5.0, 1.0, 360, 4.5}}) {
    const MapFrame frame = globe_frame({{spacing, 0, size, first}, {1, 0, 10, 0}});
    EXPECT_EQ(frame.west, west) << first;
    EXPECT_EQ(frame.east, west + 360) << first;
    EXPECT_TRUE(frame.is_closed) << first;
  }
}

TEST(GlobeFrame, SpansOneTurnIfTheFirstMeridianIsRepeated) {
  const MapFrame frame = globe_frame({{1, -180, 361, 0}, {1, -90, 181, 0}});
  EXPECT_EQ(frame.west, -180);
  EXPECT_EQ(frame.east, 180);
  EXPECT_FALSE(frame.is_closed)
      << "the last node's neighbour is the second, not the first";
}

TEST(PlaneAspect, IsTrueToScaleExceptForStrips) {
  EXPECT_EQ(plane_aspect({0, 0, 3, 2}), 1.5);
  EXPECT_EQ(plane_aspect({0, 0, 100, 1}), 4);
  EXPECT_EQ(plane_aspect({0, 0, 1, 100}), 0.4);
}

TEST(GlobeAspect, ShrinksLongitudesOnRegionalMapsOnly) {
  EXPECT_EQ(globe_aspect({-180, -90, 180, 90}), 2);
  EXPECT_NEAR(globe_aspect({0, 50, 20, 70}), 0.5, 1e-12);
  EXPECT_EQ(globe_aspect({0, -10, 20, 10}), 1);
}

}  // namespace
}  // namespace delone::io
