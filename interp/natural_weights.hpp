#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "delaunay/adjacency.hpp"
#include "interp/small_vector.hpp"

namespace delone::interp {

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

  /// NaN if missing. Within the range of the values it takes; computed from the first
  /// site on, so that constants are reproduced exactly.
  [[nodiscard]] double value(std::span<const double> site_values) const noexcept {
    if (sites_.empty()) return std::numeric_limits<double>::quiet_NaN();
    const double first = site_values[static_cast<std::size_t>(sites_[0])];
    double sum = 0, low = first, high = first;
    for (std::size_t i = 1; i < sites_.size(); ++i) {
      const double other = site_values[static_cast<std::size_t>(sites_[i])];
      low = std::min(low, other), high = std::max(high, other);
      sum += weights_[i] * (other - first);
    }
    return std::clamp(first + sum, low, high);
  }

 private:
  static constexpr std::size_t usual = 24;
  SmallVector<delaunay::Site, usual> sites_;
  SmallVector<double, usual> weights_;
};

}  // namespace delone::interp
