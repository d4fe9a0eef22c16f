#include "stripack/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include "stripack/predicate_rungs.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace delone::stripack {

void PrintTo(const Direction& d, std::ostream* out) {
  *out << std::hexfloat << '(' << d.x() << ", " << d.y() << ", " << d.z() << ')'
       << std::defaultfloat;
}

namespace {

using support::SplitMix64;
using Quadruple = std::array<Direction, 4>;

Direction draw(SplitMix64& random) {
  const auto coordinate = [&random] { return random.between(-1, 1); };
  return Direction::from(coordinate(), coordinate(), coordinate());
}

// A direction about `distance` from d.
Direction draw_near(SplitMix64& random, const Direction& d, double distance) {
  const auto moved = [&](double v) { return v + distance * random.between(-1, 1); };
  return Direction::from(moved(d.x()), moved(d.y()), moved(d.z()));
}

Direction mirrored(const Direction& d) { return Direction::from(d.x(), d.y(), -d.z()); }

// Every rung that answers gives the judge's answer.
void expect_exact(const Quadruple& q) {
  const auto& [a, b, c, p] = q;
  const int turn = support::exact_orientation(a, b, c);
  const int inside = support::exact_in_circle(a, b, c, p);
  const auto text = [&q] { return ::testing::PrintToString(q); };
  if (const int sign = orientation_filter(a, b, c)) {
    EXPECT_EQ(sign, turn) << text();
  }
  if (const auto sign = orientation_integer(a, b, c)) {
    EXPECT_EQ(*sign, turn) << text();
  }
  EXPECT_EQ(orientation_exact(a, b, c), turn) << text();
  EXPECT_EQ(orientation(a, b, c), turn) << text();
  if (const int sign = in_circle_filter(a, b, c, p)) {
    EXPECT_EQ(sign, inside) << text();
  }
  if (const auto sign = in_circle_integer(a, b, c, p)) {
    EXPECT_EQ(*sign, inside) << text();
  }
  if (const auto sign = in_circle_of_fixed_points(a, b, c, p)) {
    EXPECT_EQ(*sign, inside) << text();
  }
  EXPECT_EQ(in_circle_exact(a, b, c, p), inside) << text();
  EXPECT_EQ(in_circle(a, b, c, p), inside) << text();
}

int permutation_sign(const std::array<int, 4>& order) {
  int sign = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) sign = order[i] > order[j] ? -sign : sign;
  }
  return sign;
}

// All 24 orders of the four directions agree up to the sign of the permutation.
template <class Predicate>
void expect_antisymmetric(const Quadruple& q, Predicate predicate) {
  std::array order{0, 1, 2, 3};
  const int first = predicate(q[0], q[1], q[2], q[3]);
  do {
    const auto at = [&](std::size_t i) { return q[static_cast<std::size_t>(order[i])]; };
    EXPECT_EQ(predicate(at(0), at(1), at(2), at(3)), permutation_sign(order) * first)
        << ::testing::PrintToString(q);
  } while (std::next_permutation(order.begin(), order.end()));
}

// The facets (i, j, k) that have every other site below them, as directed edges
// with their counts.
struct Surface {
  int num_facets = 0;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  std::vector<bool> is_used;
};

bool is_facet(const std::vector<Direction>& sites, std::size_t i, std::size_t j,
              std::size_t k) {
  for (std::size_t m = 0; m < sites.size(); ++m) {
    if (m == i || m == j || m == k) continue;
    if (in_circle_perturbed(sites[i], sites[j], sites[k], sites[m]) > 0) return false;
  }
  return true;
}

Surface facets(const std::vector<Direction>& sites) {
  Surface surface{0, {}, std::vector<bool>(sites.size())};
  for (std::size_t i = 0; i < sites.size(); ++i) {
    for (std::size_t j = i + 1; j < sites.size(); ++j) {
      for (std::size_t k = i + 1; k < sites.size(); ++k) {
        if (k == j || !is_facet(sites, i, j, k)) continue;
        ++surface.num_facets;
        for (const auto& edge : {std::pair{i, j}, std::pair{j, k}, std::pair{k, i}}) {
          ++surface.edges[edge];
          surface.is_used[edge.first] = true;
        }
      }
    }
  }
  return surface;
}

