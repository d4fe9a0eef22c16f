#pragma once

#include <string>

namespace delone::io {

/// PostScript without its "%%CreationDate" line, which Cairo writes and nobody can switch
/// off.
[[nodiscard]] std::string without_creation_date(std::string postscript);

/// SVG whose ids are counted from 0: Cairo counts them through the life of the process,
/// so that the second picture would differ from the first.
[[nodiscard]] std::string with_canonical_ids(const std::string& svg);

}  // namespace delone::io
