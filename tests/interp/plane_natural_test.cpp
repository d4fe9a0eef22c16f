#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "delaunay/error.hpp"
#include "interp/natural_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using support::is_same;
using support::PlanePoints;
using support::random_values;
using support::sampled;
using support::triangulated;
using tripack::Point2;

constexpr std::array kinds{NaturalKind::sibson, NaturalKind::laplace,
                           NaturalKind::sibson_c1};

NaturalOptions options(NaturalKind kind) {
  NaturalOptions result;
  result.kind = kind;
  return result;
}

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Points of the closed hull that codes lose: nodes, points an ulp beside them, edge
// points as near as doubles come, random ones.
PlanePoints points_of_the_hull(const tripack::Triangulation& t, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  PlanePoints points(t.points().begin(), t.points().end());
  const double inf = std::numeric_limits<double>::infinity();
  for (const Point2 p : t.points()) {
    points.push_back({std::nextafter(p.x, inf), p.y});
    points.push_back({p.x, std::nextafter(p.y, -inf)});
  }
  t.adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto corners = t.adjacency().left(arc);
    const auto corner = [&](std::size_t k) { return t.points()[at(corners[k % 3])]; };
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 a = corner(k), b = corner(k + 1);
      points.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
      const double s = random.uniform(), u = random.uniform() * (1 - s);
      points.push_back({a.x + s * (b.x - a.x) + u * (corner(k + 2).x - a.x),
                        a.y + s * (b.y - a.y) + u * (corner(k + 2).y - a.y)});
    }
  });
  return points;
}

// Convex polygons cut by half-planes, in long double: the oracle of cells.
struct Corner {
  long double x, y;
};
using Polygon = std::vector<Corner>;

// What is nearer to a than to b.
Polygon nearer(const Polygon& polygon, Point2 a, Point2 b) {
  const long double nx = static_cast<long double>(b.x) - a.x,
                    ny = static_cast<long double>(b.y) - a.y;
  const long double mx = (static_cast<long double>(a.x) + b.x) / 2,
                    my = (static_cast<long double>(a.y) + b.y) / 2;
  const auto side = [&](Corner c) { return (c.x - mx) * nx + (c.y - my) * ny; };
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner c = polygon[k], d = polygon[(k + 1) % polygon.size()];
    const long double s = side(c), u = side(d);
    if (s <= 0) kept.push_back(c);
    if ((s < 0 && u > 0) || (s > 0 && u < 0)) {
      const long double part = s / (s - u);
      kept.push_back({c.x + part * (d.x - c.x), c.y + part * (d.y - c.y)});
    }
  }
  return kept;
}

long double area(const Polygon& p) {
  long double sum = 0;
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    sum += (p[k].x - p[0].x) * (p[k + 1].y - p[0].y) -
           (p[k].y - p[0].y) * (p[k + 1].x - p[0].x);
  }
  return sum / 2;
}

Polygon cell_of(Point2 q, const PlanePoints& points) {
  constexpr long double far = 1e6L;
  Polygon cell{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
  for (const Point2 p : points) cell = nearer(cell, q, p);
  return cell;
}

std::vector<double> normalized(std::vector<long double> parts) {
  const long double sum = std::accumulate(parts.begin(), parts.end(), 0.0L);
  std::vector<double> result;
  for (const long double part : parts) result.push_back(static_cast<double>(part / sum));
  return result;
}

std::vector<double> brute_force_sibson(Point2 q, const PlanePoints& points) {
  const Polygon cell = cell_of(q, points);
  std::vector<long double> areas;
  for (const Point2 p : points) {
    Polygon piece = cell;
    for (const Point2 other : points) {
      if (!(other == p)) piece = nearer(piece, p, other);
    }
    areas.push_back(area(piece));
  }
  return normalized(areas);
}

std::vector<double> brute_force_laplace(Point2 q, const PlanePoints& points) {
  const Polygon cell = cell_of(q, points);
  std::vector<long double> ratios(points.size());
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Corner a = cell[k], b = cell[(k + 1) % cell.size()];
    const auto distance = [&](Point2 p) {
      return std::hypot((a.x + b.x) / 2 - p.x, (a.y + b.y) / 2 - p.y);
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (distance(points[i]) < distance(points[best])) best = i;
    }
    ratios[best] += std::hypot(a.x - b.x, a.y - b.y) /
                    std::hypot(static_cast<long double>(q.x) - points[best].x,
                               static_cast<long double>(q.y) - points[best].y);
  }
  return normalized(ratios);
}

