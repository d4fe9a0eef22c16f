#pragma once

#include <span>
#include <vector>

#include "interp/natural_view.hpp"

namespace delone::interp {

/// Gradients at the sites of a triangulation with triangles, fitted to the values of the
/// natural neighbours.
///
/// Least squares for z_j - z_i = g . (x_j - x_i), weighted with the area that removing
/// site i gives to j, over the squared distance (Sibson 1981): exact for linear
/// functions, and for values of a + b . x + c |x|^2 at interior sites. On the sphere in
/// the stereographic plane at the site. Sites with more than 64 neighbours: weights are
/// the parts of the site's own cell beside its neighbours instead; boundary sites, whose
/// cells are not bounded: one over the squared distance. Where the neighbours are on a
/// line up to rounding the gradient is along it. No gradient is steeper than 4 times the
/// steepest way to a neighbour, nor rises over the distance of the farthest neighbour by
/// more than 16 times the largest difference to one: so neither nearly collinear
/// neighbours nor very near ones make the surface explode.
///
/// `scale`: as PlaneView has it. O(n) for bounded degrees; O(k^2) for a site of degree k
/// up to 64.
[[nodiscard]] std::vector<PlaneView::Slope> natural_gradients(
    const tripack::Triangulation& t, double scale, std::span<const double> site_values);
[[nodiscard]] std::vector<SphereView::Slope> natural_gradients(
    const stripack::Triangulation& t, double scale, std::span<const double> site_values);

}  // namespace delone::interp
