#include "stripack/measures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/predicates.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using std::numbers::pi;

__extension__ typedef __float128 Quad;
using QuadVector = std::array<Quad, 3>;

Quad quad_sqrt(Quad v) {
  Quad root = std::sqrt(static_cast<double>(v));
  for (int i = 0; i < 3; ++i) root = (root + v / root) / 2;
  return root;
}

Quad dot(const QuadVector& a, const QuadVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

QuadVector cross(const QuadVector& a, const QuadVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

QuadVector unit(QuadVector v) {
  const Quad length = quad_sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

QuadVector unit(const Direction& d) { return unit(QuadVector{d.x(), d.y(), d.z()}); }

QuadVector operator-(const QuadVector& a, const QuadVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// tan(E/2) in 113 bits.
Quad quad_tan_half_area(const Direction& a, const Direction& b, const Direction& c) {
  const QuadVector u = unit(a), v = unit(b), w = unit(c);
  return dot(u, cross(v - u, w - u)) / (1 + dot(u, v) + dot(v, w) + dot(w, u));
}

// Triangles of the given size somewhere, of all shapes.
std::vector<std::array<Direction, 3>> triangles(double size, int flatness) {
  std::vector<std::array<Direction, 3>> result;
  support::SplitMix64 random(7);
  const auto places = support::uniform_directions(500, 3);
  for (const Direction& p : places) {
    const auto near = [&](const Direction& d, double step) {
      return Direction::from(d.x() + step * random.between(-1, 1),
                             d.y() + step * random.between(-1, 1),
                             d.z() + step * random.between(-1, 1));
    };
    const Direction b = near(p, size);
    const double t = random.uniform();
    const Direction middle =
        Direction::from(p.x() + t * (b.x() - p.x()), p.y() + t * (b.y() - p.y()),
                        p.z() + t * (b.z() - p.z()));
    const Direction c = near(middle, std::ldexp(size, -flatness));
    const int side = orientation(p, b, c);
    if (side > 0) result.push_back({p, b, c});
    if (side < 0) result.push_back({b, p, c});
  }
  return result;
}

TEST(SphereArea, KeepsItsDigitsForTinyTrianglesAndSlivers) {
  for (const double size : {1.0, 1e-3, 1e-6, 1e-9}) {
    for (const int flatness : {0, 6, 12}) {
      for (const auto& [a, b, c] : triangles(size, flatness)) {
        const double half = std::atan(static_cast<double>(quad_tan_half_area(a, b, c)));
        const double exact = 2 * (half < 0 ? half + pi : half);
        EXPECT_NEAR(signed_area(a, b, c) / exact, 1, 1e-14) << size << " " << flatness;
      }
    }
  }
}

TEST(SphereArea, OfAnOctantIsHalfPi) {
  const Direction x = Direction::from(1, 0, 0), y = Direction::from(0, 1, 0),
                  z = Direction::from(0, 0, 1);
  EXPECT_NEAR(signed_area(x, y, z), pi / 2, 1e-15);
  EXPECT_NEAR(signed_area(x, z, y), -pi / 2, 1e-15);
  for (const double angle : angles(x, y, z)) EXPECT_NEAR(angle, pi / 2, 1e-15);
}

TEST(SphereArea, IsZeroExactlyOnAGreatCircle) {
  const auto at = [](double lon) { return Direction::from(LonLat{lon, 0}); };
  EXPECT_EQ(signed_area(at(0), at(10), at(37)), 0);
  EXPECT_EQ(signed_area(at(0), at(120), at(240)), 0);
}

// AREAS of STRIPACK, from arc cosines of dihedral angles, is 4 % off at 1e-7 radians.
TEST(SphereArea, IsTheLimitOfThePlaneForAnEquilateralTriangle) {
  for (const double size : {1e-6, 1e-7, 1e-9}) {
    const double h = std::sqrt(3.0) / 2 * size;
    const double area = signed_area(Direction::from(1, 0, 0), Direction::from(1, size, 0),
                                    Direction::from(1, size / 2, h));
    EXPECT_NEAR(area / (size * h / 2), 1, 2 * size * size + 4e-15);
  }
}

TEST(SphereArea, SumsToTheSphereOverATriangulation) {
  const support::SpherePoints points = support::uniform_directions(2000, 9);
  const Triangulation t(points);
  double sum = 0;
  for (const auto& [a, b, c] : t.triangles()) {
    const auto p = [&](Node row) { return points[static_cast<std::size_t>(row)]; };
    sum += signed_area(p(a), p(b), p(c));
  }
  EXPECT_NEAR(sum / (4 * pi), 1, 1e-14);
}

// R. J. Renka's driver: area of the hull of the pole and a ring over that of the sphere.
TEST(SphereArea, OfTheHullOfRenkasDriverIsAsPublished) {
  support::SpherePoints points{Direction::from(LonLat{0, 90})};
  for (int i = 0; i < 8; ++i) points.push_back(Direction::from(LonLat{45.0 * i, 60}));
  double sum = 0;
  const Triangulation t(points);
  for (const auto& [a, b, c] : t.triangles()) {
    const auto p = [&](Node row) { return points[static_cast<std::size_t>(row)]; };
    sum += signed_area(p(a), p(b), p(c));
  }
  EXPECT_NEAR(sum / (4 * pi), 0.0614689230, 5e-11);
}

TEST(SphereAngles, HaveTheTrianglesAreaAsTheirExcess) {
  for (const auto& [a, b, c] : triangles(1, 0)) {
    const auto [u, v, w] = angles(a, b, c);
    EXPECT_NEAR(u + v + w - pi, signed_area(a, b, c), 2e-14);
  }
}

TEST(SphereCircumcircle, IsThatOfQuadrupleArithmetic) {
  for (const double size : {1.0, 1e-3, 1e-6, 1e-9}) {
    for (const int flatness : {0, 6, 12}) {
      for (const auto& [a, b, c] : triangles(size, flatness)) {
        const QuadVector u = unit(a), axis = unit(cross(unit(b) - u, unit(c) - u));
        const Cap cap = circumcircle(a, b, c);
        const QuadVector error = unit(cap.center) - axis;
        EXPECT_LT(std::sqrt(static_cast<double>(dot(error, error))), 1e-15) << size;
        const QuadVector chord = u - axis;
        const double radius =
            2 * std::asin(static_cast<double>(quad_sqrt(dot(chord, chord))) / 2);
        EXPECT_NEAR(cap.radius / radius, 1, std::ldexp(1e-13, flatness))
            << size << " " << flatness;
      }
    }
  }
}

TEST(SphereCircumcircle, OfAClockwiseTriangleIsTheOtherSide) {
  const Direction x = Direction::from(1, 0, 0), y = Direction::from(0, 1, 0),
                  z = Direction::from(0, 0, 1);
  const Cap small = circumcircle(x, y, z), large = circumcircle(x, z, y);
  EXPECT_NEAR(small.radius + large.radius, pi, 1e-15);
  EXPECT_NEAR(angle(small.center, large.center), pi, 1e-15);
  EXPECT_THROW((void)circumcircle(x, x, y), Error);
}

TEST(SphereAspectRatio, OfAnOctantIsOneHalf) {
  EXPECT_NEAR(aspect_ratio(Direction::from(1, 0, 0), Direction::from(0, 1, 0),
                           Direction::from(0, 0, 1)),
              0.5, 1e-15);
}

}  // namespace
}  // namespace delone::stripack
