#include "interp/blend_lanes.hpp"

#include "delaunay/instruction_set.hpp"

namespace delone::interp {

template <BlendSpace Space, int Degree>
std::uint64_t fill_groups(const BlendFacet<Space, Degree>& facet,
                          const NodeBatch& batch) noexcept {
#if defined(DELONE_AVX2)
  if (Avx512::is_supported()) return fill_groups_avx512(facet, batch);
  if (delaunay::Avx2::is_supported()) return fill_groups_avx2(facet, batch);
#endif
  return facet.template fill_groups_as<delaunay::Portable>(batch);
}

template std::uint64_t fill_groups(const BlendFacet<PlaneSpace, 3>&,
                                   const NodeBatch&) noexcept;
template std::uint64_t fill_groups(const BlendFacet<PlaneSpace, 4>&,
                                   const NodeBatch&) noexcept;
template std::uint64_t fill_groups(const BlendFacet<SphereSpace, 3>&,
                                   const NodeBatch&) noexcept;
template std::uint64_t fill_groups(const BlendFacet<SphereSpace, 4>&,
                                   const NodeBatch&) noexcept;

}  // namespace delone::interp