// The facets close up to a sphere: every directed edge once and its reverse once,
// V - E + F = 2, every site a corner. No other set of triangles can do that, so
// the signs fit together.
void expect_closed_polyhedron(const std::vector<Direction>& sites) {
  const Surface surface = facets(sites);
  for (const auto& [edge, count] : surface.edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(surface.edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_EQ(surface.num_facets, 2 * static_cast<int>(sites.size()) - 4)
      << ::testing::PrintToString(sites);
  EXPECT_EQ(std::count(surface.is_used.begin(), surface.is_used.end(), false), 0);
}

std::vector<Direction> octahedron() {
  return {Direction::from(1, 0, 0), Direction::from(-1, 0, 0),
          Direction::from(0, 1, 0), Direction::from(0, -1, 0),
          Direction::from(0, 0, 1), Direction::from(0, 0, -1)};
}

std::vector<Direction> cube() {
  std::vector<Direction> corners;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      for (const double z : {-1, 1}) corners.push_back(Direction::from(x, y, z));
    }
  }
  return corners;
}

// The same site set with its axes exchanged, so that the circle stands differently.
std::vector<Direction> rotated(const std::vector<Direction>& sites, int turns) {
  std::vector<Direction> result;
  for (Direction d : sites) {
    for (int i = 0; i < turns; ++i) d = Direction::from(d.y(), d.z(), d.x());
    result.push_back(d);
  }
  return result;
}

// Different directions of the great circle z = 0 (tilt 0) or x = y (tilt 1).
std::vector<Direction> on_great_circle(SplitMix64& random, std::size_t count, int tilt) {
  std::vector<Direction> sites{tilt == 0 ? Direction::from(-1, 0, 0)
                                         : Direction::from(0, 0, -1)};
  while (sites.size() < count) {
    const double u = random.between(-1, 1), v = random.between(-1, 1);
    const Direction d = tilt == 0 ? Direction::from(u, v, 0) : Direction::from(u, u, v);
    if (std::find(sites.begin(), sites.end(), d) == sites.end()) sites.push_back(d);
  }
  return sites;
}

TEST(SphereOrientation, IsPositiveCounterClockwiseSeenFromOutside) {
  EXPECT_EQ(orientation(Direction::from(1, 0, 0), Direction::from(0, 1, 0),
                        Direction::from(0, 0, 1)),
            1);
  EXPECT_EQ(orientation(Direction::from(0, 1, 0), Direction::from(1, 0, 0),
                        Direction::from(0, 0, 1)),
            -1);
}

TEST(SphereOrientation, IsZeroOnTheEquatorAndOnTheMeridiansOf0And90Degrees) {
  SplitMix64 random(51);
  for (int i = 0; i < 200; ++i) {
    const auto equator = [&] {
      return Direction::from({.lon_deg = random.between(-180, 180), .lat_deg = 0});
    };
    EXPECT_EQ(orientation(equator(), equator(), equator()), 0);
    for (const double lon : {-90, 0, 90, 180}) {
      const auto meridian = [&] {
        return Direction::from({.lon_deg = lon, .lat_deg = random.between(-90, 90)});
      };
      EXPECT_EQ(orientation(meridian(), meridian(), meridian()), 0);
    }
  }
}

TEST(SphereInCircle, IsPositiveInsideOfSmallCounterClockwiseTriangles) {
  const auto at = [](double lon, double lat) {
    return Direction::from({.lon_deg = lon, .lat_deg = lat});
  };
  EXPECT_EQ(in_circle(at(0, 0), at(2, 0), at(1, 2), at(1, 1)), 1);
  EXPECT_EQ(in_circle(at(0, 0), at(2, 0), at(1, 2), at(1, 50)), -1);
  EXPECT_EQ(in_circle(at(2, 0), at(0, 0), at(1, 2), at(1, 1)), -1);
}

TEST(SphereInCircle, IsZeroForMirroredLonLatQuadruples) {
  SplitMix64 random(52);
  for (int i = 0; i < 500; ++i) {
    const double lon1 = 0.5 * static_cast<double>(random.below(180)) + 0.25,
                 lon2 = 0.25 * static_cast<double>(random.below(700));
    const double lat1 = random.between(-89, 0), lat2 = random.between(0, 89);
    const auto at = [](double lon, double lat) {
      return Direction::from({.lon_deg = lon, .lat_deg = lat});
    };
    // About the meridians of 0 and of 90 degrees, and about the equator.
    EXPECT_EQ(in_circle(at(-lon1, lat1), at(lon1, lat1), at(lon2, lat2), at(-lon2, lat2)),
              0);
    EXPECT_EQ(in_circle(at(90 - lon1, lat1), at(90 + lon1, lat1), at(90 + lon2, lat2),
                        at(90 - lon2, lat2)),
              0);
    EXPECT_EQ(in_circle(at(lon1, lat1), at(lon1, -lat1), at(lon2, lat2), at(lon2, -lat2)),
              0);
  }
}

