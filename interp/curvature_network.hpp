#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/options.hpp"

namespace delone::interp {

/// Gradients of least curvature: those for which the cubic Hermite curves over the edges
/// of a network have the least sum of
///
///   area / length^(5/2) x the integral of the squared second derivative,
///
/// the area being that of the triangles beside the edge. Area / length alone would be a
/// quadrature of the curvature of the surface; the further power gives short edges more
/// say, which predicts better.
///
/// The system is sparse, symmetric and positive definite. In coordinates in which every
/// node's own 2 x 2 block is the unit matrix, its eigenvalues lie between 1/2 and 3/2,
/// whatever the positions: an edge couples its ends by half of what it adds to their
/// blocks. So Chebyshev's iteration gains a factor of 3.7 a step on every set, without
/// inner products, in which clusters would drown what lies between them.
///
/// Source of the principle: G. M. Nielson, A method for interpolating scattered data
/// based upon a minimum norm network, Math. Comp. 40 (1983) 253-271.
class CurvatureNetwork {
 public:
  /// Components in the coordinates of a node's tangent plane.
  using Tangent = std::array<double, 2>;

  /// An edge as one of its ends sees it.
  struct End {
    std::int32_t reverse = 0;  ///< number of the other end
    Tangent direction{};       ///< towards the other end, unit
    double weight = 0;         ///< of both ends
    double slope = 0;          ///< rise towards the other end by length
  };

  /// The ends at node v are `ends[offsets[v]] .. ends[offsets[v + 1] - 1]`.
  CurvatureNetwork(std::vector<std::int32_t> offsets, std::vector<End> ends)
      : offsets_(std::move(offsets)), ends_(std::move(ends)) {}

  /// In so many steps; 24 leave 1e-14 of the error. O(edges) a step.
  [[nodiscard]] std::vector<Tangent> solve(int num_steps, const RunOptions& run) &&;

  /// The network in the coordinates in which its blocks are unit matrices, for many sets
  /// of slopes: what `gradients` and `slope_weights` need.
  [[nodiscard]] CurvatureNetwork in_unit_coordinates(const RunOptions& run) &&;
  /// What solve() gives with these slopes, one an end, up to rounding.
  [[nodiscard]] std::vector<Tangent> gradients(std::span<const double> slopes,
                                               int num_steps,
                                               const RunOptions& run) const;
  /// The transpose: from weights of the gradients to those of the slopes.
  [[nodiscard]] std::vector<double> slope_weights(std::vector<Tangent> gradient_weights,
                                                  int num_steps,
                                                  const RunOptions& run) const;

  [[nodiscard]] std::size_t num_nodes() const noexcept { return offsets_.size() - 1; }
  [[nodiscard]] const std::vector<std::int32_t>& offsets() const noexcept {
    return offsets_;
  }
  /// In unit coordinates their directions, by the root of their weight.
  [[nodiscard]] const std::vector<End>& ends() const noexcept { return ends_; }
  /// Weights of the gradient of a node in unit coordinates, from those of the gradient.
  [[nodiscard]] Tangent to_unit_weights(std::size_t node,
                                        const Tangent& weights) const noexcept {
    const Factor& f = factors_[node];
    if (!(f.first > 0 && f.second > 0)) return {};
    return {weights[0] / f.first,
            (weights[1] - f.cross * (weights[0] / f.first)) / f.second};
  }

 private:
  /// Rows of the factor of a 2 x 2 block: (first, 0), (cross, second).
  struct Factor {
    double first = 0, cross = 0, second = 0;
  };

  void make_blocks_unit(const RunOptions& run);
  /// By Chebyshev's iteration; the matrix and what is done are symmetric.
  [[nodiscard]] std::vector<Tangent> iterated(std::vector<Tangent> right, int num_steps,
                                              const RunOptions& run) const;
  [[nodiscard]] std::vector<Tangent> out_of_unit_coordinates(std::vector<Tangent> x,
                                                             double unit,
                                                             const RunOptions& run) const;
  [[nodiscard]] std::vector<Tangent> right_side(const RunOptions& run) const;
  [[nodiscard]] std::vector<Tangent> product(const std::vector<Tangent>& x,
                                             const RunOptions& run) const;
  template <class Body>
  void for_each_node(const RunOptions& run, Body body) const;

  std::vector<std::int32_t> offsets_;
  std::vector<End> ends_;
  std::vector<Factor> factors_;
  double unit_ = 1;  ///< of slopes
};

}  // namespace delone::interp
