#pragma once

#include <vector>

#include "stripack/constrained_triangulation.hpp"

namespace delone::stripack {

/// A point strictly inside each hole: what the domain leaves out, but for the region
/// beyond the hull of points in a hemisphere. In degrees, and strictly inside as a
/// Direction made from them.
///
/// With the triangulation's points, its constraint_edges() and these holes,
/// Domain::enclosed without `outside` gives the same triangles. Sorted, and the same for
/// every order of points and arcs. None for Domain::hull.
///
/// Throws Error for a hole that is too narrow for a point of doubles in any of its
/// triangles. Cost: O(faces), nearly.
[[nodiscard]] std::vector<LonLat> hole_points(const ConstrainedTriangulation& t);

}  // namespace delone::stripack
