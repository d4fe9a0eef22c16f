#pragma once

#include <optional>
#include <string>

#include "tripack/constrained_triangulation.hpp"

namespace delone::tripack {

/// Nothing if `t` is the canonical constrained Delaunay triangulation of its points and
/// segments, else one sentence that says what is violated and where. Exact.
///
/// Asked: every face counter-clockwise, the faces a tiling of the convex hull (see
/// delaunay/defect.hpp), every site used; the path of every segment made of constraints,
/// no other constraint, and its sites exactly on the segment, in order, unless it goes
/// through added vertices; on every other edge the in-circle test (perturbed); the
/// regions bounded by constraints only. O(n log n).
[[nodiscard]] std::optional<std::string> find_defect(const ConstrainedTriangulation& t);

}  // namespace delone::tripack