TEST(SpherePredicates, AgreeWithTheJudgeAtEverySeparation) {
  SplitMix64 random(53);
  for (const double distance :
       {1.0, 1e-2, 1e-4, 1e-6, 0x1p-26, 1e-9, 1e-12, 1e-14, 4e-16}) {
    for (int i = 0; i < 400; ++i) {
      const Direction centre = draw(random);
      Quadruple q;
      for (Direction& d : q) d = draw_near(random, centre, distance);
      expect_exact(q);
    }
  }
}

TEST(SpherePredicates, AgreeWithTheJudgeNearExactTies) {
  SplitMix64 random(54);
  for (int i = 0; i < 3000; ++i) {
    const double distance = std::ldexp(1, -static_cast<int>(random.below(50)));
    const Direction a = draw(random), b = draw_near(random, a, distance);
    Quadruple q{a, mirrored(a), mirrored(b), b};
    EXPECT_EQ(in_circle(q[0], q[1], q[2], q[3]), 0);
    expect_exact(q);
    Direction& moved = q[random.below(4)];
    moved = Direction::from(std::nextafter(moved.x(), 0), moved.y(), moved.z());
    expect_exact(q);
  }
}

TEST(SpherePredicates, AgreeWithTheJudgeOnLonLatCells) {
  SplitMix64 random(55);
  for (const double step : {10.0, 0.5, 0.1, 1e-3, 1e-7}) {
    for (int i = 0; i < 300; ++i) {
      const double lon = step * std::floor(random.between(-180, 180) / step);
      const double lat = step * std::floor(random.between(-90, 89) / step);
      const auto at = [&](int x, int y) {
        return Direction::from(
            {.lon_deg = lon + x * step, .lat_deg = std::min(90.0, lat + y * step)});
      };
      expect_exact({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
    }
  }
}

TEST(SpherePredicates, AgreeWithTheJudgeWhereProductsUnderflow) {
  const auto at = [](double y, double z) { return Direction::from(1, y, z); };
  const std::vector<double> tiny{0,      1.95e-90, 7.49e-80, -7.49e-80,
                                 1e-170, 1e-300,   5e-324,   -5e-324};
  SplitMix64 random(56);
  for (int i = 0; i < 1500; ++i) {
    const auto coordinate = [&] { return tiny[random.below(tiny.size())]; };
    expect_exact({at(coordinate(), coordinate()), at(coordinate(), coordinate()),
                  at(coordinate(), coordinate()), at(coordinate(), coordinate())});
  }
  EXPECT_EQ(orientation(at(0, 0), at(5e-324, 0), at(0, 5e-324)), 1);
}

// Stored lengths differ by a few 1e-16, which moves the plane through the stored
// points by more than the sphere's curvature within 1e-9 radians: the test must
// be on directions.
TEST(SphereInCircle, DoesNotDependOnStoredLengths) {
  SplitMix64 random(57);
  int num_different = 0;
  for (int i = 0; i < 500; ++i) {
    const Direction a = draw(random);
    const Quadruple q{a, draw_near(random, a, 1e-9), draw_near(random, a, 1e-9),
                      draw_near(random, a, 1e-9)};
    const auto row = [&](std::size_t k) {
      return std::array<long double, 3>{static_cast<long double>(q[k].x()) - q[3].x(),
                                        static_cast<long double>(q[k].y()) - q[3].y(),
                                        static_cast<long double>(q[k].z()) - q[3].z()};
    };
    const auto u = row(0), v = row(1), w = row(2);
    const long double stored_plane = u[0] * (v[1] * w[2] - v[2] * w[1]) +
                                     u[1] * (v[2] * w[0] - v[0] * w[2]) +
                                     u[2] * (v[0] * w[1] - v[1] * w[0]);
    num_different += static_cast<int>(in_circle(q[0], q[1], q[2], q[3]) !=
                                      (stored_plane < 0 ? 1 : -1));
    expect_exact(q);
  }
  EXPECT_GT(num_different, 50);  // else this would not be the case it is about
}

TEST(SphereInCircle, IsAntisymmetric) {
  SplitMix64 random(58);
  for (int i = 0; i < 200; ++i) {
    const Direction a = draw(random), b = draw(random);
    expect_antisymmetric({a, b, draw(random), draw(random)}, in_circle);
    expect_antisymmetric({a, mirrored(a), mirrored(b), b}, in_circle);
    expect_antisymmetric({a, draw_near(random, a, 1e-15), draw_near(random, a, 1e-15), b},
                         in_circle);
  }
}

TEST(SphereInCirclePerturbed, IsAntisymmetricAndNeverZeroOnTies) {
  SplitMix64 random(59);
  for (int i = 0; i < 200; ++i) {
    const Direction a = draw(random), b = draw(random);
    for (int turns = 0; turns < 3; ++turns) {
      const std::vector<Direction> small =
          rotated({a, mirrored(a), mirrored(b), b}, turns);
      const std::vector<Direction> great =
          rotated(on_great_circle(random, 4, i % 2), turns);
      for (const auto& s : {small, great}) {
        expect_antisymmetric({s[0], s[1], s[2], s[3]}, in_circle_perturbed);
        EXPECT_NE(in_circle_perturbed(s[0], s[1], s[2], s[3]), 0);
      }
    }
  }
}

TEST(SphereInCirclePerturbed, PutsTheFirstOfFourByCoordinatesOutside) {
  SplitMix64 random(60);
  const auto key = [](const Direction& d) { return std::array{d.x(), d.y(), d.z()}; };
  for (int i = 0; i < 200; ++i) {
    const Direction a = draw(random), b = draw(random);
    std::vector<Direction> four{a, mirrored(a), mirrored(b), b};
    std::sort(four.begin(), four.end(),
              [&](const auto& s, const auto& t) { return key(s) < key(t); });
    const int front = orientation(four[1], four[2], four[3]);
    EXPECT_EQ(in_circle_perturbed(four[1], four[2], four[3], four[0]), -front);
  }
}

TEST(SphereInCirclePerturbed, MakesAClosedPolyhedronOfRandomSites) {
  SplitMix64 random(61);
  for (int i = 0; i < 30; ++i) {
    std::vector<Direction> sites;
    for (int k = 0; k < 9; ++k) sites.push_back(draw(random));
    expect_closed_polyhedron(sites);
  }
}

TEST(SphereInCirclePerturbed, MakesAClosedPolyhedronOfOctahedronAndCube) {
  expect_closed_polyhedron(octahedron());
  expect_closed_polyhedron(cube());
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    std::vector<Direction> sites = octahedron();
    for (const Direction& corner : cube()) sites.push_back(corner);
    sites = support::shuffled(sites, seed);
    sites.erase(sites.begin() + 9, sites.end());
    expect_closed_polyhedron(sites);
  }
}

TEST(SphereInCirclePerturbed, MakesAClosedPolyhedronOfGreatCircles) {
  SplitMix64 random(62);
  for (int i = 0; i < 20; ++i) {
    for (int turns = 0; turns < 3; ++turns) {
      const auto sites =
          rotated(on_great_circle(random, 4 + random.below(5), i % 2), turns);
      expect_closed_polyhedron(sites);
    }
  }
}

TEST(SphereInCirclePerturbed, MakesAClosedPolyhedronOfAGreatCircleAndOthers) {
  SplitMix64 random(63);
  for (int i = 0; i < 20; ++i) {
    std::vector<Direction> sites = on_great_circle(random, 6, i % 2);
    sites.push_back(draw(random));
    expect_closed_polyhedron(sites);  // all within a hemisphere
    sites.push_back(draw(random));
    expect_closed_polyhedron(sites);
  }
}

TEST(SphereInCirclePerturbed, MakesAClosedPolyhedronOfLonLatGrids) {
  for (const double lat : {-80.0, 0.0, 30.0}) {
    for (const double step : {90.0, 1.0, 1e-6}) {
      std::vector<Direction> sites;
      for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double y : {-0.1, 0.0, 0.1}) {
          sites.push_back(
              Direction::from({.lon_deg = x * step, .lat_deg = lat + y * step}));
        }
      }
      expect_closed_polyhedron(sites);
    }
  }
}

