#include "interp/operator_assembly.hpp"

#include <limits>
#include <numeric>
#include <utility>

#include "delaunay/huge_pages.hpp"

namespace delone::interp {

namespace {

using delaunay::Node;
using delaunay::Site;

constexpr std::int64_t most = std::numeric_limits<int>::max();

bool is_linear(Duplicates policy) {
  return policy == Duplicates::mean || policy == Duplicates::first ||
         policy == Duplicates::last;
}

void check_size(std::int64_t count) {
  if (count > most)
    throw Error("the operator would have more than 2^31 weights; split the targets");
}

}  // namespace

RowShares::RowShares(std::span<const Site> sites, std::span<const Node> first_rows,
                     Duplicates policy)
    : first_rows_(first_rows), policy_(policy) {
  if (sites.size() == first_rows.size()) return;
  if (!is_linear(policy)) {
    throw Error(
        "some points have the same position: an operator needs mean, first or last for "
        "repeats");
  }
  repeats_ = rows_of_sites(sites, static_cast<Site>(first_rows.size()));
}

OperatorChunk::OperatorChunk(std::size_t num_targets) {
  targets_.reserve(num_targets);
  lengths_.reserve(num_targets);
  columns_.reserve(3 * num_targets);
  weights_.reserve(3 * num_targets);
}

void OperatorChunk::append(std::int64_t target, std::span<const Site> sites,
                           std::span<const double> weights, const RowShares& shares) {
  const std::size_t begin = columns_.size();
  for (std::size_t k = 0; k < sites.size(); ++k) {
    if (weights[k] == 0) continue;
    const std::span<const Node> rows = shares.of(sites[k]);
    const double weight = weights[k] / static_cast<double>(rows.size());
    for (const Node row : rows) {
      columns_.push_back(row);
      weights_.push_back(weight);
    }
  }
  sort_row(begin);
  merge_row(begin);
  targets_.push_back(static_cast<std::int32_t>(target));
  lengths_.push_back(static_cast<std::int32_t>(columns_.size() - begin));
}

// Within a row of the matrix Eigen wants ascending columns.
void OperatorChunk::sort_row(std::size_t begin) {
  constexpr std::size_t few = 24;
  const std::size_t end = columns_.size();
  if (end - begin > few) {
    std::vector<std::pair<std::int32_t, double>> entries;
    for (std::size_t i = begin; i < end; ++i)
      entries.emplace_back(columns_[i], weights_[i]);
    std::sort(entries.begin(), entries.end());
    for (std::size_t i = begin; i < end; ++i)
      std::tie(columns_[i], weights_[i]) = entries[i - begin];
    return;
  }
  for (std::size_t i = begin + 1; i < end; ++i) {
    const std::int32_t column = columns_[i];
    const double weight = weights_[i];
    std::size_t k = i;
    for (; k > begin && columns_[k - 1] > column; --k) {
      columns_[k] = columns_[k - 1];
      weights_[k] = weights_[k - 1];
    }
    columns_[k] = column;
    weights_[k] = weight;
  }
}

void OperatorChunk::merge_row(std::size_t begin) {
  std::size_t last = begin;
  for (std::size_t i = begin + 1; i < columns_.size(); ++i) {
    if (columns_[i] == columns_[last]) {
      weights_[last] += weights_[i];
    } else if (++last != i) {
      columns_[last] = columns_[i];
      weights_[last] = weights_[i];
    }
  }
  if (begin == columns_.size()) return;
  columns_.resize(last + 1);
  weights_.resize(last + 1);
}

OperatorAssembly::OperatorAssembly(std::size_t num_targets, Node num_columns,
                                   std::size_t num_chunks)
    : num_targets_(static_cast<std::int64_t>(num_targets)), num_columns_(num_columns) {
  check_size(num_targets_);
  chunks_.assign(num_chunks, OperatorChunk(0));
}

void OperatorAssembly::keep(std::size_t number, OperatorChunk chunk) {
  check_size(num_weights_ += chunk.num_weights());
  chunks_[number] = std::move(chunk);
}

Operator OperatorAssembly::finish(const RunOptions& run) {
  Operator::Matrix matrix(num_targets_, num_columns_);
  int* offsets = matrix.outerIndexPtr();
  for (const OperatorChunk& chunk : chunks_) {
    for (std::size_t i = 0; i < chunk.targets_.size(); ++i)
      offsets[chunk.targets_[i] + 1] = chunk.lengths_[i];
  }
  std::partial_sum(offsets, offsets + num_targets_ + 1, offsets);
  matrix.resizeNonZeros(num_weights_);
  delaunay::prefer_huge_pages(matrix.valuePtr(), at(num_weights_) * sizeof(double));
  delaunay::prefer_huge_pages(matrix.innerIndexPtr(), at(num_weights_) * sizeof(int));
  delaunay::parallel_chunks(
      std::ssize(chunks_), 1, run,
      [&](std::int64_t k, std::int64_t) { copy(std::move(chunks_[at(k)]), matrix); },
      {0.9, 1});
  // The sparse matrices of Eigen 3.4 have no move constructor; this is how they are
  // moved.
  return Operator(matrix.markAsRValue());
}

void OperatorAssembly::copy(OperatorChunk chunk, Operator::Matrix& matrix) const {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < chunk.targets_.size(); ++i) {
    const auto length = static_cast<std::size_t>(chunk.lengths_[i]);
    const int place = matrix.outerIndexPtr()[chunk.targets_[i]];
    std::copy_n(chunk.columns_.begin() + static_cast<std::ptrdiff_t>(begin), length,
                matrix.innerIndexPtr() + place);
    std::copy_n(chunk.weights_.begin() + static_cast<std::ptrdiff_t>(begin), length,
                matrix.valuePtr() + place);
    begin += length;
  }
}

}  // namespace delone::interp
