#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace delone::io {

/// Reads words and numbers one after the other from text in memory, and knows the line it
/// is at.
///
/// Words are separated by blanks, tabs and line ends (LF, CRLF, CR) and by the characters
/// of `separators`; `#` starts a comment to the end of its line. Numbers are locale-free
/// and correctly rounded. What does not suit throws ReadError naming file and line.
///
/// Every count in a file goes through count(), which holds it against the bytes that are
/// left before anything is allocated, and every index through index().
class TextCursor {
 public:
  /// `name` is how messages call the file. The text must outlive the cursor.
  TextCursor(std::string name, std::string_view text, std::string_view separators = "");

  /// The next word; nothing at the end.
  [[nodiscard]] std::optional<std::string_view> word();
  /// The next word of the current line; nothing at the line's end, which is not passed.
  [[nodiscard]] std::optional<std::string_view> word_in_line();
  /// Passes the rest of the current line and its end.
  void skip_line();
  /// Is there nothing left but blanks and comments?
  [[nodiscard]] bool is_at_end();

  // The next word as `what` ("the number of nodes"), which messages name.

  [[nodiscard]] std::string_view need_word(std::string_view what);
  [[nodiscard]] std::int64_t integer(std::string_view what);
  /// Finite.
  [[nodiscard]] double real(std::string_view what);
  /// Not negative, and as many things of at least `least_bytes` each as the text left can
  /// hold.
  [[nodiscard]] std::int64_t count(std::string_view what, std::int64_t least_bytes);
  /// A number in base .. base + size - 1, given back less `base`.
  [[nodiscard]] std::int32_t index(std::string_view what, std::int64_t size,
                                   std::int32_t base = 0);

  /// What has not been read yet.
  [[nodiscard]] std::string_view rest() const noexcept { return text_.substr(at_); }
  /// The line, from 1, of the word read last.
  [[nodiscard]] std::int64_t line_number() const noexcept { return line_; }
  /// "FILE: line N: why".
  [[noreturn]] void fail(const std::string& why) const;

 private:
  [[nodiscard]] bool is_separator(char c) const noexcept;
  void skip_blanks();
  void skip_line_end();

  std::string name_;
  std::string_view text_, separators_;
  std::size_t at_ = 0;
  std::int64_t line_ = 1;
};

/// `number` as a whole number; nothing if it is none.
[[nodiscard]] std::optional<std::int64_t> to_integer(std::string_view number);

}  // namespace delone::io
