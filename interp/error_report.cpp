#include "interp/error_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/index.hpp"

namespace delone::interp {

namespace {

using delaunay::Adjacency;
using delaunay::Site;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double deviations_per_median = 1.4826;

std::vector<double> present(std::span<const double> values) {
  std::vector<double> result;
  for (const double v : values) {
    if (!std::isnan(v)) result.push_back(v);
  }
  return result;
}

/// The `part` quantile, between order statistics; reorders. NaN if there are none.
double quantile(std::span<double> values, double part) {
  if (values.empty()) return missing;
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto at_place = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), at_place, values.end());
  const double low = *at_place;
  if (below + 1 == values.size()) return low;
  const double high = *std::min_element(at_place + 1, values.end());
  return low + (place - static_cast<double>(below)) * (high - low);
}

struct Center {
  double median = missing, deviation = missing;
};
Center robust_center(std::vector<double> values) {
  const double median = quantile(values, 0.5);
  for (double& v : values) v = std::abs(v - median);
  return {median, deviations_per_median * quantile(values, 0.5)};
}

void check_count(std::size_t found, std::size_t rows, const char* what) {
  if (found == rows) return;
  throw Error("there are " + std::to_string(found) + " " + what + " for " +
              std::to_string(rows) + " points; give one a point");
}

void add(ErrorReport& report, double residual, std::int64_t row) {
  if (std::isnan(residual)) {
    ++report.num_missing;
    return;
  }
  ++report.count;
  report.mean += residual;
  report.rms += residual * residual;
  report.mean_abs += std::abs(residual);
  if (report.largest_row < 0 || std::abs(residual) > report.largest) {
    report.largest = std::abs(residual);
    report.largest_row = row;
  }
}

/// One residual a site: of repeated rows the largest in magnitude.
std::vector<double> at_sites(std::span<const Site> sites, Site num_sites,
                             std::span<const double> residuals) {
  std::vector<double> result(at(num_sites), missing);
  for (std::size_t row = 0; row < sites.size(); ++row) {
    double& r = result[at(sites[row])];
    if (std::isnan(r) || std::abs(residuals[row]) > std::abs(r)) r = residuals[row];
  }
  return result;
}

class OutlierSearch {
 public:
  OutlierSearch(const Adjacency& adjacency, std::vector<double> site_values,
                std::vector<double> site_residuals, double least_deviation,
                double threshold)
      : adjacency_(adjacency),
        values_(std::move(site_values)),
        residuals_(std::move(site_residuals)),
        all_(robust_center(present(residuals_))),
        least_(least_deviation),
        threshold_(threshold) {}

  /// The score; 0 for what is no outlier.
  [[nodiscard]] double score(Site s, double residual) const {
    const double global =
        std::abs(residual - all_.median) / std::max(all_.deviation, least_);
    if (!(global > threshold_) || is_explained(s, residual)) return 0;
    const double local = std::abs(residual) / std::max(spread_around(s), least_);
    return local > threshold_ ? std::min(global, local) : 0;
  }

 private:
  // Neighbours alone, half a dozen, may agree by chance.
  [[nodiscard]] double spread_around(Site s) const {
    constexpr std::size_t most = 64;  // for hubs
    const auto neighbors = adjacency_.neighbors(s);
    std::vector<Site> sites(neighbors.begin(), neighbors.end());
    for (std::size_t i = 0; i < neighbors.size() && sites.size() < most; ++i) {
      const auto beyond = adjacency_.neighbors(neighbors[i]);
      sites.insert(sites.end(), beyond.begin(),
                   beyond.begin() + std::min(std::ssize(beyond), std::ptrdiff_t{most}));
    }
    std::sort(sites.begin(), sites.end());
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    std::erase(sites, s);
    std::vector<double> values;
    for (const Site n : sites) values.push_back(values_[at(n)]);
    return values.empty() ? 0 : robust_center(std::move(values)).deviation;
  }
  [[nodiscard]] bool is_explained(Site s, double residual) const {
    const auto neighbors = adjacency_.neighbors(s);
    return std::any_of(neighbors.begin(), neighbors.end(), [&](Site n) {
      const double r = residuals_[at(n)];
      return r * residual < 0 && std::abs(r) > std::abs(residual);
    });
  }

  const Adjacency& adjacency_;
  std::vector<double> values_, residuals_;
  Center all_;
  double least_, threshold_;
};

/// Of repeated rows the first.
std::vector<double> first_values(std::span<const delaunay::Node> rows,
                                 std::span<const double> values) {
  std::vector<double> result;
  result.reserve(rows.size());
  for (const delaunay::Node row : rows) result.push_back(values[at(row)]);
  return result;
}

