#include "delaunay/big_integer.hpp"

namespace delone::delaunay {

DecodedDouble decode(double value) noexcept {
  constexpr std::uint64_t hidden_bit = std::uint64_t{1} << 52;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & (hidden_bit - 1);
  const std::uint64_t mantissa = biased == 0 ? fraction : fraction | hidden_bit;
  if (mantissa == 0) return {};
  const int zeros = std::countr_zero(mantissa);
  return {(bits >> 63) != 0 ? -1 : 1, mantissa >> zeros,
          std::max(biased, 1) - 1075 + zeros};
}

int common_exponent(std::span<const double> values) noexcept {
  int exponent = 1024;
  for (const double value : values) {
    const DecodedDouble decoded = decode(value);
    if (decoded.sign != 0) exponent = std::min(exponent, decoded.exponent);
  }
  return exponent == 1024 ? 0 : exponent;
}

}  // namespace delone::delaunay
