#include "tripack/distance_order.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "delaunay/big_integer.hpp"
#include "delaunay/wide_integer.hpp"

namespace delone::tripack {

namespace {

using delaunay::exact_difference;
using delaunay::Int128;
using delaunay::product;

// 2^1024 over 2^-1074 is 2098 bits.
using Coordinate = delaunay::BigInteger<33>;

std::optional<int> compare_integer(Point2 p, Point2 a, Point2 b) noexcept {
  const auto scaled = delaunay::to_scaled_integers(
      std::array{exact_difference(a.x, p.x), exact_difference(a.y, p.y),
                 exact_difference(b.x, p.x), exact_difference(b.y, p.y)});
  if (!scaled.is_exact) return std::nullopt;
  const auto [ax, ay, bx, by] = scaled.values;
  const Int128 squared_a = product(ax, ax) + product(ay, ay);
  const Int128 squared_b = product(bx, bx) + product(by, by);
  return static_cast<int>(squared_a > squared_b) -
         static_cast<int>(squared_a < squared_b);
}

// |a - p|^2 - |b - p|^2
int compare_big_integer(Point2 p, Point2 a, Point2 b) noexcept {
  const int exponent =
      delaunay::common_exponent(std::array{p.x, p.y, a.x, a.y, b.x, b.y});
  const auto integer = [exponent](double v) { return Coordinate(v, exponent); };
  const auto px = integer(p.x), py = integer(p.y);
  const auto ax = integer(a.x) - px, ay = integer(a.y) - py;
  const auto bx = integer(b.x) - px, by = integer(b.y) - py;
  return (ax * ax + ay * ay - (bx * bx + by * by)).sign();
}

}  // namespace

int compare_distances_exact(Point2 p, Point2 a, Point2 b) noexcept {
  const auto exact = compare_integer(p, a, b);
  return exact ? *exact : compare_big_integer(p, a, b);
}

int compare_distances(Point2 p, Point2 a, Point2 b) noexcept {
  const int certain =
      compare_distances_filter(squared_distance(p, a), squared_distance(p, b));
  return certain != 0 ? certain : compare_distances_exact(p, a, b);
}

bool is_within(Point2 p, Point2 a, double radius) noexcept {
  if (const int certain =
          compare_distances_filter(squared_distance(p, a), radius * radius);
      certain != 0)
    return certain < 0;
  const int exponent = delaunay::common_exponent(std::array{p.x, p.y, a.x, a.y, radius});
  const auto integer = [exponent](double v) { return Coordinate(v, exponent); };
  const auto dx = integer(a.x) - integer(p.x), dy = integer(a.y) - integer(p.y);
  const auto r = integer(radius);
  return (dx * dx + dy * dy - r * r).sign() <= 0;
}

double distance(Point2 p, Point2 a) noexcept {
  const double squared = squared_distance(p, a);
  if (squared > 0x1p-900 && squared < 0x1p1000) return std::sqrt(squared);
  // Halves do not overflow; what they lose of subnormal numbers the first form keeps.
  const double dx = a.x - p.x, dy = a.y - p.y;
  if (std::isfinite(dx) && std::isfinite(dy)) return std::hypot(dx, dy);
  return 2 * std::hypot(a.x / 2 - p.x / 2, a.y / 2 - p.y / 2);
}

}  // namespace delone::tripack
