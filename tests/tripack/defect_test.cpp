#include "tripack/defect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/exact.hpp"
#include "support/plane_sets.hpp"
#include "support/random.hpp"

namespace delone::tripack {
namespace {

using Triangles = std::vector<std::array<std::int32_t, 3>>;
using Points = std::vector<Point2>;

// "" if there is none.
std::string defect(const Points& points, const Triangles& triangles) {
  return find_defect(points, triangles).value_or("");
}

const Points square_and_center{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}};
const Triangles square_and_center_triangles{{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 3, 4}};

// General position: found from the definition alone.
struct Case {
  Points points = support::uniform_points(24, 5);
  Triangles triangles = support::empty_circle_triangles(std::span<const Point2>(points));
};

TEST(PlaneDefect, AcceptsATriangulationMadeFromTheDefinition) {
  const Case c;
  ASSERT_GT(c.triangles.size(), 24u);
  EXPECT_EQ(defect(c.points, c.triangles), "");
}

TEST(PlaneDefect, AcceptsAnyOrderOfTrianglesAndCorners) {
  Case c;
  for (std::size_t i = 0; i < c.triangles.size(); i += 2) {
    std::rotate(c.triangles[i].begin(), c.triangles[i].begin() + 1, c.triangles[i].end());
  }
  EXPECT_EQ(defect(c.points, support::shuffled(c.triangles, 1)), "");
}

TEST(PlaneDefect, AcceptsClockwiseTriangles) {
  Case c;
  for (auto& t : c.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(defect(c.points, c.triangles), "");
}

TEST(PlaneDefect, AcceptsBothDiagonalsOfASquare) {
  const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(defect(square, {{0, 1, 2}, {0, 2, 3}}), "");
  EXPECT_EQ(defect(square, {{0, 1, 3}, {1, 2, 3}}), "");
}

TEST(PlaneDefect, AcceptsAnyOfSeveralRowsAtOnePosition) {
  const Points points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  EXPECT_EQ(defect(points, {{0, 1, 2}, {4, 2, 3}}), "");
  EXPECT_EQ(defect(points, {{4, 1, 2}, {4, 2, 3}}), "");
}

TEST(PlaneDefect, AcceptsPointsOnHullEdges) {
  EXPECT_EQ(defect({{0, 0}, {1, 0}, {2, 0}, {1, 1}}, {{0, 1, 3}, {1, 2, 3}}), "");
}

TEST(PlaneDefect, NamesTheFlippedEdge) {
  const Points kite{{0, 0}, {2, -1}, {4, 0}, {2, 1}};
  EXPECT_EQ(defect(kite, {{0, 1, 3}, {1, 2, 3}}), "");
  EXPECT_EQ(
      defect(kite, {{0, 1, 2}, {0, 2, 3}}),
      "edge (0, 2) is not Delaunay: row 1 is inside the circle of triangle (0, 2, 3)");
}

TEST(PlaneDefect, FindsEveryMissingTriangle) {
  const Case c;
  for (std::size_t i = 0; i < c.triangles.size(); ++i) {
    Triangles fewer = c.triangles;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_NE(defect(c.points, fewer), "") << "without triangle " << i;
  }
}

TEST(PlaneDefect, FindsEveryRepeatedTriangle) {
  const Case c;
  for (std::size_t i = 0; i < c.triangles.size(); ++i) {
    Triangles more = c.triangles;
    more.push_back(more[i]);
    EXPECT_NE(defect(c.points, more).find("has two triangles on one side"),
              std::string::npos);
  }
}

TEST(PlaneDefect, FindsEveryReversedTriangle) {
  const Case c;
  for (std::size_t i = 0; i < c.triangles.size(); ++i) {
    Triangles mixed = c.triangles;
    std::swap(mixed[i][0], mixed[i][1]);
    EXPECT_NE(defect(c.points, mixed).find("turns the other way"), std::string::npos);
  }
}

TEST(PlaneDefect, FindsEveryWrongCorner) {
  const Case c;
  support::SplitMix64 random(3);
  for (std::size_t i = 0; i < c.triangles.size(); ++i) {
    Triangles wrong = c.triangles;
    const auto other = static_cast<std::int32_t>(random.below(c.points.size()));
    if (std::find(wrong[i].begin(), wrong[i].end(), other) != wrong[i].end()) continue;
    wrong[i][random.below(3)] = other;
    EXPECT_NE(defect(c.points, wrong), "") << "triangle " << i << ", corner " << other;
  }
}

TEST(PlaneDefect, NamesAPointInNoTriangle) {
  Points points = square_and_center;
  points.push_back({3, 2});
  EXPECT_EQ(defect(points, square_and_center_triangles), "row 5 is in no triangle");
}

TEST(PlaneDefect, NamesARowThatDoesNotExist) {
  EXPECT_EQ(defect({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 3}}),
            "triangle (0, 1, 3) names row 3, but there are 3");
  EXPECT_EQ(defect({{0, 0}, {1, 0}, {0, 1}}, {{0, -1, 2}}),
            "triangle (0, -1, 2) names row -1, but there are 3");
}

TEST(PlaneDefect, NamesATriangleWithTwoCornersAtOnePosition) {
  EXPECT_EQ(defect({{0, 0}, {1, 0}, {0, 1}, {1, 0}}, {{0, 1, 3}}),
            "triangle (0, 1, 3) has two corners at one position");
}

TEST(PlaneDefect, NamesATriangleWithoutArea) {
  EXPECT_EQ(defect({{0, 0}, {1, 1}, {2, 2}, {0, 1}}, {{0, 1, 2}, {0, 1, 3}}),
            "triangle (0, 1, 2) has no area");
}

TEST(PlaneDefect, NamesARowThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(defect({{0, 0}, {1, 0}, {0, nan}}, {{0, 1, 2}}), "row 2 is not finite");
}

TEST(PlaneDefect, NamesANotchInTheHull) {
  const Points points{{0, 0}, {4, 0}, {2, 1}, {2, 5}};
  EXPECT_EQ(defect(points, {{0, 2, 3}, {1, 3, 2}}),
            "the boundary is not convex at row 2");
}

TEST(PlaneDefect, NamesAPointWhereOnlyCornersMeet) {
  const Points points{{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}};
  EXPECT_EQ(defect(points, {{0, 1, 2}, {0, 3, 4}}),
            "the triangles around row 0 are not connected through edges");
}

// A pentagram around its centre: every triangle is counter-clockwise, every side has one
// triangle, the boundary turns left everywhere, and the counts are those of a disk.
TEST(PlaneDefect, SeesThatTrianglesGoRoundTwice) {
  Points points = support::polygon_points(5, 1);
  points.push_back({0, 0});
  EXPECT_EQ(defect(points, {{5, 0, 2}, {5, 1, 3}, {5, 2, 4}, {5, 3, 0}, {5, 4, 1}}),
            "the triangles around row 5 overlap");
}

// A spiral strip of triangles that overlaps itself without sharing sides.
TEST(PlaneDefect, SeesThatAStripOverlapsItself) {
  Points points;
  Triangles strip;
  for (int i = 0; i < 14; ++i) {
    const double angle = i * std::numbers::pi / 6, radius = i % 2 == 0 ? 1 : 2;
    points.push_back(
        {(radius + 0.01 * i) * std::cos(angle), (radius + 0.01 * i) * std::sin(angle)});
    if (i > 1)
      strip.push_back(i % 2 == 0 ? Triangles::value_type{i - 2, i - 1, i}
                                 : Triangles::value_type{i - 1, i - 2, i});
  }
  EXPECT_NE(defect(points, strip), "");
}

TEST(PlaneDefect, AcceptsNoTrianglesForCollinearPointsOnly) {
  EXPECT_EQ(defect({}, {}), "");
  EXPECT_EQ(defect({{1, 2}}, {}), "");
  EXPECT_EQ(defect({{1, 2}, {2, 3}, {0, 1}, {1, 2}}, {}), "");
  EXPECT_NE(defect({{1, 2}, {2, 3}, {0, 1.5}}, {}).find("are not on one line"),
            std::string::npos);
}

TEST(PlaneDefect, AgreesWithExactArithmeticOnRandomLists) {
  support::SplitMix64 random(11);
  int num_right = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Points points;
    for (int i = 0; i < 5; ++i) {
      const auto x = static_cast<double>(random.below(4)),
                 y = static_cast<double>(random.below(4));
      if (std::find(points.begin(), points.end(), Point2{x, y}) == points.end())
        points.push_back({x, y});
    }
    const Triangles candidates =
        support::empty_circle_triangles(std::span<const Point2>(points));
    Triangles chosen;
    for (const auto& t : candidates) {
      if (random.below(4) != 0) chosen.push_back(t);
    }
    const bool is_right = !support::exact_defect(std::span<const Point2>(points), chosen);
    num_right += is_right ? 1 : 0;
    ASSERT_EQ(defect(points, chosen).empty(), is_right) << "trial " << trial;
  }
  EXPECT_GT(num_right, 400);
}

}  // namespace
}  // namespace delone::tripack
