#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "delaunay/editable_set.hpp"
#include "delaunay/error.hpp"
#include "stripack/constrained_defect.hpp"
#include "stripack/editor.hpp"
#include "stripack/sphere_editing.hpp"
#include "support/forced_arcs.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::NodePair;
using support::SphereFamily;
using support::SpherePoints;
using support::SplitMix64;
using Set = delaunay::EditableSet<SphereEditing>;

ConstrainedTriangulation afresh(const SpherePoints& points, std::vector<NodePair> arcs) {
  return ConstrainedTriangulation({.points = points, .arcs = std::move(arcs)},
                                  {.domain = Domain::hull});
}

// The definition: what the editor holds is what its points and arcs give.
void expect_canonical(const Editor& editor) {
  support::expect_same(
      editor.constrained_triangulation(),
      afresh(editor.points(), support::places_of(editor.arcs(), editor.rows())));
}

void expect_canonical(const Set& set) {
  support::expect_surface(
      set, afresh(set.points(), support::places_of(set.arcs(), set.rows())));
}

bool refuses(const SpherePoints& points, std::vector<NodePair> arcs) {
  const auto [a, b] = arcs.back();
  if (SphereEditing::is_same(points[static_cast<std::size_t>(a)],
                             points[static_cast<std::size_t>(b)]))
    return true;
  try {
    afresh(points, std::move(arcs));
    return false;
  } catch (const Error&) {
    return true;
  }
}

SpherePoints directions(const std::vector<LonLat>& places) {
  SpherePoints points;
  for (const LonLat p : places) points.push_back(Direction::from(p));
  return points;
}

template <class E>
E filled(const SpherePoints& points) {
  E editor;
  for (const Direction& p : points) editor.insert(p, delaunay::none);
  return editor;
}

std::vector<std::int64_t> rows_of(const Error& error) {
  return {error.rows().begin(), error.rows().end()};
}

