#pragma once

#include <string>

namespace delone::io {

/// The whole file in memory; "-" is standard input, pipes are read to their end. For
/// formats that mix text and binary or need to look back. Throws ReadError: missing, a
/// folder, not readable.
[[nodiscard]] std::string read_bytes(const std::string& path);

}  // namespace delone::io
