#include "interp/vector_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "delaunay/error.hpp"
#include "interp/sphere_vector.hpp"
#include "interp/surfaces.hpp"

namespace delone::interp {
namespace {

using stripack::Direction;
using support::at_lonlat;
using support::is_same;
using support::SpherePoints;
using support::triangulated;

constexpr double radian = std::numbers::pi / 180;

enum class Method { linear, c1, natural };
const std::initializer_list<Method> all_methods{Method::linear, Method::c1,
                                                Method::natural};

SphereVectorField field_over(Method method, const SpherePoints& points,
                             const std::vector<EastNorth>& vectors) {
  const auto t = triangulated(points);
  if (method == Method::linear) return SphereVectorField::linear(t, vectors);
  if (method == Method::natural) return SphereVectorField::natural(t, vectors);
  C1Options options;
  options.tension = 0;
  options.gradients = Gradients::local;
  return SphereVectorField::c1(t, vectors, options);
}

Vector3 in_space(const Direction& p, EastNorth v) {
  const Vector3 east = east_at(p);
  return v.east * east + v.north * cross(vector(p), east);
}
EastNorth components(const Direction& p, Vector3 v) {
  const Vector3 east = east_at(p);
  return {dot(v, east), dot(v, cross(vector(p), east))};
}
template <class Flow>
std::vector<EastNorth> sampled_flow(const SpherePoints& points, Flow flow) {
  std::vector<EastNorth> vectors;
  vectors.reserve(points.size());
  for (const Direction& p : points) vectors.push_back(components(p, flow(p)));
  return vectors;
}

// A spiral of equal areas, from pole to pole.
SpherePoints spread_points(int n) {
  SpherePoints points;
  for (int k = 1; k <= n; ++k) {
    const double z = 1 - (2.0 * k - 1) / n,
                 lon = k * std::numbers::pi * (3 - std::sqrt(5.0)),
                 r = std::sqrt(1 - z * z);
    points.push_back(Direction::from(r * std::cos(lon), r * std::sin(lon), z));
  }
  return points;
}
SpherePoints scattered(int n, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  SpherePoints points{at_lonlat(0, 90), at_lonlat(0, -90), at_lonlat(180, 10)};
  while (static_cast<int>(points.size()) < n) {
    const Vector3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (dot(p, p) <= 1 && dot(p, p) > 0.01)
      points.push_back(Direction::from(p.x, p.y, p.z));
  }
  return points;
}

// Rotation about an axis of no special place.
constexpr Vector3 spin{0.3, -0.5, 0.7};
Vector3 rigid(const Direction& p) { return cross(spin, vector(p)); }

// x y z is a harmonic of degree three: its Laplacian is -12 times it.
double harmonic(const Direction& p) { return p.x() * p.y() * p.z(); }
Vector3 slope_of_harmonic(const Direction& p) {
  const Vector3 g{p.y() * p.z(), p.z() * p.x(), p.x() * p.y()};
  return g - dot(g, vector(p)) * vector(p);
}
Vector3 flow_along_harmonic(const Direction& p) {
  return cross(vector(p), slope_of_harmonic(p));
}

double distance(EastNorth a, EastNorth b) {
  return std::hypot(a.east - b.east, a.north - b.north);
}

template <class Flow>
double largest_error(const SphereVectorField& field, Flow flow) {
  double largest = 0;
  for (const Direction& p : scattered(2000, 5))
    largest = std::max(largest, distance(field.value(p), components(p, flow(p))));
  return largest;
}

TEST(SphereVectorField, RigidRotationIsExactWithC1) {
  const SpherePoints points = scattered(400, 1);
  const auto field = field_over(Method::c1, points, sampled_flow(points, rigid));
  EXPECT_LT(largest_error(field, rigid), 1e-9);
  SpherePoints queries = scattered(300, 2);
  queries.insert(queries.end(), points.begin(), points.end());
  for (const Direction& p : queries) {
    const VectorDerivatives d = field.derivatives(p);
    EXPECT_NEAR(d.divergence(), 0, 1e-7);
    EXPECT_NEAR(d.curl(), 2 * dot(spin, vector(p)), 1e-7);
    // Nothing is stretched.
    EXPECT_NEAR(d.east_by_east, 0, 1e-7);
    EXPECT_NEAR(d.east_by_north + d.north_by_east, 0, 1e-7);
  }
}

TEST(SphereVectorField, RigidRotationIsExactWithC1OfItsOwnChoice) {
  const SpherePoints points = scattered(200, 3);
  const auto field =
      SphereVectorField::c1(triangulated(points), sampled_flow(points, rigid));
  EXPECT_LT(largest_error(field, rigid), 1e-9);
}

TEST(SphereVectorField, RigidRotationIsOfTheOrderOfTheSquaredSpacingOtherwise) {
  for (const Method method : {Method::linear, Method::natural}) {
    std::array<double, 2> errors{};
    for (const int n : {200, 800}) {
      const SpherePoints points = spread_points(n);
      const auto field = field_over(method, points, sampled_flow(points, rigid));
      errors[n == 200 ? 0 : 1] = largest_error(field, rigid);
    }
    EXPECT_GT(errors[1], 1e-4);
    EXPECT_GT(errors[0] / errors[1], 3);
  }
}

TEST(SphereVectorField, TurnedNodesAndVectorsGiveTheTurnedField) {
  const auto turned = [](Vector3 v) {
    return Vector3{v.z, 0.6 * v.x - 0.8 * v.y, 0.8 * v.x + 0.6 * v.y};
  };
  const auto turned_direction = [&](const Direction& p) {
    const Vector3 v = turned(vector(p));
    return Direction::from(v.x, v.y, v.z);
  };
  const SpherePoints points = scattered(300, 7);
  const auto flow = [](const Direction& p) {
    const Vector3 v{std::sin(3 * p.y()), p.x() * p.z(), 1 + p.x()};
    return v - dot(v, vector(p)) * vector(p);
  };
  SpherePoints turned_points;
  std::vector<EastNorth> turned_vectors;
  for (const Direction& p : points) {
    turned_points.push_back(turned_direction(p));
    turned_vectors.push_back(components(turned_points.back(), turned(flow(p))));
  }
  for (const Method method : all_methods) {
    const auto a = field_over(method, points, sampled_flow(points, flow)),
               b = field_over(method, turned_points, turned_vectors);
    for (const Direction& p : spread_points(309)) {
      const Direction q = turned_direction(p);
      EXPECT_LT(length(turned(in_space(p, a.value(p))) - in_space(q, b.value(q))), 1e-7);
      EXPECT_NEAR(a.derivatives(p).divergence(), b.derivatives(q).divergence(), 1e-6);
      EXPECT_NEAR(a.derivatives(p).curl(), b.derivatives(q).curl(), 1e-6);
    }
  }
}

struct Rates {
  double divergence = 0, curl = 0;
};
// Root mean square errors.
Rates error_of_rates(int n, Vector3 (*flow)(const Direction&), Rates per_harmonic) {
  const SpherePoints points = spread_points(n);
  const auto field =
      SphereVectorField::c1(triangulated(points), sampled_flow(points, flow));
  const SpherePoints queries = scattered(1000, 11);
  const std::vector<VectorDerivatives> found = field.derivatives(queries);
  Rates sum;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double h = harmonic(queries[i]);
    sum.divergence += std::pow(found[i].divergence() - per_harmonic.divergence * h, 2);
    sum.curl += std::pow(found[i].curl() - per_harmonic.curl * h, 2);
  }
  const auto count = static_cast<double>(queries.size());
  return {std::sqrt(sum.divergence / count), std::sqrt(sum.curl / count)};
}

TEST(SphereVectorField, GradientOfAHarmonicHasItsLaplacianAsDivergenceAndNoCurl) {
  const Rates coarse = error_of_rates(250, slope_of_harmonic, {-12, 0}),
              fine = error_of_rates(1000, slope_of_harmonic, {-12, 0});
  EXPECT_LT(fine.divergence, 2e-3);
  EXPECT_LT(fine.curl, 2e-3);
  EXPECT_GT(coarse.divergence / fine.divergence, 7);
  EXPECT_GT(coarse.curl / fine.curl, 7);
}

TEST(SphereVectorField, FlowOfAStreamFunctionHasNoDivergenceAndItsLaplacianAsCurl) {
  const Rates coarse = error_of_rates(250, flow_along_harmonic, {0, -12}),
              fine = error_of_rates(1000, flow_along_harmonic, {0, -12});
  EXPECT_LT(fine.divergence, 2e-3);
  EXPECT_LT(fine.curl, 2e-3);
  EXPECT_GT(coarse.divergence / fine.divergence, 7);
  EXPECT_GT(coarse.curl / fine.curl, 7);
}

// The field's own derivative along a tangent, in space.
Vector3 difference_along(const SphereVectorField& field, const Direction& p,
                         Vector3 tangent) {
  constexpr double h = 2e-6;
  const auto at = [&](double step) {
    const Vector3 v = vector(p) + step * tangent;
    const Direction q = Direction::from(v.x, v.y, v.z);
    return in_space(q, field.value(q));
  };
  return (1 / (2 * h)) * (at(h) - at(-h));
}

TEST(SphereVectorField, DerivativesAreThoseOfTheFieldItself) {
  const SpherePoints points = scattered(150, 17);
  support::SplitMix64 random(3);
  std::vector<EastNorth> vectors(points.size());
  for (EastNorth& v : vectors) v = {random.between(-1, 1), random.between(-1, 1)};
  for (const Method method : all_methods) {
    const auto field = field_over(method, points, vectors);
    for (const Direction& p : spread_points(57)) {
      const Vector3 east = east_at(p);
      const EastNorth e = components(p, difference_along(field, p, east)),
                      n = components(p,
                                     difference_along(field, p, cross(vector(p), east)));
      const VectorDerivatives d = field.derivatives(p);
      EXPECT_LT(distance(field.value(p), {d.east, d.north}), 1e-12);
      EXPECT_NEAR(d.east_by_east, e.east, 1e-4);
      EXPECT_NEAR(d.north_by_east, e.north, 1e-4);
      EXPECT_NEAR(d.east_by_north, n.east, 1e-4);
      EXPECT_NEAR(d.north_by_north, n.north, 1e-4);
    }
  }
}

TEST(SphereVectorField, PassesOverPolesAndTheDateLineWithoutAStep) {
  const SpherePoints points = scattered(200, 19);
  const auto flow = [](const Direction& p) {
    const Vector3 v{1, p.y(), 0.5};
    return v - dot(v, vector(p)) * vector(p);
  };
  for (const Method method : all_methods) {
    const auto field = field_over(method, points, sampled_flow(points, flow));
    const auto vector_at = [&](double lon, double lat) {
      const Direction p = at_lonlat(lon, lat);
      return in_space(p, field.value(p));
    };
    for (const double pole : {-90.0, 90.0}) {
      const Vector3 there = vector_at(0, pole);
      for (double lon = -180; lon < 180; lon += 15)
        EXPECT_LT(length(vector_at(lon, pole * (1 - 1e-10)) - there), 1e-7);
    }
    for (double lat = -80; lat <= 80; lat += 10)
      EXPECT_LT(length(vector_at(180 - 1e-8, lat) - vector_at(-180 + 1e-8, lat)), 1e-7);
  }
}

TEST(SphereVectorField, PassesOverAPoleThatIsNoNodeWithoutAStep) {
  const SpherePoints points = spread_points(100);
  const auto field = field_over(Method::c1, points, sampled_flow(points, rigid));
  const Direction pole = at_lonlat(0, 90), beside = at_lonlat(77, 90 - 1e-9);
  EXPECT_LT(length(in_space(pole, field.value(pole)) - rigid(pole)), 1e-10);
  EXPECT_LT(length(in_space(beside, field.value(beside)) - rigid(pole)), 1e-10);
}

TEST(SphereVectorField, GivesTheDataBackBitForBit) {
  SpherePoints points = scattered(100, 23);
  points.push_back(at_lonlat(-120, 30));
  support::SplitMix64 random(29);
  std::vector<EastNorth> vectors(points.size());
  for (EastNorth& v : vectors) v = {random.between(-9, 9), random.between(-9, 9)};
  for (const Method method : all_methods) {
    const auto field = field_over(method, points, vectors);
    const std::vector<EastNorth> found = field.values(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const EastNorth alone = field.value(points[i]);
      EXPECT_TRUE(is_same(found[i].east, vectors[i].east));
      EXPECT_TRUE(is_same(found[i].north, vectors[i].north));
      EXPECT_TRUE(is_same(alone.east, vectors[i].east));
      EXPECT_TRUE(is_same(alone.north, vectors[i].north));
    }
    const VectorGrid grid =
        field.grid(globe_grid({-120, -110, 30, 40}, NodeCounts{2, 2}));
    EXPECT_TRUE(is_same(grid.east.values[0], vectors.back().east));
    EXPECT_TRUE(is_same(grid.north.values[0], vectors.back().north));
  }
}

TEST(SphereVectorField, IsTheSameAskedForOneByOneInABatchAndOnAGrid) {
  const SpherePoints points = scattered(120, 31);
  const std::vector<EastNorth> vectors = sampled_flow(points, flow_along_harmonic);
  const Grid grid = globe_grid({-180, 180, -80, 80}, NodeCounts{24, 17});
  const SpherePoints nodes = globe_nodes(grid);
  for (const Method method : all_methods) {
    const auto field = field_over(method, points, vectors);
    const VectorGrid on_grid = field.grid(grid, {.num_threads = 2, .progress = {}});
    const std::vector<EastNorth> batch =
        field.values(nodes, {.num_threads = 1, .progress = {}});
    const auto derivatives = field.derivatives(nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const EastNorth alone = field.value(nodes[i]);
      EXPECT_TRUE(is_same(alone.east, batch[i].east));
      EXPECT_TRUE(is_same(alone.north, batch[i].north));
      EXPECT_TRUE(is_same(alone.east, on_grid.east.values[i]));
      EXPECT_TRUE(is_same(alone.north, on_grid.north.values[i]));
      EXPECT_TRUE(is_same(field.derivatives(nodes[i]).curl(), derivatives[i].curl()));
    }
  }
}

TEST(SphereVectorField, GridCountsAtAPoleFromTheLongitudeOfEachColumn) {
  const SpherePoints points = scattered(60, 37);
  const auto field = field_over(Method::linear, points, sampled_flow(points, rigid));
  const Grid grid = globe_grid({-180, 180, -90, 90}, NodeCounts{8, 3});
  const VectorGrid found = field.grid(grid);
  for (const std::int64_t row : {std::int64_t{0}, std::int64_t{2}}) {
    const double lat = grid.y.coordinate(row);
    const Direction pole = at_lonlat(0, lat);
    for (std::int64_t i = 0; i < grid.x.size; ++i) {
      const double lon = grid.x.coordinate(i) * radian;
      const Vector3 east{-std::sin(lon), std::cos(lon), 0};
      const auto n = static_cast<std::size_t>(row * grid.x.size + i);
      const Vector3 v =
          found.east.values[n] * east + found.north.values[n] * cross(vector(pole), east);
      EXPECT_LT(length(v - rigid(pole)), 1e-14);
    }
  }
}

TEST(SphereVectorField, LongitudesOfPolesAreTakenOutAndPutBack) {
  const EastNorth v{3, 4};
  for (const double lat : {-90.0, 90.0}) {
    for (const double lon : {-180.0, -77.0, 0.0, 90.0, 350.0}) {
      const EastNorth there = without_longitude(v, {lon, lat}),
                      back = with_longitude(there, {lon, lat});
      EXPECT_LT(distance(back, v), 1e-15 * 8);
      const Direction beside = at_lonlat(lon, lat * (1 - 1e-12));
      EXPECT_LT(length(in_space(at_lonlat(0, lat), there) - in_space(beside, v)), 1e-9);
    }
  }
  EXPECT_EQ(without_longitude(v, {77, 89.9}).east, 3);
  EXPECT_EQ(with_longitude(v, {77, -89.9}).north, 4);
}

TEST(SphereVectorField, RepeatedPositionsTakeTheMeanVector) {
  SpherePoints points = scattered(20, 41);
  points.push_back(points[5]);
  std::vector<EastNorth> vectors(points.size(), {1, 0});
  vectors.back() = {0, 3};
  const auto t = triangulated(points);
  const auto at_repeat = [&](Duplicates policy) {
    return SphereVectorField::linear(t, vectors, {.duplicates = policy}).value(points[5]);
  };
  EXPECT_EQ(at_repeat(Duplicates::mean).east, 0.5);
  EXPECT_EQ(at_repeat(Duplicates::mean).north, 1.5);
  EXPECT_EQ(at_repeat(Duplicates::first).east, 1);
  EXPECT_EQ(at_repeat(Duplicates::last).north, 3);
  EXPECT_THROW(at_repeat(Duplicates::median), Error);
  EXPECT_THROW(at_repeat(Duplicates::min), Error);
  EXPECT_THROW(at_repeat(Duplicates::max), Error);
  EXPECT_THROW(at_repeat(Duplicates::error), Error);
}

TEST(SphereVectorField, NamesTheRowOfAComponentThatIsNoNumber) {
  const SpherePoints points = scattered(10, 43);
  const auto t = triangulated(points);
  std::vector<EastNorth> vectors(points.size(), {1, 2});
  vectors[4].north = std::nan("");
  try {
    static_cast<void>(SphereVectorField::c1(t, vectors));
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.rows().size(), 1u);
    EXPECT_EQ(error.rows()[0], 4);
  }
  EXPECT_THROW(
      static_cast<void>(SphereVectorField::linear(t, std::vector<EastNorth>{{1, 2}})),
      Error);
  vectors[4] = {};
  EXPECT_THROW(static_cast<void>(SphereVectorField::c1(t, vectors, {.tension = 2})),
               Error);
}

