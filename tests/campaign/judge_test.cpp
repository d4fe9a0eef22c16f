// The judge itself: its predicates against GMP, what it accepts against brute force, and
// that it refuses every kind of wrong list.

#include "campaign/judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "campaign/families.hpp"
#include "campaign/judge_predicates.hpp"
#include "campaign/trial.hpp"
#include "stripack/triangulation.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "tripack/triangulation.hpp"

namespace delone::campaign {
namespace {

using stripack::Direction;
using tripack::Point2;

template <class Triangulation>
Answer answer_of(const Triangulation& t) {
  return {t.dimension(), t.triangles(), t.boundary()};
}

// Four points of a set, close to one another in its order more often than not.
template <class Points>
auto quadruple(const Points& points, support::SplitMix64& random) {
  std::array<typename Points::value_type, 4> q;
  const std::size_t start = random.below(points.size());
  for (auto& p : q) p = points[(start + random.below(8)) % points.size()];
  return q;
}

template <class Points>
int num_ties_compared(const Points& points, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  int ties = 0;
  for (int i = 0; i < 40 && !points.empty(); ++i) {
    const auto [a, b, c, d] = quadruple(points, random);
    EXPECT_EQ(orientation(a, b, c), support::exact_orientation(a, b, c));
    const int sign = support::exact_in_circle(a, b, c, d);
    EXPECT_EQ(in_circle(a, b, c, d), sign);
    ties += sign == 0 ? 1 : 0;
  }
  return ties;
}

TEST(JudgePredicates, AgreeWithExactArithmeticInThePlane) {
  for (const Family& family : plane_families()) {
    SCOPED_TRACE(family.id);
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
      num_ties_compared(make_plane_set(family, seed, 40).points, seed);
  }
}

TEST(JudgePredicates, AgreeWithExactArithmeticOnTheSphere) {
  for (const Family& family : sphere_families()) {
    SCOPED_TRACE(family.id);
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
      num_ties_compared(make_sphere_set(family, seed, 40).points, seed);
  }
}

TEST(JudgePredicates, KnowRaysOfDifferentLengths) {
  const Direction a = Direction::from(0.6, 0.8, 0), b = Direction::from(0.8, 0.6, 0);
  EXPECT_TRUE(is_same_ray(a, a));
  EXPECT_FALSE(is_same_ray(a, b));
  const Direction opposite = Direction::from(-0.6, -0.8, 0);
  EXPECT_TRUE(is_parallel(a, opposite));
  EXPECT_FALSE(is_same_ray(a, opposite));
}

// A triangulation to spoil: no ties at first.
struct Plane {
  std::vector<Point2> rows = support::uniform_points(30, 5);
  Answer answer = answer_of(tripack::Triangulation(rows));
};
struct Sphere {
  std::vector<Direction> rows = support::uniform_directions(30, 5);
  Answer answer = answer_of(stripack::Triangulation(rows));
};

// The two triangles of an inner edge with the other diagonal.
void flip(std::vector<Triangle>& triangles, std::size_t i, std::size_t j) {
  const auto corner = [&](std::size_t t, std::size_t k) { return triangles[t][k % 3]; };
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      if (corner(i, k) != corner(j, l + 1) || corner(i, k + 1) != corner(j, l)) continue;
      const Row a = corner(i, k), b = corner(i, k + 1), c = corner(i, k + 2),
                d = corner(j, l + 2);
      for (auto& [t, u] :
           {std::pair{i, Triangle{c, a, d}}, std::pair{j, Triangle{d, b, c}}}) {
        Triangle turned = u;
        std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()),
                    turned.end());
        triangles[t] = turned;
      }
      std::sort(triangles.begin(), triangles.end());
      return;
    }
  }
}

template <class Set>
class Judge : public testing::Test {};
using Sets = testing::Types<Plane, Sphere>;
TYPED_TEST_SUITE(Judge, Sets);

TYPED_TEST(Judge, AcceptsTheOnlyTriangulation) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    TypeParam set;
    set.rows = support::shuffled(set.rows, seed);
    set.rows.resize(9);
    // Without ties these are the triangulation, found without it. On the sphere they are
    // all of it, since the set is in general position.
    set.answer.triangles = support::empty_circle_triangles(
        std::span<const typename decltype(set.rows)::value_type>(set.rows));
    if constexpr (std::is_same_v<TypeParam, Plane>) {
      set.answer.boundary = tripack::Triangulation(set.rows).boundary();
    } else {
      set.answer.boundary = stripack::Triangulation(set.rows).boundary();
    }
    const Verdict verdict = judge(set.rows, set.answer);
    EXPECT_EQ(verdict.defect.value_or("none"), "none");
    EXPECT_EQ(verdict.num_ties, 0);
  }
}

