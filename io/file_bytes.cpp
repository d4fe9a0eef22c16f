#include "io/file_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "io/table.hpp"

namespace delone::io {
namespace {

/// Closes itself.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : number_(path == "-" ? fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                            : open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const noexcept { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw ReadError((path == "-" ? "standard input" : path) + ": cannot be read: " + why);
}

[[noreturn]] void fail_with_errno(const std::string& path) {
  fail(path, std::generic_category().message(errno));
}

}  // namespace

std::string read_bytes(const std::string& path) {
  const Descriptor file(path);
  struct stat info {};
  if (file.number() < 0 || fstat(file.number(), &info) != 0) fail_with_errno(path);
  if (S_ISDIR(info.st_mode)) fail(path, "it is a folder; name a file");
  constexpr std::size_t block = std::size_t{1} << 16;
  std::string bytes;
  if (S_ISREG(info.st_mode)) bytes.reserve(static_cast<std::size_t>(info.st_size) + 1);
  for (;;) {
    const std::size_t filled = bytes.size();
    bytes.resize(std::max(bytes.capacity(), filled + block));
    const ssize_t got = read(file.number(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno != EINTR) fail_with_errno(path);
    bytes.resize(filled + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) return bytes;
  }
}

}  // namespace delone::io
