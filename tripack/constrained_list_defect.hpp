#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "tripack/constrained_triangulation.hpp"

namespace delone::tripack {

/// Nothing if `triangles` (of another program, say) is a constrained Delaunay
/// triangulation of the points, segments and domain of `t`, else one sentence that says
/// what is violated and where. Exact.
///
/// `triangles`: rows of `t`, of repeated points any one, either orientation, also mixed;
/// ties may be broken either way. Asked: the triangles tile the domain, every position in
/// it is a corner, every piece of the segments is a side, and on every other side the
/// in-circle test. Points on one line, or no domain: no triangles. O(n log n).
[[nodiscard]] std::optional<std::string> find_defect(
    const ConstrainedTriangulation& t, std::span<const std::array<Node, 3>> triangles);

}  // namespace delone::tripack
