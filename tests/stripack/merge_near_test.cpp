// Near repeats against looking at all pairs, in exact arithmetic where there is any.

#include "stripack/merge_near.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/great_circle.hpp"
#include "support/exact_distance.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using Points = std::vector<Direction>;
using delaunay::Node;

bool is_before(const Direction& a, const Direction& b) {
  return lexicographically_less(a, b);
}

bool are_near(const Direction& a, const Direction& b, double distance) {
  return angle(a, b) <= distance || is_same_direction(a, b);
}

// The definition, word by word.
std::vector<Node> merged_slowly(const Points& points, double distance) {
  std::vector<Node> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Node>(i);
  const auto at = [&](Node row) -> const Direction& {
    return points[static_cast<std::size_t>(row)];
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](Node a, Node b) { return is_before(at(a), at(b)); });
  std::vector<Node> kept;
  for (const Node row : order) {
    if (std::ranges::none_of(kept,
                             [&](Node k) { return are_near(at(row), at(k), distance); }))
      kept.push_back(row);
  }
  std::vector<Node> result(points.size());
  for (const Node row : order) {
    Node best = delaunay::none;
    for (const Node k : kept) {  // in the order that breaks ties
      if (are_near(at(row), at(k), distance) &&
          (best == delaunay::none ||
           support::exact_compare_distances(at(row), at(k), at(best)) < 0))
        best = k;
    }
    result[static_cast<std::size_t>(row)] = best;
  }
  return result;
}

class SphereMergeNear : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereMergeNear, KeepsAndMergesByTheDefinition) {
  for (const std::size_t n : {1, 2, 5, 80}) {
    const Points points = GetParam().make(n, 6);
    for (const double distance : {0.0, 1e-9, 0.03, 0.3, 1.0, 2.5, 40.0}) {
      const MergedRows merged = merge_near(points, distance);
      EXPECT_EQ(merged.stands_for, merged_slowly(points, distance))
          << "n = " << n << ", distance " << distance;
    }
  }
}

TEST_P(SphereMergeNear, DoesNotDependOnTheOrderOfRows) {
  const Points points = GetParam().make(80, 6), mixed = support::shuffled(points, 1);
  for (const double distance : {0.0, 0.1, 1.5}) {
    const MergedRows a = merge_near(points, distance), b = merge_near(mixed, distance);
    EXPECT_EQ(a.num_kept, b.num_kept);
    const auto kept_positions = [](const Points& all, const MergedRows& merged) {
      Points kept;
      for (const Node row : merged.stands_for)
        kept.push_back(all[static_cast<std::size_t>(row)]);
      std::ranges::sort(kept, is_before);
      return kept;
    };
    EXPECT_TRUE(kept_positions(points, a) == kept_positions(mixed, b));
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereMergeNear,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(SphereMergeNear, RefusesDistancesThatCannotBe) {
  for (const double distance : {-1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(static_cast<void>(merge_near(Points{}, distance)), Error);
  EXPECT_EQ(merge_near(Points{}, 1).num_kept, 0);
}

TEST(SphereMergeNear, KnowsNoDateLineAndOnePole) {
  const Points points{Direction::from(LonLat{179.9, 10}),
                      Direction::from(LonLat{-179.9, 10}),
                      Direction::from(LonLat{0, 89.95}),
                      Direction::from(LonLat{180, 89.95}), Direction::from(LonLat{0, 0})};
  EXPECT_EQ(merge_near(points, 0.21 * 3.14159 / 180).num_kept, 3);
}

TEST(SphereMergeNear, OnTheEllipsoidMeasuresGeodesics) {
  // A degree of latitude: 110.574 km at the equator, 111.694 km at the pole.
  const Points points{Direction::from(LonLat{0, 0}), Direction::from(LonLat{0, 1}),
                      Direction::from(LonLat{0, 89}), Direction::from(LonLat{0, 90})};
  EXPECT_EQ(merge_near_wgs84(points, 110).num_kept, 4);
  EXPECT_EQ(merge_near_wgs84(points, 111).num_kept, 3);
  EXPECT_EQ(merge_near_wgs84(points, 112).num_kept, 2);
}

}  // namespace
}  // namespace delone::stripack
