#pragma once

#include <cstddef>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "interp/c1_choices.hpp"
#include "interp/operator.hpp"

namespace delone::interp {

/// Columns of a matrix as if they were rows of observations.
class Columns {
 public:
  explicit Columns(delaunay::Node count) : numbers_(static_cast<std::size_t>(count)) {
    std::iota(numbers_.begin(), numbers_.end(), 0);
  }
  [[nodiscard]] std::span<const delaunay::Site> sites() const noexcept {
    return numbers_;
  }
  [[nodiscard]] std::span<const delaunay::Node> rows() const noexcept { return numbers_; }

 private:
  std::vector<delaunay::Node> numbers_;
};

/// The C1 surface with `options.choices`, for known gradients, as a matrix over the
/// unknowns of the sites: targets x 3 sites; 3 s is the value of site s, 3 s + 1 and 3 s
/// + 2 its gradient by scaled length along the axes of the node (Space::axes). The
/// weights of values sum to one in every row that is not empty. Policies of duplicates do
/// not matter. Errors and cost as c1_operator.
[[nodiscard]] Operator operator_on_unknowns(
    std::shared_ptr<const tripack::Triangulation> triangulation,
    std::span<const tripack::Point2> targets, const C1Options& options,
    const RunOptions& run);
[[nodiscard]] Operator operator_on_unknowns(
    std::shared_ptr<const stripack::Triangulation> triangulation,
    std::span<const stripack::Direction> targets, const C1Options& options,
    const RunOptions& run);

}  // namespace delone::interp