TYPED_TEST(Judge, RefusesEveryFlip) {
  const TypeParam set;
  int num_flips = 0;
  for (std::size_t i = 0; i < set.answer.triangles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Answer flipped = set.answer;
      flip(flipped.triangles, i, j);
      if (flipped.triangles == set.answer.triangles) continue;
      ++num_flips;
      EXPECT_TRUE(judge(set.rows, flipped).defect);
    }
  }
  EXPECT_GT(num_flips, 40);
}

TYPED_TEST(Judge, RefusesAListThatIsNotWhole) {
  const TypeParam set;
  EXPECT_FALSE(judge(set.rows, set.answer).defect);
  const auto spoiled = [&](auto change) {
    Answer answer = set.answer;
    change(answer);
    return judge(set.rows, answer).defect;
  };
  EXPECT_TRUE(spoiled([](Answer& a) { a.triangles.pop_back(); }));
  EXPECT_TRUE(spoiled([](Answer& a) { a.triangles.back() = a.triangles.front(); }));
  EXPECT_TRUE(spoiled([](Answer& a) { std::swap(a.triangles[3], a.triangles[4]); }));
  EXPECT_TRUE(
      spoiled([](Answer& a) { std::swap(a.triangles[3][1], a.triangles[3][2]); }));
  EXPECT_TRUE(spoiled([](Answer& a) { a.triangles[0][1] = 99; }));
  EXPECT_TRUE(spoiled([](Answer& a) { a.triangles.clear(); }));
  EXPECT_TRUE(spoiled([](Answer& a) { a.dimension = 1; }));
  EXPECT_TRUE(spoiled([](Answer& a) { a.boundary.push_back(0); }));
}

TYPED_TEST(Judge, RefusesARowThatRepeatsAnEarlierOne) {
  TypeParam set;
  const Triangle last = set.answer.triangles.back();
  set.rows.push_back(set.rows[static_cast<std::size_t>(last[2])]);
  EXPECT_FALSE(judge(set.rows, set.answer).defect);
  set.answer.triangles.back()[2] = static_cast<Row>(set.rows.size()) - 1;
  EXPECT_TRUE(judge(set.rows, set.answer).defect);
}

TEST(JudgeOfThePlane, TakesOneOfTheTwoDiagonalsOfASquare) {
  const std::vector<Point2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Answer canonical{2, {{0, 1, 3}, {1, 2, 3}}, {0, 1, 2, 3}},
      other{2, {{0, 1, 2}, {0, 2, 3}}, {0, 1, 2, 3}};
  EXPECT_FALSE(judge(square, canonical).defect);
  EXPECT_EQ(judge(square, canonical).num_ties, 1);
  EXPECT_TRUE(judge(square, other).defect);
}

TEST(JudgeOfTheSphere, TakesOneOfTheTwoDiagonalsOfEveryFaceOfACube) {
  std::vector<Direction> cube;
  for (int i = 0; i < 8; ++i)
    cube.push_back(Direction::from(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  const Answer answer = answer_of(stripack::Triangulation(cube));
  EXPECT_FALSE(judge(cube, answer).defect);
  EXPECT_EQ(judge(cube, answer).num_ties, 6);
  int num_refused = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Answer flipped = answer;
      flip(flipped.triangles, i, j);
      num_refused += judge(cube, flipped).defect ? 1 : 0;
    }
  }
  EXPECT_EQ(num_refused, 18);  // one for each edge: ties and the cube's own
}

TEST(Trial, IsAFunctionOfFamilySeedAndSize) {
  for (const Family& family : all_families()) {
    EXPECT_EQ(corpus_text(family, {7, 20}), corpus_text(family, {7, 20}));
    EXPECT_FALSE(run_trial(family, {7, 20}).defect) << family.id;
  }
  EXPECT_EQ(all_families().size(), 29u);
}

TEST(Trial, SizesReachFromThreeToTheLargest) {
  std::size_t least = 2000, most = 0;
  for (std::uint64_t seed = 0; seed < 100000; ++seed) {
    const std::size_t n = size_of(seed, 2000);
    least = std::min(least, n);
    most = std::max(most, n);
  }
  EXPECT_EQ(least, 3u);
  EXPECT_GT(most, 1700u);
  EXPECT_LE(most, 2000u);
}

}  // namespace
}  // namespace delone::campaign
