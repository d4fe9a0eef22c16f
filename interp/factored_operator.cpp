#include "interp/factored_operator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"
#include "interp/blend_operator_columns.hpp"
#include "interp/factored_operator_state.hpp"

namespace delone::interp {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Matrix = Operator::Matrix;
using Term = Matrix::InnerIterator;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr Index fields_at_once = 8;
constexpr std::int64_t targets_at_once = 16;

void check_count(Index found, Index wanted, const std::string& what,
                 const std::string& place) {
  if (found == wanted) return;
  throw Error("there are " + std::to_string(found) + " " + what + " for " +
              std::to_string(wanted) + " " + place + "s; give one a " + place);
}

void check(const ApplyOptions& options) {
  if (!(options.least_share > 0 && options.least_share <= 1))
    throw Error("least_share must be above 0 and at most 1");
}

void check(const RowOptions& options) {
  if (!(options.tolerance >= 0 && options.tolerance <= 0.01))
    throw Error("the tolerance of explicit rows must lie between 0 and 0.01");
}

bool is_empty(const Matrix& matrix, Index row) {
  return matrix.outerIndexPtr()[row] == matrix.outerIndexPtr()[row + 1];
}

/// Fields that are solved together: values of the sites less `base` times `unit`.
struct Block {
  MatrixXd site_values;
  std::vector<double> base, unit;
};

// Sums and products then stay within the range of the data.
Block scaled_block(MatrixXd site_values) {
  Block block{std::move(site_values)};
  for (Index f = 0; f < block.site_values.cols(); ++f) {
    auto values = block.site_values.col(f);
    const double base = values.size() > 0 ? values[0] : 0;
    values.array() -= base;
    const double range = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
    const double unit = range > 0 && std::isfinite(range)
                            ? std::exp2(std::min(-std::ilogb(range), 1022))
                            : 1;
    values *= unit;
    block.base.push_back(base);
    block.unit.push_back(unit);
  }
  return block;
}

/// The smallest terms of a row, whose magnitudes add up to no more than a tolerance, are
/// left out; the largest one takes their sum.
class RowCutter {
 public:
  explicit RowCutter(double tolerance) : tolerance_(tolerance) {}

  NodalTerms operator()(const NodalTerms& row) {
    if (tolerance_ == 0 || row.sites().empty()) return row;
    merge(row);
    std::ranges::sort(terms_, [](const auto& a, const auto& b) {
      const double x = std::abs(a.second), y = std::abs(b.second);
      return x != y ? x < y : a.first < b.first;
    });
    double magnitude = 0, sum = 0;
    std::size_t first = 0;
    for (; first + 1 < terms_.size(); ++first) {
      const double weight = terms_[first].second;
      if (magnitude + std::abs(weight) > tolerance_) break;
      magnitude += std::abs(weight);
      sum += weight;
    }
    terms_.back().second += sum;
    NodalTerms kept;
    for (std::size_t i = first; i < terms_.size(); ++i)
      kept.add(terms_[i].first, terms_[i].second);
    return kept;
  }

 private:
  void merge(const NodalTerms& row) {
    terms_.clear();
    for (std::size_t i = 0; i < row.sites().size(); ++i)
      terms_.emplace_back(row.sites()[i], row.weights()[i]);
    std::ranges::stable_sort(terms_, {}, &std::pair<delaunay::Site, double>::first);
    std::size_t count = 0;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      if (count > 0 && terms_[count - 1].first == terms_[i].first) {
        terms_[count - 1].second += terms_[i].second;
      } else {
        terms_[count++] = terms_[i];
      }
    }
    terms_.resize(count);
  }

  double tolerance_;
  std::vector<std::pair<delaunay::Site, double>> terms_;
};

NodalTerms spread(const NodalTerms& of_sites, const Matrix& shares) {
  NodalTerms result;
  for (std::size_t i = 0; i < of_sites.sites().size(); ++i) {
    for (Term share(shares, of_sites.sites()[i]); share; ++share)
      result.add(static_cast<delaunay::Node>(share.col()),
                 of_sites.weights()[i] * share.value());
  }
  return result;
}

