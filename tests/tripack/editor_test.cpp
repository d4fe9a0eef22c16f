#include "tripack/editor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "support/edit_sequence.hpp"
#include "support/exact.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/defect.hpp"

namespace delone::tripack {
namespace {

using support::PlaneFamily;
using support::PlanePoints;
using support::shuffled;
using support::SplitMix64;

bool is_equal(const Triangulation& t, const Triangulation& u) {
  const auto equal = [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  };
  return t.adjacency() == u.adjacency() && equal(t.points(), u.points()) &&
         equal(t.rows(), u.rows()) && equal(t.sites(), u.sites()) &&
         t.dimension() == u.dimension() && t.num_triangles() == u.num_triangles();
}

// The definition of the editor: what it holds is what its points give.
void expect_canonical(const Editor& editor) {
  ASSERT_TRUE(is_equal(editor.triangulation(), Triangulation(editor.points())));
}

Editor filled(const PlanePoints& points) {
  Editor editor;
  for (const Point2 p : points) editor.insert(p);
  return editor;
}

TEST(PlaneEditor, OfNothingIsTheEmptyTriangulation) {
  const Editor editor;
  EXPECT_EQ(editor.num_rows(), 0);
  EXPECT_EQ(editor.num_points(), 0);
  EXPECT_EQ(editor.triangulation().dimension(), -1);
}

TEST(PlaneEditor, MakesATriangleOfThreePoints) {
  Editor editor;
  EXPECT_EQ(editor.insert({0, 0}), 0);
  EXPECT_EQ(editor.insert({1, 0}), 1);
  EXPECT_EQ(editor.insert({0, 1}), 2);
  EXPECT_EQ(editor.triangulation().triangles(),
            (std::vector<std::array<Node, 3>>{{0, 1, 2}}));
}

TEST(PlaneEditor, GivesTheRowRemovedLastAgain) {
  Editor editor = filled({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  editor.remove(1);
  editor.remove(2);
  EXPECT_EQ(editor.rows(), (std::vector<Node>{0, 3}));
  EXPECT_FALSE(editor.has(2));
  EXPECT_EQ(editor.insert({5, 5}), 2);
  EXPECT_EQ(editor.insert({6, 5}), 1);
  EXPECT_EQ(editor.insert({7, 5}), 4);
  EXPECT_EQ(editor.point(2), (Point2{5, 5}));
  EXPECT_EQ(editor.num_rows(), 5);
  expect_canonical(editor);
}

TEST(PlaneEditor, CountsRowsOfOnePosition) {
  Editor editor = filled({{0, 0}, {1, 0}, {0, 1}});
  const Node again = editor.insert({1, 0});
  EXPECT_EQ(editor.num_points(), 4);
  EXPECT_EQ(editor.num_sites(), 3);
  expect_canonical(editor);
  editor.remove(1);
  EXPECT_EQ(editor.num_sites(), 3);
  EXPECT_EQ(editor.point(again), (Point2{1, 0}));
  expect_canonical(editor);
  editor.remove(again);
  EXPECT_EQ(editor.num_sites(), 2);
  expect_canonical(editor);
}

TEST(PlaneEditor, TakesMinusZeroForZero) {
  Editor editor = filled({{0.0, 1.0}, {-0.0, 1.0}, {1, 1}, {1, -0.0}});
  EXPECT_EQ(editor.num_sites(), 3);
  expect_canonical(editor);
}

TEST(PlaneEditor, RefusesWhatIsNotThere) {
  Editor editor = filled({{0, 0}, {1, 0}});
  editor.remove(0);
  for (const Node row : {-1, 0, 2}) {
    EXPECT_THROW(editor.remove(row), Error);
    EXPECT_THROW(editor.move(row, {2, 2}), Error);
    EXPECT_THROW(static_cast<void>(editor.point(row)), Error);
  }
  try {
    editor.remove(7);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.rows()[0], 7);
  }
}

TEST(PlaneEditor, RefusesCoordinatesThatAreNotFiniteAndChangesNothing) {
  Editor editor = filled({{0, 0}, {1, 0}, {0, 1}});
  const Triangulation before = editor.triangulation();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(editor.insert({nan, 0}), Error);
  EXPECT_THROW(editor.insert({0, std::numeric_limits<double>::infinity()}), Error);
  EXPECT_THROW(editor.move(1, {0, nan}), Error);
  EXPECT_TRUE(is_equal(editor.triangulation(), before));
}

TEST(PlaneEditor, IgnoresAHintThatIsNotThere) {
  Editor editor = filled({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  editor.remove(3);
  editor.insert({0.25, 0.25}, 3);
  editor.insert({0.5, 0.25}, 99);
  expect_canonical(editor);
}

TEST(PlaneEditor, IsAValue) {
  Editor editor = filled(support::uniform_points(50, 3));
  const Triangulation before = editor.triangulation();
  Editor copy = editor;
  copy.remove(7);
  copy.insert({3, 3});
  EXPECT_TRUE(is_equal(editor.triangulation(), before));
  editor = copy;
  EXPECT_TRUE(is_equal(editor.triangulation(), copy.triangulation()));
  const Editor moved = std::move(copy);
  EXPECT_TRUE(is_equal(moved.triangulation(), editor.triangulation()));
}

// One point above a line of many: its removal and return change every neighbour.
TEST(PlaneEditor, GoesToALineAndBack) {
  PlanePoints line;
  for (int i = 0; i < 20; ++i) line.push_back({0.1 * i, 0.2 * i});
  line.push_back({0, 5});
  Editor editor = filled(shuffled(line, 1));
  const std::vector<Point2> points = editor.points();
  const auto apex = static_cast<Node>(
      std::find(points.begin(), points.end(), Point2{0, 5}) - points.begin());
  for (int i = 0; i < 3; ++i) {
    expect_canonical(editor);
    editor.remove(apex);
    expect_canonical(editor);
    EXPECT_EQ(editor.insert({0, 5}), apex);
  }
  editor.move(apex, {4, 8});
  expect_canonical(editor);
  editor.move(apex, {4, 9});
  expect_canonical(editor);
}

// The hull shrinks past points that lie on one line, and grows over them again.
TEST(PlaneEditor, PeelsALattice) {
  const PlanePoints points = support::lattice_points(49);
  Editor editor = filled(points);
  for (Node row = 0; row < 49; ++row) {
    editor.remove(row);
    expect_canonical(editor);
  }
  EXPECT_EQ(editor.num_points(), 0);
  for (const Point2 p : shuffled(points, 5)) {
    editor.insert(p);
    expect_canonical(editor);
  }
}

TEST(PlaneEditor, RemovesAHub) {
  const PlanePoints points = support::wheel_points(200);
  Editor editor{Triangulation(points)};
  for (const Node row : {199, 0, 100, 50}) {
    editor.remove(row);
    expect_canonical(editor);
  }
}

// A hub of 20,000 would take minutes at the square of its degree.
TEST(PlaneEditor, RemovesALargeHubInTimeProportionalToItsDegree) {
  const PlanePoints points = support::wheel_points(20001);
  Editor editor{Triangulation(points)};
  for (int i = 0; i < 10; ++i) {
    editor.remove(20000);
    EXPECT_EQ(editor.insert(points.back()), 20000);
  }
  expect_canonical(editor);
}

TEST(PlaneEditor, MovesAcrossTheSet) {
  const PlanePoints points = support::uniform_points(300, 9);
  Editor editor{Triangulation(points)};
  SplitMix64 random(4);
  for (int i = 0; i < 100; ++i) {
    editor.move(static_cast<Node>(random.below(300)),
                {random.between(-0.5, 1.5), random.between(-0.5, 1.5)});
    expect_canonical(editor);
  }
}

TEST(PlaneEditor, FollowsPointsFarBeyondWhereItBegan) {
  Editor editor = filled({{0, 0}, {1, 0}, {0, 1}});
  double radius = 1;
  for (int i = 0; i < 300; ++i, radius *= 10) {
    editor.insert({radius * std::cos(i), radius * std::sin(i)});
    if (i % 50 == 0) expect_canonical(editor);
  }
  expect_canonical(editor);
}

// Against the definition, in exact arithmetic that shares nothing with the library.
TEST(PlaneEditor, HasOnlyTrianglesWithEmptyCircles) {
  SplitMix64 random(11);
  for (int trial = 0; trial < 40; ++trial) {
    PlanePoints pool;
    for (int i = 0; i < 14; ++i)
      pool.push_back(
          {static_cast<double>(random.below(4)), static_cast<double>(random.below(4))});
    Editor editor;
    support::edit_at_random(editor, pool, 30, 6, random, [&] {
      const PlanePoints points = editor.points();
      if (points.empty() || points.size() > 12) return;
      const auto triangles = editor.triangulation().triangles();
      ASSERT_EQ(support::exact_defect(points, triangles).value_or("none"), "none");
    });
  }
}

class PlaneEditorFamilies : public testing::TestWithParam<PlaneFamily> {};

TEST_P(PlaneEditorFamilies, StayCanonicalUnderRandomEdits) {
  for (const std::size_t n : {3UL, 5UL, 8UL, 16UL, 30UL}) {
    for (std::uint64_t seed = 1; seed <= (n < 16 ? 3 : 1); ++seed) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", seed = " + std::to_string(seed));
      const PlanePoints pool = GetParam().make(n, seed);
      if (pool.empty()) continue;
      SplitMix64 random(seed);
      Editor editor;
      const auto check = [&] { expect_canonical(editor); };
      support::edit_at_random(editor, pool, n, 9, random, check);
      support::edit_at_random(editor, pool, 2 * n, 5, random, check);
      support::edit_at_random(editor, pool, 2 * n, 0, random, check);
      if (HasFatalFailure()) return;
    }
  }
}

TEST_P(PlaneEditorFamilies, GoDownToNothingAndUpAgain) {
  const PlanePoints points = GetParam().make(60, 2);
  Editor editor{Triangulation(points)};
  std::vector<Node> rows = shuffled(editor.rows(), 3);
  for (const Node row : rows) {
    editor.remove(row);
    expect_canonical(editor);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_EQ(editor.num_sites(), 0);
  for (const Point2 p : shuffled(points, 4)) {
    editor.insert(p);
    expect_canonical(editor);
    ASSERT_FALSE(HasFatalFailure());
  }
}

TEST_P(PlaneEditorFamilies, HaveNoDefectAfterManyEdits) {
  const PlanePoints pool = GetParam().make(1000, 5);
  Editor editor{Triangulation(pool)};
  SplitMix64 random(6);
  support::edit_at_random(editor, pool, 600, 5, random, [] {});
  const Triangulation t = editor.triangulation();
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
  EXPECT_TRUE(is_equal(t, Triangulation(editor.points())));
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneEditorFamilies,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

}  // namespace
}  // namespace delone::tripack
