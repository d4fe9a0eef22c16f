#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "interp/leave_one_out.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// A summary of residuals (predicted - value). Missing ones (NaN) are counted and left
/// out; with none left the statistics are NaN and largest_row is -1.
struct ErrorReport {
  std::int64_t count = 0, num_missing = 0;
  double mean = 0;      ///< bias
  double rms = 0;       ///< root mean square
  double mean_abs = 0;  ///< mean magnitude
  double largest = 0;   ///< magnitude
  std::int64_t largest_row = -1;
  double median_abs = 0, abs_90 = 0, abs_95 = 0, abs_99 = 0;  ///< of the magnitudes
  /// 1.4826 times the median distance from the median: the standard deviation if the
  /// residuals are normal, and hardly moved by outliers.
  double robust_deviation = 0;
};

/// O(n). Independent of threads; sums are taken in the order of rows. Quantiles are
/// interpolated between order statistics. Residuals beyond 1e150 may overflow to
/// infinity.
[[nodiscard]] ErrorReport error_report(std::span<const double> residuals);

struct OutlierOptions {
  /// How many robust deviations from the median count as an outlier; above 0. At 5 a
  /// million normal residuals hold about one.
  double threshold = 5;
};

/// A row whose residual stands out, with what a table about it needs.
struct Outlier {
  std::int64_t row = 0;
  double x = 0, y = 0;  ///< position; on the globe longitude and latitude, degrees
  double value = 0, predicted = 0, residual = 0;
  double score = 0;  ///< robust deviations from the median
};

/// Rows whose value the others do not bear out, the worst first; then by row.
///
/// A row is an outlier if its residual is larger than `threshold` robust deviations
/// *both* of all residuals (counted from their median) and of the values within two
/// steps along edges. Of all residuals, because it must be rare. Of the values around,
/// because interpolation errs where the field varies, and a mountain range is not a
/// hundred outliers: there neighbours differ as well. (Their residuals would be the
/// wrong measure: six of them say little about a distribution with long tails, and on
/// smooth fields every fiftieth row stood out by it.) One bad value spoils the
/// predictions of its neighbours too, with the opposite sign: a row beside one with a
/// larger residual of the opposite sign is not listed. (A second bad value hidden by that
/// comes out when the first is removed.)
/// Deviations below 1e-12 of the range of the values count as rounding.
///
/// Neighbours are those of the triangulation. O(n). Throws Error if the sizes differ or
/// the threshold is not above 0.
[[nodiscard]] std::vector<Outlier> find_outliers(const tripack::Triangulation& t,
                                                 std::span<const double> row_values,
                                                 const LeaveOneOut& left_out,
                                                 const OutlierOptions& options = {});
[[nodiscard]] std::vector<Outlier> find_outliers(const stripack::Triangulation& t,
                                                 std::span<const double> row_values,
                                                 const LeaveOneOut& left_out,
                                                 const OutlierOptions& options = {});

/// For a map of the expected error: for each row the root mean square of its own residual
/// and its neighbours'; a surface over these values is the map. NaN
/// where all of them are missing; rows at one position have one value. Throws Error if
/// the sizes differ.
[[nodiscard]] std::vector<double> local_rms(const tripack::Triangulation& t,
                                            std::span<const double> residuals);
[[nodiscard]] std::vector<double> local_rms(const stripack::Triangulation& t,
                                            std::span<const double> residuals);

}  // namespace delone::interp
