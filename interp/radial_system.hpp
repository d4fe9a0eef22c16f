#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "interp/radial_kernel.hpp"

namespace delone::interp {

/// Monomials of D coordinates up to a degree of 0, 1 or 2.
[[nodiscard]] constexpr std::size_t num_monomials(std::size_t dimension, int degree) {
  return degree == 0   ? 1
         : degree == 1 ? 1 + dimension
                       : (dimension + 1) * (dimension + 2) / 2;
}
inline constexpr std::size_t most_monomials = 10;

/// Their values for numbers of any kind: 1, the coordinates, their products.
template <class T, std::size_t D>
[[nodiscard]] std::array<T, most_monomials> monomials(const std::array<T, D>& p,
                                                      int degree) {
  std::array<T, most_monomials> result{};
  result[0] = T(1.0);
  if (degree >= 1) std::copy(p.begin(), p.end(), result.begin() + 1);
  if (degree < 2) return result;
  std::size_t next = 1 + D;
  for (std::size_t i = 0; i < D; ++i) {
    for (std::size_t j = i; j < D; ++j) result[next++] = p[i] * p[j];
  }
  return result;
}

/// A spline: the sum of weights times kernels at its nodes, and a polynomial.
struct RadialSolution {
  std::vector<double> weights;
  std::array<double, most_monomials> polynomial{};
};

struct RadialProblem {
  RadialKernel kernel = RadialKernel::thin_plate;
  int degree = 1;
  double diagonal = 0;  ///< added: smoothing, in units of the kernel
};

/// The spline through values at nodes that lie within about 1 of the origin. Empty
/// weights if the system is not positive definite or its reciprocal condition is below
/// 1e-15.
///
/// The polynomial is orthogonalised on the nodes. A direction in which they extend less
/// than `weak_direction` of the widest (in mean squares) is taken into the kernel
/// instead, as a random coefficient of variance 10; one in which they do not extend at
/// all (1e-14) is left out. O(n^3).
template <std::size_t D>
[[nodiscard]] RadialSolution solve_radial(std::span<const std::array<double, D>> nodes,
                                          std::span<const double> values,
                                          const RadialProblem& problem);

inline constexpr double weak_direction = 1e-4;

}  // namespace delone::interp
