// Compiled with AVX-512. Whatever is inline here must be always_inline or carry Avx512 in
// its type: see delaunay/instruction_set.hpp.
#include "interp/grid_lanes_of.hpp"

namespace delone::interp {

template struct GridLanes<Avx512>;

}  // namespace delone::interp
