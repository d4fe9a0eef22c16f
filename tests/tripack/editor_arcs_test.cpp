#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "delaunay/editable_set.hpp"
#include "delaunay/error.hpp"
#include "support/forced_arcs.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/constrained_defect.hpp"
#include "tripack/editor.hpp"
#include "tripack/plane_editing.hpp"

namespace delone::tripack {
namespace {

using support::NodePair;
using support::PlaneFamily;
using support::PlanePoints;
using support::SplitMix64;
using Set = delaunay::EditableSet<PlaneEditing>;

ConstrainedTriangulation afresh(const PlanePoints& points, std::vector<NodePair> arcs) {
  return ConstrainedTriangulation({.points = points, .segments = std::move(arcs)},
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

bool refuses(const PlanePoints& points, std::vector<NodePair> arcs) {
  const NodePair last = arcs.back();
  if (points[static_cast<std::size_t>(last[0])] ==
      points[static_cast<std::size_t>(last[1])])
    return true;
  try {
    afresh(points, std::move(arcs));
    return false;
  } catch (const Error&) {
    return true;
  }
}

Editor filled(const PlanePoints& points) {
  Editor editor;
  for (const Point2 p : points) editor.insert(p);
  return editor;
}

const PlanePoints square{{0, 0}, {2, 0}, {2, 2.5}, {0, 2}};

TEST(PlaneEditorArcs, ForceTheOtherDiagonal) {
  Editor editor = filled(square);
  const auto before = editor.constrained_triangulation().triangles();
  const bool has_02 = before[0] == std::array<Node, 3>{0, 1, 2};
  const Node a = has_02 ? 1 : 0, b = has_02 ? 3 : 2;
  editor.force_arc(b, a);
  EXPECT_TRUE(editor.is_forced(a, b));
  EXPECT_TRUE(editor.is_forced(b, a));
  EXPECT_EQ(editor.arcs(), (std::vector<NodePair>{{a, b}}));
  EXPECT_NE(editor.constrained_triangulation().triangles(), before);
  expect_canonical(editor);
  EXPECT_EQ(editor.triangulation().triangles(), before);
  editor.release_arc(a, b);
  EXPECT_TRUE(editor.arcs().empty());
  EXPECT_EQ(editor.constrained_triangulation().triangles(), before);
}

TEST(PlaneEditorArcs, NameBothArcsThatWouldCrossAndChangeNothing) {
  Editor editor = filled(square);
  editor.force_arc(0, 2);
  try {
    editor.force_arc(1, 3);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::vector<std::int64_t>(error.rows().begin(), error.rows().end()),
              (std::vector<std::int64_t>{1, 3, 0, 2}));
    EXPECT_NE(std::string(error.what()).find("1-3"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("0-2"), std::string::npos);
  }
  EXPECT_FALSE(editor.is_forced(1, 3));
  expect_canonical(editor);
}

// The crossing is on the second piece: the first is forced by then.
TEST(PlaneEditorArcs, TakeBackPiecesBeforeACrossing) {
  Set set;
  for (const Point2 p : PlanePoints{
           {0, 0}, {1, 0}, {2, 0}, {3, -1}, {3, 1}, {5, 0}, {0.5, 0.1}, {0.5, -0.1}})
    set.insert(p, delaunay::none);
  set.force(0, 1);
  set.force(3, 4);
  EXPECT_THROW(set.force(0, 5), Error);
  EXPECT_THROW(set.force(5, 0), Error);
  expect_canonical(set);
  set.release(3, 4);
  set.force(0, 5);
  expect_canonical(set);
}

TEST(PlaneEditorArcs, RefuseWhatIsNoArc) {
  Editor editor = filled(square);
  const Node again = editor.insert(square[0]);
  EXPECT_THROW(editor.force_arc(0, 0), Error);
  EXPECT_THROW(editor.force_arc(0, again), Error);
  EXPECT_THROW(editor.force_arc(0, 17), Error);
  EXPECT_THROW(editor.force_arc(-1, 0), Error);
  EXPECT_THROW(editor.release_arc(0, 1), Error);
  editor.force_arc(0, 1);
  editor.force_arc(1, 0);
  editor.release_arc(0, 1);
  EXPECT_THROW(editor.release_arc(0, 1), Error);
  expect_canonical(editor);
}

TEST(PlaneEditorArcs, HoldTheirEnds) {
  Editor editor = filled(square);
  editor.force_arc(0, 2);
  EXPECT_THROW(editor.remove(0), Error);
  EXPECT_THROW(editor.move(2, {9, 9}), Error);
  expect_canonical(editor);
  editor.remove(1);
  editor.release_arc(0, 2);
  editor.remove(0);
  expect_canonical(editor);
}

TEST(PlaneEditorArcs, AreDividedByPointsOnThemAndUniteWithoutThem) {
  Editor editor = filled({{0, 0}, {4, 0}, {2, 3}, {2, -3}, {1, 1}, {3, -1}});
  editor.force_arc(0, 1);
  const Node on = editor.insert({1, 0});
  EXPECT_EQ(editor.constrained_triangulation().path(0), (std::vector<Node>{0, on, 1}));
  expect_canonical(editor);
  const Node also = editor.insert({3, 0});
  expect_canonical(editor);
  editor.remove(on);
  expect_canonical(editor);
  editor.move(also, {2, 0});
  expect_canonical(editor);
  editor.remove(also);
  EXPECT_EQ(editor.constrained_triangulation().path(0), (std::vector<Node>{0, 1}));
  expect_canonical(editor);
}

TEST(PlaneEditorArcs, MayShareAPointButThenItStays) {
  Editor editor = filled({{-1, -1}, {1, 1}, {-1, 1}, {1, -1}, {0, 0}});
  editor.force_arc(0, 1);
  editor.force_arc(2, 3);
  expect_canonical(editor);
  try {
    editor.remove(4);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::vector<std::int64_t>(error.rows().begin(), error.rows().end()),
              (std::vector<std::int64_t>{4, 0, 1, 2, 3}));
  }
  EXPECT_THROW(editor.move(4, {0.5, 0.5}), Error);
  expect_canonical(editor);
  editor.release_arc(0, 1);
  editor.remove(4);
  expect_canonical(editor);
}

TEST(PlaneEditorArcs, MayOverlap) {
  Set set;
  for (const Point2 p :
       PlanePoints{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 1}, {2, -1}, {2.5, 0.5}})
    set.insert(p, delaunay::none);
  set.force(0, 3);
  set.force(1, 4);
  set.force(1, 2);
  expect_canonical(set);
  set.release(1, 2);
  expect_canonical(set);
  set.remove(2);
  expect_canonical(set);
  set.insert({1.5, 0}, delaunay::none);
  expect_canonical(set);
  set.release(0, 3);
  expect_canonical(set);
  set.release(1, 4);
  expect_canonical(set);
}

TEST(PlaneEditorArcs, SurviveALineAndComeBackWithThePlane) {
  Editor editor = filled({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 1}});
  editor.force_arc(0, 3);
  editor.remove(4);
  expect_canonical(editor);
  EXPECT_EQ(editor.constrained_triangulation().path(0), (std::vector<Node>{0, 1, 2, 3}));
  editor.force_arc(1, 2);
  editor.insert({1, -1});
  editor.insert({2, 5});
  expect_canonical(editor);
}

TEST(PlaneEditorArcs, BelongToTheValue) {
  Editor editor = filled(square);
  editor.force_arc(0, 2);
  Editor copy = editor;
  copy.release_arc(0, 2);
  copy.force_arc(1, 3);
  expect_canonical(editor);
  expect_canonical(copy);
  EXPECT_TRUE(editor.is_forced(0, 2));
}

TEST(PlaneEditorArcs, EncloseADomain) {
  Editor editor = filled({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2}, {4, 2}, {3, 4}});
  for (Node i = 0; i < 4; ++i) editor.force_arc(i, (i + 1) % 4);
  editor.force_arc(4, 5);
  editor.force_arc(5, 6);
  editor.force_arc(6, 4);
  const auto t = editor.constrained_triangulation({.domain = Domain::even_odd});
  EXPECT_EQ(t.num_triangles() + 1, editor.triangulation().num_triangles());
}

