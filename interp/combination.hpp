#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "delaunay/adjacency.hpp"
#include "interp/operator_terms.hpp"

namespace delone::interp {

/// An interpolated value as a sum of weights times site values; no terms: missing. The
/// weights sum to one.
class Combination {
 public:
  void add(delaunay::Site site, double weight) noexcept {
    for (std::size_t i = 0; i < size_; ++i) {
      if (sites_[i] != site) continue;
      weights_[i] += weight;
      return;
    }
    sites_[size_] = site;
    weights_[size_++] = weight;
  }
  [[nodiscard]] std::span<const delaunay::Site> sites() const noexcept {
    return {sites_.data(), size_};
  }
  [[nodiscard]] std::span<const double> weights() const noexcept {
    return {weights_.data(), size_};
  }

  /// NaN if missing. Computed from the first site on, so that constants are reproduced
  /// exactly.
  [[nodiscard]] double value(std::span<const double> site_values) const noexcept {
    return weighted_value(*this, site_values);
  }

 private:
  static constexpr std::size_t most = 5;  // two triangles that share a hull corner
  std::array<delaunay::Site, most> sites_{};
  std::array<double, most> weights_{};
  std::size_t size_ = 0;
};

}  // namespace delone::interp
