// Compiled with AVX2. Whatever is inline here must be always_inline or carry Avx2 in its
// type: see delaunay/instruction_set.hpp.
#include "delaunay/instruction_set.hpp"
#include "stripack/sphere_blocks.hpp"

namespace delone::stripack {

delaunay::BlockWork<SpherePoints> sphere_block_work_avx2() noexcept {
  return delaunay::BlockWorker<SphereLanes<delaunay::Avx2>>::work;
}

}  // namespace delone::stripack
