#include "delaunay/triangle_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/plane_sets.hpp"
#include "tripack/triangulation.hpp"

namespace delone::delaunay {
namespace {

using Loops = std::vector<std::vector<Node>>;
using Triangles = std::vector<TriangleCorners>;

TEST(TriangleArcs, NumberEverySideOnceOppositeItsCorner) {
  const tripack::Triangulation t(support::uniform_points(300, 1));
  const auto triangles = t.triangles();
  const TriangleArcs arcs = triangle_arcs(triangles);
  EXPECT_EQ(std::ssize(arcs.ends), t.adjacency().num_arcs() / 2);
  // NA = NT + N - 1
  EXPECT_EQ(std::ssize(arcs.ends), t.num_triangles() + t.num_sites() - 1);
  EXPECT_TRUE(std::ranges::is_sorted(arcs.ends));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& ends = arcs.ends.at(static_cast<std::size_t>(arcs.of_triangles[i][k]));
      const std::set<Node> expected{triangles[i][(k + 1) % 3], triangles[i][(k + 2) % 3]};
      EXPECT_EQ((std::set<Node>{ends[0], ends[1]}), expected);
    }
  }
  EXPECT_TRUE(triangle_arcs({}).ends.empty());
}

TEST(BoundaryLoops, OfATriangulationIsItsBoundary) {
  for (const auto& family : support::plane_families()) {
    const tripack::Triangulation t(family.make(200, 2));
    if (t.dimension() < 2) continue;
    EXPECT_EQ(boundary_loops(t.triangles()), Loops{t.boundary()}) << family.name;
  }
}

TEST(BoundaryLoops, GoRoundHolesWithTheRegionOnTheLeft) {
  // A square ring of eight triangles: 0..3 outside, 4..7 inside, counter-clockwise.
  const Triangles ring{{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                       {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  EXPECT_EQ(boundary_loops(ring), (Loops{{0, 1, 2, 3}, {4, 7, 6, 5}}));
}

TEST(BoundaryLoops, DoNotCrossWhereTheyTouch) {
  const Triangles bow{{0, 1, 2}, {2, 3, 4}};
  EXPECT_EQ(boundary_loops(bow), (Loops{{0, 1, 2}, {2, 3, 4}}));
  EXPECT_TRUE(boundary_loops({}).empty());
  const Triangles closed{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  EXPECT_TRUE(boundary_loops(closed).empty());
}

}  // namespace
}  // namespace delone::delaunay
