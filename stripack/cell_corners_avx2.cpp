// Compiled with AVX2. Whatever is inline here must be always_inline or carry Avx2 in its
// type: see delaunay/instruction_set.hpp.
#include "stripack/cell_corners.hpp"

namespace delone::stripack {

HalfAreaFunction half_areas_avx2() noexcept { return HalfAreaWork<delaunay::Avx2>::work; }

}  // namespace delone::stripack
