#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delone::io {

/// What a field of a table holds.
struct Number {
  enum class Kind : std::uint8_t {
    finite,
    infinite,  ///< inf, or a number beyond the range of double
    missing,   ///< empty, nan, NA, N/A, null, in any case of letters
    text,      ///< anything else
  };
  Kind kind = Kind::text;
  double value = 0;
};

/// Reads one field, blanks around it ignored. Locale-free; a decimal point, no decimal
/// comma; a leading
/// '+' is allowed. Correctly rounded.
[[nodiscard]] Number parse_number(std::string_view field);

/// As parse_number, for a field that must be a whole number.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view field);

/// How the fields of a line are separated: '\t', ';' or ',' (the first of them that
/// occurs outside quotes), else ' ', which stands for any number of blanks and tabs.
[[nodiscard]] char detect_delimiter(std::string_view line);

/// The fields of a line, their surrounding blanks and quotes taken off (doubled quotes
/// inside stay doubled: see unquote). Nothing if a quoted field does not end, or goes on
/// after its closing quote.
[[nodiscard]] std::optional<std::vector<std::string_view>> split_fields(
    std::string_view line, char delimiter);

/// The text of a field with "" made ".
[[nodiscard]] std::string unquote(std::string_view field);

/// `text` without blanks and tabs at either end.
[[nodiscard]] std::string_view trim(std::string_view text);

[[nodiscard]] std::string to_lower(std::string_view text);

/// Is there anything on the line but blanks or a comment (#)?
[[nodiscard]] bool holds_data(std::string_view line);

[[nodiscard]] constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

}  // namespace delone::io
