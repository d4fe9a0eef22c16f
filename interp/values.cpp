#include "interp/values.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "delaunay/error.hpp"

namespace delone::interp {

namespace {

using delaunay::Node;
using delaunay::Site;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

void check(std::span<const Site> sites, std::span<const double> row_values) {
  if (sites.size() != row_values.size()) {
    throw Error("there are " + std::to_string(row_values.size()) + " values for " +
                std::to_string(sites.size()) + " points; give one value a point");
  }
  for (std::size_t i = 0; i < row_values.size(); ++i) {
    if (std::abs(row_values[i]) <= value_max) continue;
    const auto row = static_cast<std::int64_t>(i);
    const std::string fault = std::isfinite(row_values[i])
                                  ? "the value is larger than 3e150; scale the values"
                                  : "the value is not a finite number; remove the row";
    throw Error("row " + std::to_string(row) + ": " + fault, {row});
  }
}

// `sorted` ascending. Summing offsets from the smallest keeps a mean of equal values
// exact.
double mean(std::span<const double> sorted) {
  double sum = 0;
  for (const double v : sorted) sum += v - sorted.front();
  return std::min(sorted.front() + sum / static_cast<double>(sorted.size()),
                  sorted.back());
}

double median(std::span<const double> sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : mean(sorted.subspan(half - 1, 2));
}

void check_equal(std::span<const Node> rows, std::span<const double> row_values) {
  for (const Node row : rows) {
    if (row_values[at(row)] == row_values[at(rows[0])]) continue;
    throw Error("rows " + std::to_string(rows[0]) + " and " + std::to_string(row) +
                    " have the same position but different values; choose what to do "
                    "with repeats",
                {rows[0], row});
  }
}

double merged(std::span<const Node> rows, std::span<const double> row_values,
              Duplicates policy) {
  if (policy == Duplicates::first) return row_values[at(rows.front())];
  if (policy == Duplicates::last) return row_values[at(rows.back())];
  if (policy == Duplicates::error) {
    check_equal(rows, row_values);
    return row_values[at(rows.front())];
  }
  std::vector<double> sorted(rows.size());
  std::transform(rows.begin(), rows.end(), sorted.begin(),
                 [&](Node r) { return row_values[at(r)]; });
  std::sort(sorted.begin(), sorted.end());
  if (policy == Duplicates::min) return sorted.front();
  if (policy == Duplicates::max) return sorted.back();
  return policy == Duplicates::mean ? mean(sorted) : median(sorted);
}

}  // namespace

RowsOfSites rows_of_sites(std::span<const Site> sites, Site num_sites) {
  RowsOfSites result{std::vector<std::int32_t>(at(num_sites) + 1),
                     std::vector<Node>(sites.size())};
  for (const Site s : sites) ++result.offsets[at(s) + 1];
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  std::vector<std::int32_t> next(result.offsets.begin(), result.offsets.end() - 1);
  for (std::size_t row = 0; row < sites.size(); ++row) {
    result.rows[at(next[at(sites[row])]++)] = static_cast<Node>(row);
  }
  return result;
}

std::vector<double> values_at_sites(std::span<const Site> sites, Site num_sites,
                                    std::span<const double> row_values,
                                    Duplicates policy) {
  check(sites, row_values);
  std::vector<double> values(at(num_sites));
  for (std::size_t row = 0; row < sites.size(); ++row)
    values[at(sites[row])] = row_values[row];
  if (sites.size() == values.size()) return values;
  const RowsOfSites rows = rows_of_sites(sites, num_sites);
  for (Site s = 0; s < num_sites; ++s) {
    if (rows.of(s).size() > 1) values[at(s)] = merged(rows.of(s), row_values, policy);
  }
  return values;
}

}  // namespace delone::interp
