#pragma once

#include <span>

#include "delaunay/block_reduce.hpp"
#include "stripack/direction.hpp"

namespace delone::stripack {

using delaunay::BlockOptions;
using delaunay::BlockPosition;
using delaunay::BlockRegion;
using delaunay::Blocks;
using delaunay::BlockStatistic;

/// Block mean, median or mode of observations on the globe, in blocks of longitude and
/// latitude in degrees: see delaunay/block_reduce.hpp.
///
/// Any wrap of longitude: they are brought into the 360 degrees from the region's west on
/// (without a region -180). A block does not cross the date line unless the region does.
/// At a pole all longitudes are one: such points belong to the first block of their row.
/// Positions are reduced as numbers within the block, so they stay in it. Throws Error
/// also for a latitude outside -90..90 (naming the row), and a region of more than 360
/// degrees.
[[nodiscard]] Blocks block_reduce(std::span<const LonLat> points,
                                  std::span<const double> values,
                                  std::span<const double> weights,
                                  const BlockOptions& options);

}  // namespace delone::stripack
