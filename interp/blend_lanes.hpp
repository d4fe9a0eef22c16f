#pragma once

#include <cstdint>

#include "interp/blend_facet.hpp"

namespace delone::interp {

/// BlendFacet::fill_groups_as for AVX2 and AVX-512. Only where the processor has them.
template <BlendSpace Space, int Degree>
[[nodiscard]] std::uint64_t fill_groups_avx2(const BlendFacet<Space, Degree>& facet,
                                             const NodeBatch& batch) noexcept;

template <BlendSpace Space, int Degree>
[[nodiscard]] std::uint64_t fill_groups_avx512(const BlendFacet<Space, Degree>& facet,
                                               const NodeBatch& batch) noexcept;

}  // namespace delone::interp
