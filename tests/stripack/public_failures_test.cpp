// Spherical input that made other codes fail in public, each with the thread where it was
// reported (owner/repository and number on GitHub).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "stripack/defect.hpp"
#include "stripack/triangulation.hpp"
#include "support/corpus.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::SpherePoints;

SpherePoints corpus(const std::string& name) {
  static const auto cases = support::sphere_corpus(DELONE_CORPUS_DIR);
  const auto found = std::find_if(cases.begin(), cases.end(),
                                  [&](const auto& c) { return c.name == name; });
  if (found == cases.end()) throw std::invalid_argument("no case " + name);
  return found->sphere;
}

// All signs and permutations of (a, b, c).
void add_orbit(SpherePoints& points, double a, double b, double c) {
  std::array<double, 3> v{a, b, c};
  std::set<std::array<double, 3>> images;
  std::sort(v.begin(), v.end());
  do {
    for (int s = 0; s < 8; ++s) {
      images.insert({(s & 1 ? -v[0] : v[0]) + 0.0, (s & 2 ? -v[1] : v[1]) + 0.0,
                     (s & 4 ? -v[2] : v[2]) + 0.0});
    }
  } while (std::next_permutation(v.begin(), v.end()));
  for (const auto& w : images) points.push_back(Direction::from(w[0], w[1], w[2]));
}

// The 302 nodes of order 29: V. I. Lebedev, D. N. Laikov, Doklady Mathematics 59 (1999)
// 477-481.
SpherePoints lebedev_29() {
  SpherePoints points;
  add_orbit(points, 0, 0, 1);
  add_orbit(points, 1, 1, 1);
  for (const double a : {0.3515640345570105, 0.6566329410219612, 0.4729054132581005,
                         0.9618308523614838e-1, 0.2219645236294178, 0.7011766416089545})
    add_orbit(points, a, a, std::sqrt(1 - 2 * a * a));
  for (const double a : {0.2644152887060663, 0.5718955891878961})
    add_orbit(points, a, std::sqrt(1 - a * a), 0);
  for (const auto& [a, b] : {std::array{0.2510034751770465, 0.8000727494073952},
                             std::array{0.1233548532583327, 0.4127724083168531}})
    add_orbit(points, a, b, std::sqrt(1 - a * a - b * b));
  return points;
}

struct PublicFailure {
  const char* thread;
  const char* what;
  SpherePoints (*points)();
};
void PrintTo(const PublicFailure& f, std::ostream* out) {
  *out << f.thread << ": " << f.what;
}

