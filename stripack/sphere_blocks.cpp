#include "stripack/sphere_blocks.hpp"

#include "delaunay/instruction_set.hpp"

namespace delone::stripack {

delaunay::BlockWork<SpherePoints> sphere_block_work() noexcept {
#ifdef DELONE_AVX2
  if (delaunay::Avx2::is_supported()) return sphere_block_work_avx2();
#endif
  return delaunay::BlockWorker<SphereLanes<delaunay::Portable>>::work;
}

}  // namespace delone::stripack
