#pragma once

#include <optional>

#include "tripack/point.hpp"
#include "tripack/predicate_filters.hpp"

/// The exact rungs of the planar predicates. Internal: use tripack/predicates.hpp.
namespace delone::tripack {

/// Exact in 128 bits, or nothing if the differences do not fit into 61 bits on a
/// common scale.
[[nodiscard]] std::optional<int> orientation_integer(Point2 a, Point2 b,
                                                     Point2 c) noexcept;
/// Exact for all finite doubles.
[[nodiscard]] int orientation_exact(Point2 a, Point2 b, Point2 c) noexcept;

/// Exact in 256 bits, or nothing if the differences do not fit into 61 bits on a
/// common scale.
[[nodiscard]] std::optional<int> in_circle_integer(Point2 a, Point2 b, Point2 c,
                                                   Point2 p) noexcept;
/// Exact for all finite doubles.
[[nodiscard]] int in_circle_exact(Point2 a, Point2 b, Point2 c, Point2 p) noexcept;

}  // namespace delone::tripack
