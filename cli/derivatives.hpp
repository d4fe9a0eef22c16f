#pragma once

#include <string>
#include <vector>

#include "cli/points.hpp"
#include "cli/reporter.hpp"
#include "cli/surface.hpp"
#include "interp/grid.hpp"
#include "io/grid_file.hpp"

namespace delone::cli {

/// First derivatives of the value at the positions of `queries`, and of c1 second ones
/// and the Laplacian: columns with names and units.
///
/// On the plane by x and y. On the globe towards east and north by kilometre, second ones
/// along geodesics by square kilometre, of the sphere or, --on ellipsoid, of WGS84; at a
/// pole east is the direction of 90 degrees east. NaN is missing. `units`: of the value.
[[nodiscard]] std::vector<io::GridVariable> derivatives_at(const Surface& surface,
                                                           const Points& points,
                                                           const std::string& units,
                                                           const Points& queries,
                                                           Reporter& reporter);

/// The same at the nodes of a grid.
[[nodiscard]] std::vector<io::GridVariable> derivatives_on(const Surface& surface,
                                                           const Points& points,
                                                           const std::string& units,
                                                           const interp::Grid& grid,
                                                           Reporter& reporter);

}  // namespace delone::cli
