#include "stripack/editor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/defect.hpp"
#include "support/edit_sequence.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::shuffled;
using support::SphereFamily;
using support::SpherePoints;
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

Editor filled(const SpherePoints& points) {
  Editor editor;
  for (const Direction& p : points) editor.insert(p);
  return editor;
}

const Direction x_axis = Direction::from(1, 0, 0), y_axis = Direction::from(0, 1, 0),
                z_axis = Direction::from(0, 0, 1), opposite_x = Direction::from(-1, 0, 0),
                opposite_y = Direction::from(0, -1, 0),
                opposite_z = Direction::from(0, 0, -1);

TEST(SphereEditor, OfNothingIsTheEmptyTriangulation) {
  const Editor editor;
  EXPECT_EQ(editor.num_points(), 0);
  EXPECT_EQ(editor.triangulation().dimension(), -1);
}

TEST(SphereEditor, MakesATriangleOfThreePoints) {
  const Editor editor = filled({x_axis, y_axis, z_axis});
  EXPECT_EQ(editor.triangulation().triangles(),
            (std::vector<std::array<Node, 3>>{{0, 1, 2}}));
}

TEST(SphereEditor, GrowsFromAHemisphereToTheSphereAndBack) {
  Editor editor = filled({x_axis, y_axis, z_axis, opposite_x, opposite_y});
  expect_canonical(editor);
  EXPECT_EQ(editor.triangulation().boundary().size(), 4U);
  const Node south = editor.insert(opposite_z);
  expect_canonical(editor);
  EXPECT_TRUE(editor.triangulation().boundary().empty());
  EXPECT_EQ(editor.triangulation().num_triangles(), 8);
  editor.remove(south);
  expect_canonical(editor);
  EXPECT_EQ(editor.triangulation().boundary().size(), 4U);
}

// The boundary of the value an editor begins with has to be closed first.
TEST(SphereEditor, BeginsWithAHemisphereThatHasABoundary) {
  SpherePoints points = support::box_directions(400, 3, 0.5);
  Editor editor{Triangulation(points)};
  expect_canonical(editor);
  for (const Direction& p : {opposite_x, opposite_y, opposite_z, y_axis, z_axis}) {
    editor.insert(p);
    expect_canonical(editor);
  }
  EXPECT_TRUE(editor.triangulation().boundary().empty());
  for (Node row = 0; row < 400; ++row) editor.remove(row);
  expect_canonical(editor);
}

TEST(SphereEditor, GoesToAGreatCircleAndBack) {
  for (const int count : {3, 5, 12}) {
    SpherePoints points;
    for (int i = 0; i < 12; ++i)
      points.push_back(Direction::from(LonLat{30.0 * i * count / 12, 0}));
    points.push_back(z_axis);
    Editor editor = filled(points);
    for (int i = 0; i < 3; ++i) {
      expect_canonical(editor);
      editor.remove(12);
      expect_canonical(editor);
      EXPECT_EQ(editor.insert(i == 1 ? opposite_z : z_axis), 12);
    }
    editor.insert(opposite_z);
    editor.insert(z_axis);
    expect_canonical(editor);
  }
}

TEST(SphereEditor, TakesOppositePointsForOneCircleWithAnyThird) {
  Editor editor = filled({x_axis, opposite_x, y_axis});
  EXPECT_EQ(editor.triangulation().dimension(), 1);
  expect_canonical(editor);
  editor.insert(z_axis);
  EXPECT_EQ(editor.triangulation().dimension(), 2);
  expect_canonical(editor);
  editor.remove(2);
  EXPECT_EQ(editor.triangulation().dimension(), 1);
  expect_canonical(editor);
}

TEST(SphereEditor, CountsRowsOfOnePosition) {
  Editor editor = filled({x_axis, y_axis, z_axis, opposite_x});
  const Node again = editor.insert(y_axis);
  EXPECT_EQ(editor.num_points(), 5);
  EXPECT_EQ(editor.num_sites(), 4);
  expect_canonical(editor);
  editor.remove(1);
  expect_canonical(editor);
  EXPECT_EQ(editor.num_sites(), 4);
  editor.remove(again);
  EXPECT_EQ(editor.num_sites(), 3);
  expect_canonical(editor);
}

