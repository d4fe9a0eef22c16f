#pragma once

#include "delaunay/lanes.hpp"

namespace delone::delaunay {

/// Four numbers, each the sum of two doubles: what was rounded off `high`, and smaller
/// terms, are in `low`. Not normalised: where terms cancel, `low` may exceed `high`.
struct Twofold4 {
  Double4 high, low;
  [[nodiscard, gnu::always_inline]] Double4 rounded() const { return high + low; }
};

/// What four candidates look like from a base: see the geometries of DivideConquer.
struct TwofoldLanes {
  Twofold4 cross, dot;
};

/// Arithmetic of twice the precision, without a branch. With u = 2^-53, let M and N bound
/// the magnitudes of the operands (of the terms they are made of, whatever cancels), p u
/// M and q u N their `low`. Results, errors in u^2 times their magnitude and beside those
/// of the operands:
///   difference of doubles  exact, |low| <= u times the difference
///   sum, difference        magnitude M + N, |low| <= max(p, q) + 1, error 2 max(p, q) +
///   1 product                magnitude M N, |low| <= p + q + 1, error p q + 3 (p + q) +
///   1
/// To that comes 2^-1073 for a product that underflows.
/// Source: T. J. Dekker, Numer. Math. 18 (1971) 224-242.
template <class InstructionSet>
struct TwofoldArithmetic {
  [[gnu::always_inline]] static Twofold4 difference(const Double4& a, const Double4& b) {
    return sum(a, -b);
  }
  [[gnu::always_inline]] static Twofold4 sum(const Twofold4& a, const Twofold4& b) {
    const Twofold4 s = sum(a.high, b.high);
    return {s.high, s.low + (a.low + b.low)};
  }
  [[gnu::always_inline]] static Twofold4 difference(const Twofold4& a,
                                                    const Twofold4& b) {
    return sum(a, {-b.high, -b.low});
  }
  [[gnu::always_inline]] static Twofold4 product(const Double4& a, const Double4& b) {
    const Double4 p = a * b;
    return {p, InstructionSet::product_error(a, b, p)};
  }
  [[gnu::always_inline]] static Twofold4 product(const Twofold4& a, const Twofold4& b) {
    const Twofold4 p = product(a.high, b.high);
    return {p.high, p.low + (a.high * b.low + a.low * b.high)};
  }
  [[gnu::always_inline]] static Twofold4 product(const Double4& a, const Twofold4& b) {
    const Twofold4 p = product(a, b.high);
    return {p.high, p.low + a * b.low};
  }

 private:
  [[gnu::always_inline]] static Twofold4 sum(const Double4& a, const Double4& b) {
    const Double4 s = a + b, b_part = s - a;
    return {s, (a - (s - b_part)) + (b - b_part)};
  }
};

}  // namespace delone::delaunay
