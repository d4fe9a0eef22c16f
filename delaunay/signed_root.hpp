#pragma once

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

}  // namespace delone::delaunay
