#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace delone::interp {

/// What a node's neighbour says of the polynomial about the node: where it is (u, v, in
/// any unit), how much the value differs from the node's, and its weight.
struct NodalSample {
  double u = 0, v = 0;
  double rise = 0;
  double weight = 0;
};

/// A polynomial in u and v without constant term: u, v, uu, uv, vv, uuu, uuv, uvv, vvv.
using NodalPolynomial = std::array<double, 9>;

/// The first terms of a NodalPolynomial that a degree of 1, 2 or 3 has.
[[nodiscard]] constexpr std::size_t num_terms(std::size_t degree) noexcept {
  return degree * (degree + 3) / 2;
}

/// The polynomial of a degree (1, 2, 3) that fits samples best, by weighted least
/// squares, held back where the samples do not tell.
///
/// How well the samples determine a direction of the space of polynomials is measured
/// against samples of the same distances all round: `energy`, 1 if they stand so. The
/// coefficient of a direction is shrunk by energy / (energy + ratio), where ratio is
/// `shrinkage` times the mean squared misfit over the mean squared coefficient: the
/// posterior mean if misfits are noise and coefficients are all of a size. Samples of a
/// polynomial have no misfit and give it to rounding; smooth data, whose misfit is of
/// higher order, are hardly held back; rough data in poor positions are. Directions with
/// less energy than `least_energy` (slopes across a line of nodes, the higher degrees of
/// few nodes) go to zero with it whatever the misfit.
///
/// Turning the samples turns the polynomial; scaling scales it. O(samples).
[[nodiscard]] NodalPolynomial fit_polynomial(std::span<const NodalSample> samples,
                                             std::size_t degree);

/// The root mean square of the samples' distances, weighted: the unit of length of a fit,
/// beyond some ten of which its polynomial says nothing.
[[nodiscard]] double unit_length(std::span<const NodalSample> samples);

// See fit_polynomial.
inline constexpr double shrinkage = 0.3;
inline constexpr double least_energy = 1e-5;
/// The ratio if there are not more samples than coefficients.
inline constexpr double without_excess = 0.01;

}  // namespace delone::interp
