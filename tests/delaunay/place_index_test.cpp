#include "delaunay/place_index.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "support/random.hpp"

namespace delone::delaunay {
namespace {

const auto accept_all = [](Site, std::uint64_t) { return true; };

TEST(PlaceIndex, KnowsNothingAtFirst) {
  PlaceIndex index;
  EXPECT_EQ(index.near({5, 7}, accept_all), none);
}

TEST(PlaceIndex, GivesTheNodeOfThePartThatHoldsThePlace) {
  PlaceIndex index;
  index.improve({0, 0}, 3);
  index.improve({0xFFFFFFFFu, 0}, 4);
  EXPECT_EQ(index.near({1, 1}, accept_all), 3);
  EXPECT_EQ(index.near({0xF0000000u, 9}, accept_all), 4);
}

TEST(PlaceIndex, CutsAPartThatIsGivenASecondNode) {
  PlaceIndex index;
  index.improve({0, 0}, 3);
  EXPECT_EQ(index.num_cells(), 1U);
  index.improve({0x30000000u, 0x30000000u}, 5);
  EXPECT_EQ(index.num_cells(), 2U);
  EXPECT_EQ(index.near({0x3FFFFFFFu, 0x3FFFFFFFu}, accept_all), 5);
  EXPECT_EQ(index.near({0, 0}, accept_all), 3);
  index.improve({0, 0}, 6);
  EXPECT_EQ(index.num_cells(), 2U);
  EXPECT_EQ(index.near({0, 0}, accept_all), 6);
}

TEST(PlaceIndex, AsksAroundIfTheNameIsOutOfDate) {
  PlaceIndex index;
  index.improve({0, 0}, 3);
  index.improve({0x80000000u, 0}, 4);
  const auto not_3 = [](Site v, std::uint64_t) { return v != 3; };
  EXPECT_EQ(index.near({0, 0}, not_3), 4);
  EXPECT_EQ(index.near({0, 0}, accept_all), 4) << "the name accepted is noted";
}

TEST(PlaceIndex, ReplacesANodeThatGoes) {
  PlaceIndex index;
  index.improve({0, 0}, 3);
  index.replace({0, 0}, 4, 9);
  EXPECT_EQ(index.near({0, 0}, accept_all), 3);
  index.replace({0, 0}, 3, 9);
  EXPECT_EQ(index.near({0, 0}, accept_all), 9);
}

TEST(PlaceIndex, StopsCuttingAtTheSmallestCell) {
  PlaceIndex index;
  for (Site v = 0; v < 100; ++v) index.improve({7, 7}, v);
  EXPECT_LE(index.num_cells(), 16U);
  EXPECT_EQ(index.near({7, 7}, accept_all), 99);
}

// What is accepted is near: no farther than twice the cell that was cut last.
TEST(PlaceIndex, FindsNodesNearEveryPlaceOnceAllAreIn) {
  PlaceIndex index;
  support::SplitMix64 random(1);
  const auto place = [&] {
    return Place{static_cast<std::uint32_t>(random.next()),
                 static_cast<std::uint32_t>(random.next())};
  };
  std::vector<Place> places;
  for (Site v = 0; v < 10000; ++v) {
    places.push_back(place());
    index.improve(places.back(), v);
  }
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    const Place p = place(),
                q = places[static_cast<std::size_t>(index.near(p, accept_all))];
    const double du = (static_cast<double>(p.u) - q.u) * 0x1p-32;
    const double dv = (static_cast<double>(p.v) - q.v) * 0x1p-32;
    sum += du * du + dv * dv;
  }
  EXPECT_LT(sum / 1000, 0.01);
}

}  // namespace
}  // namespace delone::delaunay
