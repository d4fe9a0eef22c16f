#include "stripack/distance_order.hpp"

#include <array>

#include "delaunay/big_integer.hpp"
#include "delaunay/signed_root.hpp"

namespace delone::stripack {

namespace {

// 2 over 2^-1074 is 1076 bits.
using Coordinate = delaunay::BigInteger<17>;

struct ExactVector {
  Coordinate x, y, z;
};

auto dot(const ExactVector& a, const ExactVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace

// The sign of b.p / |b| - a.p / |a|, multiplied by |a| |b|: two signed square roots.
int compare_distances_exact(const Direction& p, const Direction& a,
                            const Direction& b) noexcept {
  const int exponent = delaunay::common_exponent(
      std::array{p.x(), p.y(), p.z(), a.x(), a.y(), a.z(), b.x(), b.y(), b.z()});
  const auto vector = [exponent](const Direction& d) {
    return ExactVector{{d.x(), exponent}, {d.y(), exponent}, {d.z(), exponent}};
  };
  const ExactVector u = vector(p), v = vector(a), w = vector(b);
  const auto along_a = dot(v, u), along_b = dot(w, u);
  const delaunay::SignedRoot from_b{along_b.sign(), along_b * along_b * dot(v, v)};
  const delaunay::SignedRoot from_a{-along_a.sign(), along_a * along_a * dot(w, w)};
  return delaunay::sign_of_sum(from_b, from_a);
}

int compare_distances(const Direction& p, const Direction& a,
                      const Direction& b) noexcept {
  const int certain = compare_distances_filter(squared_chord(p, a), squared_chord(p, b));
  return certain != 0 ? certain : compare_distances_exact(p, a, b);
}

}  // namespace delone::stripack
