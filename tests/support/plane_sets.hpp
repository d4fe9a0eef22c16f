#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <vector>

#include "tripack/point.hpp"

namespace delone::support {

using PlanePoints = std::vector<tripack::Point2>;

/// A named family of planar point sets: a function of size and seed only. Some sizes are
/// rounded (a lattice has a square number of points); sets may hold repeated points.
struct PlaneFamily {
  const char* name;
  PlanePoints (*make)(std::size_t n, std::uint64_t seed);
};
/// For the names that tests print.
inline void PrintTo(const PlaneFamily& family, std::ostream* out) { *out << family.name; }

/// Every family: the distributions codes are measured on, and the inputs that broke other
/// codes.
[[nodiscard]] std::span<const PlaneFamily> plane_families();

// Sets that tests and benchmarks name directly.

/// n points in [0, 1)^2.
[[nodiscard]] PlanePoints uniform_points(std::size_t n, std::uint64_t seed);
/// 32 Gaussian-like clusters of width 0.01 with centres in [0, 1)^2.
[[nodiscard]] PlanePoints clustered_points(std::size_t n, std::uint64_t seed);
/// round(sqrt(n))^2 integer points, row by row.
[[nodiscard]] PlanePoints lattice_points(std::size_t n);
/// 4 floor(n / 4) points of the unit circle, by the rational parametrisation.
[[nodiscard]] PlanePoints circle_points(std::size_t n);
/// The n corners of a regular polygon, by cosine and sine: cocircular but for rounding.
[[nodiscard]] PlanePoints polygon_points(std::size_t n, double radius);
/// Integer points exactly on the circle of radius 1105, all 108 of them or the first n.
[[nodiscard]] PlanePoints integer_circle_points(std::size_t n);
/// A circle of n - 1 points and its centre: a hub of large degree.
[[nodiscard]] PlanePoints wheel_points(std::size_t n);
/// A square lattice turned by an angle.
[[nodiscard]] PlanePoints rotated_lattice_points(std::size_t n, double degrees);

}  // namespace delone::support