/// Rows are tried on one field that the operator is applied to as well.
class RowCheck {
 public:
  RowCheck(const FactoredOperator::State& state, const RunOptions& run) {
    const Index num_sites = state.site_shares.rows();
    MatrixXd field(num_sites, 1);
    for (Index s = 0; s < num_sites; ++s)
      field(s, 0) = std::cos(static_cast<double>(s) * static_cast<double>(s));
    const RunOptions quiet{run.num_threads, {}};
    const Eigen::VectorXd unknowns = std::visit(
        [&](const auto& map) { return map.unknowns(field, quiet); }, state.map);
    values_ = state.evaluation.matrix() * unknowns;
    field_ = field.col(0);
  }

  void operator()(const NodalTerms& row, std::int64_t target) const {
    constexpr double tolerance = 1e-9;
    double sum = 0, magnitude = 1;
    for (std::size_t i = 0; i < row.sites().size(); ++i) {
      sum += row.weights()[i] * field_[row.sites()[i]];
      magnitude += std::abs(row.weights()[i]);
    }
    if (std::abs(sum - values_[target]) <= tolerance * magnitude) return;
    throw Error("target " + std::to_string(target) +
                ": the points are too nearly collinear for weights to be exact; apply "
                "the operator without making its rows");
  }

 private:
  Eigen::VectorXd field_, values_;
};

/// The fields of one call.
class Application {
 public:
  Application(const FactoredOperator::State& state, const ApplyOptions& options,
              const RunOptions& run)
      : state_(state), options_(options), run_{run.num_threads, {}} {}

  /// Columns of the fields [first, first + count).
  [[nodiscard]] MatrixXd operator()(const Eigen::Ref<const Fields>& fields, Index first,
                                    Index count) const {
    MatrixXd values = fields.middleCols(first, count);
    if (!values.hasNaN()) return whole(values);
    if (options_.missing == MissingRows::renormalise) return renormalised(values);
    MatrixXd result = whole(values);
    for (Index f = 0; f < count; ++f)
      if ((state_.site_shares * values.col(f)).hasNaN())
        result.col(f).setConstant(missing);
    return result;
  }

 private:
  [[nodiscard]] MatrixXd whole(const MatrixXd& values) const {
    const Block block = scaled_block(state_.site_shares * values);
    const MatrixXd unknowns =
        std::visit([&](const auto& map) { return map.unknowns(block.site_values, run_); },
                   state_.map);
    const Matrix& matrix = state_.evaluation.matrix();
    MatrixXd result(matrix.rows(), values.cols());
    constexpr std::int64_t chunk = 1024;
    delaunay::parallel_chunks(
        matrix.rows(), chunk, run_, [&](std::int64_t first, std::int64_t last) {
          for (Index i = first; i < last; ++i)
            for (Index f = 0; f < values.cols(); ++f)
              result(i, f) = value(matrix, i, unknowns.col(f).data(), block.base[at(f)],
                                   block.unit[at(f)]);
        });
    return result;
  }

  static double value(const Matrix& matrix, Index row, const double* unknowns,
                      double base, double unit) {
    if (is_empty(matrix, row)) return missing;
    double sum = 0;
    for (Term term(matrix, row); term; ++term) sum += term.value() * unknowns[term.col()];
    return base + sum / unit;
  }

  // The same of the deviations from a mean, and of ones where there is a value.
  [[nodiscard]] MatrixXd renormalised(const MatrixXd& values) const {
    const Index count = values.cols();
    MatrixXd both(values.rows(), 2 * count);
    std::vector<double> means;
    for (Index f = 0; f < count; ++f) {
      means.push_back(mean_of(values.col(f)));
      for (Index i = 0; i < values.rows(); ++i) {
        const bool is_present = !std::isnan(values(i, f));
        both(i, f) = is_present ? values(i, f) - means.back() : 0;
        both(i, count + f) = is_present ? 1 : 0;
      }
    }
    MatrixXd result = whole(both);
    for (Index f = 0; f < count; ++f) {
      for (Index i = 0; i < result.rows(); ++i) {
        const double share = result(i, count + f);
        result(i, f) =
            share >= options_.least_share ? means[at(f)] + result(i, f) / share : missing;
      }
    }
    return result.leftCols(count);
  }

