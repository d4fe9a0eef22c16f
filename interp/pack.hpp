#pragma once

#include "interp/lanes_of.hpp"

namespace delone::interp {

/// Several numbers that a formula written for one number works on at once; each comes out
/// with the bits it has alone. The instruction set that the formula is compiled for is
/// part of the type (delaunay/instruction_set.hpp).
template <class InstructionSet>
struct Pack {
  using Lanes = LanesOf<InstructionSet>;
  typename Lanes::Numbers lanes;

  Pack() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a constant is a number like any other
  [[gnu::always_inline]] Pack(double v) : lanes(Lanes::all(v)) {}
  [[gnu::always_inline]] explicit Pack(const typename Lanes::Numbers& v) : lanes(v) {}

  [[gnu::always_inline]] friend Pack operator+(const Pack& a, const Pack& b) {
    return Pack(a.lanes + b.lanes);
  }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a, const Pack& b) {
    return Pack(a.lanes - b.lanes);
  }
  [[gnu::always_inline]] friend Pack operator*(const Pack& a, const Pack& b) {
    return Pack(a.lanes * b.lanes);
  }
  [[gnu::always_inline]] friend Pack operator/(const Pack& a, const Pack& b) {
    return Pack(a.lanes / b.lanes);
  }
  [[gnu::always_inline]] friend Pack positive_part(const Pack& a) {
    return Pack(Lanes::positive_part(a.lanes));
  }
};

template <class T>
inline constexpr bool is_pack = false;
template <class InstructionSet>
inline constexpr bool is_pack<Pack<InstructionSet>> = true;

}  // namespace delone::interp
