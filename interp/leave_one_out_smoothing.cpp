#include "interp/leave_one_out_smoothing.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "interp/leave_one_out_outside.hpp"
#include "interp/small_inverse.hpp"
#include "interp/smooth_factor.hpp"
#include "interp/smooth_fit.hpp"

namespace delone::interp {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double least_say_of_others = 1e-11;
constexpr double shortest_in_spacings = 0.05;
// Of 1 - h; and sites times sites that are looked at again.
constexpr double tolerated_error = 1e-7;
constexpr std::size_t most_work = 4'000'000;

MatrixXd values_of(const MatrixXd& unknowns) {
  MatrixXd values(unknowns.rows() / 3, unknowns.cols());
  for (Index s = 0; s < values.rows(); ++s) values.row(s) = unknowns.row(3 * s);
  return values;
}
MatrixXd as_right_side(const MatrixXd& values) {
  MatrixXd right = MatrixXd::Zero(3 * values.rows(), values.cols());
  for (Index s = 0; s < values.rows(); ++s) right.row(3 * s) = values.row(s);
  return right;
}

/// The linear map H from values to smoothed values, for one (scaled) wavelength: that of
/// the factor or, for the longest, the mean; and what functions that cost nothing add,
/// which the first smooths away.
class SmoothingMap {
 public:
  SmoothingMap(const SmoothSystem& system, double wavelength, const RunOptions& run)
      : system_(system), fronts_(dissect(system_)), weights_(system.weights) {
    const MatrixXd trend = values_of(system.trend);
    if (wavelength >= longest_wavelength) {
      free_ = trend.rowwise() - weights_.transpose() * trend / num_sites();
      invert(free_, 1e-12);
      return;
    }
    factor_.emplace(system_, fronts_, system.parameter(wavelength), run);
    if (!system.is_trend_charged) return;
    free_ =
        trend - values_of(factor_->solve(as_right_side(weights_.asDiagonal() * trend)));
    invert(trend, 1e-10);
  }
  SmoothingMap(const SmoothingMap&) = delete;
  SmoothingMap& operator=(const SmoothingMap&) = delete;

  [[nodiscard]] VectorXd diagonal() const {
    VectorXd result = VectorXd::Constant(weights_.size(), 1 / num_sites());
    if (factor_) result = corrected(factor_->inverse_diagonal());
    if (free_.cols() > 0)
      result += (free_ * inverse_).cwiseProduct(free_).rowwise().sum();
    return result.cwiseProduct(weights_);
  }

  /// Those columns of H that belong to some sites.
  [[nodiscard]] MatrixXd columns(std::span<const Site> sites) const {
    const auto count = static_cast<Index>(sites.size());
    MatrixXd result = MatrixXd::Constant(weights_.size(), count, 1 / num_sites());
    if (factor_) {
      MatrixXd units = MatrixXd::Zero(weights_.size(), count);
      for (Index j = 0; j < count; ++j) units(sites[at(j)], j) = 1;
      result = values_of(factor_->solve(as_right_side(units)));
    }
    for (Index j = 0; j < count; ++j) {
      const Site s = sites[at(j)];
      if (free_.cols() > 0)
        result.col(j) += free_ * (inverse_ * free_.row(s).transpose());
      result.col(j) *= weights_[s];
    }
    return result;
  }

 private:
  [[nodiscard]] double num_sites() const { return static_cast<double>(weights_.size()); }

  // The factor's diagonal is raised, which counts beside very short edges. Where it does,
  // the solution for random values shows.
  [[nodiscard]] VectorXd corrected(VectorXd diagonal) const {
    const VectorXd off = errors_of_factor();
    std::vector<std::pair<double, Index>> worst;
    for (Index s = 0; s < off.size(); ++s) {
      const double of_left = off[s] / std::abs(1 - diagonal[s] * weights_[s]);
      if (!(of_left <= tolerated_error)) worst.emplace_back(of_left, s);
    }
    std::sort(worst.begin(), worst.end(), std::greater<>());
    const std::size_t most = std::max<std::size_t>(16, most_work / at(std::ssize(off)));
    worst.resize(std::min(worst.size(), most));
    for (const auto& [error, s] : worst) {
      VectorXd unit = VectorXd::Zero(3 * off.size());
      unit[3 * s] = 1;
      diagonal[s] = factor_->refined(unit)[3 * s];
    }
    return diagonal;
  }

  [[nodiscard]] VectorXd errors_of_factor() const {
    VectorXd right = VectorXd::Zero(3 * weights_.size());
    for (Index s = 0; s < weights_.size(); ++s) {
      const bool is_up = (static_cast<std::uint64_t>(s) * 0x9E3779B97F4A7C15u >> 63) == 0;
      right[3 * s] = is_up ? weights_[s] : -weights_[s];
    }
    return values_of(factor_->solve(right) - factor_->refined(right)).cwiseAbs();
  }

  void invert(const MatrixXd& functions, double least) {
    const MatrixXd weighted = weights_.asDiagonal() * free_;
    const MatrixXd normal = functions.transpose() * weighted;
    const double size =
        (functions.transpose() * weights_.asDiagonal() * functions).trace();
    inverse_ = small_inverse(0.5 * (normal + normal.transpose()), least * size).inverse;
  }

