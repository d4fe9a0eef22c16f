#pragma once

#include <span>

#include "delaunay/query_order.hpp"
#include "stripack/direction.hpp"

namespace delone::stripack {

/// Indices of the queries along a curve, with their keys. Throws Error if there are
/// too many (2^31).
[[nodiscard]] delaunay::Buffer<delaunay::KeyedRow> order_along_curve(
    std::span<const Direction> queries);

}  // namespace delone::stripack
