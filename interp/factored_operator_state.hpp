#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <variant>
#include <vector>

#include "interp/factored_operator.hpp"
#include "interp/global_operator_map.hpp"
#include "interp/operator_assembly.hpp"
#include "interp/operator_terms.hpp"
#include "interp/smooth_operator_map.hpp"

namespace delone::interp {

/// Values as they are, without gradients: of the smallest and of collinear sets.
class IdentityMap {
 public:
  [[nodiscard]] Eigen::MatrixXd unknowns(const Eigen::MatrixXd& site_values,
                                         const RunOptions& run) const;
  [[nodiscard]] Eigen::MatrixXd site_weights(const Eigen::MatrixXd& unknown_weights,
                                             const RunOptions& run) const;
  [[nodiscard]] std::vector<NodalTerms> rows(
      std::span<const NodalTerms> of_unknowns) const;
};

/// targets <- unknowns of the sites <- values of the sites <- rows of the observations.
struct FactoredOperator::State {
  Operator evaluation;  ///< targets x 3 sites (operator_on_unknowns)
  std::variant<IdentityMap, CurvatureMap, SmoothMap> map;
  /// Sites x rows: what a site's value takes from its rows; each row sums to one.
  Operator::Matrix site_shares;
};

/// Equal shares of the rows of a site, as a policy says.
[[nodiscard]] Operator::Matrix shares_matrix(const RowShares& shares,
                                             delaunay::Site num_sites,
                                             delaunay::Node num_rows);

}  // namespace delone::interp
