#include "io/picture_bytes.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <string_view>

namespace delone::io {
namespace {

/// The id at the start of `text`, such as image17, if it is of a kind that Cairo counts
/// by the process.
std::string_view counted_id(std::string_view text) {
  for (const std::string_view kind : {"image", "surface"}) {
    if (!text.starts_with(kind)) continue;
    const auto end = text.find_first_not_of("0123456789", kind.size());
    if (end == std::string_view::npos || end == kind.size() || text[end] != '"') continue;
    return text.substr(0, end);
  }
  return {};
}

}  // namespace

std::string without_creation_date(std::string postscript) {
  const auto start = postscript.find("%%CreationDate:");
  if (start == std::string::npos) return postscript;
  const auto end = std::min(postscript.find('\n', start), postscript.size() - 1);
  return postscript.erase(start, end - start + 1);
}

std::string with_canonical_ids(const std::string& svg) {
  std::map<std::string, std::string, std::less<>> new_ids;
  std::string canonical;
  std::string_view rest = svg;
  // Ids stand behind a quotation mark, references to them behind a hash.
  for (auto mark = rest.find_first_of("\"#"); mark != std::string_view::npos;
       mark = rest.find_first_of("\"#")) {
    canonical += rest.substr(0, mark + 1);
    rest.remove_prefix(mark + 1);
    const auto id = counted_id(rest);
    if (id.empty()) continue;
    const auto number = std::to_string(new_ids.size());
    canonical += new_ids.try_emplace(std::string(id), "picture" + number).first->second;
    rest.remove_prefix(id.size());
  }
  return canonical.append(rest);
}

}  // namespace delone::io
