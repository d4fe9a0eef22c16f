#pragma once

#include <cstdint>

#include "interp/blend_facet.hpp"

namespace delone::interp {

/// BlendFacet::fill_groups_as for AVX2. Only where the processor has it.
template <BlendSpace Space, int Degree>
[[nodiscard]] std::uint32_t fill_groups_avx2(const BlendFacet<Space, Degree>& facet,
                                             const NodeBatch& batch) noexcept;

}  // namespace delone::interp
