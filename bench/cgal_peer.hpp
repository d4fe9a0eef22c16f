#pragma once

#include <span>

#include "bench/measure.hpp"
#include "stripack/direction.hpp"
#include "tripack/point.hpp"

/// CGAL's triangulations of the same points. Points are converted before the clock
/// starts.
namespace delone::bench {

/// Delaunay_triangulation_2 with Epick, range insertion.
[[nodiscard]] Builder cgal_plane(std::span<const tripack::Point2> points);

/// Delaunay_triangulation_on_sphere_2, range insertion, with either of its traits. Both
/// leave out points closer to another than 2^-25.
[[nodiscard]] Builder cgal_sphere(std::span<const stripack::Direction> points);
[[nodiscard]] Builder cgal_sphere_projected(std::span<const stripack::Direction> points);

}  // namespace delone::bench