  static double mean_of(const Eigen::Ref<const Eigen::VectorXd>& values) {
    double sum = 0, number = 0;
    for (const double v : values) {
      if (std::isnan(v)) continue;
      sum += v;
      ++number;
    }
    return number > 0 ? sum / number : 0;
  }

  const FactoredOperator::State& state_;
  ApplyOptions options_;
  RunOptions run_;
};

}  // namespace

MatrixXd IdentityMap::unknowns(const MatrixXd& site_values, const RunOptions&) const {
  MatrixXd result = MatrixXd::Zero(3 * site_values.rows(), site_values.cols());
  for (Index s = 0; s < site_values.rows(); ++s) result.row(3 * s) = site_values.row(s);
  return result;
}
MatrixXd IdentityMap::site_weights(const MatrixXd& unknown_weights,
                                   const RunOptions&) const {
  MatrixXd result(unknown_weights.rows() / 3, unknown_weights.cols());
  for (Index s = 0; s < result.rows(); ++s) result.row(s) = unknown_weights.row(3 * s);
  return result;
}
std::vector<NodalTerms> IdentityMap::rows(std::span<const NodalTerms> of_unknowns) const {
  std::vector<NodalTerms> result(of_unknowns.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t k = 0; k < of_unknowns[i].sites().size(); ++k) {
      const Site unknown = of_unknowns[i].sites()[k];
      if (unknown % 3 == 0) result[i].add(unknown / 3, of_unknowns[i].weights()[k]);
    }
  }
  return result;
}

Matrix shares_matrix(const RowShares& shares, delaunay::Site num_sites,
                     delaunay::Node num_rows) {
  Matrix matrix(num_sites, num_rows);
  for (delaunay::Site s = 0; s < num_sites; ++s) {
    std::vector<delaunay::Node> rows(shares.of(s).begin(), shares.of(s).end());
    std::ranges::sort(rows);
    matrix.startVec(s);
    for (const delaunay::Node row : rows)
      matrix.insertBack(s, row) = 1.0 / static_cast<double>(rows.size());
  }
  matrix.finalize();
  return matrix;
}

std::int64_t FactoredOperator::num_targets() const noexcept {
  return state_->evaluation.matrix().rows();
}
std::int64_t FactoredOperator::num_rows() const noexcept {
  return state_->site_shares.cols();
}

std::vector<double> FactoredOperator::apply(std::span<const double> row_values,
                                            const ApplyOptions& options,
                                            const RunOptions& run) const {
  check_count(std::ssize(row_values), num_rows(), "values", "point");
  const Eigen::Map<const Fields> field(row_values.data(), std::ssize(row_values), 1);
  const Fields result = apply_fields(field, options, run);
  return {result.data(), result.data() + result.size()};
}

Fields FactoredOperator::apply_fields(const Eigen::Ref<const Fields>& fields,
                                      const ApplyOptions& options,
                                      const RunOptions& run) const {
  check_count(fields.rows(), num_rows(), "values", "point");
  check(options);
  const Application applied(*state_, options, run);
  Fields result(num_targets(), fields.cols());
  for (Index first = 0; first < fields.cols(); first += fields_at_once) {
    const Index count = std::min(fields_at_once, fields.cols() - first);
    result.middleCols(first, count) = applied(fields, first, count);
    const auto done = static_cast<double>(first + count);
    if (run.progress && !run.progress(done / static_cast<double>(fields.cols())))
      throw Cancelled();
  }
  return result;
}

