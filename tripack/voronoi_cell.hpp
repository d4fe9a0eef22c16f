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
[[nodiscard]] std::vector<Polygon> cut_cell(const Triangulation& t, Site s,
                                            const Region& region);

}  // namespace delone::tripack
