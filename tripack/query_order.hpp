#pragma once

#include <span>

#include "delaunay/query_order.hpp"
#include "tripack/point.hpp"

namespace delone::tripack {

/// Indices of the queries along a curve, with their keys. Throws Error naming the row of
/// a query that is not finite, or if there are too many (2^31).
[[nodiscard]] delaunay::Buffer<delaunay::KeyedRow> order_along_curve(
    std::span<const Point2> queries);

}  // namespace delone::tripack
