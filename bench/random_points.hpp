#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "stripack/direction.hpp"
#include "tripack/point.hpp"

/// Points for benchmarks of surfaces: of the unit square, and all round the sphere.
namespace delone::bench {

inline std::vector<tripack::Point2> plane_points(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<tripack::Point2> points(n);
  for (tripack::Point2& p : points) p = {unit(random), unit(random)};
  return points;
}

inline std::vector<stripack::Direction> sphere_points(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<stripack::Direction> points;
  while (points.size() < n)
    points.push_back(
        stripack::Direction::from(normal(random), normal(random), normal(random)));
  return points;
}

}  // namespace delone::bench