TEST(SphereEditorArcs, NameBothArcsThatWouldCrossAndChangeNothing) {
  auto editor = filled<Editor>(directions({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  editor.force_arc(0, 2);
  try {
    editor.force_arc(1, 3);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(rows_of(error), (std::vector<std::int64_t>{1, 3, 0, 2}));
  }
  expect_canonical(editor);
  editor.release_arc(0, 2);
  editor.force_arc(1, 3);
  expect_canonical(editor);
}

TEST(SphereEditorArcs, DoNotJoinAntipodes) {
  auto editor = filled<Editor>(directions({{10, 20}, {-170, -20}, {90, 0}, {0, 80}}));
  try {
    editor.force_arc(0, 1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(rows_of(error), (std::vector<std::int64_t>{0, 1}));
  }
  expect_canonical(editor);
}

TEST(SphereEditorArcs, HoldTheirEnds) {
  auto editor = filled<Editor>(support::uniform_directions(30, 2));
  editor.force_arc(3, 4);
  EXPECT_THROW(editor.remove(3), Error);
  EXPECT_THROW(editor.move(4, Direction::from(LonLat{1, 2})), Error);
  expect_canonical(editor);
}

TEST(SphereEditorArcs, AreDividedByPointsOnThemAndUniteWithoutThem) {
  auto editor = filled<Editor>(
      directions({{-60, 0}, {60, 0}, {0, 40}, {0, -40}, {20, 10}, {-20, -10}, {180, 0}}));
  editor.force_arc(0, 1);
  const Node on = editor.insert(Direction::from(LonLat{10, 0}));
  EXPECT_EQ(editor.constrained_triangulation().path(0), (std::vector<Node>{0, on, 1}));
  expect_canonical(editor);
  editor.insert(Direction::from(LonLat{-10, 0}));
  expect_canonical(editor);
  editor.remove(on);
  expect_canonical(editor);
}

// A wall on the boundary, and points beyond it: in front of it and behind they would have
// to be joined to its ends twice.
TEST(SphereEditorArcs, MayLieOnTheBoundaryOfAHemisphericalSet) {
  SplitMix64 random(3);
  for (int trial = 0; trial < 40; ++trial) {
    Set set;
    for (int i = 0; i < 12; ++i)
      set.insert(Direction::from(LonLat{random.between(-30, 30), random.between(5, 50)}),
                 delaunay::none);
    const Triangulation t(set.points());
    const std::vector<Node> boundary = t.boundary();
    for (std::size_t i = 0; i < boundary.size(); i += 2)
      set.force(boundary[i], boundary[(i + 1) % boundary.size()]);
    expect_canonical(set);
    for (int i = 0; i < 20; ++i) {
      set.insert(Direction::from(LonLat{random.between(-40, 40), random.between(-5, 60)}),
                 delaunay::none);
      expect_canonical(set);
    }
    ASSERT_FALSE(HasFatalFailure());
  }
}

TEST(SphereEditorArcs, StayWhileAHemisphereBecomesTheSphereAndBack) {
  Set set;
  const SpherePoints points = support::uniform_directions(60, 9);
  std::vector<Node> south;
  for (const Direction& p : points) {
    if (p.z() > 0.1) set.insert(p, delaunay::none);
  }
  int num_forced = 0;
  for (Node row = 0; row + 5 < set.num_rows(); row += 2) {
    try {
      set.force(row, row + 5);
      ++num_forced;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(num_forced, 2);
  expect_canonical(set);
  for (int i = 0; i < 2; ++i) {
    for (const Direction& p : points) {
      if (p.z() > 0) continue;
      south.push_back(set.insert(p, delaunay::none));
      expect_canonical(set);
    }
    for (const Node row : support::shuffled(south, 7)) {
      set.remove(row);
      expect_canonical(set);
      ASSERT_FALSE(HasFatalFailure());
    }
    south.clear();
  }
}

TEST(SphereEditorArcs, SurviveAGreatCircleAndComeBackWithTheSphere) {
  auto editor =
      filled<Editor>(directions({{0, 0}, {50, 0}, {100, 0}, {200, 0}, {20, 30}}));
  editor.force_arc(0, 2);
  editor.force_arc(2, 3);
  editor.remove(4);
  expect_canonical(editor);
  editor.insert(Direction::from(LonLat{20, -30}));
  editor.insert(Direction::from(LonLat{30, 0}));
  expect_canonical(editor);
  editor.insert(Direction::from(LonLat{40, 80}));
  expect_canonical(editor);
}

// One direction comes as triples of other lengths, which break ties another way.
TEST(SphereEditorArcs, TakeThePreferredFormOfADirection) {
  const SpherePoints points = support::radian_grid_directions(30);
  SplitMix64 random(1);
  auto set = filled<Set>(points);
  for (Node i = 0; i + 1 < set.num_rows(); i += 3) {
    try {
      set.force(i, i + 1);
    } catch (const Error&) {
    }
  }
  std::vector<Node> added;
  for (const Direction& p : points) {
    const double s = 1 - 0x1p-53;
    added.push_back(
        set.insert(Direction::from(p.x() * s, p.y() * s, p.z() * s), delaunay::none));
    expect_canonical(set);
    ASSERT_FALSE(HasFatalFailure());
  }
  for (const Node row : support::shuffled(added, 3)) {
    set.remove(row);
    expect_canonical(set);
    ASSERT_FALSE(HasFatalFailure());
  }
}

TEST(SphereEditorArcs, StayCanonicalInALargeSet) {
  auto editor = filled<Editor>(support::uniform_directions(2000, 3));
  SplitMix64 random(5);
  int num_forced = 0;
  for (int i = 0; i < 400; ++i) {
    try {
      editor.force_arc(static_cast<Node>(random.below(2000)),
                       static_cast<Node>(random.below(2000)));
      ++num_forced;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(num_forced, 5);
  for (Node row = 0; row < 1500; ++row) {
    try {
      editor.remove(row);
    } catch (const Error&) {
    }
  }
  EXPECT_LT(editor.num_points(), 700);
  expect_canonical(editor);
  EXPECT_EQ(find_defect(editor.constrained_triangulation()).value_or("none"), "none");
}

class SphereEditorArcsFamilies : public testing::TestWithParam<SphereFamily> {};

TEST_P(SphereEditorArcsFamilies, StayCanonicalUnderRandomEdits) {
  for (const std::size_t n : {4UL, 6UL, 9UL, 16UL}) {
    for (std::uint64_t seed = 1; seed <= (n < 16 ? 4 : 1); ++seed) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", seed = " + std::to_string(seed));
      const SpherePoints pool = GetParam().make(n, seed);
      if (pool.empty()) continue;
      SplitMix64 random(seed);
      support::SetEditor<Set> editor;
      const auto check = [&] { expect_canonical(editor.set); };
      for (const std::size_t grow : {9UL, 5UL, 2UL}) {
        support::edit_arcs_at_random(editor, pool, 2 * n, grow, random, refuses, check);
        ASSERT_FALSE(HasFailure());
      }
    }
  }
}

TEST_P(SphereEditorArcsFamilies, GiveTheConstrainedTriangulation) {
  const SpherePoints pool = GetParam().make(20, 3);
  if (pool.empty()) return;
  SplitMix64 random(8);
  Editor editor{Triangulation(pool)};
  support::edit_arcs_at_random(editor, pool, 40, 3, random, refuses,
                               [&] { expect_canonical(editor); });
  const Triangulation t = editor.triangulation();
  EXPECT_TRUE(t.adjacency() == Triangulation(editor.points()).adjacency());
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereEditorArcsFamilies,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

}  // namespace
}  // namespace delone::stripack
