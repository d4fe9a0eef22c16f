#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "stripack/direction.hpp"

/// Seven functions on the sphere and the figures of SSRFPACK on them.
namespace delone::support {

using stripack::Direction;

inline double s1(double x, double y, double z) { return (1 + 2 * x + 3 * y + 4 * z) / 6; }
inline double s2(double x, double y, double z) {
  return (9 * x * x * x - 2 * x * x * y + 3 * x * y * y - 4 * y * y * y + 2 * z * z * z -
          x * y * z) /
         10;
}
inline double s3(double x, double y, double z) {
  return std::exp(x) + 2 * std::exp(y + z);
}
inline double s4(double x, double y, double z) {
  return std::sin(x) * std::sin(y) * std::sin(z);
}
inline double squared(double a) { return a * a; }
inline double s5(double x, double y, double z) {
  const double wide = squared(9 * x - 2) + squared(9 * y - 2) + squared(9 * z - 2),
               steep = squared(9 * x - 7) + squared(9 * y - 3) + squared(9 * z - 5),
               dip = squared(9 * x - 4) + squared(9 * y - 7) + squared(9 * z - 5);
  return 0.75 * std::exp(-wide / 4) +
         0.75 * std::exp(-squared(9 * x + 1) / 49 - (9 * y + 1) / 10 - (9 * z + 1) / 10) +
         0.5 * std::exp(-steep / 4) - 0.2 * std::exp(-dip);
}
inline double s6(double x, double y, double) { return 2 + x * x - y * y; }
inline double s7(double x, double y, double z) {
  const double lat = std::asin(std::clamp(z, -1.0, 1.0));
  return 2 + std::pow(std::sin(2 * lat), 16) * std::cos(16 * std::atan2(y, x));
}

/// SSRFPACK's root mean squares (INTRC1 with GRADL, and with GRADG converged) for 100,
/// 400, 1600 and 6400 nodes.
struct SphereCase {
  const char* name;
  double (*f)(double, double, double);
  std::array<double, 4> local, global;
};

inline constexpr std::array<int, 4> spiral_counts{100, 400, 1600, 6400};
inline constexpr std::array<SphereCase, 7> sphere_cases{{
    {"s1",
     s1,
     {1.219e-4, 6.618e-6, 4.209e-7, 2.452e-8},
     {5.283e-4, 9.807e-5, 2.279e-5, 3.971e-6}},
    {"s2",
     s2,
     {3.732e-3, 3.177e-4, 3.285e-5, 3.829e-6},
     {1.726e-3, 2.002e-4, 4.629e-5, 6.673e-6}},
    {"s3",
     s3,
     {6.997e-3, 5.889e-4, 6.315e-5, 7.266e-6},
     {4.297e-3, 7.362e-4, 1.515e-4, 2.683e-5}},
    {"s4",
     s4,
     {2.499e-3, 2.074e-4, 2.195e-5, 2.460e-6},
     {1.141e-3, 1.352e-4, 2.798e-5, 4.568e-6}},
    {"s5",
     s5,
     {2.061e-2, 4.254e-3, 5.798e-4, 5.428e-5},
     {1.866e-2, 3.392e-3, 3.286e-4, 2.215e-5}},
    {"s6",
     s6,
     {3.493e-3, 3.274e-4, 3.478e-5, 4.190e-6},
     {2.539e-3, 3.716e-4, 7.932e-5, 1.272e-5}},
    {"s7",
     s7,
     {3.549e-1, 2.676e-1, 4.957e-2, 5.662e-3},
     {3.641e-1, 2.772e-1, 2.225e-2, 1.846e-3}},
}};

/// Longitudes start at `turn` radians.
inline std::vector<Direction> spiral(int count, double turn) {
  std::vector<Direction> points;
  for (int k = 1; k <= count; ++k) {
    const double z = 1 - (2.0 * k - 1) / count;
    const double lon = k * std::numbers::pi * (3 - std::sqrt(5.0)) + turn;
    const double r = std::sqrt(1 - z * z);
    points.push_back(Direction::from(r * std::cos(lon), r * std::sin(lon), z));
  }
  return points;
}

inline std::vector<double> sampled_on(const SphereCase& c,
                                      std::span<const Direction> points) {
  std::vector<double> values;
  for (const Direction& p : points) values.push_back(c.f(p.x(), p.y(), p.z()));
  return values;
}

/// What is asked of a surface: 0.3 of the better figure on s2, s3, s6, on the others not
/// to be above it.
inline double asked(const SphereCase& c) {
  return c.f == s2 || c.f == s3 || c.f == s6 ? 0.3 : 1;
}

}  // namespace delone::support