// One weight a point.
std::vector<double> spread(const NaturalWeights& w, const tripack::Triangulation& t) {
  std::vector<double> result(at(t.num_sites()));
  for (std::size_t k = 0; k < w.sites().size(); ++k)
    result[at(t.rows()[at(w.sites()[k])])] = w.weights()[k];
  return result;
}

TEST(PlaneNatural, WeightsAreStolenAreasAndEdgeRatios) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const PlanePoints points = support::uniform_points(60, seed);
    const auto t = triangulated(points);
    const std::vector<double> zeros(points.size());
    const PlaneNatural sibson(t, zeros), laplace(t, zeros, options(NaturalKind::laplace));
    support::SplitMix64 random(seed + 10);
    for (int i = 0; i < 30; ++i) {
      const Point2 q{random.between(0.25, 0.75), random.between(0.25, 0.75)};
      const auto areas = brute_force_sibson(q, points),
                 ratios = brute_force_laplace(q, points);
      const auto a = spread(sibson.weights(q), *t), r = spread(laplace.weights(q), *t);
      for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_NEAR(a[k], areas[k], 1e-12) << "seed " << seed << " query " << i;
        EXPECT_NEAR(r[k], ratios[k], 1e-12) << "seed " << seed << " query " << i;
      }
    }
  }
}

class PlaneNaturalOnSets : public testing::TestWithParam<support::PlaneFamily> {};

