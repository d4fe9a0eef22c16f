#include "stripack/measures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "delaunay/error.hpp"
#include "stripack/predicates.hpp"
#include "support/quad_vector.hpp"
#include "support/random.hpp"
#include "support/sphere_sets.hpp"

namespace delone::stripack {
namespace {

using std::numbers::pi;
using support::cross;
using support::dot;
using support::Quad;
using support::QuadVector;
using support::unit;
using support::operator-;

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

double quad_area(const Direction& a, const Direction& b, const Direction& c) {
  const double half = std::atan(static_cast<double>(quad_tan_half_area(a, b, c)));
  return 2 * (half < 0 ? half + pi : half);
}

TEST(SphereArea, IsCorrectToTwoUnitsInTheLastPlace) {
  for (const double size : {1.0, 0.3, 1e-3, 1e-6, 1e-9}) {
    for (const int flatness : {0, 6, 12}) {
      for (const auto& [a, b, c] : triangles(size, flatness))
        EXPECT_NEAR(signed_area(a, b, c) / quad_area(a, b, c), 1, 5e-16)
            << size << " " << flatness;
    }
  }
}

// 1 + cosines cancels there.
TEST(SphereArea, IsCorrectToTwoUnitsInTheLastPlaceForCornersAlmostOpposite) {
  support::SplitMix64 random(11);
  const auto places = support::uniform_directions(500, 4);
  for (const double distance : {1e-2, 1e-5, 1e-8, 1e-11}) {
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const Direction &a = places[i], &c = places[i + 1];
      const Direction b = Direction::from(-a.x() + distance * random.between(-1, 1),
                                          -a.y() + distance * random.between(-1, 1),
                                          -a.z() + distance * random.between(-1, 1));
      const int side = orientation(a, b, c);
      const double exact = side > 0 ? quad_area(a, b, c) : -quad_area(b, a, c);
      EXPECT_NEAR(signed_area(a, b, c) / exact, 1, 5e-16) << distance;
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

// sin(radius) is the radius of the flat triangle, which 113 bits tell to 1e-20 even for
// those of 1e-9; taken from the centre, they would tell it to 1e-34 / (size^2 sine) only.
double quad_radius(const Direction& a, const Direction& b, const Direction& c) {
  const QuadVector u = unit(a), p = unit(b) - u, q = unit(c) - u, r = q - p;
  const QuadVector normal = cross(p, q);
  const Quad square = dot(p, p) * dot(q, q) * dot(r, r) / (4 * dot(normal, normal));
  const double radius = std::asin(static_cast<double>(support::quad_sqrt(square)));
  return dot(normal, u) > 0 ? radius : pi - radius;
}

TEST(SphereCircumcircle, IsThatOfQuadrupleArithmetic) {
  for (const double size : {1.0, 1e-3, 1e-6, 1e-9}) {
    for (const int flatness : {0, 6, 12}) {
      for (const auto& [a, b, c] : triangles(size, flatness)) {
        const Cap cap = circumcircle(a, b, c);
        const QuadVector axis = support::circumcenter(a, b, c);
        EXPECT_LT(support::length(unit(cap.center) - axis), 1e-15) << size;
        const double exact = quad_radius(a, b, c);
        // Close to pi / 2 the arc sine of a double no longer tells.
        if (std::abs(exact - pi / 2) < 0.1) continue;
        EXPECT_NEAR(cap.radius / exact, 1, 1e-15) << size << " " << flatness;
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
