#include "campaign/judge_predicates.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "support/exact.hpp"

namespace delone::campaign {

namespace {

using stripack::Direction;
using tripack::Point2;
using Real = long double;
using Limits = std::numeric_limits<Real>;
__extension__ typedef __int128 Wide;

// One rounding; 2^-64 on x86-64.
constexpr Real unit = Limits::epsilon() / 2;

// Four doubles multiplied neither overflow nor underflow in such a type, so that no bound
// below needs a term for that. Where long double is narrower, everything goes to GMP.
constexpr bool is_wide = Limits::max_exponent >= 4 * 1100 && Limits::digits >= 64;

std::optional<int> sign_beyond(Real value, Real bound) {
  if (!is_wide) return std::nullopt;
  // Nothing but zeros went into a bound of 0.
  if (bound == 0) return 0;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return std::nullopt;
}

template <class Number>
int sign(const Number& value) {
  return static_cast<int>(value > 0) - static_cast<int>(value < 0);
}

struct Plane {
  Real x, y;
};
Plane operator-(Point2 a, Point2 b) { return {Real{a.x} - b.x, Real{a.y} - b.y}; }

// Of one product: differences, product, sum.
struct Bounded {
  Real value, size;  // size: the sum of the magnitudes
};
Bounded cross(Plane a, Plane b) {
  const Real left = a.x * b.y, right = a.y * b.x;
  return {left - right, std::abs(left) + std::abs(right)};
}
Real squared(Plane a) { return a.x * a.x + a.y * a.y; }

// The coordinates as integers below 2^30, if they are that on a common scale.
template <std::size_t Size>
std::optional<std::array<std::int64_t, Size>> short_integers(
    const std::array<Real, Size>& values) {
  Real largest = 0;
  for (const Real v : values) largest = std::max(largest, std::abs(v));
  if (!is_wide || largest == 0) return std::nullopt;
  const Real scale = std::ldexp(Real{1}, 29 - std::ilogb(largest));
  std::array<std::int64_t, Size> result;
  for (std::size_t i = 0; i < Size; ++i) {
    const Real scaled = values[i] * scale;
    result[i] = static_cast<std::int64_t>(scaled);
    if (static_cast<Real>(result[i]) != scaled) return std::nullopt;
  }
  return result;
}

bool is_exact(Plane difference, Point2 a, Point2 b) {
  return difference.x + b.x == a.x && a.x - difference.x == b.x &&
         difference.y + b.y == a.y && a.y - difference.y == b.y;
}

Wide wide_cross(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
  return Wide{ax} * by - Wide{ay} * bx;
}
Wide wide_square(std::int64_t x, std::int64_t y) { return Wide{x} * x + Wide{y} * y; }

// Below 3 * 2^61 * 2^61.
std::optional<int> short_in_circle(Plane a, Plane b, Plane c) {
  const auto v = short_integers(std::array{a.x, a.y, b.x, b.y, c.x, c.y});
  if (!v) return std::nullopt;
  const auto [ax, ay, bx, by, cx, cy] = *v;
  return sign(wide_square(ax, ay) * wide_cross(bx, by, cx, cy) +
              wide_square(bx, by) * wide_cross(cx, cy, ax, ay) +
              wide_square(cx, cy) * wide_cross(ax, ay, bx, by));
}

struct Space {
  Real x, y, z;
};
Space vector(const Direction& a) { return {a.x(), a.y(), a.z()}; }
Space operator-(const Direction& a, const Direction& b) {
  return {Real{a.x()} - b.x(), Real{a.y()} - b.y(), Real{a.z()} - b.z()};
}
Space operator+(const Direction& a, const Direction& b) {
  return {Real{a.x()} + b.x(), Real{a.y()} + b.y(), Real{a.z()} + b.z()};
}
Real dot(const Space& a, const Space& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// a . (b x c)
Bounded volume(const Space& a, const Space& b, const Space& c) {
  const Bounded x = cross({b.y, b.z}, {c.y, c.z}), y = cross({b.z, b.x}, {c.z, c.x}),
                z = cross({b.x, b.y}, {c.x, c.y});
  return {a.x * x.value + a.y * y.value + a.z * z.value,
          std::abs(a.x) * x.size + std::abs(a.y) * y.size + std::abs(a.z) * z.size};
}

// a b against c d. Rounding is monotonic, and what it takes off fits into one number.
bool is_same_product(double a, double b, double c, double d) {
  const Real left = Real{a} * b, right = Real{c} * d;
  if (left != right) return false;
  return std::fma(Real{a}, Real{b}, -left) == std::fma(Real{c}, Real{d}, -right);
}

using Integers = std::array<std::array<mpz_class, 3>, 4>;

// All four on the scale of the smallest bit.
Integers integers(const std::array<const Direction*, 4>& directions) {
  std::array<std::array<double, 3>, 4> v;
  int lowest = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < 4; ++i) {
    v[i] = {directions[i]->x(), directions[i]->y(), directions[i]->z()};
    for (const double c : v[i])
      lowest = c == 0 ? lowest : std::min(lowest, std::ilogb(c));
  }
  Integers result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (v[i][k] == 0) continue;
      const int exponent = std::ilogb(v[i][k]);
      result[i][k] = mpz_class(std::scalbn(v[i][k], 52 - exponent));
      result[i][k] <<= static_cast<unsigned>(exponent - lowest);
    }
  }
  return result;
}

