#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

#include "delaunay/wide_integer.hpp"

namespace delone::delaunay {

/// A double taken apart: sign * mantissa * 2^exponent; mantissa odd, or 0 for zero.
struct DecodedDouble {
  int sign = 0;
  std::uint64_t mantissa = 0;
  int exponent = 0;
};
[[nodiscard]] DecodedDouble decode(double value) noexcept;

/// The largest e such that every value is a multiple of 2^e; 0 if all are zero.
/// Finite values.
[[nodiscard]] int common_exponent(std::span<const double> values) noexcept;

/// A signed integer of at most 64 * Capacity bits.
///
/// The capacity is part of the type and grows with every operation, products to the sum
/// of both and sums to the larger plus one: nothing overflows and nothing is allocated.
/// Time goes with the number of words in use, not with the capacity.
template <int Capacity>
class BigInteger {
 public:
  BigInteger() noexcept {}
  /// value / 2^exponent, which must be an integer that fits.
  BigInteger(double value, int exponent) noexcept {
    const DecodedDouble decoded = decode(value);
    if (decoded.sign == 0) return;
    const int shift = decoded.exponent - exponent;
    const auto low = static_cast<std::size_t>(shift / 64);
    const auto bits = static_cast<UnsignedInt128>(decoded.mantissa) << (shift % 64);
    std::fill_n(words_.begin(), low, std::uint64_t{0});
    words_[low] = static_cast<std::uint64_t>(bits);
    size_ = low + 1;
    if (const auto high = static_cast<std::uint64_t>(bits >> 64); high != 0)
      words_[size_++] = high;
    sign_ = decoded.sign;
  }
  BigInteger(const BigInteger& other) noexcept : size_(other.size_), sign_(other.sign_) {
    std::copy_n(other.words_.begin(), size_, words_.begin());
  }
  BigInteger& operator=(const BigInteger& other) noexcept {
    size_ = other.size_;
    sign_ = other.sign_;
    std::copy_n(other.words_.begin(), size_, words_.begin());
    return *this;
  }

  [[nodiscard]] int sign() const noexcept { return sign_; }

  [[nodiscard]] BigInteger operator-() const noexcept {
    BigInteger negated = *this;
    negated.sign_ = -sign_;
    return negated;
  }

  template <int Other>
  [[nodiscard]] auto operator+(const BigInteger<Other>& other) const noexcept {
    return plus(other, other.sign_);
  }
  template <int Other>
  [[nodiscard]] auto operator-(const BigInteger<Other>& other) const noexcept {
    return plus(other, -other.sign_);
  }
  template <int Other>
  [[nodiscard]] BigInteger<Capacity + Other> operator*(
      const BigInteger<Other>& other) const noexcept {
    BigInteger<Capacity + Other> product;
    if (sign_ == 0 || other.sign_ == 0) return product;
    std::fill_n(product.words_.begin(), size_ + other.size_, std::uint64_t{0});
    // Numbers of very different magnitude on one scale are nearly all zeros.
    const std::size_t other_begin = other.num_low_zeros();
    for (std::size_t i = 0; i < size_; ++i) {
      if (words_[i] == 0) continue;
      std::uint64_t carry = 0;
      for (std::size_t j = other_begin; j < other.size_; ++j) {
        const UnsignedInt128 t =
            static_cast<UnsignedInt128>(words_[i]) * other.words_[j] +
            product.words_[i + j] + carry;
        product.words_[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      product.words_[i + other.size_] = carry;
    }
    product.size_ = size_ + other.size_;
    product.sign_ = sign_ * other.sign_;
    product.drop_leading_zeros();
    return product;
  }

  /// mantissa * 2^exponent, 1 <= |mantissa| < 2, cut off after 53 bits; 0 and 0 for zero.
  struct Leading {
    double mantissa = 0;
    int exponent = 0;
  };
  [[nodiscard]] Leading leading() const noexcept {
    if (sign_ == 0) return {};
    const std::uint64_t top = words_[size_ - 1];
    const std::uint64_t below = size_ > 1 ? words_[size_ - 2] : 0;
    const int zeros = std::countl_zero(top);
    const auto both = (static_cast<UnsignedInt128>(top) << 64 | below) << zeros;
    const auto bits = static_cast<std::uint64_t>(both >> (128 - 53));
    return {sign_ * 0x1p-52 * static_cast<double>(bits),
            64 * static_cast<int>(size_) - zeros - 1};
  }

  template <int Other>
  [[nodiscard]] bool operator==(const BigInteger<Other>& other) const noexcept {
    return sign_ == other.sign_ && compare_magnitude(other) == 0;
  }

  /// Sign of |*this| - |other|.
  template <int Other>
  [[nodiscard]] int compare_magnitude(const BigInteger<Other>& other) const noexcept {
    if (size_ != other.size_) return size_ < other.size_ ? -1 : 1;
    for (std::size_t i = size_; i-- > 0;) {
      if (words_[i] != other.words_[i]) return words_[i] < other.words_[i] ? -1 : 1;
    }
    return 0;
  }

 private:
  template <int>
  friend class BigInteger;

  // *this + other, where other counts with the sign given.
  template <int Other>
  [[nodiscard]] auto plus(const BigInteger<Other>& other, int other_sign) const noexcept {
    BigInteger<std::max(Capacity, Other) + 1> sum;
    if (sign_ == other_sign || sign_ == 0 || other_sign == 0) {
      sum.sign_ = sign_ != 0 ? sign_ : other_sign;
      size_ < other.size_ ? sum.set_to_sum(other, *this) : sum.set_to_sum(*this, other);
      return sum;
    }
    const int comparison = compare_magnitude(other);
    if (comparison > 0) sum.set_to_difference(*this, other);
    if (comparison < 0) sum.set_to_difference(other, *this);
    sum.sign_ = comparison == 0 ? 0 : (comparison > 0 ? sign_ : other_sign);
    return sum;
  }

  template <int A, int B>
  void set_to_sum(const BigInteger<A>& longer, const BigInteger<B>& shorter) noexcept {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < longer.size_; ++i) {
      const std::uint64_t word = i < shorter.size_ ? shorter.words_[i] : 0;
      const UnsignedInt128 t =
          static_cast<UnsignedInt128>(longer.words_[i]) + word + carry;
      words_[i] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    size_ = longer.size_;
    if (carry != 0) words_[size_++] = carry;
  }

  template <int A, int B>
  void set_to_difference(const BigInteger<A>& larger,
                         const BigInteger<B>& smaller) noexcept {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < larger.size_; ++i) {
      const std::uint64_t word = i < smaller.size_ ? smaller.words_[i] : 0;
      const UnsignedInt128 t =
          static_cast<UnsignedInt128>(larger.words_[i]) - word - borrow;
      words_[i] = static_cast<std::uint64_t>(t);
      borrow = static_cast<std::uint64_t>(t >> 64) & 1;
    }
    size_ = larger.size_;
    drop_leading_zeros();
  }

  [[nodiscard]] std::size_t num_low_zeros() const noexcept {
    std::size_t num = 0;
    while (num < size_ && words_[num] == 0) ++num;
    return num;
  }

  void drop_leading_zeros() noexcept {
    while (size_ > 0 && words_[size_ - 1] == 0) --size_;
  }

  std::array<std::uint64_t, Capacity> words_;  // only the first size_ are set
  std::size_t size_ = 0;
  int sign_ = 0;
};

}  // namespace delone::delaunay
