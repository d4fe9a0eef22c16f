#pragma once

#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace delone::delaunay {

/// Four doubles that are worked on at once: a vector register where the machine has them
/// that wide, two or four registers where not. Results are the same.
using Double4 = double __attribute__((vector_size(32)));
using Mask4 = std::int64_t __attribute__((vector_size(32)));  ///< -1 or 0 a lane

[[gnu::always_inline]] inline Double4 four(double v) { return Double4{v, v, v, v}; }

/// Pairs of numbers, lane by lane: the first of each, and the second.
struct Transposed {
  Double4 first, second;
};
[[gnu::always_inline]] inline Transposed transposed(const double* p, const double* q,
                                                    const double* r, const double* t) {
#if defined(__AVX__)
  const __m256d even =
      _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(p)), _mm_loadu_pd(r), 1);
  const __m256d odd =
      _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(q)), _mm_loadu_pd(t), 1);
  return {_mm256_unpacklo_pd(even, odd), _mm256_unpackhi_pd(even, odd)};
#else
  return {Double4{p[0], q[0], r[0], t[0]}, Double4{p[1], q[1], r[1], t[1]}};
#endif
}

/// Where all parts of a vector are 0.
[[gnu::always_inline]] inline Mask4 are_zero(const Double4& x, const Double4& y) {
  const Mask4 bits = reinterpret_cast<Mask4>(x) | reinterpret_cast<Mask4>(y);
  return reinterpret_cast<Double4>(bits) == Double4{};
}
[[gnu::always_inline]] inline Mask4 are_zero(const Double4& x, const Double4& y,
                                             const Double4& z) {
  const Mask4 bits = reinterpret_cast<Mask4>(x) | reinterpret_cast<Mask4>(y) |
                     reinterpret_cast<Mask4>(z);
  return reinterpret_cast<Double4>(bits) == Double4{};
}

/// Bit i is the sign of lane i: set for negative numbers and -0.
[[gnu::always_inline]] inline unsigned sign_bits_of(const Double4& v) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(v));
#elif defined(__SSE2__)
  const __m128d low{v[0], v[1]}, high{v[2], v[3]};
  return static_cast<unsigned>(_mm_movemask_pd(low) | _mm_movemask_pd(high) << 2);
#else
  unsigned bits = 0;
  for (int i = 0; i < 4; ++i) bits |= (__builtin_signbit(v[i]) != 0 ? 1u : 0u) << i;
  return bits;
#endif
}
/// Bit i is set if lane i holds.
[[gnu::always_inline]] inline unsigned bits_of(const Mask4& mask) {
  return sign_bits_of(reinterpret_cast<Double4>(mask));
}

/// Without signs.
[[gnu::always_inline]] inline Double4 magnitude(const Double4& v) {
  constexpr std::int64_t all_but_sign = ~(std::int64_t{1} << 63);
  return reinterpret_cast<Double4>(
      reinterpret_cast<Mask4>(v) &
      Mask4{all_but_sign, all_but_sign, all_but_sign, all_but_sign});
}

}  // namespace delone::delaunay
