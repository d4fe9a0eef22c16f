#include "interp/grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "delaunay/error.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::at_lonlat;
using support::PlanePoints;
using support::SpherePoints;
using support::triangulated;

constexpr Region globe{-180, 180, -90, 90};

double last(const Axis& axis) { return axis.coordinate(axis.size - 1); }

TEST(Axis, OfDecimalStepsIsTheNearestDouble) {
  const Grid grid = plane_grid({0, 1, 0, 1}, Spacing{0.1, 0.3});
  const std::vector<double> tenths{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
  ASSERT_EQ(grid.x.size, 11);
  for (std::int64_t i = 0; i < 11; ++i)
    EXPECT_EQ(grid.x.coordinate(i), tenths[static_cast<std::size_t>(i)]);
  EXPECT_EQ(grid.y.coordinate(1), 0.3);
  EXPECT_EQ(grid.y.coordinate(3), 0.9);
}

TEST(PlaneGrid, WithSpacingHasNodesOnBothEnds) {
  const Grid grid = plane_grid({-2, 3, 10, 20}, Spacing{0.5, 2});
  EXPECT_EQ(grid.x.size, 11);
  EXPECT_EQ(grid.x.coordinate(0), -2);
  EXPECT_EQ(last(grid.x), 3);
  EXPECT_EQ(grid.y.size, 6);
  EXPECT_EQ(grid.y.coordinate(0), 10);
  EXPECT_EQ(last(grid.y), 20);
}

TEST(PlaneGrid, KeepsEndsBetweenMultiplesIfTheSpacingDividesTheRegion) {
  const Grid grid = plane_grid({0.5, 10.5, 0, 1}, Spacing{1, 1});
  EXPECT_EQ(grid.x.size, 11);
  EXPECT_EQ(grid.x.coordinate(0), 0.5);
  EXPECT_EQ(last(grid.x), 10.5);
}

TEST(PlaneGrid, WidensOtherRegionsToMultiplesOfTheSpacing) {
  const Grid grid = plane_grid({0.3, 9.9, -0.1, 0.1}, Spacing{1, 1});
  EXPECT_EQ(grid.x.coordinate(0), 0);
  EXPECT_EQ(last(grid.x), 10);
  EXPECT_EQ(grid.y.coordinate(0), -1);
  EXPECT_EQ(last(grid.y), 1);
}

TEST(PlaneGrid, WithCountsHasThemAndBothEnds) {
  const Grid grid = plane_grid({0.1, 0.7, -3, 4}, NodeCounts{50, 8});
  EXPECT_EQ(grid.x.size, 50);
  EXPECT_EQ(grid.y.size, 8);
  EXPECT_EQ(grid.x.coordinate(0), 0.1);
  EXPECT_DOUBLE_EQ(last(grid.x), 0.7);
  EXPECT_EQ(grid.y.coordinate(1), -2);
  EXPECT_EQ(last(grid.y), 4);
}

TEST(PlaneGrid, RefusesWhatCannotBeAGrid) {
  const double nan = std::nan("");
  EXPECT_THROW((void)plane_grid({1, 0, 0, 1}, Spacing{1, 1}), Error);
  EXPECT_THROW((void)plane_grid({0, 1, 2, 1}, NodeCounts{2, 2}), Error);
  EXPECT_THROW((void)plane_grid({0, nan, 0, 1}, Spacing{1, 1}), Error);
  EXPECT_THROW((void)plane_grid({0, 1, 0, 1}, Spacing{0, 1}), Error);
  EXPECT_THROW((void)plane_grid({0, 1, 0, 1}, Spacing{1, -1}), Error);
  EXPECT_THROW((void)plane_grid({0, 1, 0, 1}, Spacing{nan, 1}), Error);
  EXPECT_THROW((void)plane_grid({0, 1, 0, 1}, NodeCounts{0, 1}), Error);
  EXPECT_THROW((void)plane_grid({0, 1, 0, 1}, Spacing{1e-9, 1e-9}), Error);
  EXPECT_THROW((void)plane_grid({0, 1, 0, 1}, NodeCounts{1 << 21, 1 << 21}), Error);
}

TEST(GlobeGrid, HasBothPolesAndDoesNotRepeatItsFirstMeridian) {
  for (const double spacing : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0}) {
    const Grid grid = globe_grid(globe, Spacing{spacing, spacing});
    EXPECT_EQ(static_cast<double>(grid.x.size), std::round(360 / spacing));
    EXPECT_EQ(grid.x.coordinate(0), -180);
    EXPECT_LT(last(grid.x), 180);
    EXPECT_EQ(grid.y.coordinate(0), -90);
    EXPECT_EQ(last(grid.y), 90);
  }
  const Grid from_zero = globe_grid({0, 360, -90, 90}, Spacing{1, 1});
  EXPECT_EQ(from_zero.x.size, 360);
  EXPECT_EQ(from_zero.x.coordinate(0), 0);
}

