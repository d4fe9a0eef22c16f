#pragma once

#include <array>
#include <cstdint>
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

 private:
  /// Rows of the factor of a 2 x 2 block: (first, 0), (cross, second).
  struct Factor {
    double first = 0, cross = 0, second = 0;
  };

  void make_blocks_unit(const RunOptions& run);
  [[nodiscard]] std::vector<Tangent> right_side(const RunOptions& run) const;
  [[nodiscard]] std::vector<Tangent> product(const std::vector<Tangent>& x,
                                             const RunOptions& run) const;
  template <class Body>
  void for_each_node(const RunOptions& run, Body body) const;
  [[nodiscard]] std::size_t num_nodes() const noexcept { return offsets_.size() - 1; }

  std::vector<std::int32_t> offsets_;
  std::vector<End> ends_;
  std::vector<Factor> factors_;
  double unit_ = 1;  ///< of slopes
};

}  // namespace delone::interp
