#pragma once

#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/blend_space.hpp"
#include "interp/spot.hpp"

namespace delone::interp {

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