TEST(GlobeGrid, KeepsCellCentres) {
  const Grid grid = globe_grid({-179.5, 180.5, -89.5, 89.5}, Spacing{1, 1});
  EXPECT_EQ(grid.x.size, 360);
  EXPECT_EQ(grid.x.coordinate(0), -179.5);
  EXPECT_EQ(grid.y.size, 180);
  EXPECT_EQ(last(grid.y), 89.5);
}

TEST(GlobeGrid, WithCountsHitsThePolesExactly) {
  for (std::int64_t n = 2; n < 400; ++n) {
    for (const Region r :
         {globe, Region{0, 10, 12.34567, 90}, Region{0, 10, -90, 33.1}}) {
      const Grid grid = globe_grid(r, NodeCounts{n, n});
      EXPECT_EQ(grid.y.size, n);
      EXPECT_EQ(grid.y.coordinate(0) == -90, r.south == -90) << n;
      EXPECT_EQ(last(grid.y) == 90, r.north == 90) << n;
    }
  }
  EXPECT_EQ(globe_grid(globe, NodeCounts{36, 19}).x.spacing, 10);
}

TEST(GlobeGrid, DoesNotLeaveTheLatitudes) {
  const Grid grid = globe_grid({0, 10, -89.5, 89}, Spacing{7, 7});
  EXPECT_GE(grid.y.coordinate(0), -90);
  EXPECT_LE(last(grid.y), 90);
  EXPECT_THROW((void)globe_grid({0, 10, -91, 0}, Spacing{1, 1}), Error);
  EXPECT_THROW((void)globe_grid({0, 361, 0, 10}, Spacing{1, 1}), Error);
}

TEST(CoveringRegion, OfThePlaneIsTheBoundingBox) {
  const auto t = triangulated(PlanePoints{{3, 1}, {-2, 5}, {0, 0}});
  EXPECT_EQ(covering_region(*t), (Region{-2, 3, 0, 5}));
  EXPECT_THROW((void)covering_region(*triangulated(PlanePoints{})), Error);
}

TEST(CoveringRegion, OfTheGlobeIsTheShortestIntervalOfLongitudes) {
  const auto region = [](const SpherePoints& points) {
    return covering_region(*triangulated(points));
  };
  const Region europe =
      region({at_lonlat(-10, 35), at_lonlat(30, 40), at_lonlat(20, 70)});
  EXPECT_NEAR(europe.west, -10, 1e-12);
  EXPECT_NEAR(europe.east, 30, 1e-12);
  EXPECT_NEAR(europe.south, 35, 1e-12);
  EXPECT_NEAR(europe.north, 70, 1e-12);
  const Region fiji =
      region({at_lonlat(177, -19), at_lonlat(-179, -16), at_lonlat(178, -12)});
  EXPECT_NEAR(fiji.west, 177, 1e-12);
  EXPECT_NEAR(fiji.east, 181, 1e-12);
  const Region one = region({at_lonlat(12, 34)});
  EXPECT_EQ(one.west, one.east);
  EXPECT_THROW((void)region({}), Error);
}

