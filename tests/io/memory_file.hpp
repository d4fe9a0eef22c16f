#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace delone::test {

/// A file in memory, for tests that read thousands of them.
class MemoryFile {
 public:
  MemoryFile() : number_(memfd_create("delone", MFD_CLOEXEC)) {
    if (number_ < 0) throw std::runtime_error("no file in memory");
  }
  ~MemoryFile() { close(number_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const {
    return "/proc/self/fd/" + std::to_string(number_);
  }

  /// Makes `content` all that the file holds.
  void put(std::string_view content) const {
    cut(0);
    if (pwrite(number_, content.data(), content.size(), 0) !=
        static_cast<ssize_t>(content.size()))
      throw std::runtime_error("a file in memory cannot be written");
  }

  /// Leaves the first `size` bytes.
  void cut(std::size_t size) const {
    if (ftruncate(number_, static_cast<off_t>(size)) != 0)
      throw std::runtime_error("a file in memory cannot be cut");
  }

 private:
  int number_;
};

}  // namespace delone::test
