#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "delaunay/error.hpp"
#include "interp/natural_surface.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using std::numbers::pi;
using stripack::Direction;
using support::at_lonlat;
using support::is_same;
using support::random_values;
using support::sampled;
using support::SpherePoints;
using support::triangulated;

constexpr std::array kinds{NaturalKind::sibson, NaturalKind::laplace,
                           NaturalKind::sibson_c1};

NaturalOptions options(NaturalKind kind) {
  NaturalOptions result;
  result.kind = kind;
  return result;
}

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Nodes, middles of edges, points inside triangles, points as near to nodes as doubles
// come.
SpherePoints points_of_the_region(const stripack::Triangulation& t, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  SpherePoints points(t.points().begin(), t.points().end());
  for (const Direction& p : t.points()) {
    points.push_back(Direction::from(p.x() + 0x1p-53, p.y(), p.z()));
    points.push_back(Direction::from(p.x(), p.y() - 0x1p-52, p.z() + 0x1p-60));
  }
  t.adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto corners = t.adjacency().left(arc);
    const auto corner = [&](std::size_t k) { return t.points()[at(corners[k % 3])]; };
    const auto mixed = [&](double u, double v, double w) {
      const Direction a = corner(0), b = corner(1), c = corner(2);
      points.push_back(Direction::from(u * a.x() + v * b.x() + w * c.x(),
                                       u * a.y() + v * b.y() + w * c.y(),
                                       u * a.z() + v * b.z() + w * c.z()));
    };
    mixed(0.5, 0.5, 1e-17);
    mixed(1e-18, 0.3, 0.7);
    mixed(1, random.uniform(), random.uniform());
    mixed(1e-9, 1, 1e-12);
  });
  return points;
}

struct Vector {
  long double x, y, z;
};
Vector vector(const Direction& d) {
  const long double x = d.x(), y = d.y(), z = d.z();
  const long double size = std::sqrt(x * x + y * y + z * z);
  return {x / size, y / size, z / size};
}
long double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector combined(long double s, Vector a, long double t, Vector b) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}
Vector unit(Vector a) { return combined(1 / std::sqrt(dot(a, a)), a, 0, a); }

// Spherical polygons cut by great circles: the oracle of cells.
using Polygon = std::vector<Vector>;
Polygon nearer(const Polygon& polygon, Vector a, Vector b) {
  const Vector n = combined(1, a, -1, b);
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector c = polygon[k], d = polygon[(k + 1) % polygon.size()];
    const long double s = dot(c, n), u = dot(d, n);
    if (s >= 0) kept.push_back(c);
    if ((s < 0 && u > 0) || (s > 0 && u < 0))
      kept.push_back(unit(combined(std::abs(u), c, std::abs(s), d)));
  }
  return kept;
}

long double area(const Polygon& p) {
  long double sum = 0;
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    sum +=
        2 * std::atan2(dot(p[0], cross(combined(1, p[k], -1, p[0]),
                                       combined(1, p[k + 1], -1, p[0]))),
                       1 + dot(p[0], p[k]) + dot(p[k], p[k + 1]) + dot(p[k + 1], p[0]));
  }
  return sum;
}

// A cell that does not reach farther than `reach` (its tangent) from q.
Polygon cell_of(const Direction& q, const SpherePoints& points, long double reach) {
  const Vector up = vector(q);
  const Vector first =
      unit(cross(up, std::abs(up.z) < 0.6L ? Vector{0, 0, 1} : Vector{1, 0, 0}));
  const Vector second = cross(up, first);
  Polygon cell;
  for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    cell.push_back(unit(combined(1, up, reach, combined(s, first, t, second))));
  for (const Direction& p : points) cell = nearer(cell, up, vector(p));
  return cell;
}

std::vector<double> normalized(const std::vector<long double>& parts) {
  const long double sum = std::accumulate(parts.begin(), parts.end(), 0.0L);
  std::vector<double> result;
  for (const long double part : parts) result.push_back(static_cast<double>(part / sum));
  return result;
}

