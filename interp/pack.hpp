#pragma once

#include "delaunay/instruction_set.hpp"
#include "delaunay/lanes.hpp"

namespace delone::interp {

/// Four numbers that a formula written for one number works on at once; each comes out
/// with the bits it has alone. The instruction set that the formula is compiled for is
/// part of the type (delaunay/instruction_set.hpp).
template <class InstructionSet>
struct Pack {
  delaunay::Double4 lanes;

  Pack() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a constant is a number like any other
  [[gnu::always_inline]] Pack(double v) : lanes(delaunay::four(v)) {}
  [[gnu::always_inline]] explicit Pack(const delaunay::Double4& v) : lanes(v) {}

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
    const delaunay::Mask4 is_positive = a.lanes > delaunay::Double4{};
    return Pack(reinterpret_cast<delaunay::Double4>(
        reinterpret_cast<delaunay::Mask4>(a.lanes) & is_positive));
  }
};

template <class T>
inline constexpr bool is_pack = false;
template <class InstructionSet>
inline constexpr bool is_pack<Pack<InstructionSet>> = true;

}  // namespace delone::interp
