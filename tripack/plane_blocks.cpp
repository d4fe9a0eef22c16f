#include "tripack/plane_blocks.hpp"

#include "delaunay/instruction_set.hpp"

namespace delone::tripack {

delaunay::BlockWork<PlanePoints> plane_block_work() noexcept {
#ifdef DELONE_AVX2
  if (delaunay::Avx2::is_supported()) return plane_block_work_avx2();
#endif
  return delaunay::BlockWorker<PlaneLanes<delaunay::Portable>>::work;
}

}  // namespace delone::tripack
