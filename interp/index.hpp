#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace delone::interp {

/// A 32-bit node or site number as an index.
[[nodiscard]] constexpr std::size_t at(std::int32_t i) noexcept {
  return static_cast<std::size_t>(i);
}
/// A grid position as an index.
[[nodiscard]] constexpr std::size_t at(std::int64_t i) noexcept {
  return static_cast<std::size_t>(i);
}

/// Indices [begin, end).
struct IndexRange {
  std::int64_t begin = 0, end = 0;
  [[nodiscard]] bool is_empty() const noexcept { return begin >= end; }
};

}  // namespace delone::interp
