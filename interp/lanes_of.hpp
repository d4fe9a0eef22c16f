#pragma once

#include <cstdint>

#include "delaunay/instruction_set.hpp"
#include "delaunay/lanes.hpp"

namespace delone::interp {

/// Several numbers that are worked on at once, and which of them are meant. `Bits` are
/// what comparisons give.
template <class InstructionSet>
struct LanesOf {
  static constexpr int size = 4;
  static constexpr std::uint64_t all_bits = 0xf;
  using Numbers = delaunay::Double4;
  using Bits = delaunay::Mask4;

  [[gnu::always_inline]] static Numbers all(double v) { return delaunay::four(v); }
  [[gnu::always_inline]] static Numbers load(const double* p) {
    return Numbers{p[0], p[1], p[2], p[3]};
  }
  // Of NaN and a bound the bound, as std::min(bound, a) and std::max(bound, a) are.
  [[gnu::always_inline]] static Numbers at_most(const Numbers& a, const Numbers& bound) {
#if defined(__AVX__)
    return _mm256_min_pd(a, bound);
#else
    return a < bound ? a : bound;
#endif
  }
  [[gnu::always_inline]] static Numbers at_least(const Numbers& a, const Numbers& bound) {
#if defined(__AVX__)
    return _mm256_max_pd(a, bound);
#else
    return a > bound ? a : bound;
#endif
  }
  [[gnu::always_inline]] static Bits are_above(const Numbers& a, const Numbers& b) {
    return a > b;
  }
  [[gnu::always_inline]] static Bits are_from(const Numbers& a, const Numbers& b) {
    return a >= b;
  }
  [[gnu::always_inline]] static Bits are_numbers(const Numbers& a) { return a == a; }
  /// 0 where not above 0.
  [[gnu::always_inline]] static Numbers positive_part(const Numbers& a) {
    return reinterpret_cast<Numbers>(reinterpret_cast<Bits>(a) & are_above(a, Numbers{}));
  }
  /// Bit i is that of number i.
  [[gnu::always_inline]] static std::uint64_t word(const Bits& bits) {
    return delaunay::bits_of(bits);
  }
  [[gnu::always_inline]] static void store(double* to, const Bits& bits,
                                           const Numbers& v) {
#if defined(__AVX__)
    _mm256_maskstore_pd(to, reinterpret_cast<__m256i>(bits), v);
#else
    for (int k = 0; k < 4; ++k) {
      if (bits[k] != 0) to[k] = v[k];
    }
#endif
  }
};

/// Eight numbers in a register, and stores that leave out some of them at no cost.
struct Avx512 {
#if defined(__x86_64__)
  /// By this processor?
  [[nodiscard]] static bool is_supported() noexcept {
    return __builtin_cpu_supports("avx512f") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0;
  }
#endif
};

#if defined(__AVX512F__) && defined(__AVX512DQ__)
template <>
struct LanesOf<Avx512> {
  static constexpr int size = 8;
  static constexpr std::uint64_t all_bits = 0xff;
  using Numbers = __m512d;
  using Bits = __mmask8;

  [[gnu::always_inline]] static Numbers all(double v) { return _mm512_set1_pd(v); }
  [[gnu::always_inline]] static Numbers load(const double* p) {
    return _mm512_loadu_pd(p);
  }
  [[gnu::always_inline]] static Numbers at_most(const Numbers& a, const Numbers& bound) {
    return _mm512_min_pd(a, bound);
  }
  [[gnu::always_inline]] static Numbers at_least(const Numbers& a, const Numbers& bound) {
    return _mm512_max_pd(a, bound);
  }
  [[gnu::always_inline]] static Bits are_above(const Numbers& a, const Numbers& b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ);
  }
  [[gnu::always_inline]] static Bits are_from(const Numbers& a, const Numbers& b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_GE_OQ);
  }
  [[gnu::always_inline]] static Bits are_numbers(const Numbers& a) {
    return _mm512_cmp_pd_mask(a, a, _CMP_ORD_Q);
  }
  [[gnu::always_inline]] static Numbers positive_part(const Numbers& a) {
    return _mm512_maskz_mov_pd(are_above(a, Numbers{}), a);
  }
  [[gnu::always_inline]] static std::uint64_t word(Bits bits) { return bits; }
  [[gnu::always_inline]] static void store(double* to, Bits bits, const Numbers& v) {
    _mm512_mask_storeu_pd(to, bits, v);
  }
};
#endif

}  // namespace delone::interp
