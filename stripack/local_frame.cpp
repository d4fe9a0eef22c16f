#include "stripack/local_frame.hpp"

#include <algorithm>
#include <cmath>

#include "delaunay/double_double.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using delaunay::DoubleDouble;
using delaunay::two_difference;
using delaunay::two_product;

struct WideVector {
  DoubleDouble x, y, z;
};

DoubleDouble dot(const WideVector& a, const SpaceVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

DoubleDouble dot(const WideVector& a, const WideVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

WideVector difference(const Direction& a, const Direction& b) {
  return {two_difference(a.x(), b.x()), two_difference(a.y(), b.y()),
          two_difference(a.z(), b.z())};
}

double largest_component(const WideVector& v) {
  return std::max({std::abs(v.x.high), std::abs(v.y.high), std::abs(v.z.high)});
}

// v x d, relatively exact: what d has in the direction of v leaves nothing behind.
WideVector cross(const Direction& v, const WideVector& d) {
  const DoubleDouble x{v.x(), 0}, y{v.y(), 0}, z{v.z(), 0};
  return {delaunay::determinant(y, z, d.y, d.z), delaunay::determinant(z, x, d.z, d.x),
          delaunay::determinant(x, y, d.x, d.y)};
}

constexpr double tiny = 0x1p-80;
// Products of numbers below have no room for their roundings.
constexpr double underflow = 0x1p-500;
constexpr int lift = 600;

/// A vector times 2^scale.
struct ScaledVector {
  WideVector vector;
  int scale = 0;
};

// v x d, also of subnormal d.
ScaledVector lifted_cross(const Direction& v, const WideVector& d) {
  const WideVector turned = cross(v, d);
  if (largest_component(turned) >= underflow) return {turned, 0};
  const double factor = std::ldexp(1.0, lift);
  return {cross(v, {d.x * factor, d.y * factor, d.z * factor}), lift};
}

/// About the sine of the angle between two directions, whatever their lengths; 1 for
/// opposite ones.
struct ScaledLength {
  double value = 0;
  int scale = 0;
  [[nodiscard]] bool is_below(double limit) const {
    return std::ldexp(value, -scale) < limit;
  }
  [[nodiscard]] bool is_below(double limit, const ScaledLength& other) const {
    return std::ldexp(value, std::min(other.scale - scale, 0)) <
           limit * std::ldexp(other.value, std::min(scale - other.scale, 0));
  }
};
ScaledLength separation(const Direction& a, const Direction& b) {
  const WideVector d = difference(b, a);
  if (largest_component(d) > 0.5) return {1, 0};
  const auto [turned, scale] = lifted_cross(a, d);
  return {largest_component(turned), scale};
}

/// A spoke times 2^scale, the rise times 2^(2 scale): a direction as far from v as from w
/// does not depend on the length of the spoke.
struct WideSpoke {
  DoubleDouble x, y, rise;
  int scale = 0;
};

DoubleDouble scaled(DoubleDouble a, int exponent) {
  return {std::ldexp(a.high, exponent), std::ldexp(a.low, exponent)};
}

// Tangential to v exactly, whatever the axes, and of the unit vectors: v x w is t turned
// by a right angle.
WideSpoke wide_spoke(const Direction& v, const Direction& w, const SpaceVector& first,
                     const SpaceVector& second) {
  const WideVector d = difference(w, v);
  const ScaledVector turned = lifted_cross(v, d);
  const int lifted = turned.scale;
  const double largest = largest_component(turned.vector);
  const bool is_close = largest_component(d) < 0.5;  // and not opposite
  const bool is_tiny = is_close && largest > 0 && (lifted > 0 || largest < tiny);
  const int rest = is_tiny ? -std::ilogb(largest) : -lifted, scale = rest + lifted;
  const double stretch_v = stretch(v), stretch_w = stretch(w);
  const auto component = [&](const SpaceVector& axis) {
    const DoubleDouble c = scaled(dot(turned.vector, axis), rest);
    return c + c * stretch_v + c * stretch_w;
  };
  const DoubleDouble x = component(second), y = -component(first);
  if (scale > 0) return {x, y, (x * x + y * y) * 0.5, scale};
  const auto unit_difference = [&](DoubleDouble part, double of_v, double of_w) {
    return part + two_product(of_w, stretch_w) - two_product(of_v, stretch_v);
  };
  const WideVector u{unit_difference(d.x, v.x(), w.x()),
                     unit_difference(d.y, v.y(), w.y()),
                     unit_difference(d.z, v.z(), w.z())};
  return {x, y, dot(u, u) * 0.5, 0};
}

// The determinant of scaled spokes, which are about 1 long. What is left by rounding of
// directions on one great circle is more than the place of a circle through sites closer
// than that.
DoubleDouble exact_if_zero(DoubleDouble det, const Direction& v, const Direction& b,
                           const Direction& c) {
  constexpr double doubtful = 0x1p-90;
  if (std::abs(det.high) > doubtful || orientation(v, b, c) != 0) return det;
  return {};
}

}  // namespace

// |d|^2 = 1 + e
double stretch(const Direction& d) noexcept {
  const DoubleDouble square =
      two_product(d.x(), d.x()) + two_product(d.y(), d.y()) + two_product(d.z(), d.z());
  const double e = (square - DoubleDouble{1, 0}).rounded();
  return e * (-0.5 + 0.375 * e);
}

// Sites closer than normal numbers can tell are moved to where those can: their direction
// counts, the distance is nothing to any other length.
Spoke LocalFrame::spoke_of_close_site(const Direction& w) const noexcept {
  constexpr int largest_scale = 900;
  const WideSpoke wide = wide_spoke(up_, w, first_, second_);
  const int scale = std::min(wide.scale, largest_scale);
  const double x = std::ldexp(wide.x.rounded(), -scale),
               y = std::ldexp(wide.y.rounded(), -scale);
  return {x, y, x * x + y * y, std::ldexp(wide.rise.rounded(), -2 * scale)};
}

double LocalFrame::determinant(const Direction& b, const Direction& c) const noexcept {
  const WideSpoke to_b = wide_spoke(up_, b, first_, second_),
                  to_c = wide_spoke(up_, c, first_, second_);
  return std::ldexp((to_b.x * to_c.y - to_b.y * to_c.x).rounded(),
                    -to_b.scale - to_c.scale);
}

// Two sites that are nothing but close seen from far away are seen from one of them.
LocalVector LocalFrame::circumcenter_wide(const Direction& b,
                                          const Direction& c) const noexcept {
  const ScaledLength near = separation(b, c), far = separation(up_, b);
  if (near.is_below(tiny) && near.is_below(tiny, far)) {
    const LocalFrame frame(b);
    return local(frame.direction(frame.circumcenter_here(c, up_)));
  }
  return circumcenter_here(b, c);
}

// The rise of a scaled spoke is too large by one scale, which is taken back after the
// common part of both.
LocalVector LocalFrame::circumcenter_here(const Direction& b,
                                          const Direction& c) const noexcept {
  const WideSpoke to_b = wide_spoke(up_, b, first_, second_),
                  to_c = wide_spoke(up_, c, first_, second_);
  const int common = std::min(to_b.scale, to_c.scale);
  const DoubleDouble rise_b = scaled(to_b.rise, common - to_b.scale),
                     rise_c = scaled(to_c.rise, common - to_c.scale);
  const DoubleDouble up = exact_if_zero(to_b.x * to_c.y - to_b.y * to_c.x, up_, b, c),
                     x = rise_b * to_c.y - rise_c * to_b.y,
                     y = to_b.x * rise_c - to_c.x * rise_b;
  const int shift = up.high == 0 ? 0 : -common;
  return {up.rounded(), std::ldexp(x.rounded(), shift), std::ldexp(y.rounded(), shift)};
}

}  // namespace delone::stripack
