#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "delaunay/big_integer.hpp"

namespace delone::delaunay {

/// sign * sqrt(square): the sign -1, 0 or +1, the square not negative, 0 exactly
/// when the sign is.
template <int Capacity>
struct SignedRoot {
  int sign;
  BigInteger<Capacity> square;
};
template <int Capacity>
SignedRoot(int, BigInteger<Capacity>) -> SignedRoot<Capacity>;

/// Sign of s + t. Exact.
template <int A, int B>
[[nodiscard]] int sign_of_sum(const SignedRoot<A>& s, const SignedRoot<B>& t) noexcept {
  if (s.sign == t.sign || t.sign == 0) return s.sign;
  if (s.sign == 0) return t.sign;
  return s.sign * s.square.compare_magnitude(t.square);
}

/// Sign of X + Y, X = s + t, Y = v + w. Exact, by squaring only: no root is ever taken.
///
/// Where X and Y pull in different directions |X| against |Y| decides, that is
/// (capitals: squares)
///   X^2 - Y^2 = R + Z,  R = S + T - V - W,  Z = 2 st - 2 vw,
/// which is decided by its parts where they agree, else by
///   Z^2 - R^2 = L - 8 stvw,  L = 4 ST + 4 VW - R^2,
/// and that by L^2 against 64 STVW: the eighth power of the roots' order of magnitude.
template <int Capacity>
[[nodiscard]] int sign_of_sum(const SignedRoot<Capacity>& s,
                              const SignedRoot<Capacity>& t,
                              const SignedRoot<Capacity>& v,
                              const SignedRoot<Capacity>& w) noexcept {
  const int x = sign_of_sum(s, t), y = sign_of_sum(v, w);
  if (x == y || y == 0) return x;
  if (x == 0) return y;
  const BigInteger<1> four(4, 0);
  const auto r = s.square + t.square - (v.square + w.square);
  const auto st = four * (s.square * t.square), vw = four * (v.square * w.square);
  const int z =
      sign_of_sum(SignedRoot{s.sign * t.sign, st}, SignedRoot{-v.sign * w.sign, vw});
  if (r.sign() == z || z == 0) return x * r.sign();
  if (r.sign() == 0) return x * z;
  const auto l = st + vw - r * r;
  const auto l_square = l * l;
  const auto stvw = four * (st * vw);
  const int z_against_r =
      sign_of_sum(SignedRoot{l.sign(), l_square},
                  SignedRoot{-s.sign * t.sign * v.sign * w.sign, stvw});
  if (z_against_r == 0) return 0;
  return x * (z_against_r > 0 ? z : r.sign());
}

/// factor * sqrt(square), square > 0.
template <int Factor, int Square>
struct RootTerm {
  BigInteger<Factor> factor;
  BigInteger<Square> square;
};
template <int Factor, int Square>
RootTerm(BigInteger<Factor>, BigInteger<Square>) -> RootTerm<Factor, Square>;

/// Sign of the sum of four terms from their leading 53 bits, if they settle it.
///
/// With u = 2^-53 a factor is cut off by less than 2 u and so is a square, which is half
/// of that in its root; the root and the product round: less than 5 u of a term, 3 u for
/// the sums, twice that for the bound's own rounding. Terms that underflow on the scale
/// of the largest one (whose mantissa is at least 1) do not come near the bound either.
template <int Factor, int Square>
[[nodiscard]] std::optional<int> estimated_sign_of_sum(
    const std::array<RootTerm<Factor, Square>, 4>& terms) noexcept {
  std::array<double, 4> mantissa{};
  std::array<int, 4> exponent{};
  int largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [factor, factor_exponent] = terms[i].factor.leading();
    const auto [square, square_exponent] = terms[i].square.leading();
    const bool is_odd = square_exponent % 2 != 0;
    mantissa[i] = factor * std::sqrt(is_odd ? 2 * square : square);
    exponent[i] = factor_exponent + square_exponent / 2;
    if (factor != 0) largest = std::max(largest, exponent[i]);
  }
  double sum = 0, size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double term = std::ldexp(mantissa[i], exponent[i] - largest);
    sum += term;
    size += std::abs(term);
  }
  if (size == 0) return 0;
  if (std::abs(sum) <= 0x1p-49 * size) return std::nullopt;
  return sum > 0 ? 1 : -1;
}

/// Sign of the sum of four terms. Exact.
template <int Factor, int Square>
[[nodiscard]] int sign_of_sum(
    const std::array<RootTerm<Factor, Square>, 4>& terms) noexcept {
  if (const auto certain = estimated_sign_of_sum(terms)) return *certain;
  const auto root = [](const RootTerm<Factor, Square>& term) {
    return SignedRoot{term.factor.sign(), term.square * (term.factor * term.factor)};
  };
  return sign_of_sum(root(terms[0]), root(terms[1]), root(terms[2]), root(terms[3]));
}

}  // namespace delone::delaunay
