#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/least_curvature.hpp"
#include "interp/operator_terms.hpp"

namespace delone::interp {

/// The linear map from the values of sites to their unknowns: values as they are, and
/// gradients of least curvature (CurvatureNetwork), for FactoredOperator. Unknowns: 3 s
/// the value, 3 s + 1 and 3 s + 2 the gradient of site s by scaled length along the axes
/// of the node. O(sites) a field.
class CurvatureMap {
 public:
  /// `targets`: the site at the other end of every end of the network.
  CurvatureMap(CurvatureNetworkOfSites network, std::vector<Site> targets)
      : network_(std::move(network.network)),
        inverse_lengths_(std::move(network.inverse_lengths)),
        targets_(std::move(targets)) {}

  /// Sites x fields to 3 sites x fields.
  [[nodiscard]] Eigen::MatrixXd unknowns(const Eigen::MatrixXd& site_values,
                                         const RunOptions& run) const;
  /// The transpose: 3 sites x fields to sites x fields.
  [[nodiscard]] Eigen::MatrixXd site_weights(const Eigen::MatrixXd& unknown_weights,
                                             const RunOptions& run) const;
  /// The transpose of single rows, of few unknowns each: from the nodes within as many
  /// steps along edges as the iteration has, which is all that counts. Sites may come
  /// twice. O(nodes within 24 steps) a row, and O(sites) a call.
  [[nodiscard]] std::vector<NodalTerms> rows(
      std::span<const NodalTerms> of_unknowns) const;

 private:
  CurvatureNetwork network_;
  std::vector<double> inverse_lengths_;
  std::vector<Site> targets_;
};

template <BlendSpace Space>
[[nodiscard]] CurvatureMap curvature_map(
    const Space& space, const typename Space::Triangulation& triangulation,
    const RunOptions& run);

}  // namespace delone::interp
