#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace delone::io {

inline constexpr const char* minus_sign = "\u2212";

/// "⁻¹" for -1.
[[nodiscard]] std::string superscript(int number);

/// Units as they are printed: "m s-1" becomes "m s⁻¹", "m^2" "m²", "degC" and "Celsius"
/// "°C", "1" and the like nothing. What is not understood stays as it is.
[[nodiscard]] std::string printed_units(std::string_view units);

/// The name of a variable or column as it is printed: "sea_level_m" in "m" becomes "sea
/// level".
[[nodiscard]] std::string printed_name(std::string_view name, std::string_view units);

/// Text that can be drawn: valid UTF-8 on one line. Bytes that are not UTF-8 become "?",
/// control characters a blank.
[[nodiscard]] std::string printable(std::string_view text);

/// The whole characters within the first `num_bytes` bytes of `text`.
[[nodiscard]] std::string_view first_bytes(std::string_view text,
                                           std::size_t num_bytes) noexcept;

}  // namespace delone::io
