#pragma once

#include "delaunay/triangle_quality.hpp"
#include "stripack/triangulation.hpp"

namespace delone::stripack {

using delaunay::TriangleQuality;

/// Edge lengths in great-circle kilometres, and the smallest angle of all triangles: that
/// of the flat triangle under the surface, which is the surface's own in the limit of
/// small triangles. O(n).
[[nodiscard]] TriangleQuality triangle_quality(const Triangulation& t);

/// The same with lengths of WGS84 geodesics; directions are geodetic latitudes.
[[nodiscard]] TriangleQuality triangle_quality_wgs84(const Triangulation& t);

}  // namespace delone::stripack
