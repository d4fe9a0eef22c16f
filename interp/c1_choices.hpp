#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/c1_options.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// How a node's polynomial is made of fits of several degrees.
struct C1NodeChoice {
  /// Parts of the constant and of degrees 1 .. 3 (4): not negative, sum one. Where the
  /// gradient is known all but the constant have it, and nothing else is in degree 1.
  std::array<double, 5> parts{1, 0, 0, 0, 0};
  /// 0: the polynomial alone; towards 1 the surface nears the linear interpolant.
  double tension = 0;
  /// Exponent of the weights by which near nodes count more in the fits; above 0, at most
  /// 4. Smaller ones amplify values less.
  double nearness = 2;
};

/// All that a C1 surface otherwise chooses by its values. With it (C1Options::choices,
/// c1_operator) the surface is linear in the data: what is kept in bounds otherwise, the
/// rises of polynomials and the humps of edges, is then not.
struct C1Choices {
  FitDegree degree = FitDegree::cubic;
  std::vector<C1NodeChoice> nodes;  ///< one a site
  /// local; for polynomials that go on from gradients which are known: global (those of
  /// least curvature), or given (PlaneC1 with gradients, PlaneSmooth).
  Gradients gradients = Gradients::local;
};

/// Choices from where the nodes are, for all fields: the highest degree that the nodes
/// around determine and by which no value is amplified much.
///
/// A degree counts in full where, at the midpoints of edges and the centroids of
/// triangles around the node, its polynomial takes weights whose magnitudes add up to at
/// most 12. Where the highest degree does not, near nodes are made to count less, and if
/// that is of no avail it gives way, from 12 to 24, to the next lower one, and so down to
/// the constant, with which the node gets tension. So along tracks, at gaps and on
/// slivers the surface nears the linear one, and functions of a degree are reproduced
/// where it counts in full everywhere around. `options.tension` is the least tension of
/// every node (empty: none), `options.degree` the highest degree.
///
/// Gradients::global and given make choices for nodes whose gradients are known: weights
/// are counted that the polynomial takes beyond its gradient, and what gives way goes to
/// the gradient alone. Global gradients give way to the constant where, at these places,
/// they amplify independent errors of the values by more than 12 to 24; that is estimated
/// from 16 fields of fixed random signs.
///
/// Cost: some 20 microseconds a node. Throws Error as check(C1Options) (but for given
/// gradients) and for local bounds; Cancelled.
[[nodiscard]] std::shared_ptr<const C1Choices> c1_choices(
    const tripack::Triangulation& triangulation, const C1Options& options = {},
    const RunOptions& run = {});
[[nodiscard]] std::shared_ptr<const C1Choices> c1_choices(
    const stripack::Triangulation& triangulation, const C1Options& options = {},
    const RunOptions& run = {});

/// The choices that a surface with local gradients makes for one field, with its tension
/// or that of `options`: for fields that are like it. Degrees by which values of other
/// fields would be amplified too much (the limits are 200 and 400 here) give way all the
/// same. For that field the surface differs from the one that adapts to it where that is
/// kept in bounds. Cost: that surface's, and some 30 microseconds a node. Throws Error as
/// PlaneC1.
[[nodiscard]] std::shared_ptr<const C1Choices> c1_choices(
    const std::shared_ptr<const tripack::Triangulation>& triangulation,
    std::span<const double> row_values, const C1Options& options = {},
    const RunOptions& run = {});
[[nodiscard]] std::shared_ptr<const C1Choices> c1_choices(
    const std::shared_ptr<const stripack::Triangulation>& triangulation,
    std::span<const double> row_values, const C1Options& options = {},
    const RunOptions& run = {});

}  // namespace delone::interp
