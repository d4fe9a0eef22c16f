// Compiled with AVX2. Whatever is inline here must be always_inline or carry Avx2 in its
// type: see delaunay/instruction_set.hpp.
#include "interp/grid_lanes_of.hpp"

namespace delone::interp {

template struct GridLanes<delaunay::Avx2>;

}  // namespace delone::interp
