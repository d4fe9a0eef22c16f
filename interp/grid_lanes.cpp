#include "interp/grid_lanes.hpp"

#include "interp/grid_lanes_of.hpp"

namespace delone::interp {

namespace {

// `f(lanes)` with the widest registers of the machine.
template <class F>
auto on_widest(F f) {
#if defined(DELONE_AVX2)
  if (Avx512::is_supported()) return f(GridLanes<Avx512>{});
  if (delaunay::Avx2::is_supported()) return f(GridLanes<delaunay::Avx2>{});
#endif
  return f(GridLanes<delaunay::Portable>{});
}

template <class InstructionSet>
GridKernels kernels_of() {
  using Lanes = GridLanes<InstructionSet>;
  return {Lanes::fill, Lanes::fill, Lanes::cover, Lanes::cover};
}

}  // namespace

std::vector<GridKernels> grid_kernels() {
  std::vector<GridKernels> result;
#if defined(DELONE_AVX2)
  if (Avx512::is_supported()) result.push_back(kernels_of<Avx512>());
  if (delaunay::Avx2::is_supported()) result.push_back(kernels_of<delaunay::Avx2>());
#endif
  result.push_back(kernels_of<delaunay::Portable>());
  return result;
}

NodeMask fill_block(const PlaneSides& sides, const PlainPlaneFacet& facet,
                    const PlaneAxes& axes, const NodeBlock& block,
                    const GridValues& out) {
  return on_widest(
      [&](auto lanes) { return lanes.fill(sides, facet, axes, block, out); });
}

NodeMask fill_block(const SphereSides& sides, const PlainSphereFacet& facet,
                    const GlobeAxes& axes, const NodeBlock& block,
                    const GridValues& out) {
  return on_widest(
      [&](auto lanes) { return lanes.fill(sides, facet, axes, block, out); });
}

Cover cover(const PlaneSides& sides, const PlaneAxes& axes, const NodeBlock& block) {
  return on_widest([&](auto lanes) { return lanes.cover(sides, axes, block); });
}

Cover cover(const SphereSides& sides, const GlobeAxes& axes, const NodeBlock& block) {
  return on_widest([&](auto lanes) { return lanes.cover(sides, axes, block); });
}

}  // namespace delone::interp
