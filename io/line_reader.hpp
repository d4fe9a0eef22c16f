#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delone::io {

/// The lines of a text file, one after the other, in memory that does not grow with the
/// file.
///
/// Lines end in LF, CRLF or (a file that has no LF) CR; the last one may lack its end. A
/// UTF-8 byte order mark is left out. "-" is standard input. Works on pipes.
///
/// Throws ReadError: file missing, a folder, not readable; a NUL byte (so binary and
/// UTF-16 files are refused with one sentence instead of a thousand); a line longer than
/// `max_line_bytes`.
class LineReader {
 public:
  static constexpr std::size_t max_line_bytes = std::size_t{1} << 26;

  explicit LineReader(const std::string& path);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// The next line without its end; nothing after the last. Valid until the next call.
  [[nodiscard]] std::optional<std::string_view> next();

  /// At most `count` of the lines that next() will give, as far as they are in memory.
  /// Valid until the next call of next().
  [[nodiscard]] std::vector<std::string_view> peek(std::size_t count) const;

  /// The number, from 1, of the line that next() gave last.
  [[nodiscard]] std::int64_t line_number() const noexcept { return line_number_; }
  /// How messages call the file.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// The size of the file; 0 where it has none (pipes).
  [[nodiscard]] std::int64_t num_bytes() const noexcept { return num_bytes_; }

 private:
  void fill();
  void inspect_first_block();
  void reject_nul_bytes(std::size_t from) const;
  [[nodiscard]] std::optional<std::string_view> take_last_line();
  [[nodiscard]] std::string_view without_carriage_return(std::string_view line) const;

  std::string name_;
  int descriptor_ = -1;
  std::int64_t num_bytes_ = 0, bytes_before_ = 0, line_number_ = 0;
  std::vector<char> buffer_;
  std::size_t begin_ = 0,
              end_ = 0;  // the part of the buffer that next() has not given yet
  char line_end_ = '\n';
  bool is_at_end_ = false;
};

/// `text` for a message: cut to a few dozen characters, control characters replaced.
[[nodiscard]] std::string excerpt(std::string_view text);

}  // namespace delone::io
