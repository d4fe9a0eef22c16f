#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "interp/index.hpp"
#include "interp/small_vector.hpp"

namespace delone::interp {

/// What one target takes from the sites: Combination and TermList. No terms: missing.
template <class T>
concept SiteTerms = requires(const T& terms) {
  { terms.sites() } -> std::convertible_to<std::span<const delaunay::Site>>;
  { terms.weights() } -> std::convertible_to<std::span<const double>>;
};

/// An interpolated value as a sum of weights times site values, of any length; no terms:
/// missing. For methods with more terms than Combination holds: natural neighbours, C1,
/// smoothing.
///
/// Up to 16 terms lie in the object itself, more in memory of their own. A site may be
/// added several times: its weights are summed when an operator is assembled.
class TermList {
 public:
  void add(delaunay::Site site, double weight) {
    sites_.push_back(site);
    weights_.push_back(weight);
  }
  [[nodiscard]] std::size_t size() const noexcept { return sites_.size(); }
  [[nodiscard]] std::span<const delaunay::Site> sites() const noexcept {
    return {sites_.data(), sites_.size()};
  }
  [[nodiscard]] std::span<const double> weights() const noexcept {
    return {weights_.data(), weights_.size()};
  }

 private:
  static constexpr std::size_t inline_terms = 16;
  SmallVector<delaunay::Site, inline_terms> sites_;
  SmallVector<double, inline_terms> weights_;
};

/// The same for methods whose rows hold many sites, some of them several times: one
/// object for many rows, which keeps its memory.
class NodalTerms {
 public:
  void clear() noexcept {
    sites_.clear();
    weights_.clear();
  }
  void add(delaunay::Site site, double weight) {
    sites_.push_back(site);
    weights_.push_back(weight);
  }
  /// The weight times (the value of `to` less that of `from`): sums stay what they are.
  void add_rise(delaunay::Site from, delaunay::Site to, double weight) {
    if (weight == 0) return;
    add(to, weight);
    add(from, -weight);
  }
  [[nodiscard]] std::span<const delaunay::Site> sites() const noexcept { return sites_; }
  [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }

 private:
  std::vector<delaunay::Site> sites_;
  std::vector<double> weights_;
};

/// The sum over site values, NaN if missing. Computed from the first site on, so that
/// constants are reproduced exactly by weights that sum to one.
template <SiteTerms Terms>
[[nodiscard]] double weighted_value(const Terms& terms,
                                    std::span<const double> site_values) noexcept {
  const std::span<const delaunay::Site> sites = terms.sites();
  const std::span<const double> weights = terms.weights();
  if (sites.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double first = site_values[at(sites[0])];
  double sum = 0;
  for (std::size_t i = 1; i < sites.size(); ++i)
    sum += weights[i] * (site_values[at(sites[i])] - first);
  return first + sum;
}

}  // namespace delone::interp