std::vector<double> brute_force_sibson(const Direction& q, const SpherePoints& points,
                                       long double reach) {
  const Polygon cell = cell_of(q, points, reach);
  std::vector<long double> areas;
  for (const Direction& p : points) {
    Polygon piece = cell;
    for (const Direction& other : points) {
      if (!(other == p)) piece = nearer(piece, vector(p), vector(other));
    }
    areas.push_back(area(piece));
  }
  return normalized(areas);
}

long double angle_between(Vector a, Vector b) {
  const Vector c = combined(1, a, -1, b);
  return 2 * std::asin(std::sqrt(dot(c, c)) / 2);
}

std::vector<double> brute_force_laplace(const Direction& q, const SpherePoints& points,
                                        long double reach) {
  const Polygon cell = cell_of(q, points, reach);
  std::vector<long double> ratios(points.size());
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Vector a = cell[k], b = cell[(k + 1) % cell.size()];
    const Vector middle = unit(combined(1, a, 1, b));
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (angle_between(middle, vector(points[i])) <
          angle_between(middle, vector(points[best])))
        best = i;
    }
    ratios[best] += angle_between(a, b) / angle_between(vector(q), vector(points[best]));
  }
  return normalized(ratios);
}

std::vector<double> spread(const NaturalWeights& w, const stripack::Triangulation& t) {
  std::vector<double> result(at(t.num_sites()));
  for (std::size_t k = 0; k < w.sites().size(); ++k)
    result[at(t.rows()[at(w.sites()[k])])] = w.weights()[k];
  return result;
}

void expect_weights_of_cells(const SpherePoints& points, const Direction& q,
                             long double reach, double tolerance) {
  const auto t = triangulated(points);
  const std::vector<double> zeros(points.size());
  const auto areas = brute_force_sibson(q, points, reach),
             ratios = brute_force_laplace(q, points, reach);
  const auto a = spread(SphereNatural(t, zeros).weights(q), *t),
             r = spread(SphereNatural(t, zeros, options(NaturalKind::laplace)).weights(q),
                        *t);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_NEAR(a[k], areas[k], tolerance) << "point " << k;
    EXPECT_NEAR(r[k], ratios[k], tolerance) << "point " << k;
  }
}

TEST(SphereNatural, WeightsAreStolenAreasAndEdgeRatios) {
  const SpherePoints points = support::uniform_directions(80, 1);
  for (const Direction& q : support::uniform_directions(25, 2))
    expect_weights_of_cells(points, q, 20, 1e-12);
  for (const double lat : {90.0, -90.0, 89.9999})
    expect_weights_of_cells(points, at_lonlat(17, lat), 20, 1e-12);
}

TEST(SphereNatural, WeightsOfHugeCellsAreStolenAreas) {
  const SpherePoints points{at_lonlat(0, 80), at_lonlat(10, -20), at_lonlat(130, -30),
                            at_lonlat(-110, -10), at_lonlat(70, -50)};
  for (const Direction& q : support::uniform_directions(25, 3))
    expect_weights_of_cells(points, q, 1e5L, 1e-11);
}