TEST(SphereVectorField, FewPointsHaveAValueWhereTheSurfaceHasOne) {
  const Direction a = at_lonlat(0, 0), b = at_lonlat(90, 0), middle = at_lonlat(45, 0);
  for (const Method method : all_methods) {
    EXPECT_TRUE(std::isnan(field_over(method, {}, {}).value(a).east));
    const auto one = field_over(method, {a}, {{1, 2}});
    EXPECT_EQ(one.value(a).north, 2);
    EXPECT_TRUE(std::isnan(one.value(b).north));
    const auto two = field_over(method, {a, b}, {{0, 1}, {0, 1}});
    EXPECT_NEAR(two.value(middle).north, 1, 1e-15);
    EXPECT_NEAR(two.value(middle).east, 0, 1e-15);
    EXPECT_TRUE(std::isnan(two.derivatives(at_lonlat(0, 50)).curl()));
  }
}

TEST(SphereVectorField, IsMissingOutsideAHemisphereUnlessTheNearestIsAskedFor) {
  SpherePoints points;
  for (const Direction& p : spread_points(100))
    if (p.z() > 0.3) points.push_back(p);
  const std::vector<EastNorth> vectors = sampled_flow(points, rigid);
  const auto t = triangulated(points);
  const Direction below = at_lonlat(10, -40);
  EXPECT_TRUE(std::isnan(SphereVectorField::linear(t, vectors).value(below).east));
  EXPECT_TRUE(
      std::isnan(SphereVectorField::c1(t, vectors).values(SpherePoints{below})[0].north));
  C1Options nearest;
  nearest.outside = Outside::nearest;
  EXPECT_FALSE(std::isnan(SphereVectorField::c1(t, vectors, nearest).value(below).east));
}

