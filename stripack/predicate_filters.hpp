#pragma once

#include <cfloat>
#include <cmath>

#include "stripack/direction.hpp"

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0
#error "the bounds below hold for IEEE doubles: no -ffast-math, no extended precision"
#endif

/// The first, inexact rungs of the predicates for directions, inline for hot loops.
///
/// Each returns the sign (+1, -1) when it is certain and 0 when it is not. With u =
/// 2^-53, every bound counts the factors (1 + delta), |delta| <= u, that a term
/// collects on its way; the last addition is not counted, since rounding keeps the
/// sign of its result. Contraction to fused multiply-add only removes factors, so the
/// bounds hold with and without.
namespace delone::stripack {

inline constexpr double rounding_unit = 0x1p-53;

/// Of |B|_1 |C|_1, B = b - a, C = c - a, for a . (B x C): 2 differences, a
/// product and a subtraction make 4 u for a component of B x C, then a product
/// and a sum: 6 u of sum |a_i| (|b_j c_k| + |b_k c_j|) <= (1 + 2^-51) |B|_1
/// |C|_1. The half covers second order.
inline constexpr double orientation_bound = 6.5 * rounding_unit;

/// Of ab + bc + ca, where a, b, c are the squared distances from p. 2 differences, a
/// product and two sums make 5 u for a square; 7 u for p . (B x C); a product and a
/// sum of terms: 14 u of sum a (|p| . v), v_i = |b_j c_k| + |b_k c_j|. By Cauchy
/// v_i^2 <= (b - b_i^2)(c - c_i^2), hence |v| <= sqrt(2 b c), and sum a sqrt(bc) <=
/// ab + bc + ca: 14 sqrt(2) = 19.8.
inline constexpr double in_circle_bound = 20 * rounding_unit;

/// Of a + b + c: what leaving out the difference of lengths, (|a| - |p|)^2 <=
/// 2^-100, can cost.
inline constexpr double in_circle_length_bound = 1.5 * 0x1p-100;

[[nodiscard]] inline int orientation_filter(const Direction& a, const Direction& b,
                                            const Direction& c) noexcept {
  const double bx = b.x() - a.x(), by = b.y() - a.y(), bz = b.z() - a.z();
  const double cx = c.x() - a.x(), cy = c.y() - a.y(), cz = c.z() - a.z();
  const double det = a.x() * (by * cz - bz * cy) + a.y() * (bz * cx - bx * cz) +
                     a.z() * (bx * cy - by * cx);
  const double size = (std::abs(bx) + std::abs(by) + std::abs(bz)) *
                      (std::abs(cx) + std::abs(cy) + std::abs(cz));
  // The nine products that may underflow are off by 2^-1075 each.
  const double bound = orientation_bound * size + 0x1p-1000;
  return static_cast<int>(det > bound) - static_cast<int>(det < -bound);
}

/// With A = a - p, B = b - p, C = c - p, the determinant of the directions has
/// the sign of
///   S = sum over cyclic (A, B, C) of (|A|^2 - (|a| - |p|)^2) p . (B x C),
/// an identity. Lengths are within 2^-51 of 1, so they enter the bound only, and the test
/// is as sharp for points 1e-12 apart as for points far apart.
[[nodiscard]] inline int in_circle_filter(const Direction& a, const Direction& b,
                                          const Direction& c,
                                          const Direction& p) noexcept {
  const double ax = a.x() - p.x(), ay = a.y() - p.y(), az = a.z() - p.z();
  const double bx = b.x() - p.x(), by = b.y() - p.y(), bz = b.z() - p.z();
  const double cx = c.x() - p.x(), cy = c.y() - p.y(), cz = c.z() - p.z();
  const double aa = ax * ax + ay * ay + az * az;
  const double bb = bx * bx + by * by + bz * bz;
  const double cc = cx * cx + cy * cy + cz * cz;
  const double pbc = p.x() * (by * cz - bz * cy) + p.y() * (bz * cx - bx * cz) +
                     p.z() * (bx * cy - by * cx);
  const double pca = p.x() * (cy * az - cz * ay) + p.y() * (cz * ax - cx * az) +
                     p.z() * (cx * ay - cy * ax);
  const double pab = p.x() * (ay * bz - az * by) + p.y() * (az * bx - ax * bz) +
                     p.z() * (ax * by - ay * bx);
  const double det = aa * pbc + bb * pca + cc * pab;
  // No term for underflow: it costs less than 2^-1070 (aa + bb + cc), and where that sum
  // is below 2^-900 the determinant itself vanishes and stays uncertain.
  const double bound = in_circle_bound * (aa * (bb + cc) + bb * cc) +
                       in_circle_length_bound * (aa + (bb + cc));
  return static_cast<int>(det > bound) - static_cast<int>(det < -bound);
}

}  // namespace delone::stripack
