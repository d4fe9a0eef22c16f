#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/error.hpp"
#include "interp/cursor.hpp"
#include "interp/index.hpp"
#include "interp/operator.hpp"
#include "interp/operator_terms.hpp"
#include "interp/values.hpp"

namespace delone::interp {

/// The rows that stand for a site, each with an equal part of its weight. Throws Error
/// for a policy that is not linear in the data, if positions repeat.
class RowShares {
 public:
  template <class Triangulation>
  RowShares(const Triangulation& t, Duplicates policy)
      : RowShares(t.sites(), t.rows(), policy) {}

  [[nodiscard]] std::span<const delaunay::Node> of(delaunay::Site s) const noexcept {
    if (repeats_.offsets.empty()) return {&first_rows_[at(s)], 1};
    const std::span<const delaunay::Node> rows = repeats_.of(s);
    if (policy_ == Duplicates::first) return rows.first(1);
    return policy_ == Duplicates::last ? rows.last(1) : rows;
  }

 private:
  RowShares(std::span<const delaunay::Site> sites,
            std::span<const delaunay::Node> first_rows, Duplicates policy);

  std::span<const delaunay::Node> first_rows_;
  RowsOfSites repeats_;  // empty if no position repeats
  Duplicates policy_;
};

/// Rows of the matrix as one thread computes them, in any order of the targets.
class OperatorChunk {
 public:
  explicit OperatorChunk(std::size_t num_targets);
  /// Spreads the weights over rows, in ascending order, each row once.
  void append(std::int64_t target, std::span<const delaunay::Site> sites,
              std::span<const double> weights, const RowShares& shares);

  [[nodiscard]] std::int64_t num_weights() const noexcept { return std::ssize(columns_); }

 private:
  friend class OperatorAssembly;
  void sort_row(std::size_t begin);
  void merge_row(std::size_t begin);

  std::vector<std::int32_t> targets_, lengths_, columns_;
  std::vector<double> weights_;
};

/// Collects the chunks and makes one matrix of them.
class OperatorAssembly {
 public:
  /// `num_chunks`: how many will be kept. Throws Error for more than 2^31 targets.
  OperatorAssembly(std::size_t num_targets, delaunay::Node num_columns,
                   std::size_t num_chunks);
  /// From several threads, each number once. Throws Error once there are more than 2^31
  /// weights.
  void keep(std::size_t number, OperatorChunk chunk);
  /// Uses up the chunks, each freed when it is copied.
  [[nodiscard]] Operator finish(const RunOptions& run);

 private:
  void copy(OperatorChunk chunk, Operator::Matrix& matrix) const;

  std::int64_t num_targets_;
  delaunay::Node num_columns_;
  std::vector<OperatorChunk> chunks_;
  std::atomic<std::int64_t> num_weights_{0};
};

/// The operator of any interpolant that is linear in the data, by chunks of targets that
/// lie near one another: `make_rows()` gives for each chunk what computes its rows,
/// called as `rows(point, cursor)`, a target's weights by site (SiteTerms; by value, or
/// good until the next call). It may remember what neighbouring targets share. Chunks are
/// computed on several threads, each by one.
///
/// Targets are visited along a curve and in pieces that do not depend on the number of
/// threads; the result does not depend on either. `t` is the triangulation whose sites
/// the cursors walk on. Throws Error for more than 2^31 weights or targets; Cancelled.
/// Memory: the matrix twice (the pieces are freed one by one), and 16 bytes a target.
template <class Point, class MakeRows>
[[nodiscard]] Operator assemble_operator_in_chunks(
    std::span<const Point> targets, const delaunay::Adjacency& t, const RowShares& shares,
    delaunay::Node num_rows, const RunOptions& run, MakeRows make_rows) {
  constexpr std::int64_t ahead = 8;
  constexpr double part_for_terms = 0.9;  // of the progress
  OperatorAssembly assembly(
      targets.size(), num_rows,
      (targets.size() + at(CurveChunk::most) - 1) / at(CurveChunk::most));
  visit_along_curve(targets, run, {0, part_for_terms}, [&](const CurveChunk& chunk) {
    Cursor cursor = cursor_along_curve(t, chunk.place());
    OperatorChunk rows(at(chunk.size()));
    auto&& terms = make_rows();
    for (std::int64_t k = 0; k < chunk.size(); ++k) {
      if (k + ahead < chunk.size()) __builtin_prefetch(&targets[chunk[k + ahead]]);
      const auto& sum = terms(targets[chunk[k]], cursor);
      rows.append(static_cast<std::int64_t>(chunk[k]), sum.sites(), sum.weights(),
                  shares);
    }
    assembly.keep(at(chunk.number()), std::move(rows));
  });
  return assembly.finish(run);
}

/// The same where rows have nothing to remember: `terms(point, cursor)` gives a target's
/// weights, called from several threads.
template <class Point, class Terms>
[[nodiscard]] Operator assemble_operator(std::span<const Point> targets,
                                         const delaunay::Adjacency& t,
                                         const RowShares& shares, delaunay::Node num_rows,
                                         const RunOptions& run, Terms terms) {
  return assemble_operator_in_chunks(targets, t, shares, num_rows, run,
                                     [&]() -> Terms& { return terms; });
}

}  // namespace delone::interp
