#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <vector>

#include "stripack/direction.hpp"

namespace delone::support {

using SpherePoints = std::vector<stripack::Direction>;

/// A named family of point sets on the sphere: a function of size and seed only. Sizes
/// are rounded to what a regular grid has; sets may hold repeated points.
struct SphereFamily {
  const char* name;
  SpherePoints (*make)(std::size_t n, std::uint64_t seed);
};
/// For the names that tests print.
inline void PrintTo(const SphereFamily& family, std::ostream* out) {
  *out << family.name;
}

/// Every family: the distributions codes are measured on, and the inputs that broke other
/// codes.
[[nodiscard]] std::span<const SphereFamily> sphere_families();

// Sets that tests and benchmarks name directly.

/// Uniform on the sphere (Marsaglia 1972).
[[nodiscard]] SpherePoints uniform_directions(std::size_t n, std::uint64_t seed);
/// n points, equal in time, of a 127-revolution, 10-day repeat orbit of 66 degrees
/// inclination.
[[nodiscard]] SpherePoints track_directions(std::size_t n);
/// What a global grid file holds: every `step` degrees, longitudes -180 and 180 both,
/// every longitude at the poles. (360 / step + 1) x (180 / step + 1) rows from south to
/// north.
[[nodiscard]] std::vector<stripack::LonLat> global_grid(double step_deg);
/// The same grid, poles once and longitudes 0 <= lon < 360, by cosines of radians.
[[nodiscard]] SpherePoints radian_grid_directions(double step_deg);
/// n points uniform in a box of `side` radians on the equator.
[[nodiscard]] SpherePoints box_directions(std::size_t n, std::uint64_t seed, double side);
/// Spiral points (R. Swinbank, R. J. Purser, Q. J. R. Meteorol. Soc. 132 (2006)).
[[nodiscard]] SpherePoints fibonacci_directions(std::size_t n);
/// An icosahedron with its faces halved `level` times: 10 * 4^level + 2 points.
[[nodiscard]] SpherePoints icosahedral_directions(int level);

}  // namespace delone::support
