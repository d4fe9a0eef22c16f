#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "stripack/local_frame.hpp"

/// Areas and moments of spherical polygons as sums of triangles from one point. Internal:
/// use stripack/measures.hpp, polygon.hpp and voronoi.hpp.
namespace delone::stripack {

/// A corner in central projection from the point.
struct Corner {
  double x, y, length;  // length = sqrt(1 + x^2 + y^2)
};

/// Nothing for corners farther than 63 degrees away.
[[nodiscard]] inline std::optional<Corner> project(const LocalVector& c) noexcept {
  if (!(c.up > 0) || !(c.x * c.x + c.y * c.y < 4 * c.up * c.up)) return std::nullopt;
  const double scale = 1 / c.up, x = c.x * scale, y = c.y * scale;
  return Corner{x, y, std::sqrt(1 + x * x + y * y)};
}

[[nodiscard]] inline double crossing(const Corner& p, const Corner& q) noexcept {
  return p.x * q.y - p.y * q.x;
}

/// tan(E/2) = det / (1 + cosines) for the triangle of the point and two corners.
/// Source: F. Eriksson, Math. Mag. 63 (1990) 184-187.
[[nodiscard]] inline double tan_half_excess(const Corner& p, const Corner& q) noexcept {
  return crossing(p, q) /
         (p.length * q.length + p.length + q.length + 1 + p.x * q.x + p.y * q.y);
}

/// Sum of halves of areas, as the argument of a product: one arc tangent in all.
struct HalfAreas {
  double re = 1, im = 0;
  [[gnu::always_inline]] void turn(double c, double s) noexcept {
    const double real = re * c - im * s;
    im = re * s + im * c;
    re = real;
  }
  void turn_and_scale(double c, double s) noexcept {
    turn(c, s);
    const double length = std::hypot(re, im);
    if (length > 0) re /= length, im /= length;
  }
  /// -2 pi .. 2 pi
  [[nodiscard]] double signed_area() const noexcept { return 2 * argument(); }
  /// Of a convex region, 0 .. 2 pi; what is below by rounding becomes 0.
  [[nodiscard]] double convex_area() const noexcept {
    const double half = argument(), pi = std::numbers::pi;
    return 2 * (half < -pi / 2 ? half + 2 * pi : std::max(half, 0.0));
  }

 private:
  /// Most polygons are small: there five terms of the series reach all places.
  [[nodiscard]] double argument() const noexcept {
    constexpr double small = 0x1p-7;
    if (!(std::abs(im) <= small * re)) return std::atan2(im, re);
    const double t = im / re, u = t * t;
    return t - t * u * (1. / 3 - u * (1. / 5 - u * (1. / 7 - u / 9)));
  }
};

/// asin(s) / s - 1 for the sine and the cosine of an arc.
[[nodiscard]] inline double arc_excess(double sine, double cosine) noexcept {
  const double u = sine * sine;
  if (cosine < 0 || u > 0.01) return std::atan2(sine, cosine) / sine - 1;
  const double tail = 35. / 1152 + u * (63. / 2816 + u * (231. / 13312));
  return u * (1. / 6 + u * (3. / 40 + u * (5. / 112 + u * tail)));
}

/// The triangle's part of the integral of the position over the polygon.
///
/// That integral is half the sum of the lengths of the sides times the inward normals of
/// their planes. The normal of the plane through two corners is their cross product, (p
/// x q, y_p - y_q, x_q - x_p), and around a polygon the last two sum to 0: only what the
/// factor of each side differs from 1 matters, which keeps the digits of small polygons.
/// Source: J. E. Brock, Am. J. Phys. 42 (1974) 748-757.
[[nodiscard]] inline LocalVector fan_moment(const Corner& p, const Corner& q) noexcept {
  const double up = crossing(p, q), x = p.y - q.y, y = q.x - p.x;
  const double size = p.length * q.length;
  const double sine = std::sqrt(up * up + x * x + y * y) / size,
               cosine = (1 + p.x * q.x + p.y * q.y) / size;
  const double a = p.x * p.x + p.y * p.y, b = q.x * q.x + q.y * q.y;
  const double size_excess = (a + b + a * b) / (1 + size);
  const double excess = sine > 0 ? (arc_excess(sine, cosine) - size_excess) / size : 0;
  return {up * (1 + excess) / 2, x * excess / 2, y * excess / 2};
}

}  // namespace delone::stripack
