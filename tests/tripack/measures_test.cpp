#include "tripack/measures.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/plane_sets.hpp"
#include "support/random.hpp"
#include "tripack/predicates.hpp"

namespace delone::tripack {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using std::numbers::pi;

// Triangles of all kinds: good ones, slivers, needles and flat ones far from the origin.
std::vector<std::array<Point2, 3>> triangles() {
  std::vector<std::array<Point2, 3>> result;
  support::SplitMix64 random(3);
  for (int i = 0; i < 4000; ++i) {
    const double far = std::ldexp(1.0, static_cast<int>(random.below(30))),
                 size = std::ldexp(1.0, -static_cast<int>(random.below(20))),
                 width = std::ldexp(1.0, -static_cast<int>(random.below(45)));
    const Point2 a{far * random.between(-1, 1), far * random.between(-1, 1)};
    const Point2 b{a.x + size * random.uniform(), a.y + size * random.uniform()};
    const double t = random.between(-1, 2);
    const Point2 c{a.x + t * (b.x - a.x) + width * size * random.between(-1, 1),
                   a.y + t * (b.y - a.y) + width * size * random.between(-1, 1)};
    if (orientation(a, b, c) != 0) result.push_back({a, b, c});
  }
  return result;
}

mpq_class exact_cross(Point2 a, Point2 b, Point2 c) {
  const mpq_class ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

// Source: the usual formula, in fractions.
std::array<mpq_class, 2> exact_circumcenter(Point2 a, Point2 b, Point2 c) {
  const mpq_class bx = mpq_class(b.x) - a.x, by = mpq_class(b.y) - a.y,
                  cx = mpq_class(c.x) - a.x, cy = mpq_class(c.y) - a.y;
  const mpq_class bb = bx * bx + by * by, cc = cx * cx + cy * cy,
                  d = 2 * (bx * cy - by * cx);
  return {(cy * bb - by * cc) / d + a.x, (bx * cc - cx * bb) / d + a.y};
}

TEST(SignedArea, IsWithinTwoUnitsOfTheExactOne) {
  const auto set = triangles();
  ASSERT_GT(set.size(), 3000U);
  for (const auto& [a, b, c] : set) {
    const double exact = mpq_class(exact_cross(a, b, c) / 2).get_d();
    EXPECT_NEAR(signed_area(a, b, c) / exact, 1, 2 * eps);
  }
}

TEST(SignedArea, IsZeroExactlyOnALine) {
  EXPECT_EQ(signed_area({0.1, 0.1}, {0.2, 0.2}, {0.7, 0.7}), 0);
  EXPECT_EQ(signed_area({0, 0}, {1, 0}, {2, 0}), 0);
  EXPECT_NE(signed_area({0.4, 0.5}, {0.3, 0.6}, {0.6, 0.3}), 0);  // in decimals it is
}

TEST(SignedArea, DoesNotOverflowBeforeTheResultDoes) {
  EXPECT_EQ(signed_area({0, 0}, {0x1p600, 0}, {0, 0x1p400}), 0x1p999);
  EXPECT_EQ(signed_area({0, 0}, {0x1p-600, 0}, {0, 0x1p-400}), 0x1p-1001);
}

TEST(Circumcircle, CentreIsCorrectlyRoundedOrNearly) {
  for (const auto& [a, b, c] : triangles()) {
    const auto [x, y] = exact_circumcenter(a, b, c);
    const Circle circle = circumcircle(a, b, c);
    const double tolerance = 0x1p-79 * circle.radius;
    EXPECT_NEAR(circle.center.x, x.get_d(), 2 * eps * std::abs(x.get_d()) + tolerance);
    EXPECT_NEAR(circle.center.y, y.get_d(), 2 * eps * std::abs(y.get_d()) + tolerance);
    const mpq_class dx = x - a.x, dy = y - a.y, square = dx * dx + dy * dy;
    EXPECT_NEAR(circle.radius / std::sqrt(square.get_d()), 1, 4 * eps);
  }
}

TEST(Circumcircle, OfPointsOnALineHasNoCentre) {
  const Circle circle = circumcircle({0, 0}, {1, 1}, {2, 2});
  EXPECT_TRUE(std::isnan(circle.center.x));
  EXPECT_EQ(circle.radius, std::numeric_limits<double>::infinity());
}

TEST(Incircle, TouchesThreeSides) {
  const Circle circle = incircle({0, 0}, {4, 0}, {0, 3});
  EXPECT_NEAR(circle.radius, 1, 2 * eps);
  EXPECT_NEAR(circle.center.x, 1, 2 * eps);
  EXPECT_NEAR(circle.center.y, 1, 2 * eps);
}

TEST(Angles, SumToHalfATurn) {
  for (const auto& [a, b, c] : triangles()) {
    const auto [u, v, w] = angles(a, b, c);
    EXPECT_NEAR(u + v + w, pi, 4 * eps * pi);
  }
}

TEST(Angles, SmallOnesKeepTheirDigits) {
  const auto [u, v, w] = angles({0, 0}, {1, 0}, {1, 1e-14});
  EXPECT_NEAR(u / 1e-14, 1, 1e-15);
  EXPECT_NEAR(v, pi / 2, 1e-15);
  EXPECT_NEAR(w, pi / 2, 1e-13);
}

TEST(AspectRatio, IsOneHalfAtBestAndZeroAtWorst) {
  EXPECT_NEAR(aspect_ratio({0, 0}, {2, 0}, {1, std::sqrt(3.0)}), 0.5, 2 * eps);
  EXPECT_EQ(aspect_ratio({0, 0}, {1, 0}, {2, 0}), 0);
  EXPECT_NEAR(aspect_ratio({0, 0}, {1, 0}, {0, 1}), std::sqrt(2.0) - 1, 2 * eps);
}

TEST(TriangleQuality, OfTheDiamondHasItsTheta) {
  const Triangulation t(support::PlanePoints{{0, 0},
                                             {0, 1},
                                             {0.2, 0.5},
                                             {0.3, 0.6},
                                             {0.4, 0.5},
                                             {0.6, 0.3},
                                             {0.6, 0.5},
                                             {1, 0},
                                             {1, 1}});
  const TriangleQuality quality = triangle_quality(t);
  EXPECT_NEAR(quality.smallest_angle_deg, 14.470294100, 1e-9);
  EXPECT_GT(quality.largest_angle_deg, 90);
  EXPECT_GT(quality.mean_aspect_ratio, quality.smallest_aspect_ratio);
}

// The twelve nodes of TRIPACK's driver (R. J. Renka, ACM Trans. Math. Softw. 22 (1996)).
TEST(TriangleQuality, OfRenkasDriverIsAsPublished) {
  const support::PlanePoints nodes{{0, 0},     {1, 0},     {.5, .15},  {.15, .5},
                                   {.85, .5},  {.5, .85},  {0, 1},     {1, 1},
                                   {.35, .35}, {.65, .35}, {.65, .65}, {.35, .65}};
  const Triangulation t(nodes);
  double largest = 0;
  for (const auto& [a, b, c] : t.triangles()) {
    const auto p = [&](Node row) { return nodes[static_cast<std::size_t>(row)]; };
    largest = std::max(largest, aspect_ratio(p(a), p(b), p(c)));
  }
  EXPECT_NEAR(largest, 0.480, 5e-4);
}

}  // namespace
}  // namespace delone::tripack
