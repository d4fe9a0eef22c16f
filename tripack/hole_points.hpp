#pragma once

#include <vector>

#include "tripack/constrained_triangulation.hpp"

namespace delone::tripack {

/// A point strictly inside each hole: what segments enclose and the domain leaves out.
///
/// A domain that was given by rings (Domain::even_odd) is written with them as a .poly
/// file, which names holes by points: with the triangulation's points, its
/// constraint_edges() and these holes, Domain::enclosed gives the same triangles. Sorted,
/// and the same for every order of points and segments. None for Domain::hull.
///
/// Throws Error for a hole that is too narrow for a point of doubles in any of its
/// triangles. Cost: O(faces), nearly.
[[nodiscard]] std::vector<Point2> hole_points(const ConstrainedTriangulation& t);

}  // namespace delone::tripack
