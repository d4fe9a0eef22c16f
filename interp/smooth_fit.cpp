#include "interp/smooth_fit.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/small_inverse.hpp"
#include "interp/smooth_factor.hpp"
#include "interp/smooth_operator_map.hpp"

namespace delone::interp {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();
using Strided = Eigen::Map<const VectorXd, 0, Eigen::InnerStride<3>>;
Strided values_of(const VectorXd& unknowns) {
  return {unknowns.data(), unknowns.size() / 3};
}
MatrixXd values_of_columns(const MatrixXd& unknowns) {
  MatrixXd values(unknowns.rows() / 3, unknowns.cols());
  for (Index s = 0; s < values.rows(); ++s) values.row(s) = unknowns.row(3 * s);
  return values;
}
MatrixXd as_right_side(const MatrixXd& values) {
  MatrixXd right = MatrixXd::Zero(3 * values.rows(), values.cols());
  for (Index s = 0; s < values.rows(); ++s) right.row(3 * s) = values.row(s);
  return right;
}

/// Random signs that depend on the site only (splitmix64).
double sign_of(Index site, Index column) {
  std::uint64_t z = static_cast<std::uint64_t>(site * 64 + column) * 0x9E3779B97F4A7C15u +
                    0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return ((z ^ (z >> 31)) >> 32) % 2 == 0 ? 1 : -1;
}

/// A surface for one parameter.
struct Trial {
  VectorXd unknowns;
  double misfit = 0;  ///< mean of weighted squares
  double trace = 0;
};

enum class Effort : std::uint8_t {
  misfit,  ///< without the trace
  score,   ///< with it
  final    ///< and corrected for rounding
};

/// Surfaces over a system for one set of values, scaled to at most 1.
class Smoother {
 public:
  Smoother(SmoothSystem system, VectorXd values, const RunOptions& run)
      : system_(std::move(system)),
        fronts_(dissect(system_)),
        values_(std::move(values)),
        run_{run.num_threads, {}} {
    fit_trend();
  }

  [[nodiscard]] const SmoothSystem& system() const noexcept { return system_; }
  [[nodiscard]] const VectorXd& values() const noexcept { return values_; }
  [[nodiscard]] double num_sites() const noexcept {
    return static_cast<double>(values_.size());
  }
  /// Mean distance of sites.
  [[nodiscard]] double spacing() const noexcept {
    const double each = system_.area / num_sites();
    return system_.is_chain ? each : std::sqrt(each);
  }

  /// Wavelengths are scaled.
  [[nodiscard]] Trial at_wavelength(double wavelength, Effort effort) const {
    if (wavelength >= longest_wavelength)
      return {trend_, misfit_of(trend_), 1 + static_cast<double>(trend_rank_)};
    const double least = 1e-4 * spacing();
    const SmoothFactor factor(system_, fronts_,
                              system_.parameter(std::max(wavelength, least)), run_);
    MatrixXd columns(values_.size(), 1);
    columns.col(0) = residual_;
    const MatrixXd trend_values = values_of_columns(system_.trend);
    if (system_.is_trend_charged) {
      columns.conservativeResize(Eigen::NoChange, 1 + trend_values.cols());
      columns.rightCols(trend_values.cols()) = trend_values;
    }
    return finished(factor, solutions(factor, columns, effort), columns, effort);
  }

 private:
  void fit_trend() {
    const VectorXd& w = system_.weights;
    MatrixXd columns = values_of_columns(system_.trend);
    const Eigen::RowVectorXd means = w.transpose() * columns / num_sites();
    const double mean = w.dot(values_) / num_sites();
    columns.rowwise() -= means;
    const MatrixXd normal = columns.transpose() * w.asDiagonal() * columns;
    const SmallInverse inverse = small_inverse(normal, 1e-12 * normal.trace());
    const VectorXd slopes =
        inverse.inverse *
        (columns.transpose() * w.cwiseProduct((values_.array() - mean).matrix()));
    trend_rank_ = inverse.rank;
    trend_ = system_.trend * slopes;
    for (Index s = 0; s < values_.size(); ++s) trend_[3 * s] += mean - means.dot(slopes);
    residual_ = values_ - values_of(trend_);
  }

