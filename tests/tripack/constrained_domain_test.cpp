// What segments enclose: outlines, holes, regions, rings that are counted.

#include <gtest/gtest.h>

#include <algorithm>

#include "delaunay/error.hpp"
#include "support/planar_graphs.hpp"
#include "tripack/constrained_samples.hpp"
#include "tripack/constrained_triangulation.hpp"

namespace delone::tripack {
namespace {

using samples::defect_of;
using samples::only;
using samples::twice_area;

TEST(Constrained, IslandsInLakesInIslandsAlternate) {
  PlanarGraph graph;
  for (const double half : {8.0, 6.0, 4.0, 2.0})
    support::add_ring(graph, support::square_ring({0, 0}, half));
  const ConstrainedTriangulation rings(graph, only(Domain::even_odd));
  EXPECT_EQ(twice_area(rings) / 2, 256 - 144 + 64 - 16);
  EXPECT_EQ(rings.regions().size(), 2U);
  const ConstrainedTriangulation whole(graph);
  EXPECT_EQ(twice_area(whole) / 2, 256);
  EXPECT_EQ(whole.regions().size(), 4U);
}

TEST(Constrained, RingsThatShareASideAreBothInside) {
  PlanarGraph graph;
  support::add_ring(graph, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  support::add_ring(graph, {{2, 1}, {4, 1}, {4, 3}, {2, 3}});  // shares half a side
  const ConstrainedTriangulation t(graph, only(Domain::even_odd));
  EXPECT_EQ(twice_area(t) / 2, 8);
  EXPECT_EQ(t.regions().size(), 2U);
  EXPECT_EQ(defect_of(t), "none");
}

TEST(Constrained, SeveralOutlinesKeepWhatEachEncloses) {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({0, 0}, 1));
  support::add_ring(graph, support::square_ring({10, 3}, 2));
  const ConstrainedTriangulation t(graph);
  EXPECT_EQ(twice_area(t) / 2, 4 + 16);
  EXPECT_EQ(t.regions().size(), 2U);
}

TEST(Constrained, HolesAreLeftOutAndKeptWithTheHull) {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({0, 0}, 4));
  support::add_ring(graph, support::square_ring({0, 0}, 1));
  graph.holes = {{0.25, 0.125}, {99, 99}};  // outside the hull there is nothing to remove
  EXPECT_EQ(twice_area(ConstrainedTriangulation(graph)) / 2, 64 - 4);
  EXPECT_EQ(twice_area(ConstrainedTriangulation(graph, only(Domain::hull))) / 2, 64);
}

TEST(Constrained, RegionsAreNumberedAndNamedByTheirPoints) {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({0, 0}, 4));
  support::add_ring(graph, support::square_ring({0, 0}, 1));
  graph.regions = {{{3, 3}, 7}, {{0, 0.5}, 9}, {{0.5, 0}, 11}};
  const ConstrainedTriangulation t(graph);
  ASSERT_EQ(t.regions().size(), 2U);
  const auto inner = t.region_of(t.find_face({0.25, 0.5}));
  const auto outer = t.region_of(t.find_face({3.5, 3}));
  ASSERT_NE(inner, outer);
  EXPECT_EQ(t.regions()[static_cast<std::size_t>(inner)].attribute,
            9);  // the first of two
  EXPECT_EQ(t.regions()[static_cast<std::size_t>(inner)].seed, 1);
  EXPECT_EQ(t.regions()[static_cast<std::size_t>(outer)].attribute, 7);
  EXPECT_EQ(t.regions()[0].num_triangles + t.regions()[1].num_triangles,
            t.num_triangles());
  const auto labels = t.triangle_regions();
  EXPECT_EQ(std::count(labels.begin(), labels.end(), inner),
            t.regions()[static_cast<std::size_t>(inner)].num_triangles);
}

TEST(Constrained, HoleOnASegmentIsAnError) {
  PlanarGraph graph;
  support::add_ring(graph, support::square_ring({0, 0}, 4));
  graph.holes = {{4, 1}};
  EXPECT_THROW(ConstrainedTriangulation{graph}, Error);
  graph.holes = {{4, 4}};
  EXPECT_THROW(ConstrainedTriangulation{graph}, Error);
}

TEST(Constrained, OpenRingsHaveNoInsideByCounting) {
  PlanarGraph graph;
  graph.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  graph.segments = {{0, 4}};
  EXPECT_THROW(ConstrainedTriangulation(graph, only(Domain::even_odd)), Error);
}

TEST(Constrained, LocatesInTheDomainOnly) {
  PlanarGraph graph;
  support::add_ring(graph, {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
  const ConstrainedTriangulation t(graph);
  EXPECT_EQ(t.locate({2, 3}).kind, Location::Kind::outside);  // in the hull, not inside
  EXPECT_EQ(t.locate({9, 9}).kind, Location::Kind::outside);
  EXPECT_EQ(t.locate({4, 4}).kind, Location::Kind::node);
  EXPECT_EQ(t.locate({4, 4}).nodes[0], 2);
  EXPECT_EQ(t.locate({2, 0}).kind, Location::Kind::edge);
  EXPECT_EQ(t.locate({0.5, 1}, 2).kind, Location::Kind::triangle);
  EXPECT_EQ(t.find_face({9, 9}), delaunay::none);
}

}  // namespace
}  // namespace delone::tripack