// In a box of 1e-9 radians, 6 mm on the Earth, the sphere is a plane to 1e-18.
TEST(SphereNatural, WeightsOfTinyCellsAreStolenAreas) {
  support::SplitMix64 random(4);
  const auto draw = [&](double low, double high) {
    return tripack::Point2{random.between(low, high), random.between(low, high)};
  };
  const auto on_sphere = [](tripack::Point2 p) {
    return Direction::from(1, 1e-9 * p.x, 1e-9 * p.y);
  };
  std::vector<tripack::Point2> flat;
  SpherePoints points;
  for (int k = 0; k < 80; ++k) {
    flat.push_back(draw(-1, 1));
    points.push_back(on_sphere(flat.back()));
  }
  const auto t = triangulated(points);
  const auto flat_t = std::make_shared<const tripack::Triangulation>(flat);
  const std::vector<double> zeros(points.size());
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(t, zeros, options(kind));
    const PlaneNatural flat_surface(flat_t, zeros, options(kind));
    for (int k = 0; k < 100; ++k) {
      const tripack::Point2 q = draw(-0.4, 0.4);
      const auto a = spread(surface.weights(on_sphere(q)), *t);
      const NaturalWeights w = flat_surface.weights(q);
      std::vector<double> expected(points.size());
      for (std::size_t i = 0; i < w.sites().size(); ++i)
        expected[at(flat_t->rows()[at(w.sites()[i])])] = w.weights()[i];
      for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(a[i], expected[i], 1e-12);
    }
  }
}

class SphereNaturalOnSets : public testing::TestWithParam<support::SphereFamily> {};

TEST_P(SphereNaturalOnSets, GivesNodesTheirValuesBitForBit) {
  const SpherePoints points = support::affordable(GetParam(), 300, 1);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 2);
  const std::vector<double> merged = values_at_sites(t->sites(), t->num_sites(), values);
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(t, values, options(kind));
    for (std::size_t row = 0; row < points.size(); ++row) {
      EXPECT_TRUE(is_same(surface.value(points[row]), merged[at(t->sites()[row])]))
          << "row " << row;
    }
  }
}

TEST_P(SphereNaturalOnSets, WeightsAreNotNegativeWithSumOneOnTheClosedRegion) {
  const SpherePoints points = support::affordable(GetParam(), 250, 3);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 4);
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(t, values, options(kind));
    for (const Direction& p : points_of_the_region(*t, 5)) {
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
      EXPECT_NEAR(sum, 1, 1e-13);
      EXPECT_TRUE(std::isfinite(v)) << p.x() << ' ' << p.y() << ' ' << p.z();
      EXPECT_LE(std::abs(v), kind == NaturalKind::sibson_c1 ? 30 : 1);
    }
  }
}

TEST_P(SphereNaturalOnSets, ValuesDoNotDependOnOrderOrThreads) {
  const SpherePoints points = support::affordable(GetParam(), 200, 6);
  const auto t = triangulated(points);
  const auto f = [](const Direction& p) { return std::sin(5 * p.x()) + p.y() * p.z(); };
  const SpherePoints queries = support::shuffled(points_of_the_region(*t, 7), 8);
  const SpherePoints other_rows = support::shuffled(points, 9);
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(t, sampled(points, f), options(kind));
    const std::vector<double> expected =
        surface.values(queries, {.num_threads = 1, .progress = {}});
    for (std::size_t i = 0; i < queries.size(); i += 5) {
      EXPECT_TRUE(is_same(surface.value(queries[i]), expected[i])) << i;
    }
    EXPECT_EQ(support::first_difference(
                  surface.values(queries, {.num_threads = 5, .progress = {}}), expected),
              queries.size());
    const SphereNatural same(triangulated(other_rows), sampled(other_rows, f),
                             options(kind));
    EXPECT_EQ(support::first_difference(same.values(queries), expected), queries.size());
  }
}

TEST_P(SphereNaturalOnSets, ReproducesConstantsExactly) {
  const SpherePoints points = support::affordable(GetParam(), 200, 10);
  const auto t = triangulated(points);
  const std::vector<double> constant(points.size(), 0.1);
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(t, constant, options(kind));
    for (const Direction& p : points_of_the_region(*t, 11)) {
      if (const double v = surface.value(p); !std::isnan(v)) {
        EXPECT_EQ(v, 0.1);
      }
    }
  }
}

