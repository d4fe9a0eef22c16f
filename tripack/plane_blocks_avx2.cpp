// Compiled with AVX2. Whatever is inline here must be always_inline or carry Avx2 in its
// type: see delaunay/instruction_set.hpp.
#include "delaunay/instruction_set.hpp"
#include "tripack/plane_blocks.hpp"

namespace delone::tripack {

delaunay::BlockWork<PlanePoints> plane_block_work_avx2() noexcept {
  return delaunay::BlockWorker<PlaneLanes<delaunay::Avx2>>::work;
}

}  // namespace delone::tripack
