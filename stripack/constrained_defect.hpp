#pragma once

#include <optional>
#include <string>

#include "stripack/constrained_triangulation.hpp"

namespace delone::stripack {

/// Nothing if `t` is the canonical constrained Delaunay triangulation of its points and
/// arcs, else one sentence that says what is violated and where. Exact. Asked is what
/// tripack's check asks. O(n log n).
[[nodiscard]] std::optional<std::string> find_defect(const ConstrainedTriangulation& t);

}  // namespace delone::stripack