  [[nodiscard]] MatrixXd solutions(const SmoothFactor& factor, const MatrixXd& columns,
                                   Effort effort) const {
    MatrixXd right = as_right_side(system_.weights.asDiagonal() * columns);
    if (effort != Effort::final) return factor.solve(std::move(right));
    MatrixXd result(right.rows(), right.cols());
    for (Index k = 0; k < right.cols(); ++k) result.col(k) = factor.refined(right.col(k));
    return result;
  }

  // On the sphere a harmonic is taken from the values first, the one with which the
  // whole costs least: of the normal equations of the part that smoothing removes.
  [[nodiscard]] Trial finished(const SmoothFactor& factor, const MatrixXd& solutions,
                               const MatrixXd& columns, Effort effort) const {
    Trial trial{solutions.col(0) + trend_};
    if (effort != Effort::misfit) trial.trace = trace(factor);
    const Index count = columns.cols() - 1;
    if (count > 0) {
      const MatrixXd smoothed = values_of_columns(solutions),
                     harmonics = columns.rightCols(count),
                     removed = harmonics - smoothed.rightCols(count),
                     weighted = system_.weights.asDiagonal() * removed;
      const MatrixXd normal = harmonics.transpose() * weighted;
      const double size =
          (harmonics.transpose() * system_.weights.asDiagonal() * harmonics).trace();
      const MatrixXd inverse =
          small_inverse(0.5 * (normal + normal.transpose()), 1e-10 * size).inverse;
      trial.unknowns += (system_.trend - solutions.rightCols(count)) *
                        (inverse * (weighted.transpose() * residual_));
      trial.trace += (inverse * (removed.transpose() * weighted)).trace();
    }
    trial.misfit = misfit_of(trial.unknowns);
    return trial;
  }

  [[nodiscard]] double misfit_of(const VectorXd& unknowns) const {
    return system_.weights.dot((values_ - values_of(unknowns)).cwiseAbs2()) / num_sites();
  }

  [[nodiscard]] double trace(const SmoothFactor& factor) const {
    constexpr Index num_columns = 6;
    const VectorXd& w = system_.weights;
    if (w.size() <= most_exact_traces) return w.dot(factor.inverse_diagonal());
    MatrixXd signs(w.size(), num_columns);
    for (Index s = 0; s < w.size(); ++s)
      for (Index k = 0; k < num_columns; ++k)
        signs(s, k) = sign_of(s, k) * std::sqrt(w[s]);
    const MatrixXd answers = values_of_columns(factor.solve(as_right_side(signs)));
    return signs.cwiseProduct(answers).sum() / static_cast<double>(num_columns);
  }

  SmoothSystem system_;
  std::vector<EliminationFront> fronts_;
  VectorXd values_, residual_, trend_;
  Index trend_rank_ = 0;
  RunOptions run_;
};

/// Looks for the wavelength; all of them are binary logarithms of scaled ones.
class Search {
 public:
  Search(const Smoother& smoother, const RunOptions& run)
      : smoother_(smoother),
        run_(run),
        shortest_(std::log2(0.5 * smoother.spacing())),
        longest_(std::log2(longest_wavelength)) {}

  [[nodiscard]] double by_score(std::optional<double> start) {
    double best = start ? std::clamp(*start, shortest_, longest_) : scanned();
    const double step = 0.5;
    for (;;) {
      const double next = best_of({best, best - step, best + step});
      if (next == best) break;
      best = next;
    }
    return vertex(best, step);
  }

