#include "interp/radial_system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <vector>

#include "interp/index.hpp"

namespace delone::interp {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

template <std::size_t D>
using Nodes = std::span<const std::array<double, D>>;

template <std::size_t D>
double squared_distance(const std::array<double, D>& a, const std::array<double, D>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

template <std::size_t D, class Kernel>
MatrixXd kernel_matrix(Nodes<D> nodes, Kernel, double diagonal) {
  const auto count = static_cast<Index>(nodes.size());
  MatrixXd k(count, count);
  for (Index j = 0; j < count; ++j) {
    for (Index i = j; i < count; ++i)
      k(i, j) = Kernel::value(squared_distance(nodes[at(i)], nodes[at(j)]));
    k(j, j) = diagonal;
  }
  k.triangularView<Eigen::StrictlyUpper>() = k.transpose();
  return k;
}

template <std::size_t D>
MatrixXd polynomial_matrix(Nodes<D> nodes, int degree) {
  const auto terms = static_cast<Index>(num_monomials(D, degree));
  MatrixXd p(static_cast<Index>(nodes.size()), terms);
  for (Index i = 0; i < p.rows(); ++i) {
    const auto m = monomials(nodes[at(i)], degree);
    for (Index j = 0; j < terms; ++j) p(i, j) = m[at(j)];
  }
  return p;
}

/// Combinations of monomials, as columns.
struct Directions {
  MatrixXd free;  ///< any coefficient
  MatrixXd held;  ///< held back
};

Directions directions_of(const MatrixXd& p) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(p.transpose() * p);
  const VectorXd& lambda = eigen.eigenvalues();  // ascending
  const double largest = lambda(lambda.size() - 1);
  const auto below = [&](double part) {
    Index n = 0;
    while (n + 1 < lambda.size() && lambda(n) < part * largest) ++n;
    return n;
  };
  const Index weak = below(weak_direction), absent = below(1e-14);
  return {eigen.eigenvectors().rightCols(lambda.size() - weak),
          eigen.eigenvectors().middleCols(absent, weak - absent)};
}

constexpr double held_variance = 10;

// The weights that are orthogonal to the polynomials; empty if there is doubt.
VectorXd orthogonal_weights(const Eigen::HouseholderQR<MatrixXd>& qr, const MatrixXd& k,
                            const VectorXd& values) {
  const Index fixed = qr.matrixQR().cols(), rest = k.rows() - fixed;
  if (rest == 0) return VectorXd::Zero(k.rows());
  MatrixXd turned = qr.householderQ().transpose() * k;
  turned = (turned * qr.householderQ()).eval();
  const Eigen::LLT<MatrixXd> factor(turned.bottomRightCorner(rest, rest));
  if (factor.info() != Eigen::Success || !(factor.rcond() > 1e-15)) return {};
  VectorXd weights = qr.householderQ().transpose() * values;
  weights.head(fixed).setZero();
  weights.tail(rest) = factor.solve(weights.tail(rest)).eval();
  return qr.householderQ() * weights;
}

template <std::size_t D>
RadialSolution solve(Nodes<D> nodes, const VectorXd& values, const RadialProblem& problem,
                     MatrixXd k) {
  const MatrixXd p = polynomial_matrix<D>(nodes, problem.degree);
  const Directions directions = directions_of(p);
  const MatrixXd free = p * directions.free, held = p * directions.held;
  k += held_variance * held * held.transpose();
  const Eigen::HouseholderQR<MatrixXd> qr(free);
  const VectorXd weights = orthogonal_weights(qr, k, values);
  if (weights.size() == 0 || !weights.allFinite()) return {};
  const VectorXd rest = values - k * weights;
  const VectorXd polynomial =
      directions.free * qr.solve(rest) +
      held_variance * directions.held * (held.transpose() * weights);
  RadialSolution solution{{weights.begin(), weights.end()}, {}};
  std::copy(polynomial.begin(), polynomial.end(), solution.polynomial.begin());
  return solution;
}

}  // namespace

template <std::size_t D>
RadialSolution solve_radial(std::span<const std::array<double, D>> nodes,
                            std::span<const double> values,
                            const RadialProblem& problem) {
  return with_kernel(problem.kernel, [&](auto kernel) {
    return solve<D>(
        nodes,
        Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size())),
        problem, kernel_matrix<D>(nodes, kernel, problem.diagonal));
  });
}

template RadialSolution solve_radial<2>(std::span<const std::array<double, 2>>,
                                        std::span<const double>, const RadialProblem&);
template RadialSolution solve_radial<3>(std::span<const std::array<double, 3>>,
                                        std::span<const double>, const RadialProblem&);

}  // namespace delone::interp
