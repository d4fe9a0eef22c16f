#pragma once

#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0
#error "exact predicates need IEEE doubles: no -ffast-math, no extended precision"
#endif

/// Exact determinants of numbers that fit into 61 bits, in a few tens of nanoseconds:
/// differences of doubles become 64-bit integers on a common scale, and products of
/// two, three and four of them are summed in 128, 192 and 256 bits. No allocation, no
/// loops of variable length.
namespace delone::delaunay {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UnsignedInt128;

[[nodiscard]] constexpr int sign(Int128 value) noexcept {
  return static_cast<int>(value > 0) - static_cast<int>(value < 0);
}

/// The product of two 64-bit integers.
[[nodiscard]] constexpr Int128 product(std::int64_t a, std::int64_t b) noexcept {
  return static_cast<Int128>(a) * b;
}

[[nodiscard]] constexpr std::int64_t upper_word(Int128 value) noexcept {
  return static_cast<std::int64_t>(value >> 64);
}
[[nodiscard]] constexpr std::uint64_t lower_word(Int128 value) noexcept {
  return static_cast<std::uint64_t>(value);
}

/// high * 2^64 + low
struct Integer192 {
  Int128 high = 0;
  std::uint64_t low = 0;
  [[nodiscard]] constexpr int sign() const noexcept {
    return high != 0 ? delaunay::sign(high) : static_cast<int>(low != 0);
  }
};

/// The sum of two that are at most 2^190 in magnitude.
[[nodiscard]] constexpr Integer192 operator+(const Integer192& a,
                                             const Integer192& b) noexcept {
  const std::uint64_t low = a.low + b.low;
  return {a.high + b.high + static_cast<int>(low < a.low), low};
}

/// high * 2^128 + low
struct Integer256 {
  Int128 high = 0;
  UnsignedInt128 low = 0;
  [[nodiscard]] constexpr int sign() const noexcept {
    return high != 0 ? delaunay::sign(high) : static_cast<int>(low != 0);
  }
};

/// a . b for |a_i| <= 2^61 and |b_i| < 2^124.
[[nodiscard]] constexpr Integer192 dot(const std::array<std::int64_t, 3>& a,
                                       const std::array<Int128, 3>& b) noexcept {
  Int128 high = 0, low = 0;  // below 3 * 2^121 and 3 * 2^125
  for (std::size_t i = 0; i < 3; ++i) {
    high += product(a[i], upper_word(b[i]));
    low += static_cast<Int128>(a[i]) * static_cast<Int128>(lower_word(b[i]));
  }
  return {high + (low >> 64), lower_word(low)};
}

/// a . b for 0 <= a_i < 2^124 and |b_i| < 2^124.
[[nodiscard]] constexpr Integer256 dot(const std::array<Int128, 3>& a,
                                       const std::array<Int128, 3>& b) noexcept {
  Int128 high = 0, middle = 0,
         low = 0;  // middle, in units of 2^64: below 6 * 2^124 + 3 * 2^64
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t a_high = upper_word(a[i]), b_high = upper_word(b[i]);
    const std::uint64_t a_low = lower_word(a[i]), b_low = lower_word(b[i]);
    const UnsignedInt128 lowest = static_cast<UnsignedInt128>(a_low) * b_low;
    high += product(a_high, b_high);
    middle += static_cast<Int128>(a_high) * static_cast<Int128>(b_low) +
              static_cast<Int128>(a_low) * static_cast<Int128>(b_high) +
              static_cast<Int128>(lowest >> 64);
    low += static_cast<Int128>(static_cast<std::uint64_t>(lowest));
  }
  middle += low >> 64;
  return {high + (middle >> 64),
          static_cast<UnsignedInt128>(lower_word(middle)) << 64 | lower_word(low)};
}

/// An unevaluated sum of two doubles, |tail| at most half a unit in the last
/// place of value.
struct TwoTerms {
  double value, tail;
};

/// a - b exactly, unless the difference overflows (Knuth's two-sum).
[[nodiscard]] inline TwoTerms exact_difference(double a, double b) noexcept {
  const double value = a - b;
  const double b_virtual = a - value;
  const double a_virtual = value + b_virtual;
  return {value, (a - a_virtual) + (b_virtual - b)};
}

/// Integers of at most 2^61 in magnitude, the given numbers times the power of
/// two `scale`.
template <std::size_t Size>
struct ScaledIntegers {
  std::array<std::int64_t, Size> values;
  double scale = 0;
  bool is_exact = false;  ///< else the numbers do not fit and the values mean nothing
};

/// The numbers as integers on one common power-of-two scale. They fit if all of them are
/// multiples of 2^-60 of the largest one's binade and that one is in [2^-900, 2^900].
template <std::size_t Size>
[[nodiscard]] ScaledIntegers<Size> to_scaled_integers(
    const std::array<TwoTerms, Size>& numbers) noexcept {
  ScaledIntegers<Size> result;
  double largest = 0;
  std::uint64_t tail_bits = 0;
  for (const TwoTerms& number : numbers) {
    // Not std::max, which becomes a jump that is taken at random.
    const double size = std::abs(number.value);
    largest = largest < size ? size : largest;
    tail_bits |= std::bit_cast<std::uint64_t>(number.tail) << 1;
  }
  if (!(largest >= 0x1p-900 && largest <= 0x1p900)) return result;
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(largest) >> 52;
  const double scale = std::bit_cast<double>((2 * 1023 + 60 - exponent) << 52);
  const double unit = std::bit_cast<double>((exponent - 60) << 52);
  result.scale = scale;
  bool is_exact = true;
  // Compared with the original, not just "is a whole number": what underflows to
  // 0 is not exact.
  for (std::size_t i = 0; i < Size; ++i) {
    result.values[i] = static_cast<std::int64_t>(numbers[i].value * scale);
    is_exact &= static_cast<double>(result.values[i]) * unit == numbers[i].value;
  }
  if (tail_bits != 0) {
    for (std::size_t i = 0; i < Size; ++i) {
      const auto tail = static_cast<std::int64_t>(numbers[i].tail * scale);
      is_exact &= static_cast<double>(tail) * unit == numbers[i].tail;
      result.values[i] += tail;
    }
  }
  result.is_exact = is_exact;
  return result;
}

}  // namespace delone::delaunay