TEST(SphereVectorField, ScalesWithItsVectors) {
  const SpherePoints points = scattered(80, 47);
  const std::vector<EastNorth> vectors = sampled_flow(points, flow_along_harmonic);
  for (const double factor : {0x1p-600, 0x1p490}) {
    std::vector<EastNorth> scaled = vectors;
    for (EastNorth& v : scaled) v = {factor * v.east, factor * v.north};
    const auto a = field_over(Method::linear, points, vectors),
               b = field_over(Method::linear, points, scaled);
    for (const Direction& p : spread_points(33)) {
      EXPECT_LT(
          distance(a.value(p), {b.value(p).east / factor, b.value(p).north / factor}),
          1e-13);
    }
  }
}

TEST(SphereVectorField, CalmStaysCalm) {
  const SpherePoints points = scattered(50, 53);
  const auto field = field_over(Method::c1, points, std::vector<EastNorth>(50));
  for (const Direction& p : spread_points(20)) {
    EXPECT_EQ(field.value(p).east, 0);
    EXPECT_EQ(field.derivatives(p).divergence(), 0);
  }
}

class SphereVectorFieldOnSets : public testing::TestWithParam<support::SphereFamily> {};

std::vector<EastNorth> random_vectors(std::size_t n, std::uint64_t seed) {
  support::SplitMix64 random(seed);
  std::vector<EastNorth> vectors(n);
  for (EastNorth& v : vectors) v = {random.between(-1, 1), random.between(-1, 1)};
  return vectors;
}

