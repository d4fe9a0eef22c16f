#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/smooth_system.hpp"

namespace delone::interp {

/// Sites that are eliminated together, and those of later fronts that they touch then.
struct EliminationFront {
  std::vector<Site> sites;  ///< own ones first, then touched ones, in elimination order
  std::int32_t num_own = 0;
  std::int32_t parent = none;
  std::vector<std::int32_t> children;
  std::int32_t first_below = 0;  ///< the subtree: fronts first_below .. this one
};

/// An order of elimination for the equations of a triangulation: the sites are halved
/// across the axis along which fewer of them touch the other half; those are eliminated
/// after both halves (A. George, SIAM J. Numer. Anal. 10 (1973) 345-363). Children come
/// before their parent.
[[nodiscard]] std::vector<EliminationFront> dissect(const SmoothSystem& system);

/// The Cholesky factor of parameter * roughness + weights, front by front (I. S. Duff, J.
/// K. Reid, ACM Trans. Math. Softw. 9 (1983) 302-325).
///
/// The diagonal is raised by 1e-14 of itself, so that what rounding loses cannot make it
/// indefinite: a solution is to be corrected against SmoothSystem::apply (`refined`).
/// Refers to the system and the fronts. For n evenly spread sites about 300 n^1.5
/// multiplications and 60 n log2 n numbers.
class SmoothFactor {
 public:
  SmoothFactor(const SmoothSystem& system, const std::vector<EliminationFront>& fronts,
               double parameter, const RunOptions& run);
  SmoothFactor(const SmoothSystem&, std::vector<EliminationFront>&&, double,
               const RunOptions&) = delete;

  /// One column a right-hand side.
  [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd right) const;
  /// One solution, by conjugate gradients with the factor as preconditioner: to 1e-13 in
  /// the norm of the energy, in two or three steps unless the matrix is near singular.
  [[nodiscard]] Eigen::VectorXd refined(const Eigen::VectorXd& right) const;
  /// Diagonal entries of the inverse that belong to values. Takes about three times the
  /// time of the factor. Source: K. Takahashi, J. Fagan, M. Chen, PICA Conf. (1973).
  [[nodiscard]] Eigen::VectorXd inverse_diagonal() const;

 private:
  void eliminate(std::int32_t front, std::vector<std::int32_t>& places);
  void assemble(std::int32_t front, const std::vector<std::int32_t>& places,
                Eigen::MatrixXd& matrix) const;

  const SmoothSystem* system_;
  const std::vector<EliminationFront>* fronts_;
  double parameter_;
  std::vector<Eigen::MatrixXd> columns_;  ///< of the factor, a front each
  std::vector<Eigen::MatrixXd> updates_;  ///< for the parents
};

}  // namespace delone::interp