TEST(SphereInCirclePerturbed, MakesAClosedPolyhedronOfSitesOneUlpApart) {
  std::vector<Direction> sites;
  for (const double y : {0.0, 1e-16, 2e-16}) {
    for (const double z : {0.0, 1e-16, 5e-324}) sites.push_back(Direction::from(1, y, z));
  }
  expect_closed_polyhedron(sites);
}

TEST(SphereInCircleFilter, DecidesUniformSitesNearlyAlways) {
  SplitMix64 random(64);
  int num_undecided = 0;
  for (int i = 0; i < 100000; ++i) {
    const Direction a = draw(random);
    num_undecided += static_cast<int>(in_circle_filter(a, draw_near(random, a, 1e-3),
                                                       draw_near(random, a, 1e-3),
                                                       draw_near(random, a, 1e-3)) == 0);
  }
  EXPECT_LE(num_undecided, 2);
}

// Corners of grid cells are cocircular up to rounding: too close for the filter, far
// enough for 320 bits; only cells that mirror exactly go to the last rung.
TEST(SphereInCircleInteger, DecidesNearlyAllCellsOfTheHalfDegreeGrid) {
  int num_undecided = 0, num_exact = 0;
  for (double lat = -89.5; lat < 89.5; lat += 0.5) {
    for (double lon = -180; lon < 180; lon += 5) {
      const auto at = [&](double x, double y) {
        return Direction::from({.lon_deg = lon + x, .lat_deg = lat + y});
      };
      const Quadruple q{at(0, 0), at(.5, 0), at(.5, .5), at(0, .5)};
      if (in_circle_filter(q[0], q[1], q[2], q[3]) != 0) continue;
      ++num_undecided;
      num_exact +=
          static_cast<int>(!in_circle_integer(q[0], q[1], q[2], q[3]).has_value());
    }
  }
  EXPECT_GT(num_undecided, 1000);
  EXPECT_LT(num_exact, num_undecided / 50);
}

