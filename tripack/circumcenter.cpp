#include "tripack/circumcenter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace delone::tripack {

namespace {

using delaunay::DoubleDouble;
using delaunay::two_difference;

WidePoint2 difference(Point2 a, Point2 b) {
  return {two_difference(a.x, b.x), two_difference(a.y, b.y)};
}

DoubleDouble square(const WidePoint2& d) { return d.x * d.x + d.y * d.y; }

double rough_square(const WidePoint2& d) {
  return d.x.high * d.x.high + d.y.high * d.y.high;
}

DoubleDouble scaled(DoubleDouble a, int exponent) {
  return {std::ldexp(a.high, exponent), std::ldexp(a.low, exponent)};
}

WidePoint2 scaled(const WidePoint2& d, int exponent) {
  return {scaled(d.x, exponent), scaled(d.y, exponent)};
}

WidePoint2 unscaled(const WidePoint2& d, int exponent) {
  return exponent == 0 ? d : scaled(d, exponent);
}

WidePoint2 operator+(const WidePoint2& a, const WidePoint2& b) {
  return {a.x + b.x, a.y + b.y};
}

// Circumcentre minus the corner from which q and r are seen.
WidePoint2 solve(const WidePoint2& q, const WidePoint2& r) {
  const DoubleDouble det = delaunay::determinant(q.x, q.y, r.x, r.y) * 2;
  const DoubleDouble qq = square(q), rr = square(r);
  return {(r.y * qq - q.y * rr) / det, (q.x * rr - r.x * qq) / det};
}

}  // namespace

// From an end of the shortest side nothing cancels: the two squares that are subtracted
// differ as much as they can.
WidePoint2 circumcenter_offset_wide(Point2 v, Point2 b, Point2 c) noexcept {
  WidePoint2 to_b = difference(b, v), to_c = difference(c, v), b_to_c = difference(c, b);
  const double largest = std::max({std::abs(to_b.x.high), std::abs(to_b.y.high),
                                   std::abs(to_c.x.high), std::abs(to_c.y.high)});
  constexpr double far_from_overflow = 0x1p60;
  const bool is_moderate = largest < far_from_overflow && largest > 1 / far_from_overflow;
  const int exponent = is_moderate || !(largest > 0) ? 0 : std::ilogb(largest);
  if (exponent != 0) {
    to_b = scaled(to_b, -exponent);
    to_c = scaled(to_c, -exponent);
    b_to_c = scaled(b_to_c, -exponent);
  }
  const double far = rough_square(b_to_c);
  if (far >= std::min(rough_square(to_b), rough_square(to_c)))
    return unscaled(solve(to_b, to_c), exponent);
  const WidePoint2 b_to_v{-to_b.x, -to_b.y};
  return unscaled(to_b + solve(b_to_c, b_to_v), exponent);
}

Point2 circumcenter_offset_accurate(Point2 v, Point2 b, Point2 c) noexcept {
  const WidePoint2 offset = circumcenter_offset_wide(v, b, c);
  return {offset.x.rounded(), offset.y.rounded()};
}

}  // namespace delone::tripack
