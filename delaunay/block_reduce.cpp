#include "delaunay/block_reduce.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

#include "delaunay/error.hpp"

namespace delone::delaunay {

namespace {

double middle(double a, double b) { return a / 2 + b / 2; }

double total_weight(std::span<const Weighted> numbers) {
  double sum = 0;
  for (const Weighted& n : numbers) sum += n.weight;
  return sum;
}

// `sorted` by value. Summing offsets from the least keeps a mean of equal values exact.
double mean(std::span<const Weighted> sorted) {
  const double least = sorted.front().value;
  double sum = 0, weight = 0;
  for (const Weighted& n : sorted) {
    sum += n.weight * (n.value - least);
    weight += n.weight;
  }
  return std::min(least + sum / weight, sorted.back().value);
}

double median(std::span<const Weighted> sorted) {
  const double half = total_weight(sorted) / 2;
  double weight = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    weight += sorted[i].weight;
    if (weight == half && i + 1 < sorted.size())
      return middle(sorted[i].value, sorted[i + 1].value);
    if (weight >= half) return sorted[i].value;
  }
  return sorted.back().value;
}

// The shortest of the intervals from each number to the first one beyond half the weight.
double mode(std::span<const Weighted> sorted) {
  const double half = total_weight(sorted) / 2;
  double shortest = std::numeric_limits<double>::infinity();
  std::vector<Weighted> middles;
  double weight = 0;
  for (std::size_t i = 0, end = 0; i < sorted.size(); ++i) {
    while (end < sorted.size() && weight < half) weight += sorted[end++].weight;
    if (weight < half) break;
    const double length = sorted[end - 1].value - sorted[i].value;
    if (length < shortest) middles.clear();
    if (length <= shortest)
      middles.push_back({middle(sorted[i].value, sorted[end - 1].value), 1});
    shortest = std::min(shortest, length);
    weight -= sorted[i].weight;
  }
  std::ranges::sort(middles, {}, &Weighted::value);
  return middles.empty() ? median(sorted) : mean(middles);
}

void check_options(const BlockOptions& options) {
  if (!(options.dx > 0) || !(options.dy > 0) || !std::isfinite(options.dx) ||
      !std::isfinite(options.dy))
    throw Error("the size of blocks must be positive");
  if (!options.region) return;
  const BlockRegion& r = *options.region;
  if (!(r.west < r.east) || !(r.south < r.north) || !std::isfinite(r.east - r.west) ||
      !std::isfinite(r.north - r.south))
    throw Error("the region of the blocks is empty; give west/east/south/north");
}

void check_column(std::span<const double> column, const std::string& name,
                  double least = -std::numeric_limits<double>::max()) {
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (std::isfinite(column[i]) && column[i] >= least) continue;
    const auto row = static_cast<std::int64_t>(i);
    throw Error("row " + std::to_string(row) + ": " + name + " is not a finite number" +
                    (least == 0 ? " of at least 0" : "") + "; remove the row",
                {row});
  }
}

void check_sizes(std::size_t num_rows, std::size_t size, const std::string& name) {
  if (size == 0 || size == num_rows) return;
  throw Error("there are " + std::to_string(size) + " " + name + " for " +
              std::to_string(num_rows) + " points; give one a point, or none");
}

// The number of the block along one axis; as a double, which has room for 2^53.
class Axis {
 public:
  Axis(double size, std::optional<std::array<double, 2>> ends)
      : origin_(ends ? (*ends)[0] : 0), size_(size), ends_(ends) {
    if (ends) last_ = std::max(0.0, std::ceil(((*ends)[1] - origin_) / size_) - 1);
  }
  [[nodiscard]] bool holds(double v) const {
    return !ends_ || ((*ends_)[0] <= v && v <= (*ends_)[1]);
  }
  [[nodiscard]] double block(double v) const {
    const double number = std::floor((v - origin_) / size_);
    if (!(std::abs(number) < 0x1p53))
      throw Error("blocks of " + std::to_string(size_) +
                  " are too many; take larger ones");
    return std::min(number, last_);
  }
  // With a region the last block may reach beyond it; its middle stays the block's.
  [[nodiscard]] double center(double block) const {
    return origin_ + (block + 0.5) * size_;
  }

