#pragma once

#include <cfloat>
#include <cmath>

#include "tripack/point.hpp"

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0
#error "the bounds below hold for IEEE doubles: no -ffast-math, no extended precision"
#endif

/// The first, inexact rungs of the planar predicates, inline for hot loops.
///
/// Each returns the sign (+1, -1) when it is certain and 0 when it is not; nothing else
/// is needed of the input than that it is finite. With u = 2^-53, every bound counts the
/// factors (1 + delta), |delta| <= u, that a term collects on its way; the last addition
/// or subtraction is not counted, since rounding keeps the sign of its result.
/// Contraction to fused multiply-add only removes factors, so the bounds hold with and
/// without. Overflow makes the bound infinite or NaN, and the comparison fails; underflow
/// is covered by an absolute term.
namespace delone::tripack {

inline constexpr double rounding_unit = 0x1p-53;

/// Of |L| + |R|, L and R the two products: 2 differences and a product make 3 u to first
/// order; the quarter covers second order and the rounding of the bound.
inline constexpr double orientation_bound = 3.25 * rounding_unit;

/// Of ab + bc + ca, where a, b, c are the squared distances from p: 2 differences, a
/// product and a sum make 4 u for a cross product and as many for a squared
/// distance, then a product and a sum of terms: 10 u of sum a (|b_x c_y| + |b_y
/// c_x|). By Cauchy the bracket is at most sqrt(bc), and a sqrt(bc) + b sqrt(ca) + c
/// sqrt(ab) <= ab + bc + ca.
inline constexpr double in_circle_bound = 10.25 * rounding_unit;

[[nodiscard, gnu::always_inline]] inline int orientation_filter(Point2 a, Point2 b,
                                                                Point2 c) noexcept {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  // A product that underflows is off by at most 2^-1075.
  const double bound = orientation_bound * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  return static_cast<int>(det > bound) - static_cast<int>(det < -bound);
}

[[nodiscard]] inline int in_circle_filter(Point2 a, Point2 b, Point2 c,
                                          Point2 p) noexcept {
  const double ax = a.x - p.x, ay = a.y - p.y;
  const double bx = b.x - p.x, by = b.y - p.y;
  const double cx = c.x - p.x, cy = c.y - p.y;
  const double aa = ax * ax + ay * ay;
  const double bb = bx * bx + by * by;
  const double cc = cx * cx + cy * cy;
  const double det =
      aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
  // Underflow costs at most 2^-1069 (aa + bb + cc) + 2^-1073: each product of two
  // coordinates is off by 2^-1075 and meets a factor below that sum. `tiny` adds far
  // more than that to the bound.
  constexpr double tiny = 0x1p-400;
  const double bound = in_circle_bound * ((aa + tiny) * ((bb + cc) + tiny) + bb * cc);
  return static_cast<int>(det > bound) - static_cast<int>(det < -bound);
}

}  // namespace delone::tripack