// (3, 4, 5) scaled so that the length is 1 to within rounding, an ulp more and less: one
// direction, of which the lowest triple stands for all and breaks ties.
TEST(SphereEditor, LetsTheLowestTripleOfADirectionStandForAll) {
  SpherePoints forms;
  for (int k = -2; k <= 2; ++k) {
    const double unit = (0x1p51 / 5 + k) * 0x1p-51;
    const double whole = std::ldexp(std::nearbyint(std::ldexp(unit, 50)), -50);
    forms.push_back(Direction::from(3 * whole, 4 * whole, 0));
  }
  SpherePoints points = forms;
  for (const double lat : {-36.0, 0.0, 36.0}) {
    for (int lon = 0; lon < 360; lon += 45)
      points.push_back(Direction::from(LonLat{static_cast<double>(lon), lat}));
  }
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Editor editor = filled(shuffled(points, seed));
    expect_canonical(editor);
    for (const Node row : shuffled(editor.rows(), seed)) {
      editor.remove(row);
      expect_canonical(editor);
    }
  }
}

TEST(SphereEditor, RefusesWhatIsNotThere) {
  Editor editor = filled({x_axis, y_axis});
  editor.remove(0);
  for (const Node row : {-1, 0, 2}) {
    EXPECT_THROW(editor.remove(row), Error);
    EXPECT_THROW(editor.move(row, z_axis), Error);
    EXPECT_THROW(static_cast<void>(editor.point(row)), Error);
  }
}

TEST(SphereEditor, IsAValue) {
  Editor editor = filled(support::uniform_directions(50, 3));
  const Triangulation before = editor.triangulation();
  Editor copy = editor;
  copy.remove(7);
  copy.insert(z_axis);
  EXPECT_TRUE(is_equal(editor.triangulation(), before));
  editor = copy;
  EXPECT_TRUE(is_equal(editor.triangulation(), copy.triangulation()));
  const Editor moved = std::move(copy);
  EXPECT_TRUE(is_equal(moved.triangulation(), editor.triangulation()));
}

// A pole with all meridians around it, as grids have.
TEST(SphereEditor, RemovesALargeHubInTimeProportionalToItsDegree) {
  SpherePoints points{z_axis, opposite_z};
  for (int i = 0; i < 20000; ++i)
    points.push_back(Direction::from(LonLat{0.018 * i, 60}));
  Editor editor{Triangulation(points)};
  for (int i = 0; i < 5; ++i) {
    editor.remove(0);
    EXPECT_EQ(editor.insert(z_axis), 0);
    editor.remove(1);
    EXPECT_EQ(editor.insert(opposite_z), 1);
  }
  expect_canonical(editor);
}

// Against the definition, in exact arithmetic that shares nothing with the library.
TEST(SphereEditor, HasOnlyTrianglesWithEmptyCircles) {
  SplitMix64 random(11);
  const auto component = [&] { return static_cast<double>(random.below(5)) - 2; };
  for (int trial = 0; trial < 40; ++trial) {
    SpherePoints pool{x_axis};
    while (pool.size() < 14) {
      const double x = component(), y = component(), z = component();
      if (x != 0 || y != 0 || z != 0) pool.push_back(Direction::from(x, y, z));
    }
    Editor editor;
    support::edit_at_random(editor, pool, 30, 6, random, [&] {
      const SpherePoints points = editor.points();
      if (points.empty() || points.size() > 12) return;
      const auto triangles = editor.triangulation().triangles();
      ASSERT_EQ(support::exact_defect(points, triangles).value_or("none"), "none");
    });
  }
}

class SphereEditorFamilies : public testing::TestWithParam<SphereFamily> {};

TEST_P(SphereEditorFamilies, StayCanonicalUnderRandomEdits) {
  for (const std::size_t n : {3UL, 5UL, 8UL, 16UL, 30UL}) {
    for (std::uint64_t seed = 1; seed <= (n < 16 ? 3 : 1); ++seed) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", seed = " + std::to_string(seed));
      const SpherePoints pool = GetParam().make(n, seed);
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

TEST_P(SphereEditorFamilies, GoDownToNothingAndUpAgain) {
  const SpherePoints points = GetParam().make(40, 2);
  Editor editor{Triangulation(points)};
  for (const Node row : shuffled(editor.rows(), 3)) {
    editor.remove(row);
    expect_canonical(editor);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_EQ(editor.num_sites(), 0);
  for (const Direction& p : shuffled(points, 4)) {
    editor.insert(p);
    expect_canonical(editor);
    ASSERT_FALSE(HasFatalFailure());
  }
}

TEST_P(SphereEditorFamilies, HaveNoDefectAfterManyEdits) {
  const SpherePoints pool = GetParam().make(600, 5);
  Editor editor{Triangulation(pool)};
  SplitMix64 random(6);
  support::edit_at_random(editor, pool, 400, 5, random, [] {});
  const Triangulation t = editor.triangulation();
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
  EXPECT_TRUE(is_equal(t, Triangulation(editor.points())));
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereEditorFamilies,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

}  // namespace
}  // namespace delone::stripack