TEST_P(SphereNaturalOnSets, GradientsAreFiniteOnTheClosedRegion) {
  const SpherePoints points = support::affordable(GetParam(), 120, 12);
  const auto t = triangulated(points);
  const SphereLinear linear(t, random_values(points.size(), 13));
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(t, random_values(points.size(), 13), options(kind));
    for (const Direction& p : points_of_the_region(*t, 14)) {
      // Not where an ulp makes slopes that are beyond doubles.
      const GradientSphere slope = linear.gradient(p);
      if (!std::isfinite(slope.east) || !std::isfinite(slope.north)) continue;
      const GradientSphere g = surface.gradient(p);
      EXPECT_FALSE(std::isnan(g.east) || std::isnan(g.north));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphereNaturalOnSets,
                         testing::ValuesIn(support::sphere_families()),
                         [](const auto& set) { return std::string(set.param.name); });

Direction turned(const Direction& d) {
  // Two turns about axes, 0.7 and 1.9 radians.
  const double c = std::cos(0.7), s = std::sin(0.7), e = std::cos(1.9), g = std::sin(1.9);
  const double x = c * d.x() - s * d.y(), y = s * d.x() + c * d.y(), z = d.z();
  return Direction::from(x, e * y - g * z, g * y + e * z);
}

TEST(SphereNatural, DoesNotChangeWithARotation) {
  const SpherePoints points = support::uniform_directions(500, 15);
  const std::vector<double> values = random_values(points.size(), 16);
  SpherePoints moved;
  for (const Direction& p : points) moved.push_back(turned(p));
  for (const NaturalKind kind : kinds) {
    const SphereNatural here(triangulated(points), values, options(kind)),
        there(triangulated(moved), values, options(kind));
    for (const Direction& q : support::uniform_directions(2000, 17))
      EXPECT_NEAR(here.value(q), there.value(turned(q)), 1e-10);
  }
}

TEST(SphereNatural, GradientsAreThoseOfTheValues) {
  const SpherePoints points = support::uniform_directions(300, 18);
  const std::vector<double> values = random_values(points.size(), 19);
  const auto t = triangulated(points);
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(t, values, options(kind));
    support::SplitMix64 random(20);
    int num_rough = 0;
    for (int k = 0; k < 400; ++k) {
      const double lon = random.between(-180, 180), lat = random.between(-80, 80);
      constexpr double h = 1e-4;
      const double radian = 180 / pi, across = std::cos(lat / radian);
      const double east = (surface.value(at_lonlat(lon + h, lat)) -
                           surface.value(at_lonlat(lon - h, lat))) /
                          (2 * h) * radian / across;
      const double north = (surface.value(at_lonlat(lon, lat + h)) -
                            surface.value(at_lonlat(lon, lat - h))) /
                           (2 * h) * radian;
      const GradientSphere g = surface.gradient(at_lonlat(lon, lat));
      if (std::hypot(g.east - east, g.north - north) > 1e-2) ++num_rough;
    }
    EXPECT_LE(num_rough, kind == NaturalKind::laplace ? 4 : 1);
  }
}

double smooth(const Direction& p) {
  return std::sin(2 * p.x() + 0.3) * std::cos(3 * p.y()) + p.z() * p.z();
}
GradientSphere smooth_gradient(const Direction& p) {
  const double x = 2 * std::cos(2 * p.x() + 0.3) * std::cos(3 * p.y());
  const double y = -3 * std::sin(2 * p.x() + 0.3) * std::sin(3 * p.y());
  const double z = 2 * p.z(), across = std::hypot(p.x(), p.y());
  const double c = p.x() / across, s = p.y() / across;
  return {-s * x + c * y, -p.z() * (c * x + s * y) + across * z};
}

enum class Slopes { fitted, given };
double error(std::size_t n, NaturalKind kind, Slopes slopes) {
  const SpherePoints points = support::uniform_directions(n, 21);
  const auto t = triangulated(points);
  const std::vector<double> values = sampled(points, smooth);
  std::vector<GradientSphere> gradients;
  for (const Direction& p : points) gradients.push_back(smooth_gradient(p));
  const SphereNatural surface = slopes == Slopes::given
                                    ? SphereNatural(t, values, gradients, options(kind))
                                    : SphereNatural(t, values, options(kind));
  double sum = 0;
  const SpherePoints queries = support::uniform_directions(3000, 22);
  for (const Direction& q : queries) sum += std::pow(surface.value(q) - smooth(q), 2);
  return std::sqrt(sum / 3000);
}

