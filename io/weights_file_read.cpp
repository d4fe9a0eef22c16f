#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "io/fields.hpp"
#include "io/netcdf_source.hpp"
#include "io/table.hpp"
#include "io/weights_file.hpp"
#include "io/weights_layout.hpp"

namespace delone::io {
namespace {

using interp::Operator;

/// An entry of the matrix, numbered from 0.
struct Links {
  std::vector<std::int32_t> targets, sources;
  std::vector<double> weights;
};

class WeightsReader {
 public:
  explicit WeightsReader(const NetcdfSource& file)
      : file_(file), layout_(find_layout(file)) {}

  [[nodiscard]] WeightsFile read() const {
    const std::vector<double> weights = read_weights();
    const std::int64_t num_links = std::ssize(weights);
    WeightsSide source = read_side(layout_.source), target = read_side(layout_.target);
    const std::int64_t num_sources = size(layout_.source, source, num_links),
                       num_targets = size(layout_.target, target, num_links);
    check_sizes(layout_.source, source, num_sources);
    check_sizes(layout_.target, target, num_targets);
    std::vector<double> fraction = optional_values(layout_.target.fraction);
    check_length(layout_.target.fraction, fraction.size(), num_targets);
    const Links links{read_indices(layout_.target_index, num_links, num_targets),
                      read_indices(layout_.source_index, num_links, num_sources),
                      weights};
    return {.weights = assembled(links, num_targets, num_sources),
            .source = std::move(source),
            .target = std::move(target),
            .fraction = std::move(fraction),
            .title = file_.text(NC_GLOBAL, "title"),
            .map_method = method(),
            .normalization = file_.text(NC_GLOBAL, "normalization")};
  }

 private:
  static const WeightsNames& find_layout(const NetcdfSource& file) {
    for (const WeightsNames* layout : {&esmf_names, &scrip_names}) {
      if (file.find_variable(layout->weight) &&
          file.find_variable(layout->source_index) &&
          file.find_variable(layout->target_index))
        return *layout;
    }
    file.fail(
        "no weights: neither S, row and col (ESMF) nor remap_matrix, src_address and "
        "dst_address (SCRIP); name a weight file");
  }

  /// In the layout of SCRIP map_method is one of a few words.
  [[nodiscard]] std::string method() const {
    const std::string own = file_.text(NC_GLOBAL, "method");
    return own.empty() ? file_.text(NC_GLOBAL, "map_method") : own;
  }

  [[nodiscard]] std::string quoted(const char* name) const {
    return "variable '" + std::string(name) + "'";
  }

  [[nodiscard]] std::vector<double> values(const char* name, std::size_t rank) const {
    const int variable = *file_.find_variable(name);
    if (!is_numeric(file_.type(variable))) file_.fail(quoted(name) + " holds no numbers");
    if (file_.dimensions(variable).size() != rank) {
      file_.fail(quoted(name) + " has not " + std::to_string(rank) +
                 (rank == 1 ? " dimension" : " dimensions"));
    }
    return file_.values(variable);
  }
  [[nodiscard]] std::vector<double> optional_values(const char* name) const {
    return file_.find_variable(name) ? values(name, 1) : std::vector<double>{};
  }

  // SCRIP has a second dimension for the weights of a link: more than one for gradients.
  [[nodiscard]] std::vector<double> read_weights() const {
    const auto rank = file_.dimensions(*file_.find_variable(layout_.weight)).size();
    if (rank == 2) {
      const std::size_t num_weights =
          file_.dimensions(*file_.find_variable(layout_.weight))[1].size;
      if (num_weights != 1) {
        file_.fail(quoted(layout_.weight) + " has " + std::to_string(num_weights) +
                   " weights a link; make the file with a method of first order");
      }
    }
    std::vector<double> weights = values(layout_.weight, rank == 2 ? 2 : 1);
    if (weights.size() > std::numeric_limits<std::int32_t>::max())
      file_.fail("more than 2^31 weights; split the targets");
    check_finite(layout_.weight, weights);
    return weights;
  }

  void check_finite(const char* name, std::span<const double> numbers) const {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!std::isfinite(numbers[i]))
        file_.fail(quoted(name) + ": entry " + std::to_string(i + 1) + " is not finite");
    }
  }

  void check_length(const char* name, std::size_t length, std::int64_t wanted) const {
    if (length == 0 || static_cast<std::int64_t>(length) == wanted) return;
    file_.fail(quoted(name) + " has " + std::to_string(length) + " entries where " +
               std::to_string(wanted) + " are due");
  }

  [[nodiscard]] std::vector<std::int32_t> read_indices(const char* name,
                                                       std::int64_t num_links,
                                                       std::int64_t size) const {
    const std::vector<double> numbers = values(name, 1);
    if (std::ssize(numbers) != num_links) {
      file_.fail(quoted(name) + " has " + std::to_string(numbers.size()) +
                 " entries for " + std::to_string(num_links) + " weights");
    }
    std::vector<std::int32_t> result;
    result.reserve(numbers.size());
    for (const double number : numbers) {
      if (!(number >= 1 && number <= static_cast<double>(size)) ||
          number != std::floor(number)) {
        file_.fail(quoted(name) + ": entry " + std::to_string(result.size() + 1) +
                   " is not a number of 1 to " + std::to_string(size) +
                   "; the file is damaged or for other grids");
      }
      result.push_back(static_cast<std::int32_t>(number) - 1);
    }
    return result;
  }

