#include "interp/operator.hpp"

#include <limits>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/plane_cells.hpp"
#include "interp/sphere_cells.hpp"

namespace delone::interp {

namespace {

using Matrix = Operator::Matrix;

// The rows that stand for a site, each with an equal part of its weight.
class RowShares {
 public:
  template <class Triangulation>
  RowShares(const Triangulation& t, Duplicates policy)
      : rows_(rows_of_sites(t.sites(), t.num_sites())), policy_(policy) {
    const bool is_linear = policy == Duplicates::mean || policy == Duplicates::first ||
                           policy == Duplicates::last;
    if (t.num_rows() == t.num_sites() || is_linear) return;
    throw Error(
        "some points have the same position: an operator needs mean, first or last for "
        "repeats");
  }

  [[nodiscard]] std::span<const Node> of(Site s) const noexcept {
    const std::span<const Node> rows = rows_.of(s);
    if (policy_ == Duplicates::first) return rows.first(1);
    return policy_ == Duplicates::last ? rows.last(1) : rows;
  }

 private:
  RowsOfSites rows_;
  Duplicates policy_;
};

std::int64_t num_weights(std::span<const Combination> targets, const RowShares& shares) {
  std::int64_t count = 0;
  for (const Combination& target : targets) {
    for (const Site s : target.sites())
      count += static_cast<std::int64_t>(shares.of(s).size());
  }
  return count;
}

// Within a row of the matrix Eigen wants ascending columns.
void append_row(Matrix& matrix, int target, const Combination& combination,
                const RowShares& shares) {
  std::vector<std::pair<Node, double>> entries;
  for (std::size_t k = 0; k < combination.sites().size(); ++k) {
    const std::span<const Node> rows = shares.of(combination.sites()[k]);
    const double weight = combination.weights()[k] / static_cast<double>(rows.size());
    if (weight == 0) continue;
    for (const Node row : rows) entries.emplace_back(row, weight);
  }
  std::sort(entries.begin(), entries.end());
  matrix.startVec(target);
  for (const auto& [row, weight] : entries) matrix.insertBack(target, row) = weight;
}

Operator assemble(std::span<const Combination> targets, const RowShares& shares,
                  Node num_rows) {
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  const std::int64_t count = num_weights(targets, shares);
  if (count > most || static_cast<std::int64_t>(targets.size()) > most) {
    throw Error("the operator would have more than 2^31 weights; split the targets");
  }
  Matrix matrix(static_cast<Eigen::Index>(targets.size()), num_rows);
  matrix.reserve(count);
  for (std::size_t i = 0; i < targets.size(); ++i)
    append_row(matrix, static_cast<int>(i), targets[i], shares);
  matrix.finalize();
  // The sparse matrices of Eigen 3.4 have no move constructor; this is how they are
  // moved.
  return Operator(matrix.markAsRValue());
}

template <class Cells, class Triangulation, class Point>
Operator make_operator(std::shared_ptr<const Triangulation> triangulation,
                       std::span<const Point> targets, const SurfaceOptions& options,
                       const RunOptions& run) {
  const RowShares shares(*triangulation, options.duplicates);
  const Cells cells(triangulation, {}, options);
  const std::vector<Combination> combinations = evaluate_along_curve<Combination>(
      targets, triangulation->adjacency(), run,
      [&](const Point& p, Cursor& cursor) { return cells.combination(p, cursor); });
  return assemble(combinations, shares, triangulation->num_rows());
}

}  // namespace

Operator::Operator(Matrix matrix) {
  matrix_.swap(matrix);
  matrix_.makeCompressed();
}

std::vector<double> Operator::apply(std::span<const double> row_values) const {
  if (static_cast<Eigen::Index>(row_values.size()) != matrix_.cols()) {
    throw Error("there are " + std::to_string(row_values.size()) + " values for " +
                std::to_string(matrix_.cols()) + " points; give one value a point");
  }
  std::vector<double> result(static_cast<std::size_t>(matrix_.rows()),
                             std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < matrix_.rows(); ++i) {
    Matrix::InnerIterator term(matrix_, i);
    if (!term) continue;
    double sum = 0;
    for (; term; ++term) sum += term.value() * row_values[at(term.col())];
    result[at(i)] = sum;
  }
  return result;
}

Operator linear_operator(std::shared_ptr<const tripack::Triangulation> triangulation,
                         std::span<const tripack::Point2> targets,
                         const SurfaceOptions& options, const RunOptions& run) {
  return make_operator<PlaneCells>(std::move(triangulation), targets, options, run);
}

Operator linear_operator(std::shared_ptr<const stripack::Triangulation> triangulation,
                         std::span<const stripack::Direction> targets,
                         const SurfaceOptions& options, const RunOptions& run) {
  return make_operator<SphereCells>(std::move(triangulation), targets, options, run);
}

}  // namespace delone::interp
