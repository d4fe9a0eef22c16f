// Many points at once against one after the other.

#include "tripack/locate_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "support/plane_sets.hpp"
#include "support/random.hpp"

namespace delone::tripack {
namespace {

using Points = std::vector<Point2>;
using Triangle = std::array<Node, 3>;

// Nodes, midpoints, and points around.
Points queries_for(const Points& points) {
  Points queries(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point2 a = points[i - 1], b = points[i];
    queries.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
  }
  for (const Point2 p : support::uniform_points(20, 3))
    queries.push_back({12 * p.x - 6, 12 * p.y - 6});
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

class PlaneLocateBatch : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneLocateBatch, GivesATriangleThatHoldsThePointAndMinusOneOutside) {
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

TEST_P(PlaneLocateBatch, DoesNotDependOnThreadsOrOrder) {
  const Points points = GetParam().make(200, 2);
  const Triangulation t(points);
  Points queries;
  for (int i = 0; i < 60; ++i) {
    for (const Point2& p : queries_for(points)) queries.push_back(p);
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

TEST_P(PlaneLocateBatch, NamesWhatLocateNames) {
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

INSTANTIATE_TEST_SUITE_P(Plane, PlaneLocateBatch,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& family) {
                           return std::string(family.param.name);
                         });

TEST(PlaneLocateBatch, OnAnEdgeTakesOneOfTheTwoTriangles) {
  const Points square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Triangulation t(square);
  const Points queries{{1, 1}, {0, 0}, {3, 3}, {1, 1}};
  const auto numbers = locate_triangles(t, queries);
  EXPECT_GE(numbers[0], 0);
  EXPECT_EQ(numbers[0], numbers[3]);
  EXPECT_GE(numbers[1], 0);
  EXPECT_EQ(numbers[2], -1);
}

}  // namespace
}  // namespace delone::tripack
