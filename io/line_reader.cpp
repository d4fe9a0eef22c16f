#include "io/line_reader.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "io/table.hpp"

namespace delone::io {
namespace {

// Large enough that system calls do not count, small enough to stay in the second-level
// cache.
constexpr std::size_t block_bytes = std::size_t{1} << 18;

[[noreturn]] void fail(const std::string& name, const std::string& why) {
  throw ReadError(name + ": " + why);
}

[[noreturn]] void fail_reading(const std::string& name, int error_number) {
  fail(name, "cannot be read: " + std::generic_category().message(error_number));
}

const char* find(const char* from, const char* to, char c) {
  return static_cast<const char*>(
      std::memchr(from, c, static_cast<std::size_t>(to - from)));
}

}  // namespace

LineReader::LineReader(const std::string& path)
    : name_(path == "-" ? "standard input" : path), buffer_(block_bytes) {
  descriptor_ = path == "-" ? fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                            : open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor_ < 0) fail_reading(name_, errno);
  try {
    struct stat info {};
    if (fstat(descriptor_, &info) != 0) fail_reading(name_, errno);
    if (S_ISDIR(info.st_mode)) fail(name_, "cannot be read: it is a folder; name a file");
    if (S_ISREG(info.st_mode)) num_bytes_ = info.st_size;
    fill();
    inspect_first_block();
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

LineReader::~LineReader() { close(descriptor_); }

/// Moves what is left to the front and reads until the buffer is full or the file ends,
/// so that what peek() shows does not depend on how a pipe's writer was scheduled.
void LineReader::fill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  bytes_before_ += static_cast<std::int64_t>(begin_);
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) {
    if (end_ >= max_line_bytes)
      fail(name_, "line " + std::to_string(line_number_ + 1) + " is longer than " +
                      std::to_string(max_line_bytes >> 20) +
                      " MiB; this is not a table of points");
    buffer_.resize(2 * buffer_.size());
  }
  const std::size_t old_end = end_;
  while (end_ < buffer_.size() && !is_at_end_) {
    const ssize_t got = read(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_reading(name_, errno);
    is_at_end_ = got == 0;
    end_ += static_cast<std::size_t>(got);
  }
  reject_nul_bytes(old_end);
}

void LineReader::reject_nul_bytes(std::size_t from) const {
  const char* const data = buffer_.data();
  const char* const nul = find(data + from, data + end_, '\0');
  if (nul == nullptr) return;
  fail(name_, "is not a text file (byte " + std::to_string(bytes_before_ + (nul - data)) +
                  " is NUL); give a table in plain UTF-8 or ASCII text");
}

void LineReader::inspect_first_block() {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::string_view block(buffer_.data(), end_);
  if (block.starts_with(byte_order_mark)) begin_ = byte_order_mark.size();
  if (block.find('\n') == block.npos) line_end_ = '\r';
}

std::optional<std::string_view> LineReader::next() {
  for (std::size_t searched = 0;;) {
    const char* const first = buffer_.data() + begin_;
    const char* const last = buffer_.data() + end_;
    if (const char* const hit = find(first + searched, last, line_end_)) {
      begin_ += static_cast<std::size_t>(hit - first) + 1;
      ++line_number_;
      return without_carriage_return({first, hit});
    }
    if (is_at_end_) return take_last_line();
    searched = end_ - begin_;
    fill();
  }
}

std::optional<std::string_view> LineReader::take_last_line() {
  if (begin_ == end_) return std::nullopt;
  const std::string_view line(buffer_.data() + begin_, end_ - begin_);
  begin_ = end_;
  ++line_number_;
  return without_carriage_return(line);
}

std::string_view LineReader::without_carriage_return(std::string_view line) const {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::vector<std::string_view> LineReader::peek(std::size_t count) const {
  std::vector<std::string_view> lines;
  const char* from = buffer_.data() + begin_;
  const char* const last = buffer_.data() + end_;
  while (lines.size() < count && from < last) {
    const char* hit = find(from, last, line_end_);
    if (hit == nullptr && !is_at_end_) break;
    if (hit == nullptr) hit = last;
    lines.push_back(without_carriage_return({from, hit}));
    from = hit + 1;
  }
  return lines;
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result(text.substr(0, longest));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  // A cut must not leave the first bytes of a character of several bytes behind.
  const bool is_cut = text.size() > longest;
  if (is_cut && (static_cast<unsigned char>(text[longest]) & 0xC0) == 0x80) {
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xC0) == 0x80)
      result.pop_back();
    if (!result.empty()) result.pop_back();
  }
  return is_cut ? result + "..." : result;
}

}  // namespace delone::io
