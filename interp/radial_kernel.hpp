#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "interp/rbf_surface.hpp"

namespace delone::interp {

/// The natural logarithm of a positive normal number, to 3 units in the last place; of
/// zero something finite. Without a branch or a call, so that loops over it are done in
/// vector registers.
[[nodiscard]] inline double branchless_log(double x) noexcept {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t biased = (bits - root_half + one) >> 52;
  // An integer below 2^52 in the last places of 2^52: exact, and SSE2 has no conversion.
  const double exponent =
      std::bit_cast<double>(0x4330000000000000 | biased) - (0x1p52 + 1023);
  const double m = std::bit_cast<double>(bits - (biased << 52) + one);
  const double s = (m - 1) / (m + 1), z = s * s;
  const double high =
      1.0 / 11 + z * (1.0 / 13 + z * (1.0 / 15 + z * (1.0 / 17 + z / 19)));
  const double series =
      1.0 / 3 + z * (1.0 / 5 + z * (1.0 / 7 + z * (1.0 / 9 + z * high)));
  return exponent * std::numbers::ln2 + (2 * s + 2 * s * z * series);
}

// Kernels as functions of the squared distance q, with their derivatives by q. All are
// conditionally positive definite.
struct ThinPlate {
  static constexpr int order = 2;     ///< 1 + the least degree of the polynomial
  static constexpr double power = 2;  ///< of lengths
  static double value(double q) noexcept { return 0.5 * q * branchless_log(q); }
  static double rate(double q) noexcept { return 0.5 * branchless_log(q) + 0.5; }
};
struct Cubic {
  static constexpr int order = 2;
  static constexpr double power = 3;
  static double value(double q) noexcept { return q * std::sqrt(q); }
  static double rate(double q) noexcept { return 1.5 * std::sqrt(q); }
};
struct Quintic {
  static constexpr int order = 3;
  static constexpr double power = 5;
  static double value(double q) noexcept { return -q * q * std::sqrt(q); }
  static double rate(double q) noexcept { return -2.5 * q * std::sqrt(q); }
};

/// f(kernel) for the one that is named.
template <class F>
decltype(auto) with_kernel(RadialKernel kernel, F f) {
  if (kernel == RadialKernel::cubic) return f(Cubic{});
  if (kernel == RadialKernel::quintic) return f(Quintic{});
  return f(ThinPlate{});
}

}  // namespace delone::interp
