#include "io/voronoi_file.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "io/node_file.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

using test::content_of;
using test::TemporaryFolder;

tripack::Voronoi diagram_of(const std::vector<tripack::Point2>& points) {
  return tripack::Voronoi(std::make_shared<const tripack::Triangulation>(
      std::span<const tripack::Point2>(points)));
}

// The diamond of J. Burkardt's notes: twelve triangles, twenty edges of which four are on
// the hull, no four points on a circle.
const std::vector<tripack::Point2> diamond = {
    {0, 0}, {0, 1}, {.2, .5}, {.3, .6}, {.4, .5}, {.6, .3}, {.6, .5}, {1, 0}, {1, 1}};

TEST(VoronoiFile, HasAVertexATriangleAndAnEdgeAnEdge) {
  const TemporaryFolder folder;
  const auto diagram = diagram_of(diamond);
  write_v_node(folder.path("d.v.node"), diagram, 1);
  write_v_edge(folder.path("d.v.edge"), diagram, 1);
  const NodeFile nodes = read_node(folder.path("d.v.node"));
  EXPECT_EQ(nodes.x.size(), 12U);
  EXPECT_EQ(nodes.base, 1);
  const EdgeFile file = read_edges(folder.path("d.v.edge"), 12);
  EXPECT_EQ(file.edges.size(), 20U);
  int num_rays = 0;
  for (const auto& edge : file.edges) num_rays += edge.to < 0 ? 1 : 0;
  EXPECT_EQ(num_rays, 4);
}

TEST(VoronoiFile, RaysLeaveTheHull) {
  // The circumcentre of a right triangle is in the middle of its longest side.
  const EdgeFile file = voronoi_edges(diagram_of({{0, 0}, {4, 0}, {0, 2}}), 0);
  ASSERT_EQ(file.edges.size(), 3U);
  for (const auto& edge : file.edges) {
    EXPECT_EQ(edge.from, 0);
    EXPECT_EQ(edge.to, -1);
    const bool is_down = edge.dx == 0 && edge.dy < 0;
    const bool is_left = edge.dx < 0 && edge.dy == 0;
    const bool is_across = edge.dx > 0 && edge.dy == 2 * edge.dx;
    EXPECT_TRUE(is_down || is_left || is_across) << edge.dx << ' ' << edge.dy;
  }
}

TEST(VoronoiFile, OfCollinearSitesIsEmpty) {
  const TemporaryFolder folder;
  write_v_edge(folder.path("l.v.edge"), diagram_of({{0, 0}, {1, 0}, {3, 0}}), 0);
  EXPECT_EQ(content_of(folder.path("l.v.edge")), "0 0\n");
}

}  // namespace
}  // namespace delone::io
