// Compiled with AVX2. Whatever is inline here must be always_inline or carry Avx2 in its
// type: see delaunay/instruction_set.hpp.
#include "delaunay/instruction_set.hpp"
#include "interp/blend_lanes.hpp"

namespace delone::interp {

template <BlendSpace Space, int Degree>
std::uint64_t fill_groups_avx2(const BlendFacet<Space, Degree>& facet,
                               const NodeBatch& batch) noexcept {
  return facet.template fill_groups_as<delaunay::Avx2>(batch);
}

template std::uint64_t fill_groups_avx2(const BlendFacet<PlaneSpace, 3>&,
                                        const NodeBatch&) noexcept;
template std::uint64_t fill_groups_avx2(const BlendFacet<PlaneSpace, 4>&,
                                        const NodeBatch&) noexcept;
template std::uint64_t fill_groups_avx2(const BlendFacet<SphereSpace, 3>&,
                                        const NodeBatch&) noexcept;
template std::uint64_t fill_groups_avx2(const BlendFacet<SphereSpace, 4>&,
                                        const NodeBatch&) noexcept;

}  // namespace delone::interp
