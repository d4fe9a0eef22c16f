#include "io/xml_scanner.hpp"

#include <algorithm>

namespace delone::io {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// The document behind `mark`, or nothing left if it does not occur.
std::string_view behind(std::string_view document, std::string_view mark) {
  const std::size_t at = document.find(mark);
  return at == std::string_view::npos ? std::string_view()
                                      : document.substr(at + mark.size());
}

/// The place of the `>` that ends a tag: not one inside quotes.
std::size_t end_of_tag(std::string_view document) {
  char quote = 0;
  for (std::size_t i = 0; i < document.size(); ++i) {
    const char c = document[i];
    if (quote == 0 && c == '>') return i;
    if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
    else if (c == quote)
      quote = 0;
  }
  return std::string_view::npos;
}

std::string_view without_leading_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text;
}

}  // namespace

std::string_view XmlTag::attribute(std::string_view wanted) const {
  std::string_view left = without_leading_blanks(attributes);
  while (!left.empty()) {
    const std::size_t equals = left.find('=');
    if (equals == std::string_view::npos) return {};
    const std::string_view key = left.substr(0, left.find_first_of(" \t\r\n="));
    left = without_leading_blanks(left.substr(equals + 1));
    if (left.empty() || (left[0] != '"' && left[0] != '\'')) return {};
    const std::size_t end = left.find(left[0], 1);
    if (end == std::string_view::npos) return {};
    if (key == wanted) return left.substr(1, end - 1);
    left = without_leading_blanks(left.substr(end + 1));
  }
  return {};
}

std::string_view XmlTag::content() const {
  if (attributes.ends_with('/')) return {};
  for (std::size_t at = rest.find("</"); at != std::string_view::npos;
       at = rest.find("</", at + 2)) {
    if (rest.substr(at + 2).starts_with(name)) return rest.substr(0, at);
  }
  return rest;
}

std::optional<XmlTag> next_tag(std::string_view document) {
  for (;;) {
    const std::size_t open = document.find('<');
    if (open == std::string_view::npos) return std::nullopt;
    document.remove_prefix(open + 1);
    if (document.starts_with("!--")) {
      document = behind(document, "-->");
      continue;
    }
    const std::size_t end = end_of_tag(document);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view tag = document.substr(0, end);
    document.remove_prefix(end + 1);
    if (tag.empty() || tag[0] == '/' || tag[0] == '?' || tag[0] == '!') continue;
    const std::size_t name_end = std::min(tag.find_first_of(" \t\r\n/"), tag.size());
    return XmlTag{tag.substr(0, name_end), tag.substr(name_end), document};
  }
}

}  // namespace delone::io
