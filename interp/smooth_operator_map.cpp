#include "interp/smooth_operator_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "interp/small_inverse.hpp"
#include "interp/smooth_factor.hpp"
#include "interp/smooth_fit.hpp"

namespace delone::interp {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

MatrixXd values_of(const MatrixXd& unknowns) {
  MatrixXd values(unknowns.rows() / 3, unknowns.cols());
  for (Index s = 0; s < values.rows(); ++s) values.row(s) = unknowns.row(3 * s);
  return values;
}
MatrixXd as_unknowns(const MatrixXd& values) {
  MatrixXd unknowns = MatrixXd::Zero(3 * values.rows(), values.cols());
  for (Index s = 0; s < values.rows(); ++s) unknowns.row(3 * s) = values.row(s);
  return unknowns;
}

/// The trend function of least squares of every field.
class TrendFit {
 public:
  explicit TrendFit(const SmoothSystem& system) : system_(&system) {
    centered_ = values_of(system.trend);
    means_ = system.weights.transpose() * centered_ / num_sites();
    centered_.rowwise() -= means_;
    const MatrixXd normal =
        centered_.transpose() * system.weights.asDiagonal() * centered_;
    inverse_ = small_inverse(normal, 1e-12 * normal.trace()).inverse;
  }

  [[nodiscard]] MatrixXd unknowns(const MatrixXd& values) const {
    const MatrixXd weighted = system_->weights.asDiagonal() * values;
    const RowVectorXd means = weighted.colwise().sum() / num_sites();
    const MatrixXd deviations =
        system_->weights.asDiagonal() * (values.rowwise() - means);
    const MatrixXd slopes = inverse_ * (centered_.transpose() * deviations);
    MatrixXd result = system_->trend * slopes;
    const RowVectorXd constants = means - means_ * slopes;
    for (Index s = 0; s < values.rows(); ++s) result.row(3 * s) += constants;
    return result;
  }

  [[nodiscard]] MatrixXd transposed(const MatrixXd& unknowns) const {
    const RowVectorXd sums = values_of(unknowns).colwise().sum();
    const MatrixXd slopes =
        inverse_ * (system_->trend.transpose() * unknowns - means_.transpose() * sums);
    MatrixXd result = centered_ * slopes;
    result.rowwise() += sums / num_sites();
    return system_->weights.asDiagonal() * result;
  }

 private:
  [[nodiscard]] double num_sites() const {
    return static_cast<double>(system_->num_sites());
  }

  const SmoothSystem* system_;
  MatrixXd centered_, inverse_;
  RowVectorXd means_;
};

/// On the sphere the harmonic that is taken from the values first (fit_smooth), as a
/// linear function of what the trend of least squares leaves.
struct Harmonics {
  MatrixXd unknowns;  ///< that a harmonic adds once its smoothed part is taken away
  MatrixXd weights;   ///< sites x harmonics
};

}  // namespace

struct SmoothMap::State {
  SmoothSystem system;
  double parameter = 0, gradient_scale = 1;
  bool is_interpolating = false, is_trend = false;
  TrendFit trend;
  std::vector<EliminationFront> fronts;
  std::optional<SmoothFactor> factor;  ///< unless the surface is the trend
  Harmonics harmonics;

  State(SmoothSystem given, double wavelength, const RunOptions& run)
      : system(std::move(given)),
        gradient_scale(system.extent_scale),
        is_interpolating(wavelength == 0),
        is_trend(wavelength >= longest_wavelength),
        trend(system) {
    if (is_trend) return;
    constexpr double shortest = 1e-4;  // of the mean distance
    parameter = system.parameter(std::max(wavelength, shortest * spacing()));
    fronts = dissect(system);
    factor.emplace(system, fronts, parameter, run);
    if (system.is_trend_charged) set_harmonics();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[nodiscard]] double spacing() const {
    const double each = system.area / static_cast<double>(system.num_sites());
    return system.is_chain ? each : std::sqrt(each);
  }

  void set_harmonics() {
    const MatrixXd values = values_of(system.trend),
                   smoothed = solved(as_unknowns(system.weights.asDiagonal() * values)),
                   removed = values - values_of(smoothed),
                   weighted = system.weights.asDiagonal() * removed,
                   normal = values.transpose() * weighted;
    const double size =
        (values.transpose() * system.weights.asDiagonal() * values).trace();
    const MatrixXd inverse =
        small_inverse(0.5 * (normal + normal.transpose()), 1e-10 * size).inverse;
    harmonics = {(system.trend - smoothed) * inverse, weighted};
  }

