#pragma once

#include <cstddef>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace delone::delaunay {

/// Zero-filled or arbitrary memory, aligned to 64 bytes; large blocks go straight to the
/// system, on huge pages, and back to it when freed. Throws std::bad_alloc.
[[nodiscard]] void* allocate_bytes(std::size_t bytes);
void free_bytes(void* p, std::size_t bytes) noexcept;

/// Memory on huge pages where the system has them (first touch of 160 MB costs 54 ms on 4
/// KiB pages and 8 ms on 2 MiB pages), left uninitialised by `resize`.
template <class T>
class BufferAllocator {
 public:
  using value_type = T;
  BufferAllocator() = default;
  template <class U>
  BufferAllocator(const BufferAllocator<U>&) noexcept {}  // NOLINT: allocators convert

  [[nodiscard]] T* allocate(std::size_t size) {
    if (size > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T))
      throw std::bad_alloc();
    return static_cast<T*>(allocate_bytes(size * sizeof(T)));
  }
  void deallocate(T* p, std::size_t size) noexcept { free_bytes(p, size * sizeof(T)); }

  /// resize(n) without a value leaves plain types as they are.
  template <class U>
  void construct(U* p) noexcept(std::is_nothrow_default_constructible_v<U>) {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Args>
  void construct(U* p, Args&&... args) {
    ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
  }

  friend bool operator==(const BufferAllocator&, const BufferAllocator&) { return true; }
};

/// A vector of plain values, for large arrays.
template <class T>
using Buffer = std::vector<T, BufferAllocator<T>>;

}  // namespace delone::delaunay