// A wall of many pieces through uniform points, and points that come and go beside it.
TEST(PlaneEditorArcs, StayCanonicalInALargeSet) {
  Editor editor = filled(support::uniform_points(2000, 3));
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
  EXPECT_GT(num_forced, 10);
  int num_removed = 0;
  for (Node row = 0; row < 1500; ++row) {
    try {
      editor.remove(row);
      ++num_removed;
    } catch (const Error&) {
    }
    if (row % 3 == 0) editor.insert({random.uniform(), random.uniform()});
  }
  EXPECT_GT(num_removed, 1000);
  expect_canonical(editor);
  EXPECT_EQ(find_defect(editor.constrained_triangulation()).value_or("none"), "none");
}

class PlaneEditorArcsFamilies : public testing::TestWithParam<PlaneFamily> {};

TEST_P(PlaneEditorArcsFamilies, StayCanonicalUnderRandomEdits) {
  for (const std::size_t n : {4UL, 6UL, 9UL, 16UL}) {
    for (std::uint64_t seed = 1; seed <= (n < 16 ? 4 : 1); ++seed) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", seed = " + std::to_string(seed));
      const PlanePoints pool = GetParam().make(n, seed);
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

TEST_P(PlaneEditorArcsFamilies, GiveTheConstrainedTriangulation) {
  const PlanePoints pool = GetParam().make(20, 3);
  if (pool.empty()) return;
  SplitMix64 random(8);
  Editor editor{Triangulation(pool)};
  support::edit_arcs_at_random(editor, pool, 40, 3, random, refuses,
                               [&] { expect_canonical(editor); });
  const Triangulation t = editor.triangulation();
  EXPECT_TRUE(t.adjacency() == Triangulation(editor.points()).adjacency());
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneEditorArcsFamilies,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

}  // namespace
}  // namespace delone::tripack
