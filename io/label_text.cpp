#include "io/label_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "io/fields.hpp"

namespace delone::io {
namespace {

constexpr std::array<const char*, 10> superscript_digits{"⁰", "¹", "²", "³", "⁴",
                                                         "⁵", "⁶", "⁷", "⁸", "⁹"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

std::string superscript(std::string_view number) {
  std::string raised;
  for (const char c : number)
    raised += c == '-' ? "⁻" : superscript_digits[static_cast<std::size_t>(c - '0')];
  return raised;
}

/// Length of the exponent that starts `text`: digits, perhaps behind a minus sign; 0 if
/// there is none.
std::size_t exponent_length(std::string_view text) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  std::size_t end = sign;
  while (end < text.size() && is_digit(text[end])) ++end;
  // "kg2m" is no exponent but a name.
  if (end == sign || (end < text.size() && is_letter(text[end]))) return 0;
  return end;
}

std::string raise_exponents(std::string_view units) {
  std::string raised;
  for (std::size_t i = 0; i < units.size();) {
    const bool is_power = units[i] == '^' || units.substr(i).starts_with("**");
    const std::size_t start = !is_power ? i : units[i] == '^' ? i + 1 : i + 2;
    // Not behind a number: 1e-6.
    const bool is_behind_name =
        i > 0 && is_letter(units[i - 1]) && (i < 2 || !is_digit(units[i - 2]));
    const bool can_start = is_power || is_behind_name;
    const std::size_t length = can_start ? exponent_length(units.substr(start)) : 0;
    if (length == 0) {
      raised += units[i++];
    } else {
      raised += superscript(units.substr(start, length));
      i = start + length;
    }
  }
  return raised;
}

/// Bytes of the UTF-8 character at the start of `text`, 0 if there is no valid one
/// (surrogates, overlong forms and numbers above 10ffff are not valid).
std::size_t character_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead < 0x80                    ? 1
                             : lead >= 0xc2 && lead <= 0xdf ? 2
                             : lead >= 0xe0 && lead <= 0xef ? 3
                             : lead >= 0xf0 && lead <= 0xf4 ? 4
                                                            : 0;
  if (length > text.size()) return 0;
  const auto rest = text.substr(std::min<std::size_t>(1, length), length - (length > 0));
  if (!std::all_of(rest.begin(), rest.end(), is_continuation)) return 0;
  if (length < 3) return length;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool is_bad = (lead == 0xe0 && second < 0xa0) ||
                      (lead == 0xed && second > 0x9f) ||
                      (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f);
  return is_bad ? 0 : length;
}

/// Letters and digits in lower case: units as they stand in the name of a column, "mW
/// m-2" and "mw_m2" both mwm2.
std::string letters_of(std::string_view units) {
  std::string letters;
  for (const char c : to_lower(units))
    if (is_letter(c) || is_digit(c)) letters += c;
  return letters;
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string superscript(int number) { return superscript(std::to_string(number)); }

std::string printed_units(std::string_view units) {
  const std::string name = to_lower(units);
  for (const char* celsius : {"degc", "deg_c", "celsius", "degree_celsius",
                              "degrees_celsius", "degree celsius", "degrees celsius"})
    if (name == celsius) return "°C";
  for (const char* none : {"1", "none", "dimensionless", "unitless"})
    if (name == none) return "";
  return raise_exponents(units);
}

std::string printed_name(std::string_view name, std::string_view units) {
  const std::string letters = letters_of(units);
  const bool is_celsius = printed_units(units) == "°C";
  for (auto mark = name.find('_', 1); mark != std::string_view::npos;
       mark = name.find('_', mark + 1)) {
    const std::string suffix = letters_of(name.substr(mark));
    if ((is_celsius && suffix == "c") || (!suffix.empty() && suffix == letters))
      name = name.substr(0, mark);
  }
  std::string printed(name);
  std::replace(printed.begin(), printed.end(), '_', ' ');
  return printed;
}

std::string printable(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0 || is_control(text[0]))
      clean += length == 0 ? '?' : ' ';
    else
      clean += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return clean;
}

std::string_view first_bytes(std::string_view text, std::size_t num_bytes) noexcept {
  if (num_bytes >= text.size()) return text;
  while (num_bytes > 0 && is_continuation(text[num_bytes])) --num_bytes;
  return text.substr(0, num_bytes);
}

}  // namespace delone::io
