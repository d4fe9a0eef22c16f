#include "io/fields.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace delone::io {
namespace {

bool is_missing(std::string_view text) {
  constexpr std::array<std::string_view, 6> words = {"",    "nan",  "na",
                                                     "n/a", "null", "-nan"};
  return text.size() <= 4 && std::ranges::find(words, to_lower(text)) != words.end();
}

std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

/// The end of the quoted field that starts at `text[from]`: the place of its closing
/// quote.
std::size_t closing_quote(std::string_view text, std::size_t from) {
  std::size_t quote = text.find('"', from + 1);
  while (quote != text.npos && quote + 1 < text.size() && text[quote + 1] == '"')
    quote = text.find('"', quote + 2);
  return quote;
}

/// Skips blanks; tabs too, unless they separate the fields.
std::size_t skip_blanks(std::string_view line, std::size_t from, char delimiter) {
  while (from < line.size() && is_blank(line[from]) &&
         (delimiter == ' ' || line[from] != delimiter))
    ++from;
  return from;
}

bool is_separator(char c, char delimiter) {
  return delimiter == ' ' ? is_blank(c) : c == delimiter;
}

std::size_t end_of_plain_field(std::string_view line, std::size_t from, char delimiter) {
  const std::size_t hit =
      delimiter == ' ' ? line.find_first_of(" \t", from) : line.find(delimiter, from);
  return std::min(hit, line.size());
}

bool is_number(std::string_view field) {
  return parse_number(field).kind == Number::Kind::finite;
}

/// "1 2<tab>3" is a line of blanks and tabs mixed; "sea temperature<tab>3" has two
/// fields.
bool is_tab_just_a_blank(std::string_view line) {
  const auto by_tab = split_fields(line, '\t');
  const auto by_blank = split_fields(line, ' ');
  return by_tab && by_blank && by_blank->size() > by_tab->size() &&
         std::ranges::all_of(*by_blank, is_number);
}

}  // namespace

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string to_lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

bool holds_data(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != line.npos && line[first] != '#';
}

Number parse_number(std::string_view field) {
  const std::string_view text = trim(field);
  if (is_missing(text)) return {.kind = Number::Kind::missing};
  const std::string_view digits = without_plus(text);
  double value = 0;
  const auto [end, error] =
      fast_float::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool is_whole = end == digits.data() + digits.size();
  if (!is_whole || error == std::errc::invalid_argument) return {};
  if (std::isnan(value)) return {.kind = Number::Kind::missing};
  if (std::isinf(value)) return {.kind = Number::Kind::infinite, .value = value};
  return {.kind = Number::Kind::finite, .value = value};
}

std::optional<std::int64_t> parse_integer(std::string_view field) {
  const std::string_view text = without_plus(trim(field));
  std::int64_t value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

char detect_delimiter(std::string_view line) {
  std::array<bool, 3> is_there{};
  constexpr std::string_view delimiters = "\t;,";
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    const std::size_t kind = delimiters.find(c);
    if (!is_quoted && kind != delimiters.npos) is_there[kind] = true;
  }
  if (is_there[0] && !is_tab_just_a_blank(line)) return '\t';
  if (is_there[1]) return ';';
  return is_there[2] ? ',' : ' ';
}

std::optional<std::vector<std::string_view>> split_fields(std::string_view line,
                                                          char delimiter) {
  std::vector<std::string_view> fields;
  for (std::size_t from = skip_blanks(line, 0, delimiter);;) {
    std::size_t end = end_of_plain_field(line, from, delimiter);
    if (from < line.size() && line[from] == '"') {
      const std::size_t quote = closing_quote(line, from);
      if (quote == line.npos) return std::nullopt;
      fields.push_back(line.substr(from + 1, quote - from - 1));
      end = delimiter == ' ' ? quote + 1 : skip_blanks(line, quote + 1, delimiter);
      if (end < line.size() && !is_separator(line[end], delimiter)) return std::nullopt;
    } else {
      fields.push_back(trim(line.substr(from, end - from)));
    }
    if (end == line.size()) return fields;
    from = skip_blanks(line, end + 1, delimiter);
    if (delimiter == ' ' && from == line.size()) return fields;
  }
}

std::string unquote(std::string_view field) {
  std::string result;
  for (std::size_t i = 0; i < field.size(); ++i) {
    result += field[i];
    if (field[i] == '"' && i + 1 < field.size() && field[i + 1] == '"') ++i;
  }
  return result;
}

}  // namespace delone::io
