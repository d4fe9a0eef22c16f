#include "io/text_cursor.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "io/fields.hpp"
#include "io/line_reader.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

}  // namespace

std::optional<std::int64_t> to_integer(std::string_view number) {
  return parse_integer(number);
}

TextCursor::TextCursor(std::string name, std::string_view text,
                       std::string_view separators)
    : name_(name == "-" ? "standard input" : std::move(name)),
      text_(text),
      separators_(separators) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

bool TextCursor::is_separator(char c) const noexcept {
  return is_blank(c) || separators_.find(c) != std::string_view::npos;
}

void TextCursor::skip_blanks() {
  while (at_ < text_.size() && is_separator(text_[at_])) ++at_;
  if (at_ < text_.size() && text_[at_] == '#')
    at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
}

void TextCursor::skip_line_end() {
  const bool is_pair = text_.substr(at_).starts_with("\r\n");
  at_ += is_pair ? 2 : 1;
  ++line_;
}

void TextCursor::skip_line() {
  at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
  if (at_ < text_.size()) skip_line_end();
}

bool TextCursor::is_at_end() {
  skip_blanks();
  while (at_ < text_.size() && is_line_end(text_[at_])) {
    skip_line_end();
    skip_blanks();
  }
  return at_ == text_.size();
}

std::optional<std::string_view> TextCursor::word_in_line() {
  skip_blanks();
  const std::size_t from = at_;
  while (at_ < text_.size() && !is_separator(text_[at_]) && !is_line_end(text_[at_]) &&
         text_[at_] != '#')
    ++at_;
  if (at_ == from) return std::nullopt;
  return text_.substr(from, at_ - from);
}

std::optional<std::string_view> TextCursor::word() {
  if (is_at_end()) return std::nullopt;
  return word_in_line();
}

std::string_view TextCursor::need_word(std::string_view what) {
  const auto found = word();
  if (!found) fail("the file ends where " + std::string(what) + " is due");
  return *found;
}

std::int64_t TextCursor::integer(std::string_view what) {
  const std::string_view text = need_word(what);
  const auto number = parse_integer(text);
  if (!number)
    fail("'" + excerpt(text) + "' where " + std::string(what) +
         ", a whole number, is due");
  return *number;
}

double TextCursor::real(std::string_view what) {
  const std::string_view text = need_word(what);
  const Number number = parse_number(text);
  if (number.kind != Number::Kind::finite)
    fail("'" + excerpt(text) + "' where " + std::string(what) +
         ", a finite number, is due");
  return number.value;
}

std::int64_t TextCursor::count(std::string_view what, std::int64_t least_bytes) {
  const std::int64_t number = integer(what);
  if (number < 0 || number > std::numeric_limits<std::int32_t>::max())
    fail(std::string(what) + " cannot be " + std::to_string(number));
  // The last thing need not be followed by a separator.
  if (number > 0 && number * least_bytes > std::ssize(rest()) + 1)
    fail("the file is too short: " + std::string(what) + " is " + std::to_string(number) +
         ", and only " + std::to_string(rest().size()) + " bytes follow");
  return number;
}

std::int32_t TextCursor::index(std::string_view what, std::int64_t size,
                               std::int32_t base) {
  const std::int64_t number = integer(what);
  if (number < base || number - base >= size)
    fail(std::string(what) + " is " + std::to_string(number) + ", outside " +
         std::to_string(base) + ".." + std::to_string(size + base - 1));
  return static_cast<std::int32_t>(number - base);
}

void TextCursor::fail(const std::string& why) const {
  throw ReadError(name_ + ": line " + std::to_string(line_) + ": " + why);
}

}  // namespace delone::io
