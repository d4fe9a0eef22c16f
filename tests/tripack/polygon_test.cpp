#include "tripack/polygon.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/random.hpp"
#include "tripack/predicates.hpp"
#include "tripack/segments.hpp"

namespace delone::tripack {
namespace {

using std::numbers::pi;

Polygon star(int num_spikes, double inner, Point2 center) {
  Polygon corners;
  for (int i = 0; i < 2 * num_spikes; ++i) {
    const double r = i % 2 == 0 ? 1 : inner, a = i * pi / num_spikes;
    corners.push_back({center.x + r * std::cos(a), center.y + r * std::sin(a)});
  }
  return corners;
}

// The cyclic formula 1/2 sum x_i (y_{i+1} - y_{i-1}), in fractions.
double exact_area(const Polygon& p) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2 next = p[(i + 1) % p.size()], before = p[(i + p.size() - 1) % p.size()];
    sum += mpq_class(p[i].x) * (mpq_class(next.y) - mpq_class(before.y));
  }
  return mpq_class(sum / 2).get_d();
}

TEST(PolygonArea, IsThatOfTheCyclicFormula) {
  for (const double far : {0.0, 1e3, 1e8}) {
    Polygon p = star(9, 0.3, {far, -2 * far});
    EXPECT_NEAR(signed_area(p) / exact_area(p), 1, 3e-16) << far;
    std::reverse(p.begin(), p.end());
    EXPECT_NEAR(signed_area(p) / exact_area(p), 1, 3e-16) << far;
    EXPECT_LT(signed_area(p), 0);
  }
}

TEST(PolygonArea, OfLessThanATriangleIsZero) {
  EXPECT_EQ(signed_area(Polygon{}), 0);
  EXPECT_EQ(signed_area(Polygon{{1, 2}, {3, 4}}), 0);
}

