#pragma once

#include "delaunay/triangle_quality.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

using delaunay::TriangleQuality;

/// Edge lengths in the unit of the coordinates, and the smallest angle of all triangles.
/// O(n).
[[nodiscard]] TriangleQuality triangle_quality(const Triangulation& t);

}  // namespace delone::tripack
