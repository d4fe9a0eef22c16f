#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace delone::io {

/// The first `most` bytes that base64 text stands for, or as many as there are. White
/// space is passed, and so is padding between two pieces that were encoded one by one.
/// Stops at any other character. Source: RFC 4648.
[[nodiscard]] std::string decode_base64(std::string_view text, std::size_t most);

}  // namespace delone::io
