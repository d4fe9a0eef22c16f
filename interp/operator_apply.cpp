#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "delaunay/huge_pages.hpp"
#include "delaunay/parallel.hpp"
#include "interp/index.hpp"
#include "interp/operator.hpp"

namespace delone::interp {

namespace {

using delaunay::Node;
using Matrix = Operator::Matrix;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t targets_at_once = 4096;

/// A row of the matrix.
struct MatrixRow {
  const int* columns;
  const double* weights;
  std::ptrdiff_t size;
};

/// Plain pointers into a matrix in compressed form.
struct MatrixRows {
  explicit MatrixRows(const Matrix& m)
      : offsets(m.outerIndexPtr()), columns(m.innerIndexPtr()), weights(m.valuePtr()) {}
  [[nodiscard]] MatrixRow operator[](std::int64_t i) const noexcept {
    return {columns + offsets[i], weights + offsets[i], offsets[i + 1] - offsets[i]};
  }
  /// Of all these rows; -1 if they differ.
  [[nodiscard]] int common_length(std::int64_t first, std::int64_t last) const noexcept {
    const int length = offsets[first + 1] - offsets[first];
    int differences = 0;
    for (std::int64_t i = first; i < last; ++i)
      differences |= (offsets[i + 1] - offsets[i]) ^ length;
    return differences == 0 ? length : -1;
  }
  /// Hardware stops looking ahead where a page ends.
  void prefetch_after(std::int64_t i) const noexcept {
    prefetch_after(weights + offsets[i], columns + offsets[i]);
  }
  static void prefetch_after(const double* weight, const int* column) noexcept {
    constexpr std::uintptr_t ahead = 512;
    prefetch(weight, ahead * sizeof(double));
    prefetch(column, ahead * sizeof(int));
  }
  // As a number: no pointer may lie beyond its array, or count from null.
  static void prefetch(const void* start, std::uintptr_t bytes) noexcept {
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    __builtin_prefetch(
        reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(start) + bytes));
  }
  const int* offsets;
  const int* columns;
  const double* weights;
};

/// In the order in which apply_transposed adds. Three and four, the lengths of linear and
/// bilinear rows, are spelled out: a loop costs as much as they do.
[[gnu::always_inline]] inline double sequential_sum(const MatrixRow& row,
                                                    const double* values) noexcept {
  const double* w = row.weights;
  const int* c = row.columns;
  if (row.size == 3)
    return 0.0 + w[0] * values[c[0]] + w[1] * values[c[1]] + w[2] * values[c[2]];
  if (row.size == 4) {
    return 0.0 + w[0] * values[c[0]] + w[1] * values[c[1]] + w[2] * values[c[2]] +
           w[3] * values[c[3]];
  }
  double sum = 0;
  for (std::ptrdiff_t k = 0; k < row.size; ++k) sum += w[k] * values[c[k]];
  return sum;
}

// Longer rows are summed in two chains, so that they wait for the memory and not for one
// addition after the other; for shorter ones the simple loop is faster.
constexpr std::ptrdiff_t few = 8;

[[gnu::always_inline]] inline double weighted_sum(const MatrixRow& row,
                                                  const double* values) noexcept {
  if (row.size <= few) return sequential_sum(row, values);
  double even = 0, odd = 0;
  std::ptrdiff_t k = 0;
  for (; k + 2 <= row.size; k += 2) {
    even += row.weights[k] * values[row.columns[k]];
    odd += row.weights[k + 1] * values[row.columns[k + 1]];
  }
  if (k < row.size) even += row.weights[k] * values[row.columns[k]];
  return even + odd;
}

/// The parts of a row's weight that are present in a field, and what they give.
struct PresentShare {
  double sum = 0, signed_weight = 0, weight = 0, all_weight = 0;