mpz_class squared_length(const std::array<mpz_class, 3>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

// Four equal lengths: the sign of minus det(a - p, b - p, c - p); otherwise nothing.
std::optional<int> equal_lengths_in_circle(const std::array<const Direction*, 4>& d) {
  Integers v = integers(d);
  const mpz_class length = squared_length(v[3]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (squared_length(v[i]) != length) return std::nullopt;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) v[i][k] -= v[3][k];
  }
  const auto &a = v[0], &b = v[1], &c = v[2];
  const mpz_class det = a[0] * (b[1] * c[2] - b[2] * c[1]) +
                        a[1] * (b[2] * c[0] - b[0] * c[2]) +
                        a[2] * (b[0] * c[1] - b[1] * c[0]);
  return -sgn(det);
}

}  // namespace

// Two differences and a product: 3 units of each product.
int orientation(Point2 a, Point2 b, Point2 c) {
  const Bounded det = cross(a - c, b - c);
  const auto certain = sign_beyond(det.value, 4 * unit * det.size);
  return certain ? *certain : support::exact_orientation(a, b, c);
}

// 4 units for a squared distance and for a cross product, 2 for their product and sum.
int in_circle(Point2 a, Point2 b, Point2 c, Point2 p) {
  const Plane A = a - p, B = b - p, C = c - p;
  const Bounded bc = cross(B, C), ca = cross(C, A), ab = cross(A, B);
  const Real aa = squared(A), bb = squared(B), cc = squared(C);
  const Real det = aa * bc.value + bb * ca.value + cc * ab.value;
  const Real size = aa * bc.size + bb * ca.size + cc * ab.size;
  if (const auto certain = sign_beyond(det, 12 * unit * size)) return *certain;
  if (is_exact(A, a, p) && is_exact(B, b, p) && is_exact(C, c, p)) {
    if (const auto exact = short_in_circle(A, B, C)) return *exact;
  }
  return support::exact_in_circle(a, b, c, p);
}

// 4 units for a component of the cross product, 3 for its product and the sums.
int orientation(const Direction& a, const Direction& b, const Direction& c) {
  const Bounded det = volume(vector(a), b - a, c - a);
  const auto certain = sign_beyond(det.value, 8 * unit * det.size);
  return certain ? *certain : support::exact_orientation(a, b, c);
}

// With A = a - p and so on, the determinant with rows (v, |v|) is, but for a positive
// factor and the sign,
//   sum of (|A|^2 - d_A^2) p . (B x C) over cyclic (A, B, C),  d_A = |a| - |p|.
// d_A = A . (a + p) / (|a| + |p|), the denominator within 2^-50 of 2: off by 2^-50 d_A
// and 6 units of |A|, and since d_A <= |A|, the bracket by 20 units of |A|^2 and 2^-48
// d_A^2. 7 units for the volume and 3 for product and sums; the rest is slack.
int in_circle(const Direction& a, const Direction& b, const Direction& c,
              const Direction& p) {
  const Space A = a - p, B = b - p, C = c - p, P = vector(p);
  Real det = 0, bound = 0;
  const auto add = [&](const Direction& from, const Space& edge, const Bounded& base) {
    const Real square = dot(edge, edge), d = dot(edge, from + p) / 2;
    det += (square - d * d) * base.value;
    bound += (32 * unit * square + 0x1p-47L * d * d) * base.size;
  };
  add(a, A, volume(P, B, C));
  add(b, B, volume(P, C, A));
  add(c, C, volume(P, A, B));
  if (const auto certain = sign_beyond(det, bound)) return *certain;
  if (const auto exact = equal_lengths_in_circle({&a, &b, &c, &p})) return *exact;
  return support::exact_in_circle(a, b, c, p);
}

bool is_parallel(const Direction& a, const Direction& b) {
  return is_same_product(a.x(), b.y(), a.y(), b.x()) &&
         is_same_product(a.y(), b.z(), a.z(), b.y()) &&
         is_same_product(a.z(), b.x(), a.x(), b.z());
}

bool is_same_ray(const Direction& a, const Direction& b) {
  return dot(vector(a), vector(b)) > 0 && is_parallel(a, b);
}

}  // namespace delone::campaign