  /// `wanted`: mean of weighted squared misfits.
  [[nodiscard]] double by_misfit(double wanted, std::optional<double> start) {
    const auto excess = [&](double x) {
      report();
      const double misfit = smoother_.at_wavelength(std::exp2(x), Effort::misfit).misfit;
      return std::log(std::max(misfit, 1e-300) / wanted);
    };
    if (excess(longest_) <= 0) return longest_;
    double low = start.value_or(shortest_ + 3), high = low, step = 0.5;
    double at_low = excess(low), at_high = at_low;
    while (at_low > 0 && low > shortest_ - 8) {
      high = low, at_high = at_low;
      low -= step, step *= 2;
      at_low = excess(low);
    }
    if (at_low > 0) return low;
    while (at_high <= 0) {
      low = high, at_low = at_high;
      high = std::min(longest_, high + step), step *= 2;
      at_high = excess(high);
    }
    return root(excess, {low, at_low}, {high, at_high});
  }

 private:
  struct Place {
    double x, excess;
  };

  // By secants; an end that stays counts half the next time (the Illinois method).
  template <class Excess>
  [[nodiscard]] static double root(const Excess& excess, Place low, Place high) {
    constexpr double near_enough = 1e-3;
    constexpr int most_steps = 40;
    int last_side = 0;
    for (int k = 0; k < most_steps; ++k) {
      const double part = low.excess / (low.excess - high.excess);
      const double x = low.x + std::clamp(part, 0.01, 0.99) * (high.x - low.x);
      const double e = excess(x);
      if (std::abs(e) <= near_enough) return x;
      const int side = e > 0 ? 1 : -1;
      (side > 0 ? high : low) = {x, e};
      if (side == last_side) (side > 0 ? low : high).excess *= 0.5;
      last_side = side;
    }
    return 0.5 * (low.x + high.x);
  }

  // Nobody knows how many there will be.
  void report() {
    remaining_ *= 0.85;
    if (run_.progress && !run_.progress(1 - remaining_)) throw Cancelled();
  }

  [[nodiscard]] double scanned() {
    double best = shortest_;
    for (double x = shortest_ + 1; x < longest_; x += 1) best = best_of({best, x});
    return best;
  }

  double best_of(std::initializer_list<double> places) {
    return std::min(places, [this](double a, double b) { return score(a) < score(b); });
  }

  // Logarithm of the score.
  double score(double x) {
    if (x < shortest_ || x > longest_ + 0.5) return infinite;
    const auto [found, is_new] = scores_.try_emplace(x, 0.0);
    if (!is_new) return found->second;
    report();
    const Trial trial = smoother_.at_wavelength(std::exp2(x), Effort::score);
    const double left = 1 - trial.trace / smoother_.num_sites();
    found->second =
        std::log(std::max(trial.misfit, 1e-300)) - 2 * std::log(std::max(left, 1e-12));
    return found->second;
  }

  // Of the parabola through three places.
  double vertex(double middle, double step) {
    const double before = score(middle - step), here = score(middle),
                 after = score(middle + step);
    const double bend = before - 2 * here + after;
    if (!(bend > 0) || bend == infinite) return middle;
    return middle + std::clamp(0.5 * (before - after) / bend, -1.0, 1.0) * step;
  }

  const Smoother& smoother_;
  const RunOptions& run_;
  double remaining_ = 1;
  double shortest_, longest_;
  std::map<double, double> scores_;
};

double range_of(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v - values[0]));
  return most;
}

template <BlendSpace Space>
class Fitter {
 public:
  using Triangulation = typename Space::Triangulation;
  Fitter(const Triangulation& triangulation, const SmoothData& data, double unit,
         const RunOptions& run)
      : triangulation_(triangulation),
        data_(data),
        unit_(unit),
        run_(run),
        smoother_(smooth_system<Space>(triangulation, data.weights), scaled_values(),
                  run) {}

  [[nodiscard]] const Smoother& smoother() const noexcept { return smoother_; }

  /// Scaled.
  [[nodiscard]] double wavelength(const SmoothOptions& options) const {
    const double scale = smoother_.system().scale;
    if (options.by == SmoothBy::wavelength) return options.wavelength * scale;
    if (smoother_.num_sites() <= (smoother_.system().is_trend_charged ? 4 : 3)) return 0;
    std::optional<double> start;
    if (triangulation_.num_sites() > most_exact_traces) {
      const double part = thinned_wavelength(options);
      if (part > 0) start = std::log2(std::min(part * scale, longest_wavelength));
    }
    Search search(smoother_, run_);
    const double found = options.by == SmoothBy::errors
                             ? search.by_misfit(wanted_misfit(), start)
                             : search.by_score(start);
    return std::exp2(found);
  }

