#include "stripack/cell_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "stripack/predicates.hpp"
#include "stripack/voronoi.hpp"
#include "support/quad_vector.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using support::cross;
using support::dot;
using support::Quad;
using support::QuadVector;
using support::SpherePoints;
using support::unit;
using support::operator-;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

std::vector<HalfAreas> half_areas_by(HalfAreaFunction work, const Triangulation& t) {
  const BackFaces back(t);
  const CellNeighbors neighbors(t, back);
  std::vector<HalfAreas> result(at(t.num_sites()));
  work(t.points(), neighbors, 0, result);
  return result;
}

#if defined(__x86_64__)
TEST(CellCorners, GiveTheSameBitsForEveryInstructionSet) {
  if (__builtin_cpu_supports("avx2") == 0) GTEST_SKIP() << "no AVX2 here";
  for (const support::SphereFamily& family : support::sphere_families()) {
    const Triangulation t(family.make(700, 2));
    const auto two = half_areas_by(HalfAreaWork<delaunay::Portable>::work, t),
               four = half_areas_by(half_areas_avx2(), t);
    for (std::size_t s = 0; s < two.size(); ++s) {
      EXPECT_EQ(two[s].re, four[s].re) << family.name << " " << s;
      EXPECT_EQ(two[s].im, four[s].im) << family.name << " " << s;
    }
  }
}
#endif

// What the frame's axes and the local vector stand for; axes are known through directions
// along the coordinates.
QuadVector in_space(const LocalFrame& frame, const LocalVector& c) {
  const std::array basis{Direction::from(1, 0, 0), Direction::from(0, 1, 0),
                         Direction::from(0, 0, 1)};
  QuadVector result{};
  for (std::size_t k = 0; k < 3; ++k) {
    const LocalVector axis = frame.local(basis[k]);
    result[k] = Quad(c.up) * axis.up + Quad(c.x) * axis.x + Quad(c.y) * axis.y;
  }
  return unit(result);
}

double sine_at(const Direction& a, const Direction& b, const Direction& c) {
  const QuadVector u = unit(a), p = unit(b) - u, q = unit(c) - u;
  return support::length(cross(p, q)) / (support::length(p) * support::length(q));
}

// 32 u R / sin(A) as seen from a corner with the angle A, 48 u R / sin(B) as seen from
// the apex of a needle with the angle B at its base.
TEST(Circumcenters, OfNeedlesAreFoundToTheStatedBound) {
  constexpr double u = 0x1p-53;
  const auto places = support::uniform_directions(300, 5);
  support::SplitMix64 random(6);
  int num_needles = 0;
  for (const double length : {0.5, 1e-2, 1e-4, 1e-6}) {
    for (const double base : {0.5, 0.1, 1e-2, 1e-4}) {
      for (const Direction& v : places) {
        const auto near = [&](const Direction& d, double step) {
          return Direction::from(d.x() + step * random.between(-1, 1),
                                 d.y() + step * random.between(-1, 1),
                                 d.z() + step * random.between(-1, 1));
        };
        const Direction b = near(v, length), c = near(b, base * length);
        if (orientation(v, b, c) <= 0) continue;
        const LocalFrame frame(v);
        const LocalVector center =
            frame.circumcenter(b, c, frame.spoke(b), frame.spoke(c));
        const QuadVector exact = support::circumcenter(v, b, c);
        const double radius = support::length(exact - unit(v));
        const double sine_v = sine_at(v, b, c), sine_b = sine_at(b, c, v);
        const bool is_needle = sine_v < 0.125;
        num_needles += static_cast<int>(is_needle);
        const double bound =
            is_needle ? 48 * u / std::max(sine_b, 0.125) : 32 * u / sine_v;
        EXPECT_LT(support::length(in_space(frame, center) - exact), bound * radius)
            << length << " " << base;
      }
    }
  }
  EXPECT_GT(num_needles, 1000);
}

Quad tan_half_area(const QuadVector& u, const QuadVector& v, const QuadVector& w) {
  return dot(u, cross(v - u, w - u)) / (1 + dot(u, v) + dot(v, w) + dot(w, u));
}

double quad_cell_area(const Triangulation& t, Site s) {
  const auto neighbors = t.adjacency().neighbors(s);
  const auto point = [&](std::size_t k) -> const Direction& {
    return t.points()[at(neighbors[k % neighbors.size()])];
  };
  const Direction& v = t.points()[at(s)];
  double area = 0;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const QuadVector p = support::circumcenter(v, point(k), point(k + 1)),
                     q = support::circumcenter(v, point(k + 1), point(k + 2));
    area += 2 * std::atan(static_cast<double>(tan_half_area(unit(v), p, q)));
  }
  return area;
}

TEST(SphereVoronoiAreas, KeepTheirDigitsForEveryShapeAndSize) {
  const std::vector<std::pair<std::string, SpherePoints>> sets{
      {"uniform", support::uniform_directions(2000, 3)},
      {"tracks", support::track_directions(1000000)},  // cells 60 times as long as wide
      {"grid", support::radian_grid_directions(2)},
      {"micro", support::box_directions(2000, 4, 1e-6)}};
  for (const auto& [name, points] : sets) {
    const Triangulation t(points);
    const std::vector<double> areas = voronoi_areas(t);
    for (Site s = 0; s < t.num_sites(); s += t.num_sites() / 10000 + 1) {
      if (t.adjacency().is_boundary(s)) continue;
      EXPECT_NEAR(areas[at(s)] / quad_cell_area(t, s), 1, 1e-13) << name;
    }
  }
}

}  // namespace
}  // namespace delone::stripack
