#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "delaunay/adjacency.hpp"
#include "interp/small_vector.hpp"

namespace delone::interp {

/// The mean of site values with weights that sum to one up to rounding, at least one.
/// Within the range of the values it takes; computed from the first site on, so that
/// constants are reproduced exactly.
[[nodiscard]] inline double bounded_mean(std::span<const delaunay::Site> sites,
                                         std::span<const double> weights,
                                         std::span<const double> site_values) noexcept {
  const double first = site_values[static_cast<std::size_t>(sites[0])];
  double sum = 0, low = first, high = first;
  for (std::size_t i = 1; i < sites.size(); ++i) {
    const double other = site_values[static_cast<std::size_t>(sites[i])];
    low = std::min(low, other), high = std::max(high, other);
    sum += weights[i] * (other - first);
  }
  return std::clamp(first + sum, low, high);
}

/// An interpolated value as a sum of weights times site values, any number of them; no
/// terms: missing. The weights are not negative and sum to one up to rounding.
class NaturalWeights {
 public:
  void add(delaunay::Site site, double weight) {
    sites_.push_back(site);
    weights_.push_back(weight);
  }
  [[nodiscard]] std::span<const delaunay::Site> sites() const noexcept {
    return {sites_.data(), sites_.size()};
  }
  [[nodiscard]] std::span<const double> weights() const noexcept {
    return {weights_.data(), weights_.size()};
  }

  /// NaN if missing; else their bounded mean.
  [[nodiscard]] double value(std::span<const double> site_values) const noexcept {
    if (sites_.empty()) return std::numeric_limits<double>::quiet_NaN();
    return bounded_mean(sites(), weights(), site_values);
  }

 private:
  static constexpr std::size_t usual = 24;
  SmallVector<delaunay::Site, usual> sites_;
  SmallVector<double, usual> weights_;
};

}  // namespace delone::interp
