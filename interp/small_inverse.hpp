#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace delone::interp {

/// The inverse of a small semidefinite matrix without the directions that it does not
/// determine: those whose eigenvalues are not above `least`.
struct SmallInverse {
  Eigen::MatrixXd inverse;
  Eigen::Index rank = 0;
};
[[nodiscard]] inline SmallInverse small_inverse(const Eigen::MatrixXd& matrix,
                                                double least) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
  SmallInverse result{Eigen::MatrixXd::Zero(matrix.rows(), matrix.rows())};
  for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
    if (!(eigen.eigenvalues()[k] > least)) continue;
    const auto v = eigen.eigenvectors().col(k);
    result.inverse += v * v.transpose() / eigen.eigenvalues()[k];
    ++result.rank;
  }
  return result;
}

}  // namespace delone::interp