TEST(SphereNatural, ErrorFallsWithTheSquareOfSpacingAndOfC1WithItsCube) {
  const auto order = [](NaturalKind kind, Slopes slopes) {
    return std::log(error(1000, kind, slopes) / error(64000, kind, slopes)) / std::log(8);
  };
  EXPECT_GT(order(NaturalKind::sibson, Slopes::fitted), 1.8);
  EXPECT_GT(order(NaturalKind::laplace, Slopes::fitted), 1.8);
  EXPECT_GT(order(NaturalKind::sibson_c1, Slopes::fitted), 1.9);
  EXPECT_GT(order(NaturalKind::sibson_c1, Slopes::given), 2.8);
}

TEST(SphereNatural, C1HasTheGivenGradientsAtItsNodes) {
  const SpherePoints points = support::uniform_directions(100, 23);
  const std::vector<double> values = random_values(points.size(), 24),
                            slopes = random_values(2 * points.size(), 25);
  std::vector<GradientSphere> gradients;
  for (std::size_t i = 0; i < points.size(); ++i)
    gradients.push_back({slopes[2 * i], slopes[2 * i + 1]});
  const SphereNatural surface(triangulated(points), values, gradients,
                              options(NaturalKind::sibson_c1));
  const auto error_beside_nodes = [&](double degrees) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const stripack::LonLat p = stripack::lonlat(points[i]);
      const GradientSphere g =
          surface.gradient(at_lonlat(p.lon_deg + degrees, p.lat_deg - 0.6 * degrees));
      sum += std::hypot(g.east - gradients[i].east, g.north - gradients[i].north);
    }
    return sum;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(surface.gradient(points[i]).east, gradients[i].east, 1e-14);
    EXPECT_NEAR(surface.gradient(points[i]).north, gradients[i].north, 1e-14);
  }
  EXPECT_LT(error_beside_nodes(1e-5), error_beside_nodes(1e-3) / 50);
}

// The largest change of the gradient from one step along the equator to the next.
double roughness(const SphereNatural& surface, int steps) {
  double largest = 0;
  GradientSphere before = surface.gradient(at_lonlat(0, 0.1));
  for (int k = 1; k <= steps; ++k) {
    const GradientSphere g = surface.gradient(at_lonlat(100.0 * k / steps, 0.1));
    largest = std::max(largest, std::hypot(g.east - before.east, g.north - before.north));
    before = g;
  }
  return largest;
}

TEST(SphereNatural, GradientsOfSibsonsSurfacesAreContinuousAndLaplacesJump) {
  const SpherePoints points = support::uniform_directions(150, 26);
  const auto t = triangulated(points);
  const std::vector<double> values = random_values(points.size(), 27);
  const auto ratio = [&](NaturalKind kind) {
    const SphereNatural surface(t, values, options(kind));
    return roughness(surface, 2000) / roughness(surface, 200000);
  };
  EXPECT_GT(ratio(NaturalKind::sibson), 8);
  EXPECT_GT(ratio(NaturalKind::sibson_c1), 8);
  EXPECT_LT(ratio(NaturalKind::laplace), 3);
}

TEST(SphereNatural, IsContinuousUpToTheRimOfAHemisphericalSet) {
  const SpherePoints points{at_lonlat(0, 0), at_lonlat(40, 0), at_lonlat(45, 30),
                            at_lonlat(-5, 30), at_lonlat(20, 12)};
  const std::vector<double> values{1, 5, -3, 2, 40};
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(triangulated(points), values, options(kind));
    for (const double lon : {1.0, 13.0, 20.0, 37.0}) {
      const double on_rim = surface.value(at_lonlat(lon, 0));
      EXPECT_TRUE(std::isfinite(on_rim));
      for (const double lat : {1e-5, 1e-8, 1e-11})
        EXPECT_NEAR(surface.value(at_lonlat(lon, lat)), on_rim, 1e3 * lat + 1e-11);
    }
  }
}