TEST_P(PlaneNaturalOnSets, GivesNodesTheirValuesBitForBit) {
  const PlanePoints points = support::affordable(GetParam(), 300, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  for (const NaturalKind kind : kinds) {
    const PlaneNatural surface(t, values, options(kind));
    for (std::size_t row = 0; row < points.size(); ++row) {
      EXPECT_TRUE(is_same(surface.value(points[row]), merged[at(t->sites()[row])]))
          << "row " << row;
    }
  }
}

TEST_P(PlaneNaturalOnSets, WeightsAreNotNegativeWithSumOneOnTheClosedHull) {
  const PlanePoints points = support::affordable(GetParam(), 250, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  for (const NaturalKind kind : kinds) {
    const PlaneNatural surface(t, values, options(kind));
    for (const Point2 p : points_of_the_hull(*t, 5)) {
      const NaturalWeights w = surface.weights(p);
      const double v = surface.value(p);
      if (t->locate(p).kind == delaunay::Location::Kind::outside) {
        EXPECT_TRUE(std::isnan(v));
        EXPECT_TRUE(w.sites().empty());
        continue;
      }
      double sum = 0;
      for (const double weight : w.weights()) {
        EXPECT_GE(weight, 0);
        sum += weight;
      }
      EXPECT_NEAR(sum, 1, 1e-13) << p.x << ' ' << p.y;
      EXPECT_TRUE(std::isfinite(v)) << p.x << ' ' << p.y;
      EXPECT_LE(std::abs(v), kind == NaturalKind::sibson_c1 ? 30 : 1);
    }
  }
}

TEST_P(PlaneNaturalOnSets, ValuesDoNotDependOnOrderOrThreads) {
  const PlanePoints points = support::affordable(GetParam(), 200, 6);
  const auto t = triangulated(points);
  const auto f = [](Point2 p) { return std::sin(p.x) + std::cos(p.y); };
  const PlanePoints queries = support::shuffled(points_of_the_hull(*t, 7), 8);
  const PlanePoints other_rows = support::shuffled(points, 9);
  for (const NaturalKind kind : kinds) {
    const PlaneNatural surface(t, sampled(points, f), options(kind));
    const std::vector<double> expected =
        surface.values(queries, {.num_threads = 1, .progress = {}});
    for (std::size_t i = 0; i < queries.size(); i += 5) {
      EXPECT_TRUE(is_same(surface.value(queries[i]), expected[i])) << i;
    }
    EXPECT_EQ(support::first_difference(
                  surface.values(queries, {.num_threads = 5, .progress = {}}), expected),
              queries.size());
    const PlaneNatural same(triangulated(other_rows), sampled(other_rows, f),
                            options(kind));
    EXPECT_EQ(support::first_difference(same.values(queries), expected), queries.size());
  }
}

TEST_P(PlaneNaturalOnSets, ReproducesConstantsExactly) {
  const PlanePoints points = support::affordable(GetParam(), 200, 10);
  const auto t = triangulated(points);
  const std::vector<double> constant(points.size(), 0.1);
  for (const NaturalKind kind : kinds) {
    const PlaneNatural surface(t, constant, options(kind));
    for (const Point2 p : points_of_the_hull(*t, 11)) {
      if (const double v = surface.value(p); !std::isnan(v)) {
        EXPECT_EQ(v, 0.1);
      }
    }
  }
}

TEST_P(PlaneNaturalOnSets, GradientsAreFiniteOnTheClosedHull) {
  const PlanePoints points = support::affordable(GetParam(), 120, 12);
  const auto t = triangulated(points);
  double largest = 0;
  for (const Point2 p : points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  if (!(largest > 1e-30 && largest < 1e30)) GTEST_SKIP() << "slopes beyond doubles";
  for (const NaturalKind kind : kinds) {
    const PlaneNatural surface(t, random_values(points.size(), 13), options(kind));
    for (const Point2 p : points_of_the_hull(*t, 14)) {
      if (t->locate(p).kind == delaunay::Location::Kind::outside) continue;
      const Gradient2 g = surface.gradient(p);
      EXPECT_FALSE(std::isnan(g.x) || std::isnan(g.y)) << p.x << ' ' << p.y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneNaturalOnSets,
                         testing::ValuesIn(support::plane_families()),
                         [](const auto& set) { return std::string(set.param.name); });

// Moved and stretched so that a linear function of the set is known to rounding of its
// own range: coordinates are integers, small beside the move.
struct Placement {
  const char* name;
  double x_step, y_step, move;
};
class PlaneNaturalPlaced : public testing::TestWithParam<Placement> {};

TEST_P(PlaneNaturalPlaced, ReproducesLinearFunctionsToTwelveDigits) {
  const Placement& place = GetParam();
  support::SplitMix64 random(1);
  const auto whole = [&] { return std::floor(random.between(0, 4096)); };
  const auto placed = [&](double i, double j) {
    return Point2{place.move + i * place.x_step, place.move + j * place.y_step};
  };
  const auto i_of = [&](Point2 p) { return (p.x - place.move) / place.x_step; };
  const auto j_of = [&](Point2 p) { return (p.y - place.move) / place.y_step; };
  PlanePoints points;
  for (int k = 0; k < 1500; ++k) points.push_back(placed(whole(), whole()));
  const auto f = [&](Point2 p) { return i_of(p) - 2 * j_of(p); };
  const double range = 3 * 4096;
  const auto t = triangulated(points);
  for (const NaturalKind kind : {NaturalKind::sibson, NaturalKind::laplace}) {
    const PlaneNatural surface(t, sampled(points, f), options(kind));
    for (int k = 0; k < 3000; ++k) {
      const Point2 q = placed(whole() + 0.25, whole() + 0.5);
      const double v = surface.value(q);
      if (!std::isnan(v)) {
        EXPECT_NEAR(v, f(q), 1e-12 * range) << q.x << ' ' << q.y;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlaneNaturalPlaced,
                         testing::Values(Placement{"square", 0x1p-12, 0x1p-12, 0},
                                         Placement{"moved_by_1e7", 0x1p-12, 0x1p-12, 1e7},
                                         Placement{"thin", 1, 0x1p-20, 0},
                                         Placement{"thin_and_moved", 1, 0x1p-26, 1e7},
                                         Placement{"small", 0x1p-40, 0x1p-40, 0},
                                         Placement{"large", 0x1p40, 0x1p40, 0}),
                         [](const auto& place) { return std::string(place.param.name); });

// Thin and turned: coordinates are rounded, so the function is taken of the rounded ones.
TEST(PlaneNatural, ReproducesLinearFunctionsOnThinTurnedSets) {
  support::SplitMix64 random(2);
  PlanePoints points;
  for (int k = 0; k < 800; ++k) {
    const double along = random.between(0, 1), across = random.between(0, 1e-6);
    points.push_back({0.6 * along - 0.8 * across, 0.8 * along + 0.6 * across});
  }
  const auto f = [](Point2 p) { return p.x + p.y; };
  const auto t = triangulated(points);
  for (const NaturalKind kind : {NaturalKind::sibson, NaturalKind::laplace}) {
    const PlaneNatural surface(t, sampled(points, f), options(kind));
    for (int k = 0; k < 2000; ++k) {
      const double along = random.between(0, 1), across = random.between(0, 1e-6);
      const Point2 q{0.6 * along - 0.8 * across, 0.8 * along + 0.6 * across};
      const double v = surface.value(q);
      if (!std::isnan(v)) {
        EXPECT_NEAR(v, f(q), 1e-12);
      }
    }
  }
}

TEST(PlaneNatural, IsLinearOnHullEdgesAndTendsToIt) {
  const PlanePoints points{{0, 0}, {8, 0}, {9, 7}, {-1, 6}, {3, 4}, {5, 2}};
  const std::vector<double> values{1, 5, -3, 2, 40, -20};
  const auto t = triangulated(points);
  for (const NaturalKind kind : {NaturalKind::sibson, NaturalKind::laplace}) {
    const PlaneNatural surface(t, values, options(kind));
    for (const double x : {0.5, 2.0, 4.0, 7.75}) {
      EXPECT_DOUBLE_EQ(surface.value({x, 0}), 1 + x / 2);
      for (const double height : {1e-4, 1e-8, 1e-12, 1e-100, 1e-300})
        EXPECT_NEAR(surface.value({x, height}), 1 + x / 2, 200 * height + 1e-13)
            << height;
    }
  }
}

TEST(PlaneNatural, C1TendsToItsCubicOnHullEdges) {
  const PlanePoints points{{0, 0}, {8, 0}, {9, 7}, {-1, 6}, {3, 4}, {5, 2}};
  const std::vector<double> values{1, 5, -3, 2, 40, -20};
  const PlaneNatural surface(triangulated(points), values,
                             options(NaturalKind::sibson_c1));
  for (const double x : {0.5, 2.0, 4.0, 7.75}) {
    for (const double height : {1e-5, 1e-9, 1e-12})
      EXPECT_NEAR(surface.value({x, height}), surface.value({x, 0}),
                  1e4 * height + 1e-12);
  }
}

TEST(PlaneNatural, IsContinuousAlongSegmentsThroughNodesEdgesAndTheHull) {
  const PlanePoints points = support::lattice_points(100);  // 10 x 10, cocircular
  const std::vector<double> values = random_values(points.size(), 5);
  const auto t = triangulated(points);
  const std::array<std::array<Point2, 2>, 4> segments{{{{{0, 0}, {9, 9}}},
                                                       {{{0, 3}, {9, 3}}},
                                                       {{{0.1, 8.7}, {8.9, 0.2}}},
                                                       {{{4, 0}, {4.5, 9}}}}};
  for (const NaturalKind kind : kinds) {
    const PlaneNatural surface(t, values, options(kind));
    for (const auto& [a, b] : segments) {
      constexpr int steps = 20000;
      double before = surface.value(a);
      for (int k = 1; k <= steps; ++k) {
        const double s = static_cast<double>(k) / steps;
        const double v = surface.value({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
        EXPECT_NEAR(v, before, 40.0 * 9 / steps) << s;
        before = v;
      }
    }
  }
}

TEST(PlaneNatural, GradientsAreThoseOfTheValues) {
  const PlanePoints points = support::uniform_points(200, 6);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 7);
  for (const NaturalKind kind : kinds) {
    const PlaneNatural surface(t, values, options(kind));
    support::SplitMix64 random(8);
    int num_rough = 0;
    for (int k = 0; k < 500; ++k) {
      const Point2 q{random.between(0.1, 0.9), random.between(0.1, 0.9)};
      constexpr double h = 1e-6;
      const double x =
          (surface.value({q.x + h, q.y}) - surface.value({q.x - h, q.y})) / (2 * h);
      const double y =
          (surface.value({q.x, q.y + h}) - surface.value({q.x, q.y - h})) / (2 * h);
      const Gradient2 g = surface.gradient(q);
      // Within h of a circumcircle of a surface that is C0 only the difference is a mean.
      if (std::hypot(g.x - x, g.y - y) > 1e-3) ++num_rough;
    }
    EXPECT_LE(num_rough, kind == NaturalKind::laplace ? 3 : 1);
  }
}

// The largest change of the gradient from one step of a segment to the next.
double roughness(const PlaneNatural& surface, Point2 a, Point2 b, int steps) {
  double largest = 0;
  Gradient2 before = surface.gradient(a);
  for (int k = 1; k <= steps; ++k) {
    const double s = static_cast<double>(k) / steps;
    const Gradient2 g = surface.gradient({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
    largest = std::max(largest, std::hypot(g.x - before.x, g.y - before.y));
    before = g;
  }
  return largest;
}

TEST(PlaneNatural, GradientsOfSibsonsSurfacesAreContinuousAndLaplacesJump) {
  const PlanePoints points = support::uniform_points(100, 9);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 10);
  const auto ratio = [&](NaturalKind kind) {
    const PlaneNatural surface(t, values, options(kind));
    const Point2 a{0.2, 0.25}, b{0.8, 0.7};
    return roughness(surface, a, b, 2000) / roughness(surface, a, b, 200000);
  };
  EXPECT_GT(ratio(NaturalKind::sibson), 8);
  EXPECT_GT(ratio(NaturalKind::sibson_c1), 8);
  EXPECT_LT(ratio(NaturalKind::laplace), 3);
}

TEST(PlaneNatural, C1HasTheGivenGradientsAtItsNodes) {
  const PlanePoints points = support::uniform_points(100, 11);
  const std::vector<double> values = random_values(points.size(), 12),
                            slopes = random_values(2 * points.size(), 13);
  std::vector<Gradient2> gradients;
  for (std::size_t i = 0; i < points.size(); ++i)
    gradients.push_back({slopes[2 * i], slopes[2 * i + 1]});
  const auto t = triangulated(points);
  const PlaneNatural surface(t, values, gradients, options(NaturalKind::sibson_c1));
  const auto error_beside_nodes = [&](double distance) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (t->adjacency().is_boundary(t->sites()[i])) continue;
      for (const double angle : {0.3, 2.0, 4.1}) {
        const Gradient2 g = surface.gradient({points[i].x + distance * std::cos(angle),
                                              points[i].y + distance * std::sin(angle)});
        sum += std::hypot(g.x - gradients[i].x, g.y - gradients[i].y);
      }
    }
    return sum;
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(surface.gradient(points[i]), gradients[i]);
  EXPECT_LT(error_beside_nodes(1e-7), error_beside_nodes(1e-5) / 50);
}

TEST(PlaneNatural, C1ReproducesQuadraticsWithTheirGradients) {
  const PlanePoints points = support::uniform_points(300, 14);
  const auto f = [](Point2 p) { return 1 + p.x - 2 * p.y + 3 * p.x * p.y - p.y * p.y; };
  std::vector<Gradient2> gradients;
  for (const Point2 p : points)
    gradients.push_back({1 + 3 * p.y, -2 + 3 * p.x - 2 * p.y});
  const PlaneNatural surface(triangulated(points), sampled(points, f), gradients,
                             options(NaturalKind::sibson_c1));
  for (const Point2 q : support::uniform_points(2000, 15)) {
    const double v = surface.value(q);
    if (std::isnan(v)) continue;
    EXPECT_NEAR(v, f(q), 1e-12);
    EXPECT_NEAR(surface.gradient(q).x, 1 + 3 * q.y, 1e-6);
  }
}

TEST(PlaneNatural, C1FitsLinearFunctionsExactly) {
  const PlanePoints points = support::clustered_points(500, 16);
  const auto f = [](Point2 p) { return 2 * p.x - p.y; };
  const PlaneNatural surface(triangulated(points), sampled(points, f),
                             options(NaturalKind::sibson_c1));
  for (const Point2 p : points) EXPECT_NEAR(surface.gradient(p).x, 2, 1e-6);
  for (const Point2 q : support::uniform_points(1000, 17)) {
    if (const double v = surface.value(q); !std::isnan(v)) {
      EXPECT_NEAR(v, f(q), 1e-9);
    }
  }
}

double franke(Point2 p) {
  const double x = 9 * p.x, y = 9 * p.y;
  return 0.75 * std::exp(-((x - 2) * (x - 2) + (y - 2) * (y - 2)) / 4) +
         0.75 * std::exp(-(x + 1) * (x + 1) / 49 - (y + 1) / 10) +
         0.5 * std::exp(-((x - 7) * (x - 7) + (y - 3) * (y - 3)) / 4) -
         0.2 * std::exp(-(x - 4) * (x - 4) - (y - 7) * (y - 7));
}
Gradient2 franke_gradient(Point2 p) {
  constexpr double h = 1e-5;
  return {(franke({p.x + h, p.y}) - franke({p.x - h, p.y})) / (2 * h),
          (franke({p.x, p.y + h}) - franke({p.x, p.y - h})) / (2 * h)};
}

enum class Slopes { fitted, given };
double error(std::size_t n, NaturalKind kind, Slopes slopes) {
  const PlanePoints points = support::uniform_points(n, 18);
  const auto t = triangulated(points);
  std::vector<Gradient2> gradients;
  for (const Point2 p : points) gradients.push_back(franke_gradient(p));
  const std::vector<double> values = sampled(points, franke);
  const PlaneNatural surface = slopes == Slopes::given
                                   ? PlaneNatural(t, values, gradients, options(kind))
                                   : PlaneNatural(t, values, options(kind));
  support::SplitMix64 random(19);
  double sum = 0;
  constexpr int num = 4000;
  for (int k = 0; k < num; ++k) {
    const Point2 q{random.between(0.2, 0.8), random.between(0.2, 0.8)};
    const double e = surface.value(q) - franke(q);
    sum += e * e;
  }
  return std::sqrt(sum / num);
}

TEST(PlaneNatural, ErrorFallsWithTheSquareOfSpacingAndOfC1WithItsCube) {
  const auto order = [](NaturalKind kind, Slopes slopes) {
    return std::log(error(1000, kind, slopes) / error(64000, kind, slopes)) / std::log(8);
  };
  EXPECT_GT(order(NaturalKind::sibson, Slopes::fitted), 1.8);
  EXPECT_GT(order(NaturalKind::laplace, Slopes::fitted), 1.8);
  EXPECT_GT(order(NaturalKind::sibson_c1, Slopes::fitted), 1.9);
  EXPECT_GT(order(NaturalKind::sibson_c1, Slopes::given), 2.8);
}

TEST(PlaneNatural, ValuesAndGridGiveTheSameBits) {
  const PlanePoints points = support::lattice_points(400);
  const auto f = [](Point2 p) { return std::sin(p.x) * p.y; };
  const Grid grid = plane_grid({-1, 20, -1, 20}, Spacing{0.25, 0.25});
  for (const NaturalKind kind : kinds) {
    const PlaneNatural surface(triangulated(points), sampled(points, f), options(kind));
    const std::vector<double> field = surface.grid(grid).values;
    EXPECT_EQ(support::first_difference(surface.values(plane_nodes(grid)), field),
              field.size());
    EXPECT_EQ(support::first_difference(
                  surface.grid(grid, {.num_threads = 3, .progress = {}}).values, field),
              field.size());
  }
}

TEST(PlaneNatural, KeepsOutsideAndMaxDistance) {
  const PlanePoints points{{0, 0}, {4, 0}, {0, 4}, {4, 4}, {2, 2}};
  const std::vector<double> values{1, 2, 3, 4, 5};
  const auto t = triangulated(points);
  for (const NaturalKind kind : kinds) {
    NaturalOptions o = options(kind);
    EXPECT_TRUE(std::isnan(PlaneNatural(t, values, o).value({5, 5})));
    EXPECT_TRUE(std::isnan(PlaneNatural(t, values, o).gradient({5, 5}).x));
    EXPECT_TRUE(std::isnan(PlaneNatural(t, values, o).value({std::nan(""), 1})));
    EXPECT_TRUE(PlaneNatural(t, values, o).values({}).empty());
    o.outside = Outside::nearest;
    EXPECT_EQ(PlaneNatural(t, values, o).value({5, 5}), 4);
    o.max_distance = 0.5;
    EXPECT_TRUE(std::isnan(PlaneNatural(t, values, o).value({2, 1})));
    EXPECT_TRUE(std::isnan(PlaneNatural(t, values, o).gradient({2, 1}).x));
    EXPECT_FALSE(std::isnan(PlaneNatural(t, values, o).value({2, 1.75})));
    o.max_distance = -1;
    EXPECT_THROW(PlaneNatural(t, values, o), Error);
    o.max_distance = 1;
    o.outside = Outside::linear;
    EXPECT_THROW(PlaneNatural(t, values, o), Error);
  }
}

TEST(PlaneNatural, RefusesWrongNumbersOfValuesAndGradients) {
  const PlanePoints points{{0, 0}, {4, 0}, {0, 4}};
  const auto t = triangulated(points);
  EXPECT_THROW(PlaneNatural(t, std::vector<double>{1, 2}), Error);
  EXPECT_THROW(PlaneNatural(t, std::vector<double>{1, 2, std::nan("")}), Error);
  EXPECT_THROW(PlaneNatural(t, std::vector<double>{1, 2, 3}, std::vector<Gradient2>(2)),
               Error);
  EXPECT_THROW(PlaneNatural(t, std::vector<double>{1, 2, 3},
                            std::vector<Gradient2>{{}, {1, std::nan("")}, {}}),
               Error);
}

TEST(PlaneNatural, OfFewOrCollinearPointsIsTheLinearSurface) {
  const std::array<PlanePoints, 4> sets{
      {{}, {{1, 2}}, {{1, 2}, {3, 4}}, {{0, 0}, {1, 1}, {2, 2}, {4, 4}}}};
  for (const PlanePoints& points : sets) {
    const auto t = triangulated(points);
    const std::vector<double> values = random_values(points.size(), 20);
    const PlaneLinear linear(t, values);
    for (const NaturalKind kind : kinds) {
      const PlaneNatural surface(t, values, options(kind));
      for (const Point2 q : {Point2{1, 2}, {2, 3}, {0.5, 0.5}, {3, 3}, {3, 3.5}})
        EXPECT_TRUE(is_same(surface.value(q), linear.value(q)));
    }
  }
}

// A hub of thousands of neighbours: more than fit into what needs no memory.
TEST(PlaneNatural, CopesWithThousandsOfNaturalNeighbours) {
  const PlanePoints points = support::wheel_points(3000);
  const auto f = [](Point2 p) { return p.x - 3 * p.y; };
  for (const NaturalKind kind : {NaturalKind::sibson, NaturalKind::laplace}) {
    const PlaneNatural surface(triangulated(points), sampled(points, f), options(kind));
    for (const Point2 q : {Point2{1e-3, 2e-3}, {0.4, 0.1}, {-0.7, 0.6}})
      EXPECT_NEAR(surface.value(q), f(q), 1e-11);
  }
}

}  // namespace
}  // namespace delone::interp