TEST_P(SphereVectorFieldOnSets, GivesDataBackAndIsNeverMuchLongerThanThem) {
  const SpherePoints points = GetParam().make(60, 1);
  const auto t = triangulated(points);
  if (t->num_sites() < 1) return;
  std::vector<EastNorth> vectors = random_vectors(points.size(), 2);
  for (std::size_t row = 0; row < points.size(); ++row)
    vectors[row] = vectors[static_cast<std::size_t>(
        t->rows()[static_cast<std::size_t>(t->sites()[row])])];
  SpherePoints queries = points;
  t->adjacency().for_each_triangle([&](delaunay::Arc arc) {
    const auto c = t->adjacency().left(arc);
    const auto at = [&](std::size_t k) {
      return vector(t->points()[static_cast<std::size_t>(c[k])]);
    };
    const Vector3 p = at(0) + (at(1) + 2.0 * at(2));
    queries.push_back(Direction::from(p.x, p.y, p.z));
  });
  for (const Method method : {Method::linear, Method::c1}) {
    const auto field = field_over(method, points, vectors);
    const std::vector<EastNorth> found = field.values(queries);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i < points.size()) {
        EXPECT_TRUE(is_same(found[i].east, vectors[i].east));
        EXPECT_TRUE(is_same(found[i].north, vectors[i].north));
      } else if (t->adjacency().has_left(t->find(queries[i]))) {
        // Components leave their range, at most 2 sqrt(2) wide, by a quarter.
        EXPECT_LT(std::hypot(found[i].east, found[i].north),
                  std::sqrt(3.0) * std::sqrt(2.0) * 1.5 + 1e-9);
      }
    }
  }
}

TEST_P(SphereVectorFieldOnSets, DoesNotDependOnTheOrderOfRows) {
  const SpherePoints points = GetParam().make(40, 3);
  const auto t = triangulated(points);
  const std::vector<EastNorth> vectors = random_vectors(points.size(), 4);
  const SpherePoints reversed_points(points.rbegin(), points.rend());
  const std::vector<EastNorth> reversed(vectors.rbegin(), vectors.rend());
  const auto a = field_over(Method::c1, points, vectors),
             b = field_over(Method::c1, reversed_points, reversed);
  for (const Direction& p : spread_points(20)) {
    EXPECT_TRUE(is_same(a.value(p).east, b.value(p).east));
    EXPECT_TRUE(is_same(a.derivatives(p).curl(), b.derivatives(p).curl()));
  }
}

INSTANTIATE_TEST_SUITE_P(AllSets, SphereVectorFieldOnSets,
                         testing::ValuesIn(support::sphere_families().begin(),
                                           support::sphere_families().end()),
                         [](const auto& param_info) {
                           return std::string(param_info.param.name);
                         });

}  // namespace
}  // namespace delone::interp
