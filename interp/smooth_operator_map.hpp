#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/operator_terms.hpp"
#include "interp/smooth_system.hpp"

namespace delone::interp {

/// The linear map from the values of sites to smoothed values and gradients, for a fixed
/// wavelength, for FactoredOperator: what fit_smooth does, with the factor kept.
/// Unknowns: 3 s the value, 3 s + 1 and 3 s + 2 the gradient of site s by the scaled
/// length of its space, along the axes of the node. The factor of n evenly spread sites
/// has 60 n log2 n numbers, and every field takes four or five passes over it.
class SmoothMap {
 public:
  /// `wavelength`: scaled as the system.
  SmoothMap(SmoothSystem system, double wavelength, const RunOptions& run);

  /// Sites x fields to 3 sites x fields.
  [[nodiscard]] Eigen::MatrixXd unknowns(const Eigen::MatrixXd& site_values,
                                         const RunOptions& run) const;
  /// The transpose: 3 sites x fields to sites x fields.
  [[nodiscard]] Eigen::MatrixXd site_weights(const Eigen::MatrixXd& unknown_weights,
                                             const RunOptions& run) const;
  /// The transpose of single rows: solved together, over all sites.
  [[nodiscard]] std::vector<NodalTerms> rows(
      std::span<const NodalTerms> of_unknowns) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace delone::interp
