#pragma once

#include <cfloat>

#include "tripack/point.hpp"

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0
#error "the bounds below hold for IEEE doubles: no -ffast-math, no extended precision"
#endif

namespace delone::tripack {

[[nodiscard]] inline double squared_distance(Point2 p, Point2 a) noexcept {
  const double dx = a.x - p.x, dy = a.y - p.y;
  return dx * dx + dy * dy;
}

/// The first rung, inline for hot loops: the sign of |a - p|^2 - |b - p|^2 given both as
/// squared_distance rounds them, or 0 if that is uncertain.
///
/// A difference, a square and a sum make 4 u for each, u = 2^-53; the last subtraction
/// keeps its sign. The quarter covers second order and the bound's rounding; products
/// that underflow are off by 2^-1075 each, and overflow makes the bound infinite.
[[nodiscard]] inline int compare_distances_filter(double squared_a,
                                                  double squared_b) noexcept {
  constexpr double relative = 4.25 * 0x1p-53;
  const double difference = squared_a - squared_b;
  const double bound = relative * (squared_a + squared_b) + 0x1p-1000;
  return static_cast<int>(difference > bound) - static_cast<int>(difference < -bound);
}

/// The further rungs.
[[nodiscard]] int compare_distances_exact(Point2 p, Point2 a, Point2 b) noexcept;

/// Which of `a` and `b` is nearer to `p`? -1 a, +1 b, 0 if both are as far.
///
/// Exact for every finite double: a filter in doubles (2 ns), integers of 128 bits (12
/// ns; they decide ties on lattices), integers of any length.
[[nodiscard]] int compare_distances(Point2 p, Point2 a, Point2 b) noexcept;

/// Is `p` at most `radius` away from `a`? Exact. `radius` finite and not negative.
[[nodiscard]] bool is_within(Point2 p, Point2 a, double radius) noexcept;

/// The distance to within 2 units in the last place, without overflow or underflow
/// between.
[[nodiscard]] double distance(Point2 p, Point2 a) noexcept;

}  // namespace delone::tripack
