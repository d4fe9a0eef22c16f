// Near repeats against looking at all pairs, in exact arithmetic where there is any.

#include "tripack/merge_near.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "delaunay/error.hpp"
#include "support/exact_distance.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"

namespace delone::tripack {
namespace {

using Points = std::vector<Point2>;
using delaunay::Node;

bool is_before(Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

bool are_near(Point2 a, Point2 b, double distance) {
  return support::exact_is_within(a, b, distance);
}

// The definition, word by word.
std::vector<Node> merged_slowly(const Points& points, double distance) {
  std::vector<Node> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Node>(i);
  const auto at = [&](Node row) -> const Point2& {
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

class PlaneMergeNear : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneMergeNear, KeepsAndMergesByTheDefinition) {
  for (const std::size_t n : {1, 2, 5, 80}) {
    const Points points = GetParam().make(n, 6);
    for (const double distance : {0.0, 1e-9, 0.03, 0.3, 1.0, 2.5, 40.0}) {
      const MergedRows merged = merge_near(points, distance);
      EXPECT_EQ(merged.stands_for, merged_slowly(points, distance))
          << "n = " << n << ", distance " << distance;
    }
  }
}

TEST_P(PlaneMergeNear, DoesNotDependOnTheOrderOfRows) {
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

INSTANTIATE_TEST_SUITE_P(Plane, PlaneMergeNear,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(PlaneMergeNear, RefusesDistancesThatCannotBe) {
  for (const double distance : {-1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(static_cast<void>(merge_near(Points{}, distance)), Error);
  EXPECT_EQ(merge_near(Points{}, 1).num_kept, 0);
}

TEST(PlaneMergeNear, IsExactAtTheEdge) {
  // 0.1 + 0.2 is farther than 0.3 from 0 by an ulp.
  EXPECT_EQ(merge_near(Points{{0, 0}, {0.1 + 0.2, 0}}, 0.3).num_kept, 2);
  EXPECT_EQ(merge_near(Points{{0, 0}, {0.3, 0}}, 0.3).num_kept, 1);
  EXPECT_EQ(merge_near(Points{{5, 5}, {8, 9}}, 5).num_kept, 1);
}

TEST(PlaneMergeNear, NamesTheRowThatIsNotFinite) {
  try {
    static_cast<void>(merge_near(Points{{0, 0}, {0, std::nan("")}}, 1));
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.rows().size(), 1u);
    EXPECT_EQ(error.rows()[0], 1);
  }
}

}  // namespace
}  // namespace delone::tripack
