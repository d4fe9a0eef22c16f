#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "interp/east_north.hpp"
#include "interp/grid.hpp"
#include "interp/linear_surface.hpp"
#include "interp/reach.hpp"
#include "interp/row_walk.hpp"
#include "interp/scatter_jet.hpp"

namespace delone::interp {

/// The plane as meshless methods see it: points with D coordinates.
///
/// Coordinates are multiplied by a power of two, which is exact, so that the sites lie
/// within [-2, 2] of each other and no square overflows; differences are taken before
/// anything is rounded, so that far from the origin nothing is lost.
class PlaneDomain {
 public:
  static constexpr std::size_t dimension = 2;
  using Triangulation = tripack::Triangulation;
  using Point = tripack::Point2;
  using Gradient = Gradient2;
  using Position = std::array<double, dimension>;

  explicit PlaneDomain(std::span<const Point> points) {
    double largest = 0;
    for (const Point p : points) {
      largest = std::max({largest, std::abs(0.5 * p.x - 0.5 * points[0].x),
                          std::abs(0.5 * p.y - 0.5 * points[0].y)});
    }
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    scale_ = std::ldexp(1.0, std::clamp(-1 - exponent, -1022, 1022));
  }

  [[nodiscard]] Position position(Point p) const noexcept {
    return {p.x * scale_, p.y * scale_};
  }
  /// Scaled lengths are `scale()` times those of the data.
  [[nodiscard]] double scale() const noexcept { return scale_; }
  [[nodiscard]] static Gradient missing_gradient() noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  [[nodiscard]] Gradient gradient(const Position& slope, Point) const noexcept {
    return {slope[0] * scale_, slope[1] * scale_};
  }
  /// evaluate(point, cursor) for the nodes of a grid.
  template <class Evaluate>
  [[nodiscard]] static Field field(const Grid& grid, const RunOptions& run,
                                   Evaluate evaluate) {
    return walk_plane_grid(grid, run, evaluate);
  }

 private:
  double scale_ = 1;
};

/// The sphere: unit vectors in space, distances along chords.
class SphereDomain {
 public:
  static constexpr std::size_t dimension = 3;
  using Triangulation = stripack::Triangulation;
  using Point = stripack::Direction;
  using Gradient = GradientSphere;
  using Position = std::array<double, dimension>;

  explicit SphereDomain(std::span<const Point>) {}

  [[nodiscard]] static Position position(const Point& p) noexcept {
    return {p.x(), p.y(), p.z()};
  }
  [[nodiscard]] static double scale() noexcept { return 1; }
  [[nodiscard]] static Gradient missing_gradient() noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  [[nodiscard]] static Gradient gradient(const Position& g, const Point& p) noexcept {
    return east_and_north({g[0], g[1], g[2]}, p);
  }
  template <class Evaluate>
  [[nodiscard]] static Field field(const Grid& grid, const RunOptions& run,
                                   Evaluate evaluate) {
    return walk_globe_grid(grid, run, evaluate);
  }
};

/// Differences of coordinates, to derive by.
template <Number T, std::size_t D>
[[nodiscard]] std::array<T, D> difference(const std::array<T, D>& p,
                                          const std::array<double, D>& q) noexcept {
  std::array<T, D> result{};
  for (std::size_t i = 0; i < D; ++i) result[i] = p[i] - q[i];
  return result;
}

template <Number T, std::size_t D>
[[nodiscard]] T squared_length(const std::array<T, D>& v) noexcept {
  T sum = v[0] * v[0];
  for (std::size_t i = 1; i < D; ++i) sum += v[i] * v[i];
  return sum;
}

}  // namespace delone::interp
