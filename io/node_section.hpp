#pragma once

#include "io/node_file.hpp"
#include "io/text_cursor.hpp"

namespace delone::io {

/// The nodes of a .node file, or those at the beginning of a .poly file: header and rows.
/// Throws ReadError naming the line.
[[nodiscard]] NodeFile read_node_section(TextCursor& cursor);

}  // namespace delone::io