  void add(double w, double value) noexcept {
    all_weight += std::abs(w);
    if (std::isnan(value)) return;
    sum += w * value;
    signed_weight += w;
    weight += std::abs(w);
  }
  [[nodiscard]] double value(double least_share) const noexcept {
    const bool is_enough =
        signed_weight >= least_share && weight >= least_share * all_weight;
    return is_enough ? sum / signed_weight : missing;
  }
};

/// For a row whose sum is NaN. `stride`: from one row's value to the next.
double renormalized_sum(const MatrixRow& row, const double* values, std::ptrdiff_t stride,
                        double least_share) noexcept {
  PresentShare share;
  bool is_whole = true;
  for (std::ptrdiff_t k = 0; k < row.size; ++k) {
    const double value = values[row.columns[k] * stride];
    is_whole = is_whole && !std::isnan(value);
    share.add(row.weights[k], value);
  }
  // Whole rows are NaN where infinities cancel.
  return is_whole ? missing : share.value(least_share);
}

template <std::size_t width>
using Sums = std::array<double, width>;

template <std::size_t width>
void add_fields(Sums<width>& sums, double weight, const double* values) noexcept {
  for (std::size_t f = 0; f < width; ++f) sums[f] += weight * values[f];
}

/// weighted_sum for neighbouring fields.
template <std::size_t width>
void sum_fields(const MatrixRow& row, const double* fields, std::ptrdiff_t stride,
                double* out) noexcept {
  Sums<width> even{}, odd{};
  const auto values = [&](std::ptrdiff_t k) { return fields + row.columns[k] * stride; };
  std::ptrdiff_t k = 0;
  if (row.size > few) {
    for (; k + 2 <= row.size; k += 2) {
      add_fields(even, row.weights[k], values(k));
      add_fields(odd, row.weights[k + 1], values(k + 1));
    }
  }
  for (; k < row.size; ++k) add_fields(even, row.weights[k], values(k));
  for (std::size_t f = 0; f < width; ++f) out[f] = even[f] + odd[f];
}

// Eight pairs of sums fit into registers; the row stays in the cache for the next ones.
void sum_all_fields(const MatrixRow& row, const double* fields, std::ptrdiff_t stride,
                    std::ptrdiff_t count, double* out) noexcept {
  std::ptrdiff_t f = 0;
  for (; f + 8 <= count; f += 8) sum_fields<8>(row, fields + f, stride, out + f);
  if (f + 4 <= count) {
    sum_fields<4>(row, fields + f, stride, out + f);
    f += 4;
  }
  if (f + 2 <= count) {
    sum_fields<2>(row, fields + f, stride, out + f);
    f += 2;
  }
  if (f < count) sum_fields<1>(row, fields + f, stride, out + f);
}

void check_count(std::int64_t found, std::int64_t wanted, const char* what,
                 const char* of_what) {
  if (found == wanted) return;
  throw Error("there are " + std::to_string(found) + " " + what + " for " +
              std::to_string(wanted) + " " + of_what + "s; give one a " + of_what);
}

void check(const ApplyOptions& options) {
  if (!(options.least_share > 0 && options.least_share <= 1))
    throw Error("least_share must be above 0 and at most 1");
}

void check_spread(std::span<const double> values, const char* what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= 0 && std::isfinite(values[i])) continue;
    const auto row = static_cast<std::int64_t>(i);
    throw Error("row " + std::to_string(row) + ": the " + what +
                    " is not a finite number of zero or more; mend it or remove the row",
                {row});
  }
}

// On its own and by value, so that nothing is read again for every row.
template <class Value>
void fill(MatrixRows rows, std::int64_t first, std::int64_t last, double empty,
          Value value, double* out) {
  for (std::int64_t i = first; i < last; ++i) {
    rows.prefetch_after(i);
    const MatrixRow row = rows[i];
    out[i] = row.size == 0 ? empty : value(row);
  }
}

/// Rows of one length: nothing is read but weights, columns and values.
template <std::ptrdiff_t width>
void fill_equal(MatrixRows rows, std::int64_t first, std::int64_t last,
                const double* values, double* out) {
  const double* w = rows.weights + rows.offsets[first];
  const int* c = rows.columns + rows.offsets[first];
  for (std::int64_t i = first; i < last; ++i, w += width, c += width) {
    MatrixRows::prefetch_after(w, c);
    out[i] = sequential_sum({c, w, width}, values);
  }
}

