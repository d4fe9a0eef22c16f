#pragma once

#include "io/node_file.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"

namespace delone::io {

/// The nodes of a .node file, or those at the beginning of a .poly file: header and rows.
/// Throws ReadError naming the line.
[[nodiscard]] NodeFile read_node_section(TextCursor& cursor);

/// The same to a file that goes on. Throws Error if the lists have different lengths.
void write_node_section(TextWriter& text, const NodeFile& nodes);

}  // namespace delone::io
