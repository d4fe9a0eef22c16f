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
/// SlopeLimit::positions: bounds four times as high, for the steepest gradient that any
/// values with these steepest ways and largest differences could have; then gradients are
/// linear in the values.
///
/// `scale`: as PlaneView has it. O(n) for bounded degrees; O(k^2) for a site of degree k
/// up to 64.
[[nodiscard]] std::vector<PlaneView::Slope> natural_gradients(
    const tripack::Triangulation& t, double scale, std::span<const double> site_values,
    SlopeLimit limit = SlopeLimit::values);
[[nodiscard]] std::vector<SphereView::Slope> natural_gradients(
    const stripack::Triangulation& t, double scale, std::span<const double> site_values,
    SlopeLimit limit = SlopeLimit::values);

/// What the gradient at a site with SlopeLimit::positions takes from the rise to each of
/// its neighbours, in the order of its list.
[[nodiscard]] std::vector<PlaneView::Slope> natural_slope_weights(
    const tripack::Triangulation& t, double scale, Site site);
[[nodiscard]] std::vector<SphereView::Slope> natural_slope_weights(
    const stripack::Triangulation& t, double scale, Site site);

/// A site and its neighbours, counter-clockwise; of a boundary site from one boundary
/// neighbour to the other.
struct SiteStar {
  delaunay::Site site = delaunay::none;
  std::span<const delaunay::Site> neighbors;
  bool is_boundary = false;
};

/// The same for one site whose neighbours are given: those that it has in another
/// triangulation of these sites, without some of them.
[[nodiscard]] PlaneView::Slope natural_gradient(const tripack::Triangulation& t,
                                                double scale,
                                                std::span<const double> site_values,
                                                const SiteStar& star);
[[nodiscard]] SphereView::Slope natural_gradient(const stripack::Triangulation& t,
                                                 double scale,
                                                 std::span<const double> site_values,
                                                 const SiteStar& star);

}  // namespace delone::interp