/// The weighted sums of the values. Most operators have long stretches of rows of one
/// length, 3 in triangles, 4 in cells of a grid, 1 for the nearest point.
void fill_sums(MatrixRows rows, std::int64_t first, std::int64_t last,
               const double* values, double* out) {
  constexpr std::int64_t stretch = 64;
  for (std::int64_t begin = first; begin < last; begin += stretch) {
    const std::int64_t end = std::min(begin + stretch, last);
    switch (rows.common_length(begin, end)) {
      case 1:
        fill_equal<1>(rows, begin, end, values, out);
        break;
      case 3:
        fill_equal<3>(rows, begin, end, values, out);
        break;
      case 4:
        fill_equal<4>(rows, begin, end, values, out);
        break;
      default:
        fill(
            rows, begin, end, missing,
            [values](const MatrixRow& row) { return weighted_sum(row, values); }, out);
    }
  }
}

/// `fill(rows, first, last, out)` gives all targets their values, piece by piece.
///
/// One thread lets the result grow as it goes, so that the zeros a vector begins with are
/// still in the cache when they are written over.
template <class Fill>
std::vector<double> filled(const Matrix& matrix, const RunOptions& run, Fill fill) {
  const MatrixRows rows(matrix);
  const auto size = static_cast<std::size_t>(matrix.rows());
  const bool is_alone = delaunay::num_threads(run) == 1;
  std::vector<double> result;
  result.reserve(size);
  delaunay::prefer_huge_pages(result.data(), size * sizeof(double));
  if (!is_alone) result.resize(size);
  delaunay::parallel_chunks(matrix.rows(), targets_at_once, run,
                            [&](std::int64_t first, std::int64_t last) {
                              if (is_alone) result.resize(at(last));
                              fill(rows, first, last, result.data());
                            });
  return result;
}

/// `value(row)` for every target that is not missing.
template <class Value>
std::vector<double> for_targets(const Matrix& matrix, double empty, const RunOptions& run,
                                Value value) {
  return filled(matrix, run,
                [&](MatrixRows rows, std::int64_t first, std::int64_t last, double* out) {
                  fill(rows, first, last, empty, value, out);
                });
}

template <class F>
std::vector<double> mapped(std::span<const double> values, F f) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const double v : values) result.push_back(f(v));
  return result;
}

}  // namespace

Operator::Operator(Matrix matrix) {
  const auto shared = std::make_shared<Matrix>();
  shared->swap(matrix);
  shared->makeCompressed();
  matrix_ = shared;
}

std::vector<double> Operator::apply(std::span<const double> row_values,
                                    const ApplyOptions& options,
                                    const RunOptions& run) const {
  check(options);
  check_count(std::ssize(row_values), matrix_->cols(), "values", "point");
  const double* values = row_values.data();
  const auto renormalize = [&](const MatrixRow& row, double& sum) {
    if (std::isnan(sum) && row.size > 0)
      sum = renormalized_sum(row, values, 1, options.least_share);
  };
  return filled(*matrix_, run,
                [&](MatrixRows rows, std::int64_t first, std::int64_t last, double* out) {
                  fill_sums(rows, first, last, values, out);
                  if (options.missing == MissingRows::propagate) return;
                  for (std::int64_t i = first; i < last; ++i)
                    renormalize(rows[i], out[i]);
                });
}