 private:
  [[nodiscard]] VectorXd scaled_values() const {
    VectorXd values(std::ssize(data_.values));
    for (Index s = 0; s < values.size(); ++s)
      values[s] = (data_.values[at(s)] - data_.values[0]) * unit_;
    return values;
  }
  // Misfits over errors of one, in terms of scaled values and weights of mean one.
  [[nodiscard]] double wanted_misfit() const {
    double mean = 0;
    for (const double w : data_.weights)
      mean += w / static_cast<double>(data_.weights.size());
    const double error = std::sqrt(data_.squared_error_unit / mean) * unit_;
    return std::max(error * error, 1e-280);
  }

  // In the units of the coordinates, of every k-th site along the curve.
  [[nodiscard]] double thinned_wavelength(const SmoothOptions& options) const {
    constexpr Site aim = 2048;
    const Site stride = triangulation_.num_sites() / aim;
    std::vector<typename Space::Point> points;
    for (Site s = 0; s < triangulation_.num_sites(); s += stride)
      points.push_back(triangulation_.points()[at(s)]);
    const Triangulation part(points, {run_.num_threads, {}});
    SmoothData data{{}, {}, data_.squared_error_unit};
    for (const delaunay::Node row : part.rows()) {
      data.values.push_back(data_.values[at(row * stride)]);
      data.weights.push_back(data_.weights[at(row * stride)]);
    }
    if (part.num_sites() < 3) return 0;
    const Fitter fitter(part, data, unit_, {run_.num_threads, {}});
    return fitter.wavelength(options) / fitter.smoother().system().scale;
  }

  const Triangulation& triangulation_;
  const SmoothData& data_;
  double unit_;
  RunOptions run_;
  Smoother smoother_;
};

SmoothFit told(const Smoother& smoother, const Trial& trial, const SmoothData& data,
               double scaled_wavelength, double unit) {
  const SmoothSystem& system = smoother.system();
  const double n = smoother.num_sites();
  SmoothFit fit;
  fit.wavelength = scaled_wavelength >= longest_wavelength
                       ? infinite
                       : scaled_wavelength / system.scale;
  fit.degrees_of_freedom = std::min(trial.trace, n);
  fit.rms_misfit = std::sqrt(trial.misfit) / unit;
  const double left = n - trial.trace;
  if (left > 1e-9 * n) {
    fit.predicted_rms = fit.rms_misfit * (n / left);
    fit.noise = fit.rms_misfit * std::sqrt(n / left);
  }
  double sum = 0;
  for (const double w : data.weights) sum += w;
  const double per_error =
      data.squared_error_unit > 0 ? std::sqrt(sum / n / data.squared_error_unit) : 0;
  fit.rms_misfit_over_errors = fit.rms_misfit * per_error;
  const double length = fit.wavelength / (2 * std::numbers::pi) * system.scale;
  const double in_weights = data.squared_error_unit > 0 ? per_error * per_error : sum / n;
  fit.parameter = length * length * length * length * n * in_weights / system.area /
                  system.scale / system.scale;
  return fit;
}

std::vector<double> row_weights(const SmoothOptions& options, std::size_t num_rows) {
  std::vector<double> weights(num_rows, 1.0);
  if (options.errors.empty()) return weights;
  const double least = std::ranges::min(options.errors);
  for (std::size_t i = 0; i < num_rows; ++i)
    weights[i] = std::max(1e-30, least / options.errors[i] * (least / options.errors[i]));
  return weights;
}

}  // namespace