  [[nodiscard]] WeightsSide read_side(const WeightsSideNames& names) const {
    WeightsSide side;
    for (const double n : optional_values(names.shape)) {
      if (!(n >= 0 && n <= std::numeric_limits<std::int32_t>::max()))
        file_.fail(quoted(names.shape) + " is negative or too large");
      side.shape.push_back(static_cast<std::int32_t>(n));
    }
    for (const double m : optional_values(names.mask))
      side.mask.push_back(m == 0 ? 0 : 1);
    side.x = optional_values(names.x);
    side.y = optional_values(names.y);
    if (side.x.empty() || side.y.empty()) {
      side.x.clear();
      side.y.clear();
      return side;
    }
    check_finite(names.x, side.x);
    check_finite(names.y, side.y);
    read_units(names, side);
    return side;
  }

  void read_units(const WeightsSideNames& names, WeightsSide& side) const {
    const std::string units =
        to_lower(file_.text(*file_.find_variable(names.x), "units"));
    const bool is_radian = units.starts_with("radian");
    if (!is_radian && !units.starts_with("degree")) {
      side.units = units;
      return;
    }
    side.space = Mesh::Space::globe;
    if (!is_radian) return;
    for (std::vector<double>* c : {&side.x, &side.y}) {
      for (double& v : *c) v *= 180 / std::numbers::pi;
    }
  }

  /// How many points a side has. What nothing but a header claims may not exceed the
  /// weights by more than masks could explain.
  [[nodiscard]] std::int64_t size(const WeightsSideNames& names, const WeightsSide& side,
                                  std::int64_t num_links) const {
    constexpr double most_a_link = 1024, always = 1 << 24;
    double claimed = 1;
    if (const auto dimension = file_.dimension_size(names.size)) {
      claimed = static_cast<double>(*dimension);
    } else if (!side.shape.empty()) {
      for (const std::int32_t n : side.shape) claimed *= n;
    } else {
      file_.fail(std::string("the number of ") + names.what + " points (dimension '" +
                 names.size + "') is missing");
    }
    const bool is_plausible =
        !side.x.empty() ||
        claimed <= always + most_a_link * static_cast<double>(num_links);
    if (!is_plausible || claimed > std::numeric_limits<std::int32_t>::max() - 1) {
      file_.fail(std::string("the number of ") + names.what + " points, " +
                 std::to_string(static_cast<std::int64_t>(std::min(claimed, 9e18))) +
                 ", is too large for this file");
    }
    return static_cast<std::int64_t>(claimed);
  }

  // A shape that does not fit is that of a grid of corners or cells: a list then.
  void check_sizes(const WeightsSideNames& names, WeightsSide& side,
                   std::int64_t size) const {
    check_length(names.x, side.x.size(), size);
    check_length(names.y, side.y.size(), size);
    check_length(names.mask, side.mask.size(), size);
    double product = 1;
    for (const std::int32_t n : side.shape) product *= n;
    if (product != static_cast<double>(size) || side.shape.size() < 2) side.shape.clear();
  }

  [[nodiscard]] Operator assembled(const Links& links, std::int64_t num_targets,
                                   std::int64_t num_sources) const {
    std::vector<std::int32_t> offsets(static_cast<std::size_t>(num_targets) + 1);
    for (const std::int32_t target : links.targets)
      ++offsets[static_cast<std::size_t>(target) + 1];
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<std::int32_t> next(offsets.begin(), offsets.end() - 1);
    std::vector<std::pair<std::int32_t, double>> entries(links.weights.size());
    for (std::size_t k = 0; k < links.weights.size(); ++k) {
      const auto target = static_cast<std::size_t>(links.targets[k]);
      entries[static_cast<std::size_t>(next[target]++)] = {links.sources[k],
                                                           links.weights[k]};
    }
    Operator::Matrix matrix(num_targets, num_sources);
    matrix.reserve(static_cast<Eigen::Index>(entries.size()));
    for (std::int32_t i = 0; i < num_targets; ++i) {
      const auto begin = entries.begin() + offsets[static_cast<std::size_t>(i)],
                 end = entries.begin() + offsets[static_cast<std::size_t>(i) + 1];
      std::sort(begin, end);
      matrix.startVec(i);
      for (auto entry = begin; entry != end; ++entry) {
        if (entry != begin && entry->first == (entry - 1)->first) {
          matrix.valuePtr()[matrix.data().size() - 1] += entry->second;
        } else {
          matrix.insertBack(i, entry->first) = entry->second;
        }
      }
    }
    matrix.finalize();
    return Operator(matrix.markAsRValue());
  }

  const NetcdfSource& file_;
  const WeightsNames& layout_;
};

}  // namespace

WeightsFile read_weights(const std::string& path) {
  const NetcdfSource file(path);
  return WeightsReader(file).read();
}

}  // namespace delone::io
