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

/// Bit i is set if lane i holds.
[[gnu::always_inline]] inline unsigned bits_of(const Mask4& mask) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#elif defined(__SSE2__)
  const __m128i low{mask[0], mask[1]}, high{mask[2], mask[3]};
  return static_cast<unsigned>(_mm_movemask_pd(_mm_castsi128_pd(low)) |
                               _mm_movemask_pd(_mm_castsi128_pd(high)) << 2);
#else
  return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) |
                               (mask[3] & 8));
#endif
}

}  // namespace delone::delaunay
