#include "stripack/defect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using Triangles = std::vector<std::array<std::int32_t, 3>>;
using support::SpherePoints;

// "" if there is none.
std::string defect(const SpherePoints& points, const Triangles& triangles) {
  return find_defect(points, triangles).value_or("");
}

SpherePoints at(const std::vector<LonLat>& places) {
  SpherePoints points;
  for (const LonLat p : places) points.push_back(Direction::from(p));
  return points;
}

const SpherePoints octahedron =
    at({{0, 0}, {90, 0}, {180, 0}, {-90, 0}, {0, 90}, {0, -90}});
const Triangles octahedron_triangles{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                                     {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};

// General position, found from the definition alone: all around the sphere, and in a cap.
std::vector<SpherePoints> sets() {
  SpherePoints northern;
  for (const Direction& d : support::uniform_directions(40, 9)) {
    if (d.z() > 0.2) northern.push_back(d);
  }
  return {support::uniform_directions(20, 8), northern,
          support::box_directions(16, 2, 1e-9)};
}

Triangles triangles_of(const SpherePoints& points) {
  return support::empty_circle_triangles(std::span<const Direction>(points));
}

TEST(SphereDefect, AcceptsTriangulationsMadeFromTheDefinition) {
  for (const SpherePoints& points : sets()) {
    ASSERT_GT(triangles_of(points).size(), points.size());
    EXPECT_EQ(defect(points, triangles_of(points)), "");
  }
}

TEST(SphereDefect, AcceptsClockwiseTriangles) {
  for (const SpherePoints& points : sets()) {
    Triangles triangles = triangles_of(points);
    for (auto& t : triangles) std::swap(t[1], t[2]);
    EXPECT_EQ(defect(points, triangles), "");
  }
}

TEST(SphereDefect, AcceptsTheOctahedron) {
  EXPECT_EQ(defect(octahedron, octahedron_triangles), "");
}

TEST(SphereDefect, AcceptsHalfAnOctahedronOnItsOwn) {
  const SpherePoints half(octahedron.begin(), octahedron.begin() + 5);
  const Triangles upper(octahedron_triangles.begin(), octahedron_triangles.begin() + 4);
  EXPECT_EQ(defect(half, upper), "");
}

TEST(SphereDefect, AcceptsEitherDiagonalOfATie) {
  const SpherePoints box = at({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}});
  EXPECT_EQ(defect(box, {{0, 1, 2}, {0, 2, 3}}), "");
  EXPECT_EQ(defect(box, {{0, 1, 3}, {1, 2, 3}}), "");
}

TEST(SphereDefect, AcceptsAnyLengthOfOneDirection) {
  SpherePoints points = octahedron;
  points.push_back(Direction::from(1 + 0x1p-52, 0, 0));
  ASSERT_NE(points.front(), points.back());
  Triangles triangles = octahedron_triangles;
  EXPECT_EQ(defect(points, triangles), "");
  triangles[0][0] = 6;
  EXPECT_EQ(defect(points, triangles), "");
}

TEST(SphereDefect, FindsEveryMissingTriangle) {
  for (const SpherePoints& points : sets()) {
    const Triangles triangles = triangles_of(points);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      Triangles fewer = triangles;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_NE(defect(points, fewer), "") << "without triangle " << i;
    }
  }
}

TEST(SphereDefect, FindsEveryReversedTriangle) {
  for (const SpherePoints& points : sets()) {
    const Triangles triangles = triangles_of(points);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      Triangles mixed = triangles;
      std::swap(mixed[i][1], mixed[i][2]);
      EXPECT_NE(defect(points, mixed).find("turns the other way"), std::string::npos);
    }
  }
}

TEST(SphereDefect, NamesTheFlippedEdge) {
  const SpherePoints kite = at({{-20, 0}, {0, -10}, {20, 0}, {0, 10}});
  EXPECT_EQ(defect(kite, {{0, 1, 3}, {1, 2, 3}}), "");
  EXPECT_NE(defect(kite, {{0, 1, 2}, {0, 2, 3}}), "");
}

TEST(SphereDefect, NamesAPointInNoTriangle) {
  SpherePoints points = octahedron;
  points.push_back(Direction::from(LonLat{45, 45}));
  EXPECT_EQ(defect(points, octahedron_triangles), "row 6 is in no triangle");
}

// Two pentagrams between the poles: closed, counter-clockwise, and 2n - 4 triangles.
TEST(SphereDefect, SeesThatTrianglesGoRoundTwice) {
  const SpherePoints points =
      at({{0, 0}, {72, 0}, {144, 0}, {-144, 0}, {-72, 0}, {0, 90}, {0, -90}});
  Triangles triangles;
  for (std::int32_t k = 0; k < 5; ++k) {
    triangles.push_back({5, k, (k + 2) % 5});
    triangles.push_back({6, (k + 2) % 5, k});
  }
  EXPECT_EQ(defect(points, triangles), "the triangles around row 5 overlap");
}

// Closed and one-fold, but twice: positions of the one sphere lie between those of the
// other.
TEST(SphereDefect, SeesTwoSpheresInOneList) {
  SpherePoints points = octahedron;
  for (const Direction& d : octahedron) {
    points.push_back(Direction::from(d.x() + 0.1, d.y() + 0.2, d.z() + 0.3));
  }
  Triangles triangles = octahedron_triangles;
  for (const auto& t : octahedron_triangles)
    triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  EXPECT_EQ(
      defect(points, triangles),
      "16 triangles and 24 edges, but 12 points with 0 on the boundary have 20 and 30");
}

TEST(SphereDefect, AcceptsNoTrianglesForPointsOfOneGreatCircleOnly) {
  EXPECT_EQ(defect({}, {}), "");
  EXPECT_EQ(defect(at({{1, 2}, {1, 2}}), {}), "");
  EXPECT_EQ(defect(at({{0, 90}, {0, -90}, {17, 3}}), {}), "");
  EXPECT_EQ(defect(at({{0, 0}, {10, 0}, {200, 0}, {180, 0}}), {}), "");
  EXPECT_NE(defect(octahedron, {}).find("are not on one great circle"),
            std::string::npos);
}

TEST(SphereDefect, AgreesWithExactArithmeticOnRandomLists) {
  support::SplitMix64 random(12);
  int num_right = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    SpherePoints points;
    for (int i = 0; i < 6; ++i) {
      const Direction d =
          Direction::from(LonLat{90.0 * static_cast<double>(random.below(4)) / 2,
                                 45.0 * static_cast<double>(random.below(5)) - 90});
      if (std::find(points.begin(), points.end(), d) == points.end()) points.push_back(d);
    }
    Triangles chosen;
    for (const auto& t : triangles_of(points)) {
      if (random.below(5) != 0) chosen.push_back(t);
    }
    const bool is_right =
        !support::exact_defect(std::span<const Direction>(points), chosen);
    num_right += is_right ? 1 : 0;
    ASSERT_EQ(defect(points, chosen).empty(), is_right) << "trial " << trial;
  }
  EXPECT_GT(num_right, 150);
}

}  // namespace
}  // namespace delone::stripack
