#pragma once

#include <optional>
#include <string_view>

namespace delone::io {

/// A start tag or an empty-element tag. Views into the document.
struct XmlTag {
  std::string_view name, attributes;
  /// The document behind the tag.
  std::string_view rest;

  /// The value of an attribute, entities left as they are; empty if there is none.
  [[nodiscard]] std::string_view attribute(std::string_view wanted) const;
  /// What stands between this tag and its end tag, nested elements of the same name not
  /// allowed for; everything behind it if there is no end tag.
  [[nodiscard]] std::string_view content() const;
};

/// The first start tag at or behind the beginning of `document`; comments, declarations
/// and end tags are passed. Nothing if there is none.
///
/// No tree, no recursion, no entities: enough for files whose structure is flat. Cost:
/// linear.
[[nodiscard]] std::optional<XmlTag> next_tag(std::string_view document);

}  // namespace delone::io