TEST(SphereNatural, GridHasTheBitsOfSinglePointsAndOneValueAtAPole) {
  const SpherePoints points = support::uniform_directions(300, 28);
  const Grid grid = globe_grid({-180, 180, -90, 90}, Spacing{5, 5});
  for (const NaturalKind kind : kinds) {
    const SphereNatural surface(triangulated(points), sampled(points, smooth),
                                options(kind));
    const std::vector<double> field = surface.grid(grid).values;
    EXPECT_EQ(support::first_difference(surface.values(globe_nodes(grid)), field),
              field.size());
    const auto row = static_cast<std::size_t>(grid.x.size);
    for (std::size_t i = 1; i < row; ++i) EXPECT_EQ(field[i], field[0]);
  }
}

TEST(SphereNatural, KeepsOutsideAndMaxDistance) {
  const SpherePoints points{at_lonlat(-10, 0), at_lonlat(10, 0), at_lonlat(0, 15)};
  const auto t = triangulated(points);
  const std::vector<double> values{1, 2, 3};
  for (const NaturalKind kind : kinds) {
    NaturalOptions o = options(kind);
    EXPECT_TRUE(std::isnan(SphereNatural(t, values, o).value(at_lonlat(180, 0))));
    o.outside = Outside::nearest;
    EXPECT_EQ(SphereNatural(t, values, o).value(at_lonlat(120, -10)), 2);
    o.max_distance = 100;
    EXPECT_TRUE(std::isnan(SphereNatural(t, values, o).value(at_lonlat(0, 5))));
    EXPECT_FALSE(std::isnan(SphereNatural(t, values, o).value(at_lonlat(0, 14.5))));
    o.max_distance = -1;
    EXPECT_THROW(SphereNatural(t, values, o), Error);
    o.max_distance = 1;
    o.outside = Outside::linear;
    EXPECT_THROW(SphereNatural(t, values, o), Error);
  }
}

TEST(SphereNatural, RefusesWrongNumbersOfGradients) {
  const SpherePoints points{at_lonlat(-10, 0), at_lonlat(10, 0), at_lonlat(0, 15)};
  const auto t = triangulated(points);
  EXPECT_THROW(SphereNatural(t, std::vector<double>{1, 2}), Error);
  EXPECT_THROW(
      SphereNatural(t, std::vector<double>{1, 2, 3}, std::vector<GradientSphere>(4)),
      Error);
  EXPECT_THROW(SphereNatural(t, std::vector<double>{1, 2, 3},
                             std::vector<GradientSphere>{{}, {std::nan(""), 0}, {}}),
               Error);
}

TEST(SphereNatural, OfFewPointsOrOneGreatCircleIsTheLinearSurface) {
  const std::array<SpherePoints, 4> sets{
      {{},
       {at_lonlat(10, 0)},
       {at_lonlat(10, 0), at_lonlat(40, 0)},
       {at_lonlat(0, 0), at_lonlat(50, 0), at_lonlat(90, 0), at_lonlat(130, 0)}}};
  for (const SpherePoints& points : sets) {
    const auto t = triangulated(points);
    const std::vector<double> values = random_values(points.size(), 29);
    const SphereLinear linear(t, values);
    for (const NaturalKind kind : kinds) {
      const SphereNatural surface(t, values, options(kind));
      for (const double lon : {10.0, 20.0, 45.0, 131.0})
        EXPECT_TRUE(
            is_same(surface.value(at_lonlat(lon, 0)), linear.value(at_lonlat(lon, 0))));
    }
  }
}

}  // namespace
}  // namespace delone::interp
