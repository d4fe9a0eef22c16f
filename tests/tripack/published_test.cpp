// Published results: R. J. Renka's driver of TRIPACK, the lists of J. Burkardt's diamond.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "support/plane_sets.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {
namespace {

using support::PlanePoints;
using Triangles = std::vector<std::array<Node, 3>>;

// From 0, counter-clockwise, smallest first, sorted.
Triangles canonical(Triangles triangles, Node base) {
  for (auto& t : triangles) {
    for (Node& v : t) v -= base;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// Without orientation.
std::set<std::set<Node>> corners(const Triangles& triangles, Node base) {
  std::set<std::set<Node>> all;
  for (const auto& t : triangles) all.insert({t[0] - base, t[1] - base, t[2] - base});
  return all;
}

// R. J. Renka, ACM Trans. Math. Softw. 22 (1996) 1-8 (Algorithm 751): twelve nodes.
const PlanePoints renka{{0, 0}, {1, 0}, {.5, .15},  {.15, .5},  {.85, .5},  {.5, .85},
                        {0, 1}, {1, 1}, {.35, .35}, {.65, .35}, {.65, .65}, {.35, .65}};

TEST(Algorithm751, HasRenkasCounts) {
  const Triangulation t(renka);
  EXPECT_EQ(t.boundary().size(), 4u);
  EXPECT_EQ(t.adjacency().num_arcs() / 2, 29);
  EXPECT_EQ(t.num_triangles(), 18);
}

// Nodes 9 to 12 are a square in decimals: TRIPACK prints the diagonal 9-11. Of the
// doubles the canonical one is whichever is exact; all the others agree.
TEST(Algorithm751, HasRenkasTrianglesButForTheDiagonalOfTheSquare) {
  const Triangles printed = canonical({{1, 2, 3},
                                       {1, 3, 9},
                                       {1, 9, 4},
                                       {1, 4, 7},
                                       {2, 8, 5},
                                       {2, 5, 10},
                                       {2, 10, 3},
                                       {3, 10, 9},
                                       {4, 9, 12},
                                       {4, 12, 7},
                                       {5, 8, 11},
                                       {5, 11, 10},
                                       {6, 8, 7},
                                       {6, 7, 12},
                                       {6, 12, 11},
                                       {6, 11, 8}},
                                      1);
  Triangles ours = Triangulation(renka).triangles();
  ASSERT_EQ(ours.size(), 18u);
  std::erase_if(ours, [](const auto& t) { return t[0] >= 8; });
  EXPECT_EQ(ours, printed);
}

const PlanePoints diamond{{0, 0},     {0, 1},     {0.2, 0.5}, {0.3, 0.6}, {0.4, 0.5},
                          {0.6, 0.3}, {0.6, 0.5}, {1, 0},     {1, 1}};

struct Listing {
  const char* system;
  Triangles triangles;
  Node base;
};

// The lists that J. Burkardt, Some Notes on Delaunay Triangulations (2005), shows of six
// systems, each in its own order, orientation and numbering.
const Listing listings[] = {
    {"MATLAB",
     {{1, 3, 2},
      {1, 3, 6},
      {6, 1, 8},
      {4, 2, 3},
      {9, 2, 4},
      {5, 4, 3},
      {5, 3, 6},
      {7, 4, 5},
      {9, 4, 7},
      {7, 5, 6},
      {8, 7, 6},
      {7, 9, 8}},
     1},
    {"SWEEP2",
     {{7, 0, 5},
      {2, 5, 0},
      {1, 2, 0},
      {5, 6, 7},
      {5, 2, 4},
      {6, 5, 4},
      {3, 4, 2},
      {6, 4, 3},
      {1, 3, 2},
      {8, 7, 6},
      {3, 8, 6},
      {8, 3, 1}},
     0},
    {"DTRIS2",
     {{2, 1, 3},
      {3, 1, 6},
      {2, 3, 4},
      {4, 3, 5},
      {7, 4, 5},
      {5, 3, 6},
      {7, 5, 6},
      {9, 4, 7},
      {6, 1, 8},
      {7, 6, 8},
      {7, 8, 9},
      {2, 4, 9}},
     1},
    {"Triangle",
     {{1, 3, 2},
      {3, 1, 6},
      {8, 6, 1},
      {2, 3, 4},
      {4, 9, 2},
      {5, 4, 3},
      {3, 6, 5},
      {7, 4, 5},
      {7, 9, 4},
      {6, 7, 5},
      {7, 6, 8},
      {9, 7, 8}},
     1},
    {"QVORONOI",
     {{5, 0, 7},
      {0, 5, 2},
      {2, 1, 0},
      {7, 6, 5},
      {4, 2, 5},
      {5, 6, 4},
      {2, 4, 3},
      {4, 6, 3},
      {1, 2, 3},
      {7, 8, 6},
      {6, 8, 3},
      {8, 1, 3}},
     0},
    {"canonical",
     {{1, 3, 2},
      {1, 6, 3},
      {1, 8, 6},
      {2, 3, 4},
      {2, 4, 9},
      {3, 5, 4},
      {3, 6, 5},
      {4, 5, 7},
      {4, 7, 9},
      {5, 6, 7},
      {6, 8, 7},
      {7, 8, 9}},
     1},
};

TEST(Diamond, HasTheTrianglesOfAllSixSystems) {
  const auto ours = corners(Triangulation(diamond).triangles(), 0);
  for (const Listing& listing : listings)
    EXPECT_EQ(corners(listing.triangles, listing.base), ours) << listing.system;
}

TEST(Diamond, IsTheCanonicalListOfTheNotes) {
  EXPECT_EQ(Triangulation(diamond).triangles(),
            canonical(listings[5].triangles, listings[5].base));
}

}  // namespace
}  // namespace delone::tripack
