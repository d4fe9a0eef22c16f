#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "delaunay/error.hpp"
#include "interp/c1_surface.hpp"
#include "interp/linear_surface.hpp"
#include "interp/region_integral.hpp"
#include "interp/surfaces.hpp"
#include "tripack/measures.hpp"
#include "tripack/polygon.hpp"

namespace delone::interp {
namespace {

using support::PlanePoints;
using support::sampled;
using support::triangulated;
using tripack::Point2;
using tripack::Polygon;
using Rings = std::vector<Polygon>;

PlaneRegion region_of_rings(const Rings& rings) { return PlaneRegion(rings); }

Polygon box(double west, double east, double south, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

// Not convex, with a hole that is not either, and an island in the hole.
Rings star_with_hole() {
  Polygon star, hole;
  for (int k = 0; k < 14; ++k) {
    const double angle = k * std::numbers::pi / 7, radius = k % 2 == 0 ? 0.45 : 0.22;
    star.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
    hole.push_back(
        {0.5 + radius / 2.1 * std::sin(angle), 0.5 + radius / 2.1 * std::cos(angle)});
  }
  return {star, hole, box(0.48, 0.53, 0.47, 0.51)};
}

// Of a + b x + c y over what an odd number of disjoint nested rings enclose.
double exact_integral(const Rings& rings, double a, double b, double c) {
  double sum = 0, sign = 1;
  for (const Polygon& ring : rings) {
    const Point2 middle = tripack::centroid(ring);
    sum +=
        sign * std::abs(tripack::signed_area(ring)) * (a + b * middle.x + c * middle.y);
    sign = -sign;
  }
  return sum;
}

PlanePoints points_of_the_square(std::size_t n, std::uint64_t seed) {
  PlanePoints points = support::uniform_points(n, seed);
  for (const Point2 corner : {Point2{0, 0}, Point2{1, 0}, Point2{0, 1}, Point2{1, 1}})
    points.push_back(corner);
  return points;
}

PlanePoints moved(PlanePoints points, double unit, double by) {
  for (Point2& p : points) p = {p.x * unit + by, p.y * unit + by};
  return points;
}

Point2 corner(const tripack::Triangulation& t, delaunay::Node row) {
  return t.points()[static_cast<std::size_t>(t.sites()[static_cast<std::size_t>(row)])];
}

double hull_area(const tripack::Triangulation& t) {
  double sum = 0;
  for (const auto& triangle : t.triangles()) {
    sum += tripack::signed_area(corner(t, triangle[0]), corner(t, triangle[1]),
                                corner(t, triangle[2]));
  }
  return sum;
}

// The part of a convex polygon on the left of a -> b (Sutherland and Hodgman).
Polygon clipped(const Polygon& polygon, Point2 a, Point2 b) {
  const auto height = [&](Point2 p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double at_p = height(p), at_q = height(q);
    if (at_p >= 0) result.push_back(p);
    if ((at_p < 0) == (at_q < 0)) continue;
    const double s = at_p / (at_p - at_q);
    result.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
  }
  return result;
}

// Over a triangle, by the mean of edges' middles in 4^depth parts.
template <class F>
double integral_over(F f, const std::array<Point2, 3>& p, int depth) {
  const auto middle = [](Point2 a, Point2 b) {
    return Point2{(a.x + b.x) / 2, (a.y + b.y) / 2};
  };
  const Point2 a = middle(p[1], p[2]), b = middle(p[2], p[0]), c = middle(p[0], p[1]);
  if (depth == 0)
    return tripack::signed_area(p[0], p[1], p[2]) * (f(a) + f(b) + f(c)) / 3;
  return integral_over(f, {p[0], c, b}, depth - 1) +
         integral_over(f, {c, p[1], a}, depth - 1) +
         integral_over(f, {b, a, p[2]}, depth - 1) +
         integral_over(f, {a, b, c}, depth - 1);
}

TEST(PlaneRegionIntegral, OfEverythingIsTheIntegral) {
  const PlanePoints points = support::uniform_points(150, 1);
  const auto t = triangulated(points);
  const PlaneLinear surface(t, support::random_values(points.size(), 2));
  const RegionIntegral all = surface.integral(PlaneRegion());
  EXPECT_NEAR(all.integral, surface.integral(), 1e-14);
  EXPECT_NEAR(all.area, hull_area(*t), 1e-14);
  const RegionIntegral around = surface.integral(region_of_rings({box(-1, 2, -1, 2)}));
  EXPECT_NEAR(around.integral, surface.integral(), 1e-14);
  EXPECT_NEAR(around.area, hull_area(*t), 1e-14);
  const RegionIntegral huge =
      surface.integral(region_of_rings({box(-1e300, 1e300, -1e300, 1e300)}));
  EXPECT_NEAR(huge.integral, surface.integral(), 1e-14);
}

TEST(PlaneRegionIntegral, OfALinearFunctionOverAStarWithHoleAndIslandIsExact) {
  const Rings rings = star_with_hole();
  const auto plane = [](Point2 p) { return 3 - 2 * p.x + 5 * p.y; };
  const double exact = exact_integral(rings, 3, -2, 5);
  for (const std::size_t n : {0u, 1u, 20u, 500u, 4000u}) {
    const PlanePoints points = points_of_the_square(n, 3);
    const PlaneLinear surface(triangulated(points), sampled(points, plane));
    const RegionIntegral r = surface.integral(region_of_rings(rings));
    EXPECT_NEAR(r.integral, exact, 1e-14) << n;
    EXPECT_NEAR(r.area, exact_integral(rings, 1, 0, 0), 1e-15) << n;
    EXPECT_NEAR(r.mean(), r.integral / r.area, 1e-15);
    EXPECT_NEAR(region_of_rings(rings).area(), r.area, 1e-15);
  }
}

// Coordinates that are multiples of 2^-20 keep their digits when moved.
TEST(PlaneRegionIntegral, KeepsItsDigitsFarFromTheOriginAndInAnyUnit) {
  const auto rounded = [](PlanePoints points) {
    for (Point2& p : points) {
      p = {std::round(p.x * 0x1p20) * 0x1p-20, std::round(p.y * 0x1p20) * 0x1p-20};
    }
    return points;
  };
  const PlanePoints points = rounded(points_of_the_square(300, 4));
  const std::vector<double> values = support::random_values(points.size(), 5);
  Rings rings = star_with_hole();
  for (Polygon& ring : rings) ring = rounded(ring);
  const RegionIntegral expected =
      PlaneLinear(triangulated(points), values).integral(region_of_rings(rings));
  for (const auto& [unit, by] :
       {std::pair{1.0, 1e7}, {1e-6, 0.0}, {1e6, 0.0}, {0x1p-500, 0.0}, {0x1p500, 0.0}}) {
    Rings placed;
    for (const Polygon& ring : rings) placed.push_back(moved(ring, unit, by));
    const PlaneLinear surface(triangulated(moved(points, unit, by)), values);
    const RegionIntegral r = surface.integral(region_of_rings(placed));
    EXPECT_NEAR(r.area / unit / unit, expected.area, by == 0 ? 1e-15 : 1e-15) << unit;
    EXPECT_NEAR(r.integral / unit / unit, expected.integral, by == 0 ? 1e-14 : 1e-10)
        << unit;
  }
}

TEST(PlaneRegionIntegral, OfASmallRegionInsideOneTriangleKeepsItsDigits) {
  const PlanePoints corners{{0, 0}, {1, 0}, {0, 1}};
  const PlaneLinear surface(triangulated(corners), std::vector<double>{0, 1, 0});
  for (const double size : {1e-2, 1e-5, 1e-9}) {
    const Polygon small = box(0.3, 0.3 + size, 0.2, 0.2 + size);
    const double area = tripack::signed_area(small);
    const RegionIntegral r = surface.integral(region_of_rings({small}));
    EXPECT_NEAR(r.area, area, 1e-14 * area);
    EXPECT_NEAR(r.mean(), tripack::centroid(small).x, 1e-14);
    // As a hole: all but it.
    const RegionIntegral rest =
        surface.integral(region_of_rings({box(-1, 2, -1, 2), small}));
    EXPECT_NEAR(rest.area, 0.5 - area, 1e-15);
  }
}

TEST(PlaneRegionIntegral, CountsNothingBeyondTheHull) {
  const PlanePoints points = points_of_the_square(30, 6);
  const PlaneLinear surface(triangulated(points), std::vector<double>(points.size(), 2),
                            {.outside = Outside::linear});
  const RegionIntegral half = surface.integral(region_of_rings({box(-5, 0.5, -7, 9)}));
  EXPECT_NEAR(half.area, 0.5, 1e-15);
  EXPECT_NEAR(half.integral, 1, 1e-15);
  EXPECT_DOUBLE_EQ(half.mean(), 2);
  // Both ends of a side outside, the hull between them.
  const Polygon band{{-1, 0.25}, {2, 0.5}, {2, 0.75}, {-1, 0.5}};
  EXPECT_NEAR(surface.integral(region_of_rings({band})).area, 0.25, 1e-15);
  const RegionIntegral beside = surface.integral(region_of_rings({box(2, 3, 0, 1)}));
  EXPECT_EQ(beside.area, 0);
  EXPECT_TRUE(std::isnan(beside.mean()));
  EXPECT_EQ(surface.integral(region_of_rings({})).area, 0);
}

TEST(PlaneRegionIntegral, WithoutTrianglesIsZero) {
  const PlanePoints line{{0, 0}, {1, 1}, {2, 2}};
  const PlaneLinear surface(triangulated(line), std::vector<double>{1, 2, 3});
  EXPECT_EQ(surface.integral(region_of_rings({box(0, 1, 0, 1)})).area, 0);
  EXPECT_EQ(surface.integral(PlaneRegion()).area, 0);
}

TEST(PlaneRegionIntegral, OverALatticeWithEverySideAlongEdgesIsExact) {
  const PlanePoints points = support::lattice_points(121);
  const std::vector<double> values =
      sampled(points, [](Point2 p) { return 1 + p.x - 2 * p.y; });
  const PlaneLinear surface(triangulated(points), values);
  for (const Rings& rings :
       {Rings{box(2, 7, 3, 9)}, Rings{box(0, 10, 0, 10)}, Rings{box(-1, 3, 0, 4)},
        Rings{box(0, 10, 0, 10), box(1, 2, 1, 2), box(2, 4, 2, 3)},
        Rings{{{1, 1}, {5, 1}, {5, 5}}}, Rings{{{0, 0}, {10, 10}, {0, 10}}},
        Rings{box(2, 6, 2, 6), box(6, 8, 2, 6)}}) {
    Rings inside;  // what of them lies in the hull, for the oracle
    for (Polygon ring : rings) {
      for (Point2& p : ring) p.x = std::max(p.x, 0.0);
      inside.push_back(ring);
    }
    double area = 0, integral = 0;
    for (std::size_t k = 0; k < inside.size(); ++k) {
      const bool is_hole = rings.size() == 3 && k > 0;
      area += (is_hole ? -1 : 1) * exact_integral({inside[k]}, 1, 0, 0);
      integral += (is_hole ? -1 : 1) * exact_integral({inside[k]}, 1, 1, -2);
    }
    const RegionIntegral r = surface.integral(region_of_rings(rings));
    EXPECT_NEAR(r.area, area, 1e-12);
    EXPECT_NEAR(r.integral, integral, 1e-11);
  }
}

class PlaneRegionOnSets : public testing::TestWithParam<support::PlaneFamily> {};

// Regions that have nodes for corners and edges for sides: every decision is a tie.
TEST_P(PlaneRegionOnSets, TrianglesOfItsOwnAreMeasuredExactly) {
  const PlanePoints points = GetParam().make(60, 7);
  const auto t = triangulated(points);
  const PlaneLinear surface(t, std::vector<double>(points.size(), 1));
  int num = 0;
  for (const auto& c : t->triangles()) {
    if (++num > 30) break;
    const Polygon ring{corner(*t, c[0]), corner(*t, c[1]), corner(*t, c[2])};
    const double area = tripack::signed_area(ring[0], ring[1], ring[2]);
    if (!(area > 1e-250 * hull_area(*t))) continue;  // underflow
    const double width = tripack::perimeter(ring);
    EXPECT_NEAR(surface.integral(region_of_rings({ring})).area / area, 1,
                1e-15 * (width / area * width))
        << num;
  }
}

TEST_P(PlaneRegionOnSets, PartsOfTheHullSumToTheWhole) {
  const PlanePoints points = GetParam().make(80, 8);
  const auto t = triangulated(points);
  if (t->dimension() < 2 || !std::isnormal(hull_area(*t))) return;
  const PlaneLinear surface(t, std::vector<double>(points.size(), 1));
  const interp::Region r = support::region_of(*t);
  const double width = r.east - r.west, height = r.north - r.south;
  if (!std::isfinite(width * height)) return;
  // Two parts with a zigzag between them, from node to node and beside them.
  Polygon zigzag;
  for (int k = 0; k <= 8; ++k)
    zigzag.push_back(
        {r.west + width * (k % 2 == 0 ? 0.3 : 0.7), r.south + height * (k / 8.0)});
  if (zigzag.front().y >= zigzag[1].y) return;
  Polygon left = zigzag, right = zigzag;
  left.push_back({r.west - width, r.north});
  left.push_back({r.west - width, r.south});
  right.push_back({r.east + width, r.north});
  right.push_back({r.east + width, r.south});
  const double whole = surface.integral(PlaneRegion()).area;
  double sum = 0;
  try {
    sum = surface.integral(region_of_rings({left})).area +
          surface.integral(region_of_rings({right})).area;
  } catch (const Error&) {
    return;  // a height of few doubles: the zigzag crosses itself
  }
  // Positions are rounded by parts of the longest sides.
  const double rounding =
      1e-12 + 1e-14 * std::hypot(width, height) / whole * std::hypot(width, height);
  EXPECT_NEAR(sum / whole, 1, rounding);
  EXPECT_NEAR(whole / hull_area(*t), 1, rounding);
}

TEST_P(PlaneRegionOnSets, AgreesWithClippingEveryTriangle) {
  const PlanePoints points = GetParam().make(50, 9);
  const auto t = triangulated(points);
  const interp::Region r = support::region_of(*t);
  const double width = r.east - r.west, height = r.north - r.south;
  if (t->dimension() < 2 || !(width * height > 1e-200 && width * height < 1e200)) return;
  const std::vector<double> values = support::random_values(points.size(), 10);
  const PlaneLinear surface(t, values);
  const auto place = [&](double x, double y) {
    return Point2{r.west + x * width, r.south + y * height};
  };
  const Polygon quad{place(0.2, -0.1), place(0.9, 0.2), place(0.8, 0.7), place(0.1, 0.9)};
  if (tripack::find_self_intersection(quad) || tripack::signed_area(quad) <= 0) return;
  double area = 0, integral = 0;
  for (const auto& c : t->triangles()) {
    Polygon part{corner(*t, c[0]), corner(*t, c[1]), corner(*t, c[2])};
    for (std::size_t k = 0; k < 4; ++k) part = clipped(part, quad[k], quad[(k + 1) % 4]);
    for (std::size_t k = 2; k < part.size(); ++k) {
      const Point2 a = part[0], b = part[k - 1], d = part[k];
      const double size = tripack::signed_area(a, b, d);
      area += size;
      const Point2 q{(a.x + b.x + d.x) / 3, (a.y + b.y + d.y) / 3};
      if (const double v = surface.value(q); std::isfinite(v)) integral += size * v;
    }
  }
  const RegionIntegral got = surface.integral(region_of_rings({quad}));
  const double scale =
      hull_area(*t) + 1e-3 * std::hypot(width, height) * std::hypot(width, height);
  EXPECT_NEAR(got.area / scale, area / scale, 1e-9);
  if (std::hypot(r.west, r.south) > 1e6 * width)
    return;  // the oracle's places are coarse
  EXPECT_NEAR(got.integral / scale, integral / scale, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(AllSets, PlaneRegionOnSets,
                         testing::ValuesIn(support::plane_families().begin(),
                                           support::plane_families().end()),
                         [](const auto& set) { return std::string(set.param.name); });

TEST(PlaneRegionIntegral, DoesNotDependOnThreadsOrTheSenseOfRings) {
  const PlanePoints points = points_of_the_square(2000, 11);
  const PlaneLinear surface(triangulated(points),
                            support::random_values(points.size(), 12));
  Rings rings = star_with_hole();
  const RunOptions one{.num_threads = 1, .progress = {}},
      three{.num_threads = 3, .progress = {}};
  const RegionIntegral expected = surface.integral(region_of_rings(rings), one);
  EXPECT_EQ(surface.integral(region_of_rings(rings), three).integral, expected.integral);
  for (Polygon& ring : rings) std::reverse(ring.begin(), ring.end());
  std::swap(rings[0], rings[2]);
  EXPECT_EQ(surface.integral(region_of_rings(rings), three).integral, expected.integral);
}

TEST(PlaneRegionIntegral, TakesTheDomainOfATriangulation) {
  const PlanePoints points = points_of_the_square(100, 13);
  const PlaneLinear surface(triangulated(points),
                            sampled(points, [](Point2 p) { return p.x; }));
  // A square with a hole that is named, not counted.
  tripack::PlanarGraph graph;
  graph.points = {{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9},
                  {0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
  graph.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  graph.holes = {{0.5, 0.5}};
  const PlaneRegion region{tripack::ConstrainedTriangulation(graph)};
  EXPECT_NEAR(region.area(), 0.6, 1e-15);
  EXPECT_NEAR(surface.integral(region).integral, 0.3, 1e-15);
}

TEST(PlaneRegionIntegral, RefusesBadRingsByName) {
  const auto message = [](const Rings& rings) {
    try {
      static_cast<void>(PlaneRegion(rings));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message({box(0, 1, 0, 1), {{0, 0}, {1, 1}}}).find("ring 1"),
            std::string::npos);
  EXPECT_NE(message({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}).find("cross"), std::string::npos);
  EXPECT_NE(message({{{0, 0}, {1, NAN}, {1, 0}}}), "");
}

TEST(PlaneRegionIntegral, OfAC1SurfaceComesNearThatOfTheFunction) {
  const auto wave = [](Point2 p) { return std::sin(3 * p.x) * std::cos(2 * p.y); };
  // Over a triangle, by halving it.
  const std::array<Point2, 3> corners{Point2{0.13, 0.2}, {0.85, 0.31}, {0.4, 0.9}};
  const double exact = integral_over([&](Point2 p) { return wave(p); }, corners, 6);
  double before = 0;
  for (const int n : {8, 16, 32}) {
    PlanePoints points;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) points.push_back({i * 1.0 / n, j * 1.0 / n});
    const PlaneC1 surface(triangulated(points), sampled(points, wave));
    const RegionIntegral r =
        surface.integral(region_of_rings({{corners[0], corners[1], corners[2]}}));
    const double error = std::abs(r.integral - exact);
    EXPECT_TRUE(before == 0 || error < before / 6) << n << ": " << error;
    before = error;
  }
  EXPECT_LT(before, 1e-6);
}

TEST(PlaneRegionIntegral, OfAC1SurfacePartsSumToTheWhole) {
  const PlanePoints points = points_of_the_square(300, 14);
  const PlaneC1 surface(triangulated(points), sampled(points, [](Point2 p) {
                          return std::sin(9 * p.x) * std::exp(p.y);
                        }));
  const Rings rings = star_with_hole();
  Rings rest = rings;
  rest.push_back(box(-1, 2, -1, 2));
  const double sum = surface.integral(region_of_rings(rings)).integral +
                     surface.integral(region_of_rings(rest)).integral;
  EXPECT_NEAR(sum, surface.integral(), 2e-7);
  const PlaneC1 constant(triangulated(points), std::vector<double>(points.size(), -3));
  EXPECT_DOUBLE_EQ(constant.integral(region_of_rings(rings)).mean(), -3);
}

}  // namespace
}  // namespace delone::interp
