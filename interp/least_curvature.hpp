#pragma once

#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/blend_space.hpp"
#include "interp/curvature_network.hpp"
#include "interp/spot.hpp"

namespace delone::interp {

/// Steps of the iteration over all sites.
inline constexpr int num_curvature_steps = 24;

/// The network of all edges, in unit coordinates; an end has the number of its arc.
struct CurvatureNetworkOfSites {
  CurvatureNetwork network;
  /// Of every end one over its (scaled) length, 0 where the edge says nothing of slopes.
  std::vector<double> inverse_lengths;
};
template <BlendSpace Space>
[[nodiscard]] CurvatureNetworkOfSites curvature_network_of(
    const Space& space, const typename Space::Triangulation& triangulation,
    const RunOptions& run);

/// Gradients of least curvature (CurvatureNetwork) at all sites: tangent vectors by
/// scaled length. O(sites).
template <BlendSpace Space>
[[nodiscard]] std::vector<typename Space::Vector> least_curvature_gradients(
    const Space& space, const typename Space::Triangulation& triangulation,
    std::span<const double> site_values, const RunOptions& run);

/// The same at some sites once another is removed, in whose place lies a triangle or edge
/// of these sites: from the network of the nodes around, which tells nearly as much as
/// the whole.
template <BlendSpace Space>
[[nodiscard]] std::vector<typename Space::Vector> least_curvature_gradients_without(
    Site removed, std::span<const Site> corners, const Space& space,
    const typename Space::Triangulation& triangulation,
    std::span<const double> site_values);

}  // namespace delone::interp
