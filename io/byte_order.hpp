#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstring>

namespace delone::io {

/// The number that the first sizeof(T) bytes at `bytes` hold in byte order `order`.
template <class T>
requires std::integral<T> || std::floating_point<T>
[[nodiscard]] T number_at(const char* bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::ranges::reverse(raw);
  return std::bit_cast<T>(raw);
}

}  // namespace delone::io
