#pragma once

#include "delaunay/lanes.hpp"

/// Code that gains from wide registers is compiled once for every instruction set, in a
/// file of its own, and chosen at run time. What differs between the versions carries the
/// name of its instruction set in its type, so that the linker never takes one version's
/// inline function for another's. Sums of products are rounded differently, within the
/// bounds that decide whether a sign is certain: results are the same.
namespace delone::delaunay {

struct Portable {
  [[gnu::always_inline]] static Double4 sum_of_products(const Double4& a,
                                                        const Double4& b,
                                                        const Double4& c,
                                                        const Double4& d) {
    return a * b + c * d;
  }
  [[gnu::always_inline]] static Double4 difference_of_products(const Double4& a,
                                                               const Double4& b,
                                                               const Double4& c,
                                                               const Double4& d) {
    return a * b - c * d;
  }
  [[gnu::always_inline]] static Double4 sum_of_products(
      const Double4& a, const Double4& b, const Double4& c, const Double4& d,
      const Double4& e, const Double4& f) {
    return a * b + c * d + e * f;
  }
  /// What rounding took from p = a b, by splitting the factors (Veltkamp).
  [[gnu::always_inline]] static Double4 product_error(const Double4& a, const Double4& b,
                                                      const Double4& p) {
    const Double4 a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
    return a2 * b2 - (((p - a1 * b1) - a2 * b1) - a1 * b2);
  }

 private:
  [[gnu::always_inline]] static Double4 upper_half(const Double4& a) {
    const Double4 c = 134217729.0 * a;
    return c - (c - a);
  }
};

/// AVX2 and fused multiply-add.
struct Avx2 {
#if defined(__x86_64__)
  /// By this processor?
  [[nodiscard]] static bool is_supported() noexcept {
    return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  }
#endif
#if defined(__AVX2__) && defined(__FMA__)
  [[gnu::always_inline]] static Double4 sum_of_products(const Double4& a,
                                                        const Double4& b,
                                                        const Double4& c,
                                                        const Double4& d) {
    return _mm256_fmadd_pd(a, b, c * d);
  }
  [[gnu::always_inline]] static Double4 difference_of_products(const Double4& a,
                                                               const Double4& b,
                                                               const Double4& c,
                                                               const Double4& d) {
    return _mm256_fmsub_pd(a, b, c * d);
  }
  [[gnu::always_inline]] static Double4 sum_of_products(
      const Double4& a, const Double4& b, const Double4& c, const Double4& d,
      const Double4& e, const Double4& f) {
    return _mm256_fmadd_pd(a, b, _mm256_fmadd_pd(c, d, e * f));
  }
  [[gnu::always_inline]] static Double4 product_error(const Double4& a, const Double4& b,
                                                      const Double4& p) {
    return _mm256_fmsub_pd(a, b, p);
  }
#endif
};

}  // namespace delone::delaunay