double range_of(std::span<const double> values) {
  if (values.empty()) return 0;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

void set_position(Outlier& outlier, tripack::Point2 p) {
  outlier.x = p.x, outlier.y = p.y;
}
void set_position(Outlier& outlier, const stripack::Direction& p) {
  const stripack::LonLat place = lonlat(p);
  outlier.x = place.lon_deg, outlier.y = place.lat_deg;
}

template <class Triangulation>
std::vector<Outlier> search(const Triangulation& t, std::span<const double> values,
                            const LeaveOneOut& left_out, const OutlierOptions& options) {
  check_count(values.size(), t.sites().size(), "values");
  check_count(left_out.residual.size(), t.sites().size(), "residuals");
  check_count(left_out.predicted.size(), t.sites().size(), "predictions");
  if (!(options.threshold > 0)) throw Error("the outlier threshold must be above 0");
  constexpr double rounding = 1e-12;
  const double least =
      std::max(rounding * range_of(values), std::numeric_limits<double>::min());
  const OutlierSearch search(t.adjacency(), first_values(t.rows(), values),
                             at_sites(t.sites(), t.num_sites(), left_out.residual), least,
                             options.threshold);
  std::vector<Outlier> result;
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double residual = left_out.residual[row];
    if (std::isnan(residual)) continue;
    const double score = search.score(t.sites()[row], residual);
    if (score == 0) continue;
    Outlier outlier{.row = static_cast<std::int64_t>(row),
                    .value = values[row],
                    .predicted = left_out.predicted[row],
                    .residual = residual,
                    .score = score};
    set_position(outlier, t.points()[at(t.sites()[row])]);
    result.push_back(outlier);
  }
  std::sort(result.begin(), result.end(), [](const Outlier& a, const Outlier& b) {
    return a.score != b.score ? a.score > b.score : a.row < b.row;
  });
  return result;
}

template <class Triangulation>
std::vector<double> rms_around(const Triangulation& t,
                               std::span<const double> residuals) {
  check_count(residuals.size(), t.sites().size(), "residuals");
  const std::vector<double> by_site = at_sites(t.sites(), t.num_sites(), residuals);
  std::vector<double> rms(by_site.size());
  for (Site s = 0; s < t.num_sites(); ++s) {
    double sum = 0;
    int count = 0;
    const auto add_residual = [&](double r) {
      if (std::isnan(r)) return;
      sum += r * r;
      ++count;
    };
    add_residual(by_site[at(s)]);
    for (const Site n : t.adjacency().neighbors(s)) add_residual(by_site[at(n)]);
    rms[at(s)] = count == 0 ? missing : std::sqrt(sum / count);
  }
  std::vector<double> result;
  for (const Site s : t.sites()) result.push_back(rms[at(s)]);
  return result;
}

}  // namespace

ErrorReport error_report(std::span<const double> residuals) {
  ErrorReport report;
  for (std::size_t row = 0; row < residuals.size(); ++row)
    add(report, residuals[row], static_cast<std::int64_t>(row));
  const auto count = static_cast<double>(report.count);  // 0 / 0: NaN
  report.mean /= count;
  report.rms = std::sqrt(report.rms / count);
  report.mean_abs /= count;
  if (report.count == 0) report.largest = missing;
  std::vector<double> values = present(residuals);
  report.robust_deviation = robust_center(values).deviation;
  for (double& v : values) v = std::abs(v);
  report.median_abs = quantile(values, 0.5);
  report.abs_90 = quantile(values, 0.9);
  report.abs_95 = quantile(values, 0.95);
  report.abs_99 = quantile(values, 0.99);
  return report;
}

std::vector<Outlier> find_outliers(const tripack::Triangulation& t,
                                   std::span<const double> row_values,
                                   const LeaveOneOut& left_out,
                                   const OutlierOptions& options) {
  return search(t, row_values, left_out, options);
}

std::vector<Outlier> find_outliers(const stripack::Triangulation& t,
                                   std::span<const double> row_values,
                                   const LeaveOneOut& left_out,
                                   const OutlierOptions& options) {
  return search(t, row_values, left_out, options);
}

std::vector<double> local_rms(const tripack::Triangulation& t,
                              std::span<const double> residuals) {
  return rms_around(t, residuals);
}

std::vector<double> local_rms(const stripack::Triangulation& t,
                              std::span<const double> residuals) {
  return rms_around(t, residuals);
}

}  // namespace delone::interp