void check(const SmoothOptions& options, std::size_t num_rows) {
  check(static_cast<const SurfaceOptions&>(options));
  if (options.by == SmoothBy::wavelength && !(options.wavelength >= 0))
    throw Error("the wavelength of smoothing must be zero or more");
  if (options.by == SmoothBy::errors && options.errors.empty() && num_rows > 0)
    throw Error("smoothing by errors needs the errors of the values; give them");
  if (options.errors.empty()) return;
  if (options.errors.size() != num_rows) {
    throw Error("there are " + std::to_string(options.errors.size()) + " errors for " +
                std::to_string(num_rows) + " points; give one a point");
  }
  for (std::size_t i = 0; i < num_rows; ++i) {
    if (options.errors[i] > 0 && options.errors[i] <= value_max) continue;
    const auto row = static_cast<std::int64_t>(i);
    throw Error("row " + std::to_string(row) +
                    ": the error of a value must be a positive number; correct it or "
                    "remove the row",
                {row});
  }
}

SmoothData smooth_data(std::span<const delaunay::Site> sites, Site num_sites,
                       std::span<const double> row_values, const SmoothOptions& options) {
  check(options, row_values.size());
  SmoothData data;
  data.values = values_at_sites(sites, num_sites, row_values, options.duplicates);
  if (!options.errors.empty()) {
    const double least = std::ranges::min(options.errors);
    data.squared_error_unit = least * least;
  }
  const std::vector<double> weights = row_weights(options, row_values.size());
  data.weights.resize(at(num_sites));
  const RowsOfSites rows = rows_of_sites(sites, num_sites);
  for (Site s = 0; s < num_sites; ++s) {
    std::vector<std::array<double, 2>> all;
    for (const delaunay::Node r : rows.of(s))
      all.push_back({row_values[at(r)], weights[at(r)]});
    std::ranges::sort(all);
    double sum = 0, moment = 0;
    for (const auto& [value, weight] : all) {
      sum += weight;
      moment += weight * (value - all[0][0]);
    }
    const bool is_mean = options.duplicates == Duplicates::mean;
    data.weights[at(s)] = is_mean ? sum : sum / static_cast<double>(all.size());
    if (is_mean && all.size() > 1) data.values[at(s)] = all[0][0] + moment / sum;
  }
  return data;
}

template <BlendSpace Space>
SmoothedSites fit_smooth(const typename Space::Triangulation& triangulation,
                         const SmoothData& data, const SmoothOptions& options,
                         const RunOptions& run) {
  SmoothedSites result;
  result.values = data.values;
  result.gradients.resize(data.values.size());
  if (data.values.size() < 3) {
    result.fit.degrees_of_freedom = static_cast<double>(data.values.size());
    return result;
  }
  const double range = range_of(data.values);
  const double unit = range > 0 ? std::exp2(std::min(-std::ilogb(range), 1022)) : 1;
  const Fitter<Space> fitter(triangulation, data, unit, run);
  const double wavelength = fitter.wavelength(options);
  const Trial trial = fitter.smoother().at_wavelength(wavelength, Effort::final);
  if (run.progress && !run.progress(1)) throw Cancelled();
  result.fit = told(fitter.smoother(), trial, data, wavelength, unit);
  double per_length = fitter.smoother().system().scale / unit;
  VectorXd unknowns = trial.unknowns;
  if (options.choices) {
    // What the operator applies, bit for bit: the two do not agree to 1e-13 otherwise
    // where the equations are nearly singular.
    SmoothSystem system = smooth_system<Space>(triangulation, data.weights);
    per_length /= system.extent_scale;
    unknowns = SmoothMap(std::move(system), wavelength, run)
                   .unknowns(fitter.smoother().values(), run);
  }
  for (std::size_t s = 0; s < data.values.size(); ++s) {
    const auto i = 3 * static_cast<Index>(s);
    if (wavelength > 0) result.values[s] = data.values[0] + unknowns[i] / unit;
    result.gradients[s] = {unknowns[i + 1] * per_length, unknowns[i + 2] * per_length};
  }
  return result;
}

template SmoothedSites fit_smooth<PlaneSpace>(const tripack::Triangulation&,
                                              const SmoothData&, const SmoothOptions&,
                                              const RunOptions&);
template SmoothedSites fit_smooth<SphereSpace>(const stripack::Triangulation&,
                                               const SmoothData&, const SmoothOptions&,
                                               const RunOptions&);

}  // namespace delone::interp
