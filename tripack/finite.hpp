#pragma once

#include <span>
#include <string>

#include "tripack/point.hpp"

namespace delone::tripack {

/// Throws Error, which names the first of the points that has a coordinate that is not
/// finite: as `what` (row, query) and its number.
void check_finite(std::span<const Point2> points, const std::string& what);

}  // namespace delone::tripack