std::vector<double> FactoredOperator::apply_transposed(
    std::span<const double> target_values, const RunOptions& run) const {
  check_count(std::ssize(target_values), num_targets(), "values", "target");
  const Matrix& matrix = state_->evaluation.matrix();
  MatrixXd of_unknowns = MatrixXd::Zero(matrix.cols(), 1);
  for (Index i = 0; i < matrix.rows(); ++i)
    for (Term term(matrix, i); term; ++term)
      of_unknowns(term.col(), 0) += term.value() * target_values[at(i)];
  const MatrixXd of_sites = std::visit(
      [&](const auto& map) { return map.site_weights(of_unknowns, run); }, state_->map);
  const Eigen::VectorXd result = state_->site_shares.transpose() * of_sites;
  return {result.data(), result.data() + result.size()};
}

Operator FactoredOperator::explicit_rows(std::span<const std::int64_t> targets,
                                         const RowOptions& options,
                                         const RunOptions& run) const {
  check(options);
  for (const std::int64_t target : targets) {
    if (target < 0 || target >= num_targets())
      throw Error("there is no target " + std::to_string(target) +
                  "; they go from 0 to " + std::to_string(num_targets() - 1));
  }
  const Matrix& matrix = state_->evaluation.matrix();
  const Columns columns(static_cast<delaunay::Node>(num_rows()));
  const RowShares each(columns, Duplicates::mean);
  const auto count = std::ssize(targets);
  OperatorAssembly assembly(targets.size(), static_cast<delaunay::Node>(num_rows()),
                            at((count + targets_at_once - 1) / targets_at_once));
  const RowCheck check_row(*state_, run);
  constexpr double part_for_terms = 0.9;  // of the progress
  delaunay::parallel_chunks(
      count, targets_at_once, run,
      [&](std::int64_t first, std::int64_t last) {
        std::vector<NodalTerms> of_unknowns(at(last - first));
        for (std::int64_t i = first; i < last; ++i)
          for (Term term(matrix, targets[at(i)]); term; ++term)
            of_unknowns[at(i - first)].add(static_cast<Site>(term.col()), term.value());
        const std::vector<NodalTerms> of_sites = std::visit(
            [&](const auto& map) { return map.rows(of_unknowns); }, state_->map);
        OperatorChunk chunk(of_sites.size());
        RowCutter cut(options.tolerance);
        for (std::int64_t i = first; i < last; ++i) {
          check_row(of_sites[at(i - first)], targets[at(i)]);
          const NodalTerms row =
              spread(cut(of_sites[at(i - first)]), state_->site_shares);
          chunk.append(i, row.sites(), row.weights(), each);
        }
        assembly.keep(at(first / targets_at_once), std::move(chunk));
      },
      {0, part_for_terms});
  return assembly.finish(run);
}

Operator FactoredOperator::explicit_rows(const RowOptions& options,
                                         const RunOptions& run) const {
  std::vector<std::int64_t> all(at(num_targets()));
  std::iota(all.begin(), all.end(), 0);
  return explicit_rows(all, options, run);
}

std::vector<double> FactoredOperator::propagated_variance(
    std::span<const std::int64_t> targets, std::span<const double> row_variances,
    const RunOptions& run) const {
  constexpr std::size_t rows_at_once = 4096;
  std::vector<double> result;
  for (std::size_t first = 0; first < targets.size() || first == 0;
       first += rows_at_once) {
    const auto some =
        targets.subspan(first, std::min(rows_at_once, targets.size() - first));
    const std::vector<double> variances =
        explicit_rows(some, {}, run).propagated_variance(row_variances, run);
    result.insert(result.end(), variances.begin(), variances.end());
  }
  return result;
}

FactoredOperator FactoredOperator::spread_to_rows(std::span<const delaunay::Node> rows,
                                                  delaunay::Node num_rows) const {
  const Operator shares(Matrix(state_->site_shares));
  return FactoredOperator(std::make_shared<const State>(State{
      state_->evaluation, state_->map, shares.spread_to_rows(rows, num_rows).matrix()}));
}

}  // namespace delone::interp
