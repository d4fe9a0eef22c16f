#pragma once

#include <cstdint>

/// For choices that nothing foretells: no branch.
namespace delone::delaunay {

/// All bits, or none.
[[gnu::always_inline]] inline std::int32_t mask(bool holds) {
  return -static_cast<std::int32_t>(holds);
}
[[gnu::always_inline]] inline std::int32_t choose(bool holds, std::int32_t a,
                                                  std::int32_t b) {
  return (mask(holds) & a) | (~mask(holds) & b);
}

}  // namespace delone::delaunay