TEST(CoveringRegion, IsTheGlobeWhenTheDataGoRoundItOrHoldAPole) {
  EXPECT_EQ(covering_region(*triangulated(support::uniform_directions(100, 1))), globe);
  const SpherePoints around_pole{at_lonlat(0, 60), at_lonlat(120, 60),
                                 at_lonlat(240, 60)};
  EXPECT_EQ(covering_region(*triangulated(around_pole)), globe);
  const SpherePoints at_pole{at_lonlat(0, 60), at_lonlat(50, 60), at_lonlat(0, 90)};
  EXPECT_EQ(covering_region(*triangulated(at_pole)), globe);
  const SpherePoints equator{at_lonlat(0, 0), at_lonlat(120, 0), at_lonlat(-120, 0)};
  EXPECT_EQ(covering_region(*triangulated(equator)), globe);
}

TEST(SuggestedSpacing, GivesAboutFourNodesForEachObservation) {
  EXPECT_EQ(suggested_plane_spacing({0, 1, 0, 1}, 25), (Spacing{0.1, 0.1}));
  EXPECT_EQ(suggested_plane_spacing({0, 2000, 0, 2000}, 10000), (Spacing{10, 10}));
  EXPECT_EQ(suggested_globe_spacing(globe, 5000), (Spacing{2, 2}));
  EXPECT_EQ(suggested_globe_spacing(globe, 3), (Spacing{10, 10}));
  support::SplitMix64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const double size = std::pow(10, random.between(-12, 12));
    const auto n = static_cast<std::int64_t>(10 + random.below(1000000));
    const double spacing = suggested_plane_spacing({0, size, 0, size}, n).x;
    const double nodes_each = size / spacing * (size / spacing) / static_cast<double>(n);
    EXPECT_GT(nodes_each, 1.5);
    EXPECT_LT(nodes_each, 10.1);
    const double digit = spacing / std::pow(10, std::floor(std::log10(spacing * 1.0001)));
    EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 ||
                std::abs(digit - 5) < 1e-9)
        << digit;
  }
}

TEST(SuggestedSpacing, OfARegionWithoutAreaIsPositive) {
  EXPECT_GT(suggested_plane_spacing({1, 1, 2, 2}, 1).x, 0);
  EXPECT_EQ(suggested_plane_spacing({0, 40, 2, 2}, 10), (Spacing{1, 1}));
}

TEST(WidenedRegion, LiesOnMultiplesOfTheSpacing) {
  EXPECT_EQ(widened_plane_region({0.5, 10.5, -0.5, 3}, {1, 1}), (Region{0, 11, -1, 3}));
  EXPECT_EQ(widened_globe_region({177.2, 181.3, -89.5, -70}, {2, 2}),
            (Region{176, 182, -90, -70}));
  EXPECT_EQ(widened_globe_region(globe, {7, 7}), globe);
  EXPECT_EQ(widened_globe_region({-179, 179, 0, 1}, {5, 5}), (Region{-180, 180, 0, 5}));
}

TEST(GridNodes, AreRowByRow) {
  const Grid grid = plane_grid({0, 2, 5, 6}, Spacing{1, 1});
  const PlanePoints nodes = plane_nodes(grid);
  ASSERT_EQ(nodes.size(), 6u);
  EXPECT_EQ(nodes[4], (tripack::Point2{1, 6}));
  EXPECT_EQ(globe_nodes(grid)[4], at_lonlat(1, 6));
  EXPECT_THROW((void)globe_nodes(plane_grid({0, 1, 89, 91}, Spacing{1, 1})), Error);
}

}  // namespace
}  // namespace delone::interp
