#include "interp/nodal_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "interp/index.hpp"

namespace delone::interp {

namespace {

constexpr int most_terms = 9;
using Square =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_terms, most_terms>;
using Terms = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_terms, 1>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

// Monomials scaled by the roots of multinomial coefficients: turning u and v turns the
// space they span without stretching it.
constexpr double root2 = std::numbers::sqrt2, root3 = std::numbers::sqrt3;
constexpr std::array<double, 9> scales{1, 1, 1, root2, 1, 1, root3, root3, 1};
constexpr std::array<std::size_t, 9> degrees{1, 1, 2, 2, 2, 3, 3, 3, 3};

std::array<double, 9> monomials(double u, double v) {
  const double uu = u * u, uv = u * v, vv = v * v;
  return {u, v, uu, root2 * uv, vv, u * uu, root3 * uu * v, root3 * u * vv, v * vv};
}

// Means of products of two monomials over the unit circle. Eight directions give the
// exact mean up to degree 7.
Eigen::Matrix<double, 9, 9> circle_means() {
  Eigen::Matrix<double, 9, 9> sum = Eigen::Matrix<double, 9, 9>::Zero();
  for (int k = 0; k < 8; ++k) {
    const double angle = k * std::numbers::pi / 4;
    const auto m = monomials(std::cos(angle), std::sin(angle));
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> column(m.data());
    sum += column * column.transpose() / 8;
  }
  return sum;
}
// The products of columns that samples of the same distances would have if each stood
// all round. A thousandth of the mean for the degree is added to the diagonal, for on a
// single circle u (uu + vv) and u are the same.
Square products_all_round(std::span<const NodalSample> samples, double unit,
                          Eigen::Index terms) {
  std::array<double, 7> moments{};
  for (const NodalSample& s : samples) {
    const double squared = (s.u * s.u + s.v * s.v) / (unit * unit);
    double power = s.weight * s.weight;
    for (std::size_t d = 2; d <= 6; d += 2) moments[d] += power *= squared;
  }
  static const Eigen::Matrix<double, 9, 9> mean_products = circle_means();
  Square result(terms, terms);
  for (Eigen::Index i = 0; i < terms; ++i) {
    for (Eigen::Index j = 0; j < terms; ++j) {
      const std::size_t degree = degrees[at(i)] + degrees[at(j)];
      result(i, j) = degree % 2 == 0 ? mean_products(i, j) * moments[degree] : 0;
    }
    result(i, i) +=
        0.001 * moments[2 * degrees[at(i)]] / (1.0 + static_cast<double>(degrees[at(i)]));
  }
  return result;
}

struct Equations {
  Rows rows;
  Eigen::VectorXd rises;
};

Equations weighted_equations(std::span<const NodalSample> samples, double unit,
                             Eigen::Index terms) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  Equations e{Rows(count, terms), Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const NodalSample& s = samples[at(i)];
    const auto m = monomials(s.u / unit, s.v / unit);
    for (Eigen::Index j = 0; j < terms; ++j) e.rows(i, j) = s.weight * m[at(j)];
    e.rises(i) = s.weight * s.rise;
  }
  return e;
}

/// Least squares along the directions in which the rows are orthogonal.
class Fit {
 public:
  explicit Fit(const Equations& e) : equations_(e) {
    const Eigen::SelfAdjointEigenSolver<Square> eigen(
        Square(e.rows.transpose().lazyProduct(e.rows)));
    energies_ = eigen.eigenvalues().cwiseMax(0.0);
    directions_ = eigen.eigenvectors();
    Terms known = energies_, all = energies_;
    for (Eigen::Index j = 0; j < energies_.size(); ++j) {
      const bool is_known = energies_[j] >= least_energy;
      known[j] = is_known ? 1 / energies_[j] : 0;
      all[j] = is_known ? known[j] : energies_[j] / (least_energy * least_energy);
      num_known_ += is_known ? 1 : 0;
    }
    const auto along = [&](const Eigen::VectorXd& right) -> Terms {
      return directions_.transpose() * (e.rows.transpose() * right);
    };
    coefficients_ = all.cwiseProduct(along(e.rises));
    // A step of refinement, for eigenvalues are the squares of what was rounded.
    coefficients_ += known.cwiseProduct(along(misfits()));
  }

  [[nodiscard]] Terms shrunk() const {
    const double ratio = shrinkage * noise_to_signal();
    Terms part = energies_;
    for (double& p : part) p = p > 0 ? p / (p + ratio) : 0;
    return directions_ * part.cwiseProduct(coefficients_);
  }

 private:
  [[nodiscard]] Eigen::VectorXd misfits() const {
    return equations_.rises - equations_.rows * (directions_ * coefficients_);
  }

  // The mean square that the fit leaves to that of the coefficients; of columns of
  // energy 1 these are what the fit explains, each its part.
  [[nodiscard]] double noise_to_signal() const {
    const double all = equations_.rises.squaredNorm(), left = misfits().squaredNorm();
    const double explained = (all - left) / static_cast<double>(energies_.size());
    if (!(explained > 0)) return 0;
    const auto excess = static_cast<double>(equations_.rises.size() - num_known_);
    if (excess < 1) return without_excess;
    return left / excess / explained;
  }

  const Equations& equations_;
  Square directions_;
  Terms energies_, coefficients_;
  Eigen::Index num_known_ = 0;
};

}  // namespace

double unit_length(std::span<const NodalSample> samples) {
  double sum = 0, weights = 0;
  for (const NodalSample& s : samples) {
    const double w = s.weight * s.weight;
    sum += w * (s.u * s.u + s.v * s.v);
    weights += w;
  }
  return weights > 0 ? std::sqrt(sum / weights) : 0;
}

NodalPolynomial fit_polynomial(std::span<const NodalSample> samples, std::size_t degree) {
  NodalPolynomial result{};
  const double unit = unit_length(samples);
  if (!(unit > 0)) return result;
  const auto terms = static_cast<Eigen::Index>(num_terms(degree));
  const Eigen::LLT<Square> reference(products_all_round(samples, unit, terms));
  Equations e = weighted_equations(samples, unit, terms);
  reference.matrixU().solveInPlace<Eigen::OnTheRight>(e.rows);
  Terms x = Fit(e).shrunk();
  reference.matrixU().solveInPlace(x);
  double power = 1;
  for (std::size_t j = 0; j < num_terms(degree); ++j) {
    if (j == 0 || degrees[j] != degrees[j - 1]) power *= unit;
    result[j] = scales[j] * x[static_cast<Eigen::Index>(j)] / power;
  }
  return result;
}

}  // namespace delone::interp
