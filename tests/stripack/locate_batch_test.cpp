// Many points at once against one after the other.

#include "stripack/locate_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using Points = std::vector<Direction>;
using Triangle = std::array<Node, 3>;

// Nodes, midpoints, and points around.
Points queries_for(const Points& points) {
  Points queries(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Direction &a = points[i - 1], &b = points[i];
    const double x = a.x() + b.x(), y = a.y() + b.y(), z = a.z() + b.z();
    if (x * x + y * y + z * z > 0.01) queries.push_back(Direction::from(x, y, z));
  }
  for (const Direction& p : support::uniform_directions(20, 3)) queries.push_back(p);
  return queries;
}

// The triangles that hold what `locate` names.
std::vector<Triangle> holders(const std::vector<Triangle>& triangles,
                              const Location& place) {
  std::vector<Triangle> found;
  for (const Triangle& t : triangles) {
    const bool holds = std::all_of(place.nodes.begin(), place.nodes.end(), [&](Node row) {
      return row == delaunay::none || std::ranges::find(t, row) != t.end();
    });
    if (holds && place.kind != Location::Kind::outside) found.push_back(t);
  }
  return found;
}

class SphereLocateBatch : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereLocateBatch, GivesATriangleThatHoldsThePointAndMinusOneOutside) {
  for (const std::size_t n : {1, 2, 3, 5, 12, 60}) {
    const Points points = GetParam().make(n, 2);
    const Triangulation t(points);
    const auto triangles = t.triangles();
    const Points queries = queries_for(points);
    const auto numbers = locate_triangles(t, queries);
    ASSERT_EQ(numbers.size(), queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto expected = holders(triangles, t.locate(queries[i]));
      if (numbers[i] == -1) {
        EXPECT_TRUE(expected.empty()) << "n = " << n << ", query " << i;
      } else {
        EXPECT_NE(std::ranges::find(expected,
                                    triangles.at(static_cast<std::size_t>(numbers[i]))),
                  expected.end())
            << "n = " << n << ", query " << i;
      }
    }
  }
}

TEST_P(SphereLocateBatch, DoesNotDependOnThreadsOrOrder) {
  const Points points = GetParam().make(200, 2);
  const Triangulation t(points);
  Points queries;
  for (int i = 0; i < 60; ++i) {
    for (const Direction& p : queries_for(points)) queries.push_back(p);
  }
  const auto numbers = locate_triangles(t, queries, {.num_threads = 1, .progress = {}});
  EXPECT_EQ(numbers, locate_triangles(t, queries, {.num_threads = 3, .progress = {}}));
  std::vector<std::size_t> order(queries.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  order = support::shuffled(order, 8);
  Points mixed;
  for (const std::size_t i : order) mixed.push_back(queries[i]);
  const auto mixed_numbers = locate_triangles(t, mixed);
  for (std::size_t i = 0; i < order.size(); ++i)
    EXPECT_EQ(mixed_numbers[i], numbers[order[i]]);
}

TEST_P(SphereLocateBatch, NamesWhatLocateNames) {
  for (const std::size_t n : {1, 2, 3, 30}) {
    const Points points = GetParam().make(n, 4);
    const Triangulation t(points);
    const Points queries = queries_for(points);
    const auto places = locate_all(t, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      auto expected = t.locate(queries[i]);
      EXPECT_EQ(places[i].kind, expected.kind);
      EXPECT_TRUE(std::ranges::is_permutation(places[i].nodes, expected.nodes));
      if (places[i].kind == Location::Kind::edge ||
          places[i].kind == Location::Kind::triangle) {
        EXPECT_LT(places[i].nodes[0], places[i].nodes[1]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereLocateBatch,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(SphereLocateBatch, OnAnEdgeTakesOneOfTheTwoTriangles) {
  const Points octant{Direction::from(1, 0, 0), Direction::from(0, 1, 0),
                      Direction::from(0, 0, 1), Direction::from(0, 0, -1)};
  const Triangulation t(octant);
  ASSERT_EQ(t.num_triangles(), 2);
  const Points queries{Direction::from(1, 1, 0), Direction::from(-1, 0, 0),
                       Direction::from(1, 2, 3)};
  const auto numbers = locate_triangles(t, queries);
  EXPECT_GE(numbers[0], 0);
  EXPECT_EQ(numbers[1], -1);
  EXPECT_EQ(t.triangles().at(static_cast<std::size_t>(numbers[2])), (Triangle{0, 1, 2}));
}

}  // namespace
}  // namespace delone::stripack
