// Hashes of triangulations, and foreign neighbour lists.

#include "stripack/hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/defect.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using Points = std::vector<Direction>;
using Lists = delaunay::NeighborRings;

class SphereHash : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereHash, OfPositionsDependsNeitherOnOrderNorOnRepeats) {
  for (const std::size_t n : {1, 2, 3, 9, 80}) {
    Points points = GetParam().make(n, 4);
    const Hash hash = hash_of_positions(Triangulation(points));
    EXPECT_EQ(hash, hash_of_positions(Triangulation(support::shuffled(points, 5))));
    if (points.empty()) continue;
    points.push_back(points[points.size() / 2]);
    EXPECT_EQ(hash, hash_of_positions(Triangulation(points)));
  }
}

TEST_P(SphereHash, OfAForeignListIsThatOfTheTriangulation) {
  const Points points = GetParam().make(80, 4);
  const Triangulation t(points);
  auto triangles = support::shuffled(t.triangles(), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % 2 == 0)
      std::rotate(triangles[i].begin(), triangles[i].begin() + 1, triangles[i].end());
    if (i % 3 == 0) std::swap(triangles[i][0], triangles[i][2]);
  }
  EXPECT_EQ(hash_of_positions(points, triangles), hash_of_positions(t));
  if (triangles.empty()) return;
  triangles.pop_back();
  EXPECT_NE(hash_of_positions(points, triangles), hash_of_positions(t));
}

// The lists of all rows, interior ones turned, and where `is_mirrored` backwards.
Lists lists_of(const Triangulation& t, bool is_mirrored) {
  Lists lists;
  for (Node row = 0; row < t.num_rows(); ++row) {
    std::vector<Node> list;
    const Site s = t.sites()[static_cast<std::size_t>(row)];
    if (t.rows()[static_cast<std::size_t>(s)] == row) list = t.neighbors(row);
    std::rotate(list.begin(),
                list.begin() + row % std::max<std::ptrdiff_t>(1, std::ssize(list)),
                list.end());
    if (is_mirrored) std::ranges::reverse(list);
    lists.push_back(list);
  }
  return lists;
}

class SphereLists : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereLists, OfOurTriangulationsHaveNoDefect) {
  for (const std::size_t n : {1, 2, 3, 4, 5, 9, 80}) {
    for (const bool is_mirrored : {false, true}) {
      const Points points = GetParam().make(n, 4);
      const Lists lists = lists_of(Triangulation(points), is_mirrored);
      EXPECT_EQ(find_defect(points, lists).value_or("none"), "none") << n;
    }
  }
}

TEST_P(SphereLists, WithAnArcLessHaveOne) {
  const Points points = GetParam().make(60, 4);
  const Triangulation t(points);
  Lists lists = lists_of(t, false);
  if (t.num_sites() < 2) return;
  const Node row = t.rows()[0];
  const Node other = lists[static_cast<std::size_t>(row)].front();
  std::erase(lists[static_cast<std::size_t>(row)], other);
  EXPECT_NE(find_defect(points, lists).value_or("none"), "none");
  std::erase(lists[static_cast<std::size_t>(other)], row);
  EXPECT_NE(find_defect(points, lists).value_or("none"), "none");
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereHash,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });
INSTANTIATE_TEST_SUITE_P(Sphere, SphereLists,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(SphereHash, OfRowsTellsTheOrderOfRows) {
  const Points points = support::uniform_directions(40, 1);
  const Points mixed = support::shuffled(points, 2);
  EXPECT_EQ(hash_of_rows(Triangulation(points)), hash_of_rows(Triangulation(points)));
  EXPECT_NE(hash_of_rows(Triangulation(points)), hash_of_rows(Triangulation(mixed)));
}

TEST(SphereHash, DiffersForDifferentPoints) {
  std::set<Hash> seen;
  for (unsigned seed = 0; seed < 200; ++seed) {
    for (const std::size_t n : {1, 2, 3, 4, 17})
      seen.insert(hash_of_positions(Triangulation(support::uniform_directions(n, seed))));
  }
  EXPECT_EQ(seen.size(), 1000u);
  EXPECT_EQ(delaunay::to_string(Hash{0x0123456789abcdefu, 15}),
            "0123456789abcdef000000000000000f");
}

TEST(SphereHash, RefusesTrianglesOfRowsThatAreNotThere) {
  const Points points = support::uniform_directions(4, 1);
  const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 4}};
  EXPECT_THROW(static_cast<void>(hash_of_positions(points, triangles)), Error);
}

TEST(SphereLists, AreNamedWhereTheyAreWrong) {
  const Points points = support::uniform_directions(4, 7);
  const auto defect = [&](const Lists& lists) {
    return find_defect(points, lists).value_or("none");
  };
  EXPECT_EQ(defect({{1}, {0}}), "2 lists of neighbours for 4 points");
  EXPECT_EQ(defect({{1}, {0}, {9}, {}}),
            "the list of row 2 names row 9, but there are 4");
  EXPECT_EQ(defect({{1}, {0}, {2}, {}}), "row 2 is in its own list of neighbours");
  EXPECT_EQ(defect({{1, 1}, {0}, {}, {}}), "the list of row 0 names row 1 twice");
  EXPECT_EQ(defect({{1}, {}, {}, {}}),
            "row 1 is in the list of row 0 but not the other way round");
  EXPECT_NE(defect({{1}, {0}, {}, {}}), "none");
}

}  // namespace
}  // namespace delone::stripack
