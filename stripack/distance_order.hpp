#pragma once

#include <cfloat>

#include "stripack/direction.hpp"

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0
#error "the bounds below hold for IEEE doubles: no -ffast-math, no extended precision"
#endif

namespace delone::stripack {

[[nodiscard]] inline double squared_chord(const Direction& p,
                                          const Direction& a) noexcept {
  const double dx = a.x() - p.x(), dy = a.y() - p.y(), dz = a.z() - p.z();
  return dx * dx + dy * dy + dz * dz;
}

/// The first rung, inline for hot loops: -1 if `a` is nearer than `b`, +1 if farther,
/// given the squared chords as squared_chord rounds them, or 0 if that is uncertain.
///
/// With u = 2^-53, the squared chord of the unit vectors is (|a - p|^2 - (|a| - |p|)^2) /
/// (|a| |p|). Rounding of |a - p|^2 makes 5 u (a difference, a square, two sums); lengths
/// are within 2^-51 = 4 u of 1, which makes 4 u from |a| (|p| is common to both sides)
/// and an absolute 2^-100. The half covers second order and the bound's rounding.
[[nodiscard]] inline int compare_distances_filter(double squared_a,
                                                  double squared_b) noexcept {
  constexpr double relative = 9.5 * 0x1p-53;
  const double difference = squared_a - squared_b;
  const double bound = relative * (squared_a + squared_b) + 0x1p-98;
  return static_cast<int>(difference > bound) - static_cast<int>(difference < -bound);
}

/// The further rung.
[[nodiscard]] int compare_distances_exact(const Direction& p, const Direction& a,
                                          const Direction& b) noexcept;

/// Which of `a` and `b` makes the smaller angle with `p`? -1 a, +1 b, 0 if both are as
/// far.
///
/// Exact for the directions of the stored triples, whose lengths are not exactly 1: a
/// filter in doubles (2 ns), then the signs of two square roots of integers (0.3
/// microseconds).
[[nodiscard]] int compare_distances(const Direction& p, const Direction& a,
                                    const Direction& b) noexcept;

}  // namespace delone::stripack