 private:
  double origin_, size_, last_ = std::numeric_limits<double>::infinity();
  std::optional<std::array<double, 2>> ends_;
};

struct Item {
  double row, column;  // of the block
  std::size_t index;
};

class Reducer {
 public:
  Reducer(std::span<const double> x, std::span<const double> y,
          std::span<const double> values, std::span<const double> weights,
          const BlockOptions& options)
      : x_(x), y_(y), values_(values), weights_(weights), options_(options) {
    if (const auto& r = options.region) {
      columns_ = Axis(options.dx, std::array{r->west, r->east});
      rows_ = Axis(options.dy, std::array{r->south, r->north});
    }
  }

  [[nodiscard]] Blocks reduce_all() {
    const std::vector<Item> items = sorted_items();
    for (std::size_t begin = 0; begin < items.size();) {
      std::size_t end = begin + 1;
      while (end < items.size() && items[end].row == items[begin].row &&
             items[end].column == items[begin].column)
        ++end;
      add_block(std::span(items).subspan(begin, end - begin));
      begin = end;
    }
    return std::move(blocks_);
  }

 private:
  [[nodiscard]] double weight(std::size_t i) const {
    return weights_.empty() ? 1 : weights_[i];
  }

  [[nodiscard]] std::vector<Item> sorted_items() const {
    std::vector<Item> items;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (columns_.holds(x_[i]) && rows_.holds(y_[i]) && weight(i) > 0)
        items.push_back({rows_.block(y_[i]), columns_.block(x_[i]), i});
    }
    std::ranges::stable_sort(items, [](const Item& a, const Item& b) {
      return a.row != b.row ? a.row < b.row : a.column < b.column;
    });
    return items;
  }

  [[nodiscard]] double reduced(std::span<const Item> items,
                               std::span<const double> column) const {
    std::vector<Weighted> numbers;
    for (const Item& item : items)
      numbers.push_back({column[item.index], weight(item.index)});
    return reduce(numbers, options_.statistic);
  }

  void add_block(std::span<const Item> items) {
    const bool is_center = options_.position == BlockPosition::center;
    blocks_.x.push_back(is_center ? columns_.center(items[0].column)
                                  : reduced(items, x_));
    blocks_.y.push_back(is_center ? rows_.center(items[0].row) : reduced(items, y_));
    if (!values_.empty()) blocks_.value.push_back(reduced(items, values_));
    blocks_.count.push_back(std::ssize(items));
    std::vector<double> weights;
    for (const Item& item : items) weights.push_back(weight(item.index));
    std::ranges::sort(weights);  // a sum must not depend on the order of rows
    blocks_.weight.push_back(std::accumulate(weights.begin(), weights.end(), 0.0));
  }

  std::span<const double> x_, y_, values_, weights_;
  const BlockOptions& options_;
  Axis columns_{options_.dx, {}}, rows_{options_.dy, {}};
  Blocks blocks_;
};

}  // namespace

double reduce(std::span<Weighted> numbers, BlockStatistic statistic) {
  std::ranges::sort(numbers, [](const Weighted& a, const Weighted& b) {
    return a.value != b.value ? a.value < b.value : a.weight < b.weight;
  });
  if (statistic == BlockStatistic::mean) return mean(numbers);
  return statistic == BlockStatistic::median ? median(numbers) : mode(numbers);
}

Blocks block_reduce(std::span<const double> x, std::span<const double> y,
                    std::span<const double> values, std::span<const double> weights,
                    const BlockOptions& options) {
  check_options(options);
  if (x.size() != y.size()) throw Error("x and y differ in number");
  check_sizes(x.size(), values.size(), "values");
  check_sizes(x.size(), weights.size(), "weights");
  check_column(x, "x");
  check_column(y, "y");
  check_column(values, "the value");
  check_column(weights, "the weight", 0);
  return Reducer(x, y, values, weights, options).reduce_all();
}

}  // namespace delone::delaunay
