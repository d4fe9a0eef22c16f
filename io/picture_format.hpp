#pragma once

#include <cstdint>
#include <string>

namespace delone::io {

enum class PictureFormat : std::uint8_t { png, svg, pdf, eps };

/// From `format` or, if that is empty, from the extension of `path`, in any case of
/// letters. Throws WriteError naming the formats there are.
[[nodiscard]] PictureFormat picture_format(const std::string& path,
                                           const std::string& format = "");

}  // namespace delone::io
