#include "delaunay/triangle_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace delone::delaunay {
namespace {

using Triangles = std::vector<TriangleCorners>;

/// A strip of squares, each cut in two, its triangles shuffled and turned.
Triangles shuffled_lattice(Node width, unsigned seed) {
  Triangles triangles;
  for (Node y = 0; y + 1 < width; ++y) {
    for (Node x = 0; x + 1 < width; ++x) {
      const Node corner = width * y + x;
      triangles.push_back({corner, corner + 1, corner + width + 1});
      triangles.push_back({corner, corner + width + 1, corner + width});
    }
  }
  std::mt19937 random(seed);
  std::shuffle(triangles.begin(), triangles.end(), random);
  for (TriangleCorners& t : triangles)
    std::rotate(t.begin(), t.begin() + static_cast<int>(random() % 3), t.end());
  return triangles;
}

bool has_side(const TriangleCorners& t, Node a, Node b) {
  return std::ranges::count(t, a) == 1 && std::ranges::count(t, b) == 1;
}

/// The other triangle with the side a, b, found by looking at all.
std::int32_t neighbor_by_search(const Triangles& triangles, std::size_t self, Node a,
                                Node b) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (i != self && has_side(triangles[i], a, b)) return static_cast<std::int32_t>(i);
  return none;
}

TEST(Canonical, PutsTheSmallestCornerFirstKeepsOrientationAndSorts) {
  EXPECT_EQ(canonical({{5, 4, 3}, {2, 0, 1}, {1, 0, 2}}),
            (Triangles{{0, 1, 2}, {0, 2, 1}, {3, 5, 4}}));
  EXPECT_EQ(canonical({}), Triangles{});
}

TEST(Canonical, DoesNotDependOnOrderAndRotation) {
  EXPECT_EQ(canonical(shuffled_lattice(6, 1)), canonical(shuffled_lattice(6, 2)));
}

TEST(TriangleNeighbors, AgreeWithASearchInBothConventions) {
  const Triangles triangles = shuffled_lattice(7, 3);
  const auto opposite = triangle_neighbors(triangles, SideOrder::opposite_corner);
  const auto after = triangle_neighbors(triangles, SideOrder::after_corner);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Node a = triangles[t][k], b = triangles[t][(k + 1) % 3],
                 c = triangles[t][(k + 2) % 3];
      EXPECT_EQ(opposite[t][k], neighbor_by_search(triangles, t, b, c));
      EXPECT_EQ(after[t][k], neighbor_by_search(triangles, t, a, b));
    }
  }
}

TEST(TriangleNeighbors, DoNotDependOnOrientation) {
  Triangles triangles = shuffled_lattice(5, 4);
  const auto before = triangle_neighbors(triangles, SideOrder::opposite_corner);
  for (TriangleCorners& t : triangles) std::swap(t[1], t[2]);
  const auto turned = triangle_neighbors(triangles, SideOrder::opposite_corner);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    EXPECT_EQ(turned[t],
              (std::array<std::int32_t, 3>{before[t][0], before[t][2], before[t][1]}));
}

TEST(TrianglesOfRings, NeedAllThreeCornersToAgree) {
  // A square with its diagonal 0-2 in the rings; then node 1 forgets it is next to 2.
  const NeighborRings square = {{1, 2, 3}, {2, 0}, {3, 0, 1}, {0, 2}};
  EXPECT_EQ(triangles_of_rings(square), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  const NeighborRings broken = {{1, 2, 3}, {0}, {3, 0, 1}, {0, 2}};
  EXPECT_EQ(triangles_of_rings(broken), (Triangles{{0, 2, 3}}));
  EXPECT_EQ(find_lone_arc(broken), (LoneArc{2, 1}));
}

TEST(TrianglesOfRings, PassOverNeighborsThatAreNoNodes) {
  EXPECT_EQ(triangles_of_rings({{1, 9}, {9, 0}}), Triangles{});
  EXPECT_EQ(triangles_of_rings({}), Triangles{});
  EXPECT_EQ(triangles_of_rings({{0, 0}, {}, {2}}), Triangles{});
}

}  // namespace
}  // namespace delone::delaunay
