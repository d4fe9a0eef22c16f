#include "delaunay/buffer.hpp"

#include <cstdint>
#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace delone::delaunay {

namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;
constexpr std::size_t cache_line = 64;

constexpr std::size_t round_up(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

#ifdef __linux__
// A block that begins on a huge page: maps one page more than needed and gives the ends
// back.
void* map_bytes(std::size_t bytes) {
  const std::size_t size = round_up(bytes, huge_page), slack = huge_page;
  void* const mapped = mmap(nullptr, size + slack, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  const auto address = reinterpret_cast<std::uintptr_t>(mapped);
  const std::size_t head = round_up(address, huge_page) - address;
  char* const begin = static_cast<char*>(mapped) + head;
  if (head > 0) munmap(mapped, head);
  if (slack > head) munmap(begin + size, slack - head);
  madvise(begin, size, MADV_HUGEPAGE);  // advice: failure does no harm
  return begin;
}
#endif

}  // namespace

void* allocate_bytes(std::size_t bytes) {
#ifdef __linux__
  if (bytes >= huge_page) return map_bytes(bytes);
#endif
  void* const p = std::aligned_alloc(cache_line, round_up(bytes, cache_line));
  if (p == nullptr) throw std::bad_alloc();
  return p;
}

void free_bytes(void* p, std::size_t bytes) noexcept {
#ifdef __linux__
  if (bytes >= huge_page) {
    munmap(p, round_up(bytes, huge_page));
    return;
  }
#endif
  std::free(p);
}

}  // namespace delone::delaunay
