#include <gtest/gtest.h>

#include <cmath>

#include "interp/combination.hpp"
#include "interp/plane_facet.hpp"
#include "interp/sphere_facet.hpp"
#include "support/random.hpp"

namespace delone::interp {
namespace {

TEST(DoubleDouble, ProductsAndSumsAreExactForDoubles) {
  const double a = 1 + 0x1p-52, b = 1 - 0x1p-53;
  const DoubleDouble product = delaunay::two_product(a, b);
  // (1 + 2^-52)(1 - 2^-53) = 1 + 2^-53 - 2^-105
  EXPECT_EQ(product.high + product.low, product.high);
  EXPECT_EQ((product - DoubleDouble{1, 0}).rounded(), 0x1p-53 - 0x1p-105);
  const DoubleDouble sum = delaunay::two_sum(1, 0x1p-80);
  EXPECT_EQ(sum.high, 1);
  EXPECT_EQ(sum.low, 0x1p-80);
}

TEST(DoubleDouble, QuotientTimesDivisorGivesTheDividend) {
  const DoubleDouble third = DoubleDouble{1, 0} / DoubleDouble{3, 0};
  EXPECT_LT(std::abs((third * DoubleDouble{3, 0} - DoubleDouble{1, 0}).rounded()),
            0x1p-100);
}

TEST(PlaneFacet, ReproducesLinearFunctionsOnThinTriangles) {
  // Height over length from 1 to 2^-40, turned so that nothing is parallel to an axis.
  // The third corner lies on a multiple of 2^-50 beside the middle of the long side.
  for (int thinness = 0; thinness <= 40; ++thinness) {
    const double h = std::ldexp(1.0, -thinness);
    const Point2 a{0.125, 0.25}, b{0.875, 1}, c{0.5 - h / 4, 0.625 + h / 4};
    const auto f = [](Point2 p) {
      return 3 * p.x - 2 * p.y + 1;
    };  // exact at the corners
    const PlaneFacet facet({a, f(a)}, {b, f(b)}, {c, f(c)});
    const Point2 middle{(a.x + b.x + 2 * c.x) / 4, (a.y + b.y + 2 * c.y) / 4};
    EXPECT_NEAR(facet(middle), f(middle), 1e-13) << thinness;
    EXPECT_EQ(facet.is_thin(), thinness > 4) << thinness;
  }
}

TEST(PlaneFacet, FindsSteepSlopesOfThinTriangles) {
  const double h = 0x1p-40;
  const Point2 a{0, 0}, b{1, 1}, c{0.5 - h, 0.5 + h};
  const PlaneFacet facet({a, 0}, {b, 0}, {c, 1});
  EXPECT_NEAR(facet({0.5 - h / 2, 0.5 + h / 2}), 0.5, 1e-13);
  EXPECT_NEAR(facet.gradient().x * h, -0.5, 1e-13);
  EXPECT_NEAR(facet.gradient().y * h, 0.5, 1e-13);
}

TEST(PlaneFacet, StaysWithinTheCornerValues) {
  support::SplitMix64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const double h = std::ldexp(1.0, -static_cast<int>(random.below(50)));
    const Point2 a{random.uniform(), random.uniform()},
        b{a.x + 1, a.y + random.uniform()};
    const Point2 c{(a.x + b.x) / 2 - h * (b.y - a.y), (a.y + b.y) / 2 + h};
    const PlaneFacet facet({a, 1}, {b, 2}, {c, 4});
    const double s = random.uniform(), t = random.uniform() * (1 - s);
    const double v = facet({a.x + s * (b.x - a.x) + t * (c.x - a.x),
                            a.y + s * (b.y - a.y) + t * (c.y - a.y)});
    EXPECT_GE(v, 1);
    EXPECT_LE(v, 4);
  }
}

TEST(PlaneFacet, OnOneLineUpToRoundingIsLinearAlongTheLongestSide) {
  const PlaneFacet facet({{0, 0}, 0}, {{1, 1}, 10}, {{4, 4}, 8});
  EXPECT_EQ(facet({2, 2}), 4);
  EXPECT_EQ(PlaneFacet({{3, 3}, 5}, {{3, 3}, 5}, {{3, 3}, 5})({3, 3}), 5);
}

TEST(PlaneFacet, EdgesAreLinearFromEndToEnd) {
  const PlaneFacet steep({{0, 0}, 1}, {{1, 4}, 3});
  EXPECT_EQ(steep({0.25, 1}), 1.5);
  EXPECT_EQ(edge_weight(Point2{0, 0}, Point2{1, 4}, Point2{0.25, 1}), 0.25);
}

TEST(CornerWeights, OfThinTrianglesReproducePositions) {
  for (int thinness = 0; thinness <= 40; thinness += 4) {
    const double h = std::ldexp(1.0, -thinness);
    const Point2 a{0.125, 0.25}, b{0.875, 1}, c{0.5 - h / 4, 0.625 + h / 4};
    const Point2 p{(a.x + b.x + 2 * c.x) / 4, (a.y + b.y + 2 * c.y) / 4};
    const auto w = corner_weights(a, b, c, p);
    EXPECT_NEAR(w[0], 0.25, 1e-13);
    EXPECT_NEAR(w[1], 0.25, 1e-13);
    EXPECT_NEAR(w[2], 0.5, 1e-13);
  }
  const auto flat =
      corner_weights(Point2{0, 0}, Point2{1, 1}, Point2{4, 4}, Point2{3, 3});
  EXPECT_EQ(flat[0] + flat[1] + flat[2], 1);
  EXPECT_EQ(flat[2], 0.75);
}

// A triangle about the direction (2/3, 1/3, 2/3) with given sizes along two tangents.
std::array<Vector3, 3> small_triangle(double length, double height) {
  const Vector3 o{2.0 / 3, 1.0 / 3, 2.0 / 3}, u{1.0 / 3, 2.0 / 3, -2.0 / 3},
      v = cross(o, u);
  const auto unit = [&](double s, double t) {
    return vector(Direction::from(o.x + s * u.x + t * v.x, o.y + s * u.y + t * v.y,
                                  o.z + s * u.z + t * v.z));
  };
  return {unit(-length, 0), unit(length, 0), unit(0, height)};
}

TEST(SphereFacet, ReproducesTheFunctionsThatAreLinearOnTheFlatTriangle) {
  // On the plane of the triangle n . x = d: any g . x is linear there, so f(p) = d (g .
  // p) / (n . p).
  const Vector3 g{0.3, -1.2, 0.7};
  for (const double length : {1.0, 1e-2, 1e-6}) {
    for (const double ratio : {1.0, 1e-2, 1e-4}) {
      const auto [a, b, c] = small_triangle(length, length * ratio);
      const SphereFacet facet({a, dot(g, a)}, {b, dot(g, b)}, {c, dot(g, c)});
      if (length < 1) {
        EXPECT_EQ(facet.is_thin(), ratio <= 0.01);
      }
      const Vector3 flat = a + 0.25 * (b - a) + 0.25 * (c - a);
      EXPECT_NEAR(facet(flat), dot(g, flat), 1e-15 + 1e-12 * length)
          << length << ' ' << ratio;
      const auto w = corner_weights(a, b, c, flat);
      // The corners are rounded to 1e-16, which on a small thin triangle is not little.
      EXPECT_NEAR(w[1], 0.25, 1e-14 + 1e-15 / (length * ratio));
      EXPECT_NEAR(w[0] + w[1] + w[2], 1, 4e-16);
    }
  }
}

TEST(SphereFacet, GradientIsTangentAndAgreesWithDifferences) {
  const auto [a, b, c] = small_triangle(0.3, 0.5);
  const SphereFacet facet({a, 1}, {b, 3}, {c, -2});
  const Vector3 p = vector(Direction::from(2, 1, 2)), g = facet.gradient(p);
  EXPECT_NEAR(dot(g, p), 0, 1e-14);
  for (const Vector3 d : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    const double h = 1e-6;
    const double slope = (facet(p + h * d) - facet(p - h * d)) / (2 * h);
    EXPECT_NEAR(dot(g, d), slope, 1e-8);
  }
}

TEST(SphereFacet, OnOneGreatCircleUpToRoundingStaysFiniteAndWithinTheValues) {
  const Vector3 a{1, 0, 0}, b{0, 1, 0}, c = vector(Direction::from(-1, 1, 0));
  const SphereFacet facet({a, 1}, {b, 2}, {c, 5});
  for (const Vector3 p : {a, b, c, vector(Direction::from(1, 1, 0))}) {
    EXPECT_GE(facet(p), 1);
    EXPECT_LE(facet(p), 5);
    const auto w = corner_weights(a, b, c, p);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-15);
  }
}