TEST(SphereInCircleInteger, LeavesExactTiesToTheLastRung) {
  const auto at = [](double lon, double lat) {
    return Direction::from({.lon_deg = lon, .lat_deg = lat});
  };
  EXPECT_EQ(in_circle_filter(at(-1, 5), at(1, 5), at(1, 6), at(-1, 6)), 0);
  EXPECT_FALSE(in_circle_integer(at(-1, 5), at(1, 5), at(1, 6), at(-1, 6)).has_value());
  EXPECT_EQ(in_circle_exact(at(-1, 5), at(1, 5), at(1, 6), at(-1, 6)), 0);
}

// Cells between two mirrors: equal lengths in pairs, all determinants cancel.
TEST(SphereInCircleOfFixedPoints, DecidesTies) {
  SplitMix64 random(65);
  const auto at = [](double lon, double lat) {
    return Direction::from({.lon_deg = lon, .lat_deg = lat});
  };
  int num_decided = 0;
  for (int i = 0; i < 1000; ++i) {
    const double lon = random.between(1, 80), south = random.between(1, 80),
                 north = south + 5;
    const Quadruple cell{at(-lon, south), at(lon, south), at(lon, north),
                         at(-lon, north)};
    const Quadruple equator{at(-lon, 0), at(south, 0), at(north, 0), at(lon + 90, 0)};
    for (const Quadruple& q : {cell, equator}) {
      const auto sign = in_circle_of_fixed_points(q[0], q[1], q[2], q[3]);
      EXPECT_EQ(sign.value_or(0), 0);
      EXPECT_EQ(in_circle_exact(q[0], q[1], q[2], q[3]), 0);
      num_decided += sign ? 1 : 0;
    }
  }
  EXPECT_GT(num_decided, 1800);
}

TEST(SphereInCircleOfFixedPoints, LeavesLengthsThatMatterToTheLastRung) {
  // A tie whose one direction is longer by an ulp in one component.
  const auto at = [](double x, double y, double z) { return Direction::from(x, y, z); };
  const Direction a = at(0.6, 0.8, 0), b = at(-0.6, 0.8, 0), c = at(-0.8, 0.6, 0);
  const Direction longer = at(std::nextafter(0.8, 1), 0.6, 0);
  EXPECT_EQ(in_circle_of_fixed_points(a, b, c, longer), 0);  // one great circle
  const Direction d = at(0.6, 0, 0.8), e = at(-0.6, 0, 0.8);
  expect_exact({a, b, e, d});
  expect_exact({at(std::nextafter(0.6, 1), 0.8, 0), b, e, d});
  expect_exact({at(0.6, std::nextafter(0.8, 1), 0), b, e, d});
  expect_exact({a, at(-0.6, std::nextafter(0.8, 0), 0), e, d});
}

}  // namespace
}  // namespace delone::stripack
