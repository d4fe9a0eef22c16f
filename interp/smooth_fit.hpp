#pragma once

#include <array>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/smooth_options.hpp"
#include "interp/smooth_system.hpp"

namespace delone::interp {

/// Values of sites and the weights of their misfits.
struct SmoothData {
  std::vector<double> values;
  std::vector<double> weights;    ///< positive
  double squared_error_unit = 0;  ///< weight times squared error; 0: no errors known
};

/// Repeated positions: for Duplicates::mean the weighted mean and the sum of the weights,
/// otherwise the value chosen and the mean of the weights. Throws as values_at_sites and
/// check(SmoothOptions).
[[nodiscard]] SmoothData smooth_data(std::span<const delaunay::Site> sites,
                                     Site num_sites, std::span<const double> row_values,
                                     const SmoothOptions& options);

/// Smoothed values and gradients (along Space::axes, per unit of the coordinates) of
/// sites.
struct SmoothedSites {
  std::vector<double> values;
  std::vector<std::array<double, 2>> gradients;
  SmoothFit fit;
};

/// Traces are exact up to this many sites, above it estimated from fixed random signs (M.
/// F. Hutchinson, Commun. Stat. Simul. 19 (1990) 433-450), to about the root of their
/// number over 2.
inline constexpr std::int32_t most_exact_traces = 4096;

/// Beyond so many extents of the domain a surface is the trend.
inline constexpr double longest_wavelength = 128;

/// The minimiser of parameter * roughness + weighted squared misfits (SmoothSystem). On
/// the sphere a surface's first-degree harmonic is not charged: the roughness is that of
/// the surface less the harmonic that makes it least.
///
/// Chosen parameters: the least of P. Craven and G. Wahba's score (Numer. Math. 31 (1979)
/// 377-403) by halves and quarters of powers of two in wavelength and a parabola; misfits
/// over errors of one (root mean square) by bisection and secants, or the plane if it
/// fits as well (C. H. Reinsch, Numer. Math. 10 (1967) 177-183). Above 4096 sites the
/// search begins where a subset of them ended.
template <BlendSpace Space>
[[nodiscard]] SmoothedSites fit_smooth(const typename Space::Triangulation& triangulation,
                                       const SmoothData& data,
                                       const SmoothOptions& options,
                                       const RunOptions& run);

}  // namespace delone::interp