TEST(PolygonCentroid, OfAnLIsThatOfItsTwoRectangles) {
  const Polygon p{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Point2 c = centroid(p);
  EXPECT_NEAR(c.x, (4 * 2 + 2 * 0.5) / 6, 1e-15);
  EXPECT_NEAR(c.y, (4 * 0.5 + 2 * 2) / 6, 1e-15);
  EXPECT_EQ(perimeter(p), 14);
}

TEST(PolygonCentroid, WithoutAreaIsThatOfTheCorners) {
  EXPECT_EQ(centroid(Polygon{{0, 0}, {1, 1}, {2, 2}}), (Point2{1, 1}));
  EXPECT_TRUE(std::isnan(centroid(Polygon{}).x));
}

TEST(PolygonLocate, SaysWhatIsOnTheBoundary) {
  const Polygon p{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_EQ(locate(p, {0.5, 2}), Containment::inside);
  EXPECT_EQ(locate(p, {2, 2}), Containment::outside);
  EXPECT_EQ(locate(p, {1, 2}), Containment::boundary);
  EXPECT_EQ(locate(p, {1, 1}), Containment::boundary);
  EXPECT_EQ(locate(p, {0.5, 1}), Containment::inside);  // on the line of a side
  EXPECT_EQ(locate(p, {-1, 1}), Containment::outside);
  EXPECT_EQ(locate(p, {-1, 3}), Containment::outside);
  EXPECT_EQ(locate(p, {0.5, 0}), Containment::boundary);
  EXPECT_TRUE(contains(p, {4, 0.5}));
}

TEST(PolygonLocate, TellsAnUlpFromTheBoundary) {
  const Polygon p{{0, 0}, {3, 1}, {1, 3}};
  const Point2 on{1.5, 0.5};
  EXPECT_EQ(locate(p, on), Containment::boundary);
  EXPECT_EQ(locate(p, {on.x, std::nextafter(on.y, 1)}), Containment::inside);
  EXPECT_EQ(locate(p, {on.x, std::nextafter(on.y, 0)}), Containment::outside);
}

// Oracle: the winding number, summed from angles.
TEST(PolygonLocate, AgreesWithTheWindingNumber) {
  const Polygon p = star(7, 0.4, {0, 0});
  support::SplitMix64 random(2);
  for (int k = 0; k < 2000; ++k) {
    const Point2 q{random.between(-1.1, 1.1), random.between(-1.1, 1.1)};
    double turn = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Point2 a = p[i], b = p[(i + 1) % p.size()];
      turn += std::remainder(
          std::atan2(b.y - q.y, b.x - q.x) - std::atan2(a.y - q.y, a.x - q.x), 2 * pi);
    }
    EXPECT_EQ(locate(p, q) == Containment::inside, turn > pi);
  }
}

TEST(SelfIntersection, IsFoundAndNamed) {
  EXPECT_EQ(find_self_intersection(star(7, 0.4, {0, 0})), std::nullopt);
  using Sides = std::array<std::int32_t, 2>;
  EXPECT_EQ(find_self_intersection(Polygon{{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
            (Sides{0, 2}));
  EXPECT_EQ(find_self_intersection(Polygon{{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
            (Sides{1, 1}));
  // A corner that touches a side, and a side that goes back on itself.
  EXPECT_NE(find_self_intersection(Polygon{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}),
            std::nullopt);
  EXPECT_NE(find_self_intersection(Polygon{{0, 0}, {4, 0}, {2, 0}}), std::nullopt);
}

TEST(Convexity, AllowsStraightAngles) {
  EXPECT_TRUE(is_convex(Polygon{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_FALSE(is_convex(star(5, 0.4, {0, 0})));
}

TEST(Segments, CrossTouchOverlapOrMiss) {
  EXPECT_EQ(meeting({0, 0}, {2, 2}, {0, 2}, {2, 0}), Meeting::cross);
  EXPECT_EQ(meeting({0, 0}, {2, 2}, {1, 1}, {2, 0}), Meeting::touch);
  EXPECT_EQ(meeting({0, 0}, {2, 2}, {2, 2}, {3, 0}), Meeting::touch);
  EXPECT_EQ(meeting({0, 0}, {2, 2}, {1, 1}, {3, 3}), Meeting::overlap);
  EXPECT_EQ(meeting({0, 0}, {2, 2}, {2, 2}, {3, 3}), Meeting::touch);
  EXPECT_EQ(meeting({0, 0}, {2, 2}, {3, 3}, {4, 4}), Meeting::none);
  EXPECT_EQ(meeting({0, 0}, {2, 2}, {1, 0}, {5, 4}), Meeting::none);
  EXPECT_EQ(meeting({0, 0}, {2, 0}, {3, 1}, {3, -1}), Meeting::none);
  EXPECT_EQ(meeting({1, 1}, {1, 1}, {0, 0}, {2, 2}), Meeting::touch);
  EXPECT_EQ(meeting({1, 1}, {1, 1}, {1, 1}, {1, 1}), Meeting::touch);
  EXPECT_EQ(meeting({1, 1}, {1, 1}, {2, 1}, {2, 1}), Meeting::none);
}

TEST(Segments, OverlapHasItsTwoEnds) {
  const Intersection i = intersect({0, 0}, {2, 2}, {3, 3}, {1, 1});
  ASSERT_EQ(i.num_points, 2);
  EXPECT_EQ(i.points[0], (Point2{1, 1}));
  EXPECT_EQ(i.points[1], (Point2{2, 2}));
}

TEST(Segments, CrossWhereFractionsSay) {
  support::SplitMix64 random(6);
  int num_crossings = 0;
  for (int k = 0; k < 20000; ++k) {
    const double flat = std::ldexp(1.0, -static_cast<int>(random.below(45)));
    const auto point = [&](double y) {
      return Point2{random.between(-1, 1), y * flat * random.uniform() + 5};
    };
    const Point2 a = point(1), b = point(-1), c = point(-1), d = point(1);
    const Intersection i = intersect(a, b, c, d);
    if (i.kind != Meeting::cross) continue;
    ++num_crossings;
    const mpq_class ux = mpq_class(b.x) - a.x, uy = mpq_class(b.y) - a.y,
                    vx = mpq_class(d.x) - c.x, vy = mpq_class(d.y) - c.y,
                    wx = mpq_class(c.x) - a.x, wy = mpq_class(c.y) - a.y;
    const mpq_class t = (wx * vy - wy * vx) / (ux * vy - uy * vx);
    const double x = mpq_class(t * ux + a.x).get_d(), y = mpq_class(t * uy + a.y).get_d();
    EXPECT_NEAR(i.points[0].x, x, 5e-16 * std::abs(x) + 1e-23);
    EXPECT_NEAR(i.points[0].y, y, 5e-16 * std::abs(y) + 1e-23);
  }
  EXPECT_GT(num_crossings, 3000);
}

TEST(Segments, OfHugeAndTinyCoordinatesCross) {
  for (const double s : {0x1p1000, 0x1p-1000}) {
    const Intersection i = intersect({0, 0}, {2 * s, 2 * s}, {0, 2 * s}, {2 * s, 0});
    ASSERT_EQ(i.kind, Meeting::cross);
    EXPECT_EQ(i.points[0], (Point2{s, s}));
  }
}

}  // namespace
}  // namespace delone::tripack
