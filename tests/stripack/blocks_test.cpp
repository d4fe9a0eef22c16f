// Blocks of longitude and latitude: wraps, poles, regions across the date line.

#include "stripack/blocks.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "delaunay/error.hpp"

namespace delone::stripack {
namespace {

using Numbers = std::vector<double>;
using Points = std::vector<LonLat>;

TEST(SphereBlocks, EveryWrapOfALongitudeIsInOneBlock) {
  const Points points{{-10, 5}, {350, 5}, {710, 5}, {-370, 5}};
  const Blocks blocks =
      block_reduce(points, Numbers{1, 2, 3, 4}, {}, {.dx = 10, .dy = 10});
  EXPECT_EQ(blocks.x, (Numbers{-10}));
  EXPECT_EQ(blocks.value, (Numbers{2.5}));
}

TEST(SphereBlocks, TheDateLineDividesBlocksUnlessTheRegionCrossesIt) {
  const Points points{{179, 1}, {-179, 1}, {180, 1}, {-180, 1}};
  BlockOptions options{.dx = 10, .dy = 10};
  const Blocks apart = block_reduce(points, {}, {}, options);
  EXPECT_EQ(apart.count, (std::vector<std::int64_t>{3, 1}));
  options.region = BlockRegion{175, 185, 0, 10};
  const Blocks together = block_reduce(points, {}, {}, options);
  EXPECT_EQ(together.count, (std::vector<std::int64_t>{4}));
  EXPECT_EQ(together.x, (Numbers{180}));
}

TEST(SphereBlocks, APoleIsOnePoint) {
  const Points points{{-120, 90}, {0, 90}, {77, 90}, {0, -90}, {9, -90}};
  const Blocks blocks = block_reduce(points, {}, {}, {.dx = 30, .dy = 30});
  EXPECT_EQ(blocks.count, (std::vector<std::int64_t>{2, 3}));
  EXPECT_EQ(blocks.y, (Numbers{-90, 90}));
}

TEST(SphereBlocks, RefuseLatitudesBeyondThePolesAndRegionsBeyondTheCircle) {
  const Points points{{0, 0}, {0, 91}};
  try {
    static_cast<void>(block_reduce(points, {}, {}, {.dx = 1, .dy = 1}));
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.rows().size(), 1u);
    EXPECT_EQ(error.rows()[0], 1);
  }
  EXPECT_THROW(static_cast<void>(block_reduce(
                   Points{{0, 0}}, {}, {},
                   {.dx = 1, .dy = 1, .region = BlockRegion{-180, 181, -90, 90}})),
               Error);
}

}  // namespace
}  // namespace delone::stripack
