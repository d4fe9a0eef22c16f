#pragma once

#include "delaunay/ring_builder.hpp"
#include "tripack/plane_lanes.hpp"

namespace delone::tripack {

/// The work of a block with the best instructions of this processor.
[[nodiscard]] delaunay::BlockWork<PlanePoints> plane_block_work() noexcept;

[[nodiscard]] delaunay::BlockWork<PlanePoints> plane_block_work_avx2() noexcept;

}  // namespace delone::tripack