Fields Operator::apply_fields(const Eigen::Ref<const Fields>& fields,
                              const ApplyOptions& options, const RunOptions& run) const {
  check(options);
  check_count(fields.rows(), matrix_->cols(), "rows of values", "point");
  const MatrixRows rows(*matrix_);
  const std::ptrdiff_t count = fields.cols(), stride = fields.outerStride();
  Fields result(matrix_->rows(), count);
  delaunay::prefer_huge_pages(result.data(), at(result.size()) * sizeof(double));
  const auto fill_row = [&](const MatrixRow& row, double* out) {
    if (row.size == 0) {
      std::fill_n(out, count, missing);
      return;
    }
    sum_all_fields(row, fields.data(), stride, count, out);
    if (options.missing == MissingRows::propagate) return;
    for (std::ptrdiff_t f = 0; f < count; ++f) {
      if (std::isnan(out[f]))
        out[f] = renormalized_sum(row, fields.data() + f, stride, options.least_share);
    }
  };
  delaunay::parallel_chunks(matrix_->rows(), targets_at_once, run,
                            [&](std::int64_t first, std::int64_t last) {
                              for (std::int64_t i = first; i < last; ++i) {
                                rows.prefetch_after(i);
                                fill_row(rows[i], result.data() + i * count);
                              }
                            });
  return result;
}

std::vector<double> Operator::apply_transposed(
    std::span<const double> target_values) const {
  check_count(std::ssize(target_values), matrix_->rows(), "values", "target");
  const MatrixRows rows(*matrix_);
  std::vector<double> result(static_cast<std::size_t>(matrix_->cols()));
  for (std::int64_t i = 0; i < matrix_->rows(); ++i) {
    const MatrixRow row = rows[i];
    for (std::ptrdiff_t k = 0; k < row.size; ++k)
      result[at(row.columns[k])] += row.weights[k] * target_values[at(i)];
  }
  return result;
}

TransposedOperator Operator::transposed() const {
  const auto shared = std::make_shared<Matrix>(matrix_->transpose());
  shared->makeCompressed();
  return TransposedOperator(shared);
}

std::vector<double> TransposedOperator::apply(std::span<const double> target_values,
                                              const RunOptions& run) const {
  check_count(std::ssize(target_values), matrix_->cols(), "values", "target");
  const double* values = target_values.data();
  return for_targets(*matrix_, 0, run, [values](const MatrixRow& row) {
    return sequential_sum(row, values);
  });
}

std::vector<double> Operator::propagated_variance(std::span<const double> row_variances,
                                                  const RunOptions& run) const {
  check_count(std::ssize(row_variances), matrix_->cols(), "variances", "point");
  check_spread(row_variances, "variance");
  return for_targets(*matrix_, missing, run, [&](const MatrixRow& row) {
    double sum = 0;
    for (std::ptrdiff_t k = 0; k < row.size; ++k)
      sum += row.weights[k] * row.weights[k] * row_variances[at(row.columns[k])];
    return sum;
  });
}

std::vector<double> Operator::propagated_deviation(std::span<const double> row_deviations,
                                                   const RunOptions& run) const {
  check_count(std::ssize(row_deviations), matrix_->cols(), "deviations", "point");
  check_spread(row_deviations, "standard deviation");
  const std::vector<double> variances =
      mapped(row_deviations, [](double s) { return s * s; });
  return mapped(propagated_variance(variances, run),
                [](double v) { return std::sqrt(v); });
}

Operator Operator::spread_to_rows(std::span<const Node> rows, Node num_rows) const {
  check_count(std::ssize(rows), matrix_->cols(), "rows", "column");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool is_ascending = k == 0 ? rows[k] >= 0 : rows[k] > rows[k - 1];
    if (is_ascending && rows[k] < num_rows) continue;
    throw Error("entry " + std::to_string(k) +
                " of the rows is not above the one before it and below " +
                std::to_string(num_rows) + "; sort them and remove repeats");
  }
  Matrix matrix(matrix_->rows(), num_rows);
  matrix.resizeNonZeros(matrix_->nonZeros());
  std::copy_n(matrix_->outerIndexPtr(), matrix_->rows() + 1, matrix.outerIndexPtr());
  std::copy_n(matrix_->valuePtr(), matrix_->nonZeros(), matrix.valuePtr());
  std::transform(matrix_->innerIndexPtr(), matrix_->innerIndexPtr() + matrix_->nonZeros(),
                 matrix.innerIndexPtr(), [&](int column) { return rows[at(column)]; });
  return Operator(matrix.markAsRValue());
}

}  // namespace delone::interp