const PublicFailure failures[] = {
    {"underworldcode/stripy#85", "Lebedev's nodes of order 29: hangs", lebedev_29},
    {"STRIPACK IER -2", "the first three nodes on a great circle",
     [] { return corpus("sphere_first_three_collinear"); }},
    {"underworldcode/stripy#69", "an octahedron, any three of four on a great circle",
     [] { return corpus("sphere_octahedron"); }},
    {"underworldcode/stripy#117", "all nodes on one great circle",
     [] { return corpus("sphere_great_circle"); }},
    {"GenericMappingTools/gmt#4254", "grid, poles and +-180 repeated",
     [] { return corpus("sphere_global_grid_30"); }},
    {"GenericMappingTools/gmt#634", "the same by one row a pole: failure in INTRC0",
     [] { return corpus("sphere_global_grid_one_pole_row"); }},
    {"UXARRAY/uxarray#1689", "ten-degree grid, poles and +-180 repeated",
     [] {
       SpherePoints points;
       for (const LonLat& p : support::global_grid(10))
         points.push_back(Direction::from(p));
       return points;
     }},
    {"scipy/scipy#8859", "four points in a cap of 40 degrees",
     [] { return corpus("sphere_tetrahedron_in_a_cap"); }},
    {"scipy/scipy#9386", "all points in a hemisphere, some on its boundary",
     [] { return corpus("sphere_hemisphere_closed"); }},
    {"Fil/d3-geo-voronoi#10", "700 points of one city",
     [] {
       support::SplitMix64 random(10);
       SpherePoints points;
       while (points.size() < 700) {
         const double lon = 2.35 + 1e-5 * static_cast<double>(random.below(1000));
         points.push_back(Direction::from(
             LonLat{lon, 48.85 + 1e-5 * static_cast<double>(random.below(1000))}));
       }
       return points;
     }},
    {"Turfjs/turf#1043", "points less than a kilometre apart",
     [] { return corpus("sphere_city"); }},
    {"CGAL sphere separation", "points closer than 2^-25, which are rejected",
     [] { return corpus("sphere_below_cgal_separation"); }},
    {"CGAL sphere ulps", "points an ulp apart", [] { return corpus("sphere_ulps"); }},
    {"JuliaGeo/GeometryOps.jl#489", "poles with many longitudes: NaN",
     [] { return corpus("sphere_pole_many_longitudes"); }},
    {"JuliaGeo/GeometryOps.jl#489 opposite", "opposite points",
     [] { return corpus("sphere_antipodal_pair_and_one"); }},
    {"google/s2geometry StableSignUnderflow", "(1, 1.95e-90, 7.49e-80)",
     [] { return corpus("sphere_underflow"); }},
    {"golang/geo#263", "components whose products underflow",
     [] {
       SpherePoints points;
       for (const double y : {1.95e-90, -1.95e-90, 1e-170, 5e-324})
         for (const double z : {7.49e-80, 1e-160, -5e-324})
           points.push_back(Direction::from(1, y, z));
       points.push_back(Direction::from(-1, 0, 0));
       points.push_back(Direction::from(0, 1, 0));
       return points;
     }},
    {"CGAL is_on_sphere", "vectors of lengths 1e-200, 1 + 1e-9 and 1e200",
     [] { return corpus("sphere_any_length"); }},
    {"CGAL cube", "eight corners of a cube", [] { return corpus("sphere_cube"); }},
};

class SpherePublicFailure : public testing::TestWithParam<PublicFailure> {};

TEST_P(SpherePublicFailure, IsTriangulatedExactly) {
  const SpherePoints points = GetParam().points();
  const Triangulation t(points);
  EXPECT_EQ(find_defect(t).value_or("none"), "none");
  EXPECT_EQ(support::exact_defect(points, t.triangles()).value_or("none"), "none");
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Triangulation shuffled(support::shuffled(points, seed));
    EXPECT_TRUE(shuffled.adjacency() == t.adjacency());
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, SpherePublicFailure, testing::ValuesIn(failures),
                         [](const auto& failure) {
                           std::string name = failure.param.thread;
                           for (char& c : name)
                             c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           return name;
                         });

// underworldcode/stripy#85: some of 10,000 random orders of these nodes never ended.
TEST(SpherePublicFailureOfOrder, LebedevNodesAreTheSameInTenThousandOrders) {
  const SpherePoints points = lebedev_29();
  ASSERT_EQ(points.size(), 302u);
  const Triangulation t(points);
  EXPECT_EQ(t.num_triangles(), 2 * 302 - 4);
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    ASSERT_TRUE(Triangulation(support::shuffled(points, seed)).adjacency() ==
                t.adjacency())
        << "seed " << seed;
  }
}

// GenericMappingTools/gmt#4254: one point a pole, both columns +-180, every half degree.
TEST(SpherePublicFailureOfGrids, HalfDegreeGridWithOnePointAPole) {
  SpherePoints points;
  for (const LonLat& p : support::global_grid(0.5)) {
    if (std::abs(p.lat_deg) != 90 || p.lon_deg == -180)
      points.push_back(Direction::from(p));
  }
  const Triangulation t(points);
  EXPECT_EQ(t.num_rows(), 721 * 359 + 2);
  EXPECT_EQ(t.num_sites(), 258482);
  EXPECT_EQ(t.num_triangles(), 2 * 258482 - 4);
  EXPECT_TRUE(t.boundary().empty());
}

}  // namespace
}  // namespace delone::stripack
