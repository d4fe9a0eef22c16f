#include <gtest/gtest.h>

#include <string>

#include "stripack/constrained_list_defect.hpp"
#include "support/random.hpp"

namespace delone::stripack {
namespace {

using support::SplitMix64;
using Triangles = std::vector<std::array<Node, 3>>;

std::string defect_of(const ConstrainedTriangulation& t, const Triangles& triangles) {
  return find_defect(t, triangles).value_or("none");
}

void expect_words(const std::string& sentence, const std::string& words) {
  EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
}

Direction at(double lon, double lat) { return Direction::from(LonLat{lon, lat}); }

/// The corners of an octahedron, random points, and a ring round the north pole.
SphereGraph capped() {
  SphereGraph graph;
  for (const auto& [lon, lat] :
       {std::pair(0, 90), {0, -90}, {0, 0}, {90, 0}, {180, 0}, {-90, 0}})
    graph.points.push_back(at(lon, lat));
  SplitMix64 random(5);
  for (int i = 0; i < 60; ++i)
    graph.points.push_back(at(random.between(-180, 180), random.between(-89, 89)));
  const auto first = static_cast<Node>(graph.points.size());
  constexpr Node size = 12;
  for (Node i = 0; i < size; ++i) {
    graph.points.push_back(at(30.0 * i, 60));
    graph.arcs.push_back({first + i, first + (i + 1) % size});
  }
  return graph;
}

TEST(SphereConstrainedList, OwnTrianglesHaveNoDefectInAnyDomain) {
  for (const Domain domain : {Domain::hull, Domain::even_odd}) {
    const ConstrainedTriangulation t(capped(), {.domain = domain});
    Triangles triangles = t.triangles();
    EXPECT_EQ(defect_of(t, triangles), "none");
    for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
    EXPECT_EQ(defect_of(t, triangles), "none");
  }
}

TEST(SphereConstrainedList, DomainsAreToldApart) {
  const ConstrainedTriangulation cap(capped()), whole(capped(), {.domain = Domain::hull}),
      rest(capped(), {.outside = at(10, 89)});
  expect_words(defect_of(cap, whole.triangles()), "boundary of the domain");
  EXPECT_NE(defect_of(whole, cap.triangles()), "none");
  EXPECT_NE(defect_of(cap, rest.triangles()), "none");
  EXPECT_EQ(defect_of(rest, rest.triangles()), "none");
}

TEST(SphereConstrainedList, EveryMissingAndEveryDoubledTriangleIsADefect) {
  const ConstrainedTriangulation t(capped());
  const Triangles triangles = t.triangles();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangles without = triangles, doubled = triangles;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    doubled.push_back(triangles[i]);
    EXPECT_NE(defect_of(t, without), "none") << i;
    EXPECT_NE(defect_of(t, doubled), "none") << i;
  }
}

TEST(SphereConstrainedList, ASecondCoverOfTheSphereIsADefect) {
  // The domain is one face of an octahedron; the list has it and, over other corners, a
  // whole tetrahedron besides.
  SphereGraph graph;
  for (const auto& [lon, lat] : {std::pair(0, 0),
                                 {90, 0},
                                 {0, 90},
                                 {180, 0},
                                 {-90, 0},
                                 {0, -90},
                                 {10, -80},
                                 {120, 50},
                                 {-120, 50},
                                 {1, 40}})
    graph.points.push_back(at(lon, lat));
  graph.arcs = {{0, 1}, {1, 2}, {2, 0}};
  const ConstrainedTriangulation t(graph);
  Triangles triangles = t.triangles();
  ASSERT_EQ(defect_of(t, triangles), "none");
  for (const auto& face : Triangles{{6, 9, 7}, {6, 7, 8}, {6, 8, 9}, {7, 9, 8}})
    triangles.push_back(face);
  expect_words(defect_of(t, triangles), "more than once");
}

}  // namespace
}  // namespace delone::stripack