  // SmoothFactor::refined for several columns, each with steps of its own. Until nothing
  // is gained: where gradients weigh next to nothing beside values, they are wrong when
  // the norm of the energy has long been small.
  [[nodiscard]] MatrixXd solved(const MatrixXd& right) const {
    constexpr int most_steps = 24;
    constexpr double tolerance = 1e-60;  // of the squared norm
    constexpr double least_gain = 0.25;  // the same, in a step
    MatrixXd x = MatrixXd::Zero(right.rows(), right.cols()), residual = right;
    MatrixXd better = factor->solve(residual), step = better;
    RowVectorXd size = residual.cwiseProduct(better).colwise().sum();
    const RowVectorXd first_size = size, enough = tolerance * size;
    std::vector<bool> is_done(static_cast<std::size_t>(right.cols()), false);
    for (int k = 0; k < most_steps; ++k) {
      bool is_all_done = true;
      for (Index c = 0; c < right.cols(); ++c) {
        auto done = is_done.begin() + c;
        if (*done || !(size[c] > enough[c])) {
          *done = true;
          continue;
        }
        const VectorXd image = system.apply(parameter, step.col(c));
        const double energy = step.col(c).dot(image);
        if (!(energy > 0)) {
          *done = true;
          continue;
        }
        is_all_done = false;
        x.col(c) += (size[c] / energy) * step.col(c);
        residual.col(c) -= (size[c] / energy) * image;
      }
      if (is_all_done) break;
      better = factor->solve(residual);
      for (Index c = 0; c < right.cols(); ++c) {
        const double next = residual.col(c).dot(better.col(c));
        if (!(next < least_gain * size[c]) && size[c] < 1e-26 * first_size[c])
          is_done[static_cast<std::size_t>(c)] = true;
        step.col(c) = better.col(c) + (next / size[c]) * step.col(c);
        size[c] = next;
      }
    }
    return x;
  }

  [[nodiscard]] MatrixXd unknowns(const MatrixXd& values) const {
    MatrixXd result = trend.unknowns(values);
    if (!is_trend) {
      const MatrixXd left = values - values_of(result);
      result += solved(as_unknowns(system.weights.asDiagonal() * left));
      if (system.is_trend_charged)
        result += harmonics.unknowns * (harmonics.weights.transpose() * left);
    }
    for (Index s = 0; s < values.rows(); ++s) {
      if (is_interpolating) result.row(3 * s) = values.row(s);
      result.middleRows<2>(3 * s + 1) *= gradient_scale;
    }
    return result;
  }

  [[nodiscard]] MatrixXd transposed(MatrixXd unknowns) const {
    const MatrixXd of_values = values_of(unknowns);
    for (Index s = 0; s < of_values.rows(); ++s) {
      if (is_interpolating) unknowns.row(3 * s).setZero();
      unknowns.middleRows<2>(3 * s + 1) *= gradient_scale;
    }
    MatrixXd result = MatrixXd::Zero(of_values.rows(), of_values.cols());
    if (!is_trend) {
      result = system.weights.asDiagonal() * values_of(solved(unknowns));
      if (system.is_trend_charged)
        result += harmonics.weights * (harmonics.unknowns.transpose() * unknowns);
    }
    unknowns -= as_unknowns(result);
    result += trend.transposed(unknowns);
    if (is_interpolating) result += of_values;
    return result;
  }
};

SmoothMap::SmoothMap(SmoothSystem system, double wavelength, const RunOptions& run)
    : state_(std::make_shared<const State>(std::move(system), wavelength,
                                           RunOptions{run.num_threads, {}})) {}

MatrixXd SmoothMap::unknowns(const MatrixXd& site_values, const RunOptions&) const {
  return state_->unknowns(site_values);
}

MatrixXd SmoothMap::site_weights(const MatrixXd& unknown_weights,
                                 const RunOptions&) const {
  return state_->transposed(unknown_weights);
}

std::vector<NodalTerms> SmoothMap::rows(std::span<const NodalTerms> of_unknowns) const {
  const Index num_sites = state_->system.num_sites();
  MatrixXd unknowns = MatrixXd::Zero(3 * num_sites, std::ssize(of_unknowns));
  for (std::size_t i = 0; i < of_unknowns.size(); ++i) {
    for (std::size_t k = 0; k < of_unknowns[i].sites().size(); ++k)
      unknowns(of_unknowns[i].sites()[k], static_cast<Index>(i)) +=
          of_unknowns[i].weights()[k];
  }
  const MatrixXd weights = state_->transposed(std::move(unknowns));
  std::vector<NodalTerms> result(of_unknowns.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (Site s = 0; s < num_sites; ++s) {
      const double weight = weights(s, static_cast<Index>(i));
      if (weight != 0) result[i].add(s, weight);
    }
  }
  return result;
}

}  // namespace delone::interp
