#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "cli/settings.hpp"

namespace delone::cli {

/// The format an output is written in: --format, or else the extension of the file, in
/// lower case; standard output has the only format there is, if there is one only.
/// Throws UsageError naming `formats` if it is none of them.
[[nodiscard]] std::string choose_format(const OutputSettings& output,
                                        std::initializer_list<std::string_view> formats);

/// The same among the formats of pictures.
[[nodiscard]] std::string choose_map_format(const OutputSettings& output);

/// Is it "-" or /dev/stdout?
[[nodiscard]] bool is_standard_output(const OutputSettings& output);

/// Throws UsageError if both are standard input.
void check_inputs(const std::string& first, const std::string& second);

/// Asks before a long run what would otherwise come out after it: throws io::WriteError
/// if `output` cannot be opened, and UsageError if it is the file `input`, which the run
/// would overwrite.
void check_output(const std::string& output,
                  std::initializer_list<std::string_view> inputs);

/// Writes `text` to standard output; throws io::WriteError if it does not take it (a full
/// disk).
void print(std::string_view text);

/// `delone: error: ...`, one line on standard error, whatever `message` holds.
void report_failure(std::string_view message);

/// "3 points", "1 point".
[[nodiscard]] std::string counted(std::int64_t count, std::string_view noun);

/// `text` as a JSON string, quotes included.
[[nodiscard]] std::string json_string(std::string_view text);

}  // namespace delone::cli