  const SmoothSystem& system_;
  std::vector<EliminationFront> fronts_;
  const VectorXd& weights_;
  std::optional<SmoothFactor> factor_;
  MatrixXd free_, inverse_;
};

/// A surface and what it would be at sites without their data.
template <BlendSpace Space>
class LeftOutSmooth {
 public:
  using Triangulation = typename Space::Triangulation;

  LeftOutSmooth(const Triangulation& t, const SmoothData& data,
                const SmoothOptions& options, const RunOptions& run)
      : t_(t),
        options_(options),
        run_{run.num_threads, {}},
        system_(smooth_system<Space>(t, data.weights)),
        data_(data),
        sites_(fit_smooth<Space>(t, data, options, run)) {
    lengthen();
  }

  [[nodiscard]] std::vector<double> predictions() const {
    const SmoothingMap map(system_, sites_.fit.wavelength * system_.scale, run_);
    const VectorXd own = map.diagonal();
    std::vector<double> residuals(at(t_.num_sites())), predicted;
    std::vector<Site> outside;
    for (Site s = 0; s < t_.num_sites(); ++s) {
      const double left = 1 - own[s];
      residuals[at(s)] = left > least_say_of_others
                             ? (data_.values[at(s)] - sites_.values[at(s)]) / left
                             : missing;
      predicted.push_back(data_.values[at(s)] - residuals[at(s)]);
      const RemovedSite<Triangulation> removed(t_, s);
      if (!is_near_others(removed, options_)) {
        predicted.back() = missing;
      } else if (options_.outside != Outside::linear && is_left_outside(removed)) {
        predicted.back() = missing;
        if (options_.outside == Outside::nearest) outside.push_back(s);
      }
    }
    add_nearest(map, outside, residuals, predicted);
    return predicted;
  }

 private:
  [[nodiscard]] double spacing() const {
    const double each = system_.area / static_cast<double>(t_.num_sites());
    return system_.is_chain ? each : std::sqrt(each);
  }

  // Misfits must be larger than rounding.
  void lengthen() {
    const double shortest = shortest_in_spacings * spacing() / system_.scale;
    if (sites_.fit.wavelength >= shortest) return;
    SmoothOptions longer = options_;
    longer.by = SmoothBy::wavelength;
    longer.wavelength = shortest;
    sites_ = fit_smooth<Space>(t_, data_, longer, run_);
  }

  // Of the surfaces without data at some sites the values at the nearest others.
  void add_nearest(const SmoothingMap& map, std::span<const Site> outside,
                   const std::vector<double>& residuals,
                   std::vector<double>& predicted) const {
    constexpr std::size_t at_once = 32;
    for (std::size_t first = 0; first < outside.size(); first += at_once) {
      const auto some = outside.subspan(first, std::min(at_once, outside.size() - first));
      const MatrixXd columns = map.columns(some);
      for (std::size_t j = 0; j < some.size(); ++j) {
        const Site s = some[j], near = RemovedSite<Triangulation>(t_, s).nearest();
        predicted[at(s)] = sites_.values[at(near)] -
                           columns(near, static_cast<Index>(j)) * residuals[at(s)];
      }
    }
  }

  const Triangulation& t_;
  SmoothOptions options_;
  RunOptions run_;
  SmoothSystem system_;
  const SmoothData& data_;
  SmoothedSites sites_;
};

constexpr Site most_not_smoothed = 3;

/// Without smoothing, by sites.
template <class Triangulation>
std::vector<double> linear_predictions(const std::shared_ptr<const Triangulation>& t,
                                       const SmoothData& data,
                                       const SurfaceOptions& options,
                                       const RunOptions& run) {
  std::vector<double> row_values, predicted;
  for (const Site s : t->sites()) row_values.push_back(data.values[at(s)]);
  const LeaveOneOut by_rows = leave_out_linear(t, row_values, options, run);
  for (const delaunay::Node row : t->rows())
    predicted.push_back(by_rows.predicted[at(row)]);
  return predicted;
}

template <BlendSpace Space>
LeaveOneOut leave_out(const std::shared_ptr<const typename Space::Triangulation>& t,
                      std::span<const double> row_values, const SmoothOptions& options,
                      const RunOptions& run) {
  using Linear = typename LinearOver<typename Space::Triangulation>::Surface;
  const Linear checked(t, row_values, options);  // throws for options and values
  const SmoothData data = smooth_data(t->sites(), t->num_sites(), row_values, options);
  const std::vector<double> predicted =
      t->num_sites() <= most_not_smoothed
          ? linear_predictions(t, data, options, run)
          : LeftOutSmooth<Space>(*t, data, options, run).predictions();
  return left_out_rows(t->sites(), predicted, row_values);
}

}  // namespace

LeaveOneOut leave_out_smooth(std::shared_ptr<const tripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const SmoothOptions& options, const RunOptions& run) {
  return leave_out<PlaneSpace>(triangulation, row_values, options, run);
}

LeaveOneOut leave_out_smooth(std::shared_ptr<const stripack::Triangulation> triangulation,
                             std::span<const double> row_values,
                             const SmoothOptions& options, const RunOptions& run) {
  return leave_out<SphereSpace>(triangulation, row_values, options, run);
}

}  // namespace delone::interp
