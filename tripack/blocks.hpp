#pragma once

#include <span>

#include "delaunay/block_reduce.hpp"
#include "tripack/point.hpp"

namespace delone::tripack {

using delaunay::BlockOptions;
using delaunay::BlockPosition;
using delaunay::BlockRegion;
using delaunay::Blocks;
using delaunay::BlockStatistic;

/// Block mean, median or mode of observations in the plane: see
/// delaunay/block_reduce.hpp.
[[nodiscard]] Blocks block_reduce(std::span<const Point2> points,
                                  std::span<const double> values,
                                  std::span<const double> weights,
                                  const BlockOptions& options);

}  // namespace delone::tripack
