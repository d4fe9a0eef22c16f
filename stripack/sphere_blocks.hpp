#pragma once

#include "delaunay/ring_builder.hpp"
#include "stripack/sphere_lanes.hpp"

namespace delone::stripack {

/// The work of a block with the best instructions of this processor.
[[nodiscard]] delaunay::BlockWork<SpherePoints> sphere_block_work() noexcept;

[[nodiscard]] delaunay::BlockWork<SpherePoints> sphere_block_work_avx2() noexcept;

}  // namespace delone::stripack
