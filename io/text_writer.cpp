#include "io/text_writer.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace delone::io {

TextWriter& TextWriter::operator<<(std::string_view text) {
  constexpr std::size_t piece = std::size_t{1} << 16;
  pending_ += text;
  if (pending_.size() >= piece) {
    file_.write(pending_);
    pending_.clear();
  }
  return *this;
}

TextWriter& TextWriter::append_number(double number) {
  if (std::isnan(number)) return *this;
  // Without a format, to_chars writes 100000 as 1e+05 because that is shorter.
  const double size = std::abs(number);
  const bool is_readable = size == 0 || (size >= 1e-5 && size < 1e16);
  const auto format =
      is_readable ? std::chars_format::fixed : std::chars_format::scientific;
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, format).ptr;
  return *this << std::string_view(text.data(), end);
}

TextWriter& TextWriter::append_number(std::int64_t number) {
  std::array<char, 24> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return *this << std::string_view(text.data(), end);
}

void TextWriter::commit() {
  file_.write(pending_);
  pending_.clear();
  file_.commit();
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",;\t\"\r\n") == text.npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += '"';
  }
  return quoted + '"';
}

}  // namespace delone::io
