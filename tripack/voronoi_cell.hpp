#pragma once

#include <span>
#include <vector>

#include "tripack/polygon_clip.hpp"
#include "tripack/region.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

/// The cell of a site inside a region with corners, in coordinates that begin at the
/// site: the region cut by the bisectors of all neighbours. Internal: use
/// tripack/voronoi.hpp.
///
/// O(d + r) for d neighbours and a convex region with r corners. If the region is not
/// convex O(d + k (k + r)), k the number of sides that the cell has in the box around
/// it.
[[nodiscard]] std::vector<Polygon> cut_cell(const Triangulation& t, Site s,
                                            const Region& region);

}  // namespace delone::tripack