TEST(SphereEdge, IsLinearAlongTheChord) {
  const SphereCorner a{{1, 0, 0}, 2}, b{{0, 1, 0}, 6};
  const Vector3 quarter = vector(Direction::from(3, 1, 0));
  EXPECT_NEAR(edge_weight(a.p, b.p, quarter), 0.25, 1e-15);
  EXPECT_NEAR(edge_value(a, b, quarter), 3, 1e-14);
  EXPECT_EQ(edge_value(a, b, a.p), 2);
  const Vector3 g = edge_gradient(a, b, quarter);
  const double h = 1e-6;
  const Vector3 east{-quarter.y, quarter.x, 0};
  const double slope =
      (edge_value(a, b, quarter + h * east) - edge_value(a, b, quarter - h * east)) /
      (2 * h);
  EXPECT_NEAR(dot(g, east), slope, 1e-8);
  EXPECT_NEAR(dot(g, quarter), 0, 1e-15);
}

TEST(Combination, WithoutTermsIsMissing) {
  EXPECT_TRUE(std::isnan(Combination{}.value({})));
}

TEST(Combination, AddsWeightsOfOneSiteAndReproducesConstantsExactly) {
  Combination sum;
  sum.add(3, 0.7);
  sum.add(1, 0.6);
  sum.add(3, -0.3);
  ASSERT_EQ(sum.sites().size(), 2u);
  EXPECT_DOUBLE_EQ(sum.weights()[0], 0.4);
  EXPECT_EQ(sum.value(std::vector<double>(4, 0.1)), 0.1);
}

}  // namespace
}  // namespace delone::interp
