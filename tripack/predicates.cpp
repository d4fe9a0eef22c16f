#include "tripack/predicates.hpp"

#include <array>
#include <cstdint>
#include <utility>

#include "delaunay/big_integer.hpp"
#include "delaunay/wide_integer.hpp"
#include "tripack/predicate_rungs.hpp"

namespace delone::tripack {

namespace {

using delaunay::exact_difference;
using delaunay::Int128;
using delaunay::product;

// 2^1024 over 2^-1074 is 2098 bits.
using Coordinate = delaunay::BigInteger<33>;

Int128 squared_length(std::int64_t x, std::int64_t y) {
  return product(x, x) + product(y, y);
}

Int128 cross(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
  return product(ax, by) - product(ay, bx);
}

// Without jumps: of the four points of a tie any may be the first.
bool is_before(Point2 a, Point2 b) {
  return static_cast<int>(a.x < b.x) |
         (static_cast<int>(a.x == b.x) & static_cast<int>(a.y < b.y));
}

}  // namespace

std::optional<int> orientation_integer(Point2 a, Point2 b, Point2 c) noexcept {
  const auto scaled = delaunay::to_scaled_integers(
      std::array{exact_difference(a.x, c.x), exact_difference(a.y, c.y),
                 exact_difference(b.x, c.x), exact_difference(b.y, c.y)});
  if (!scaled.is_exact) return std::nullopt;
  const auto [ax, ay, bx, by] = scaled.values;
  return delaunay::sign(cross(ax, ay, bx, by));
}

int orientation_exact(Point2 a, Point2 b, Point2 c) noexcept {
  const int exponent =
      delaunay::common_exponent(std::array{a.x, a.y, b.x, b.y, c.x, c.y});
  const auto integer = [exponent](double v) { return Coordinate(v, exponent); };
  const auto ax = integer(a.x) - integer(c.x), ay = integer(a.y) - integer(c.y);
  const auto bx = integer(b.x) - integer(c.x), by = integer(b.y) - integer(c.y);
  return (ax * by - ay * bx).sign();
}

int orientation(Point2 a, Point2 b, Point2 c) noexcept {
  if (const int certain = orientation_filter(a, b, c); certain != 0) return certain;
  if (const auto exact = orientation_integer(a, b, c)) return *exact;
  return orientation_exact(a, b, c);
}

std::optional<int> in_circle_integer(Point2 a, Point2 b, Point2 c, Point2 p) noexcept {
  const auto scaled = delaunay::to_scaled_integers(
      std::array{exact_difference(a.x, p.x), exact_difference(a.y, p.y),
                 exact_difference(b.x, p.x), exact_difference(b.y, p.y),
                 exact_difference(c.x, p.x), exact_difference(c.y, p.y)});
  if (!scaled.is_exact) return std::nullopt;
  const auto [ax, ay, bx, by, cx, cy] = scaled.values;
  // Coordinates of at most 2^61 make squares and cross products of at most 2^123.
  return delaunay::dot(
             std::array{squared_length(ax, ay), squared_length(bx, by),
                        squared_length(cx, cy)},
             {cross(bx, by, cx, cy), cross(cx, cy, ax, ay), cross(ax, ay, bx, by)})
      .sign();
}

int in_circle_exact(Point2 a, Point2 b, Point2 c, Point2 p) noexcept {
  const int exponent =
      delaunay::common_exponent(std::array{a.x, a.y, b.x, b.y, c.x, c.y, p.x, p.y});
  const auto integer = [exponent](double v) { return Coordinate(v, exponent); };
  const auto px = integer(p.x), py = integer(p.y);
  const auto ax = integer(a.x) - px, ay = integer(a.y) - py;
  const auto bx = integer(b.x) - px, by = integer(b.y) - py;
  const auto cx = integer(c.x) - px, cy = integer(c.y) - py;
  return ((ax * ax + ay * ay) * (bx * cy - by * cx) +
          (bx * bx + by * by) * (cx * ay - cy * ax) +
          (cx * cx + cy * cy) * (ax * by - ay * bx))
      .sign();
}

int in_circle(Point2 a, Point2 b, Point2 c, Point2 p) noexcept {
  if (const int certain = in_circle_filter(a, b, c, p); certain != 0) return certain;
  if (const auto exact = in_circle_integer(a, b, c, p)) return *exact;
  return in_circle_exact(a, b, c, p);
}

namespace {

// The sign of the determinant with rows (x, y, x^2 + y^2, 1) once the third entry of the
// point of rank i grows by e_i, e_0 >> e_1 >> ..., each infinitely smaller than the one
// before. The first decides whose cofactor, an orientation of the other three, is not
// zero. Four different points of a circle have no three on a line, so that is e_0: the
// point of lowest (x, y) goes outside.
int break_tie(Point2 a, Point2 b, Point2 c, Point2 p) noexcept {
  const std::array<Point2, 5> corner{a, b, c, a, b};
  std::size_t first = static_cast<std::size_t>(is_before(b, a));
  first = is_before(c, corner[first]) ? 2 : first;
  if (is_before(p, corner[first])) return orientation(b, a, c);
  return orientation(corner[first + 1], corner[first + 2], p);
}

}  // namespace

int in_circle_perturbed(Point2 a, Point2 b, Point2 c, Point2 p) noexcept {
  const int exact = in_circle(a, b, c, p);
  return exact != 0 ? exact : break_tie(a, b, c, p);
}

}  // namespace delone::tripack
