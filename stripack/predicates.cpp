#include "stripack/predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "delaunay/big_integer.hpp"
#include "delaunay/double_double.hpp"
#include "delaunay/signed_root.hpp"
#include "delaunay/wide_integer.hpp"
#include "stripack/predicate_rungs.hpp"

namespace delone::stripack {

namespace {

using delaunay::exact_difference;
using delaunay::Int128;
using delaunay::product;
using delaunay::SignedRoot;
using delaunay::TwoTerms;

// 2 over 2^-1074 is 1076 bits.
using Coordinate = delaunay::BigInteger<17>;

template <class Number>
struct Vector {
  Number x, y, z;
};

using IntegerVector = std::array<std::int64_t, 3>;
using ExactVector = Vector<Coordinate>;

std::array<TwoTerms, 3> exact_difference(const Direction& a, const Direction& b) {
  return {exact_difference(a.x(), b.x()), exact_difference(a.y(), b.y()),
          exact_difference(a.z(), b.z())};
}

std::array<Int128, 3> cross(const IntegerVector& a, const IntegerVector& b) {
  return {product(a[1], b[2]) - product(a[2], b[1]),
          product(a[2], b[0]) - product(a[0], b[2]),
          product(a[0], b[1]) - product(a[1], b[0])};
}

Int128 squared_length(const IntegerVector& a) {
  return product(a[0], a[0]) + product(a[1], a[1]) + product(a[2], a[2]);
}

// In units of 2^-60, cut off towards zero. No coordinate exceeds 1 + 2^-51.
constexpr double fixed_point_scale = 0x1p60;
IntegerVector to_fixed_point(const Direction& a) {
  return {static_cast<std::int64_t>(a.x() * fixed_point_scale),
          static_cast<std::int64_t>(a.y() * fixed_point_scale),
          static_cast<std::int64_t>(a.z() * fixed_point_scale)};
}

bool is_exact(const IntegerVector& fixed, const Direction& a) {
  return static_cast<double>(fixed[0]) == a.x() * fixed_point_scale &&
         static_cast<double>(fixed[1]) == a.y() * fixed_point_scale &&
         static_cast<double>(fixed[2]) == a.z() * fixed_point_scale;
}

// |v| / 2^64 from above; the upper word converts to double at no cost.
double upper_bound(Int128 v) {
  return std::abs(static_cast<double>(delaunay::upper_word(v))) + 1;
}
double bound_of_sum(const std::array<Int128, 3>& v) {
  return upper_bound(v[0]) + upper_bound(v[1]) + upper_bound(v[2]);
}

// For the rounding of the bounds and of what is compared with them.
constexpr double bound_margin = 1 + 0x1p-40;

// The sign, if the upper part is beyond the bound; the lower part is worth 1, and that is
// the bound's part to allow for.
template <class Integer>
std::optional<int> sign_beyond(const Integer& value, double bound) {
  if (std::abs(static_cast<double>(value.high)) > bound) return value.sign();
  return std::nullopt;
}

}  // namespace

std::optional<int> orientation_integer(const Direction& a, const Direction& b,
                                       const Direction& c) noexcept {
  const auto [bx, by, bz] = exact_difference(b, a);
  const auto [cx, cy, cz] = exact_difference(c, a);
  const auto scaled = delaunay::to_scaled_integers(std::array{bx, by, bz, cx, cy, cz});
  if (!scaled.is_exact) return std::nullopt;
  const auto& v = scaled.values;
  const std::array<Int128, 3> normal = cross({v[0], v[1], v[2]}, {v[3], v[4], v[5]});
  const IntegerVector fixed = to_fixed_point(a);
  const auto det = delaunay::dot(fixed, normal);
  if (is_exact(fixed, a)) return det.sign();
  // Cutting a off changes the determinant by less than |normal|_1; in units of 2^64.
  return sign_beyond(det, (bound_of_sum(normal) + 1) * bound_margin);
}

std::optional<int> in_circle_integer(const Direction& a, const Direction& b,
                                     const Direction& c, const Direction& p) noexcept {
  const auto [ax, ay, az] = exact_difference(a, p);
  const auto [bx, by, bz] = exact_difference(b, p);
  const auto [cx, cy, cz] = exact_difference(c, p);
  const auto scaled =
      delaunay::to_scaled_integers(std::array{ax, ay, az, bx, by, bz, cx, cy, cz});
  if (!scaled.is_exact) return std::nullopt;
  const auto& v = scaled.values;
  const IntegerVector a_p{v[0], v[1], v[2]}, b_p{v[3], v[4], v[5]}, c_p{v[6], v[7], v[8]};
  const std::array normals{cross(b_p, c_p), cross(c_p, a_p), cross(a_p, b_p)};
  const std::array squares{squared_length(a_p), squared_length(b_p), squared_length(c_p)};
  const IntegerVector fixed = to_fixed_point(p);
  const auto upper_part = [&](std::size_t i) {
    return delaunay::dot(fixed, normals[i]).high;
  };
  const auto det =
      delaunay::dot(squares, std::array{upper_part(0), upper_part(1), upper_part(2)});

  // In units of 2^192. A term is (|A|^2 - (|a| - |p|)^2) p . (B x C). Cutting p
  // off and taking the upper part changes p . (B x C) by less than |B x C|_1 +
  // 2^64; the lengths are left out, at most 2^-100 scale^2 times |p . (B x C)| <=
  // 2^60 (1 + 2^-51) |B x C|_1.
  const double length_term = 0x1p-104 * scaled.scale * scaled.scale;
  double bound = 0x1p64;
  for (std::size_t i = 0; i < 3; ++i) {
    bound += (upper_bound(squares[i]) + length_term) * (bound_of_sum(normals[i]) + 1);
  }
  return sign_beyond(det, 0x1p-64 * bound * bound_margin);
}

namespace {

// The four directions as integers on a common scale.
template <std::size_t Size>
std::array<ExactVector, Size> to_exact(
    const std::array<const Direction*, Size>& directions) {
  std::array<double, 3 * Size> values;
  for (std::size_t i = 0; i < Size; ++i) {
    values[3 * i] = directions[i]->x();
    values[3 * i + 1] = directions[i]->y();
    values[3 * i + 2] = directions[i]->z();
  }
  const int exponent = delaunay::common_exponent(values);
  std::array<ExactVector, Size> result;
  for (std::size_t i = 0; i < Size; ++i) {
    result[i] = {{values[3 * i], exponent},
                 {values[3 * i + 1], exponent},
                 {values[3 * i + 2], exponent}};
  }
  return result;
}

auto determinant(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
         a.z * (b.x * c.y - b.y * c.x);
}

auto squared_length(const ExactVector& a) { return a.x * a.x + a.y * a.y + a.z * a.z; }

}  // namespace

namespace {

// On the equator or one of the meridians 0 and 90 degrees, where degree-exact data have
// the most ties: a column of zeros.
template <class... Directions>
bool is_on_coordinate_circle(const Directions&... d) {
  return ((d.x() == 0) && ...) || ((d.y() == 0) && ...) || ((d.z() == 0) && ...);
}

}  // namespace

int orientation_exact(const Direction& a, const Direction& b,
                      const Direction& c) noexcept {
  const auto v = to_exact(std::array{&a, &b, &c});
  return determinant(v[0], v[1], v[2]).sign();
}

int orientation(const Direction& a, const Direction& b, const Direction& c) noexcept {
  if (const int certain = orientation_filter(a, b, c); certain != 0) return certain;
  if (is_on_coordinate_circle(a, b, c)) return 0;
  if (const auto exact = orientation_integer(a, b, c)) return *exact;
  return orientation_exact(a, b, c);
}

// Minus the determinant with rows (x, y, z, |v|), by its last column, is a sum of four
// terms: a length times the determinant of the other three. Both rungs below first add up
// the determinants of equal lengths. Exact ties come from symmetry, four directions of
// one circle that are each other's images, and these have equal lengths in pairs or all,
// so that all sums are zero or have one sign and no root is needed.

std::optional<int> in_circle_of_fixed_points(const Direction& a, const Direction& b,
                                             const Direction& c,
                                             const Direction& p) noexcept {
  const std::array fixed{to_fixed_point(a), to_fixed_point(b), to_fixed_point(c),
                         to_fixed_point(p)};
  if (!is_exact(fixed[0], a) || !is_exact(fixed[1], b) || !is_exact(fixed[2], c) ||
      !is_exact(fixed[3], p)) {
    return std::nullopt;
  }
  // Coordinates of at most 2^60 (1 + 2^-51): lengths below 2^122, cross products below
  // 2^122, determinants below 2^184.
  const std::array<Int128, 3> ab = cross(fixed[0], fixed[1]),
                              ba = cross(fixed[1], fixed[0]),
                              cp = cross(fixed[2], fixed[3]),
                              pc = cross(fixed[3], fixed[2]);
  const std::array determinants{delaunay::dot(fixed[1], cp), delaunay::dot(fixed[0], pc),
                                delaunay::dot(fixed[3], ab), delaunay::dot(fixed[2], ba)};
  const std::array lengths{squared_length(fixed[0]), squared_length(fixed[1]),
                           squared_length(fixed[2]), squared_length(fixed[3])};
  bool some_positive = false, some_negative = false;
  for (std::size_t i = 0; i < 4; ++i) {
    delaunay::Integer192 sum;
    for (std::size_t j = 0; j < 4; ++j) {
      if (lengths[j] == lengths[i]) sum = sum + determinants[j];
    }
    some_positive |= sum.sign() > 0;
    some_negative |= sum.sign() < 0;
  }
  if (some_positive && some_negative) return std::nullopt;
  return static_cast<int>(some_positive) - static_cast<int>(some_negative);
}

namespace {

// The sum of the determinants whose lengths are that of number i; 0 if an earlier number
// has the same.
template <class Determinant, class Square>
auto sum_of_equal_lengths(const std::array<Determinant, 4>& determinants,
                          const std::array<Square, 4>& squares, std::size_t i) {
  const auto part = [&](std::size_t j) {
    return squares[j] == squares[i] ? determinants[j] : Determinant();
  };
  auto sum = part(0) + part(1) + part(2) + part(3);
  const bool is_first = std::find(squares.begin(), squares.end(), squares[i]) ==
                        squares.begin() + static_cast<std::ptrdiff_t>(i);
  return is_first ? sum : decltype(sum)();
}

}  // namespace

int in_circle_exact(const Direction& a, const Direction& b, const Direction& c,
                    const Direction& p) noexcept {
  const auto v = to_exact(std::array{&a, &b, &c, &p});
  const std::array squares{squared_length(v[0]), squared_length(v[1]),
                           squared_length(v[2]), squared_length(v[3])};
  const std::array determinants{
      determinant(v[1], v[2], v[3]), determinant(v[2], v[0], v[3]),
      determinant(v[0], v[1], v[3]), determinant(v[1], v[0], v[2])};
  const auto term = [&](std::size_t i) {
    return delaunay::RootTerm{sum_of_equal_lengths(determinants, squares, i), squares[i]};
  };
  return delaunay::sign_of_sum(std::array{term(0), term(1), term(2), term(3)});
}

int in_circle(const Direction& a, const Direction& b, const Direction& c,
              const Direction& p) noexcept {
  if (const int certain = in_circle_filter(a, b, c, p); certain != 0) return certain;
  if (is_on_coordinate_circle(a, b, c, p)) return 0;
  if (const auto certain = in_circle_integer(a, b, c, p)) return *certain;
  if (const auto exact = in_circle_of_fixed_points(a, b, c, p)) return *exact;
  return in_circle_exact(a, b, c, p);
}

// Rounding is monotonic, so different rounded products tell; where they agree, what was
// rounded off does, unless it may have underflowed.
int cross_sign(double ux, double uy, double vx, double vy) noexcept {
  const auto [left, left_rest] = delaunay::two_product(ux, vy);
  const auto [right, right_rest] = delaunay::two_product(uy, vx);
  if (left != right) return left > right ? 1 : -1;
  if (std::abs(left) > 0x1p-900) {
    return static_cast<int>(left_rest > right_rest) -
           static_cast<int>(left_rest < right_rest);
  }
  if ((ux == 0 || vy == 0) && (uy == 0 || vx == 0)) return 0;
  const int exponent = delaunay::common_exponent(std::array{ux, uy, vx, vy});
  const auto integer = [exponent](double v) { return Coordinate(v, exponent); };
  return (integer(ux) * integer(vy) - integer(uy) * integer(vx)).sign();
}

namespace {

bool is_before(const Direction& a, const Direction& b) {
  if (a.x() != b.x()) return a.x() < b.x();
  if (a.y() != b.y()) return a.y() < b.y();
  return a.z() < b.z();
}

struct Coordinates2 {
  double u, v;
};

Coordinates2 without_x(const Direction& d) { return {d.y(), d.z()}; }
Coordinates2 without_y(const Direction& d) { return {d.x(), d.z()}; }
Coordinates2 without_z(const Direction& d) { return {d.x(), d.y()}; }

// Turning sense of three different directions of one great circle in a projection: of the
// three crosses at most one is against the others or zero. 0 where it is seen edge-on.
int turn(Coordinates2 a, Coordinates2 b, Coordinates2 c) {
  const int sum = cross_sign(a.u, a.v, b.u, b.v) + cross_sign(b.u, b.v, c.u, c.v) +
                  cross_sign(c.u, c.v, a.u, a.v);
  return static_cast<int>(sum > 0) - static_cast<int>(sum < 0);
}

// Rows of the determinant in an even order, which leaves its sign alone.
struct Rows {
  const Direction *first, *second, *third, *fourth;
};

// An even order whose first row is the lowest.
Rows lowest_first(const Direction& a, const Direction& b, const Direction& c,
                  const Direction& p) {
  const std::array<Rows, 4> orders{
      {{&a, &b, &c, &p}, {&b, &c, &a, &p}, {&c, &a, &b, &p}, {&p, &b, &a, &c}}};
  return *std::min_element(
      orders.begin(), orders.end(),
      [](const Rows& s, const Rows& t) { return is_before(*s.first, *t.first); });
}

// Minus the cofactors of z, y and x in the first row: the other three rows without
// that column are (u, v, length), whose determinant has the sign of the turn of
// the unit vectors' (u, v).
int break_great_circle_tie(const Rows& rows) {
  const auto& [first, second, third, fourth] = rows;
  if (const int z = turn(without_z(*second), without_z(*third), without_z(*fourth));
      z != 0) {
    return -z;
  }
  if (const int y = turn(without_y(*second), without_y(*third), without_y(*fourth));
      y != 0) {
    return y;
  }
  return -turn(without_x(*second), without_x(*third), without_x(*fourth));
}

}  // namespace

// The sign of minus the determinant with rows (x, y, z, |v|) once |v| of the direction of
// rank i grows by e_i, its z by f_i, y by g_i and x by h_i, where each of
//   e_0 >> e_1 >> ... >> f_0 >> f_1 >> ... >> g_0 >> ... >> h_0 >> ...
// is infinitely smaller than the one before. One perturbation for all sites, so all
// answers fit together. The first decides whose cofactor is not zero. Four directions
// of a small circle have no three on a great circle, so there it is e_0; where its
// cofactor vanishes, all four are on a great circle and all cofactors of the e vanish,
// and those of f, g or h where the circle is seen edge-on along z, y or x.
int break_tie(const Direction& a, const Direction& b, const Direction& c,
              const Direction& p) noexcept {
  const Rows rows = lowest_first(a, b, c, p);
  if (const int side = orientation(*rows.second, *rows.third, *rows.fourth); side != 0)
    return side;
  return break_great_circle_tie(rows);
}

int in_circle_perturbed(const Direction& a, const Direction& b, const Direction& c,
                        const Direction& p) noexcept {
  const int exact = in_circle(a, b, c, p);
  return exact != 0 ? exact : break_tie(a, b, c, p);
}

}  // namespace delone::stripack
