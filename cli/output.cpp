#include "cli/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "cli/exit_code.hpp"
#include "cli/reporter.hpp"
#include "io/output_file.hpp"

namespace delone::cli {
namespace {

namespace fs = std::filesystem;

std::string in_lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

/// The longest of `formats` that the name of the file ends with, since some have a dot
/// of their own ("v.node"); empty if none.
std::string extension_of(const std::string& path,
                         std::initializer_list<std::string_view> formats) {
  const std::string name = in_lower_case(fs::path(path).filename().string());
  std::string_view found;
  for (const std::string_view format : formats) {
    if (format.size() > found.size() && name.ends_with(fmt::format(".{}", format)))
      found = format;
  }
  return std::string(found);
}

[[noreturn]] void refuse_format(const OutputSettings& output, const std::string& words) {
  if (!output.format.empty())
    throw UsageError(
        fmt::format("--format takes one of {}, not '{}'", words, output.format));
  if (is_standard_output(output))
    throw UsageError(
        fmt::format("-o {}: standard output has no extension that says the format; add "
                    "--format with one of {}",
                    output.path, words));
  throw UsageError(
      fmt::format("{}: its extension names no format written here; use one of {}, or say "
                  "--format",
                  output.path, words));
}

bool is_plain_or_absent(const std::string& path) {
  std::error_code error;
  const auto type = fs::status(path, error).type();
  return type == fs::file_type::regular || type == fs::file_type::not_found ||
         type == fs::file_type::directory;
}

bool is_same_plain_file(const std::string& a, std::string_view b) {
  std::error_code error;
  return fs::is_regular_file(a, error) && fs::equivalent(a, b, error);
}

}  // namespace

std::string choose_format(const OutputSettings& output,
                          std::initializer_list<std::string_view> formats) {
  std::string format = output.format.empty() ? extension_of(output.path, formats)
                                             : in_lower_case(output.format);
  if (std::ranges::find(formats, format) != formats.end()) return format;
  if (output.format.empty() && is_standard_output(output) && formats.size() == 1)
    return std::string(*formats.begin());
  refuse_format(output, fmt::format("{}", fmt::join(formats, ", ")));
}

std::string choose_map_format(const OutputSettings& output) {
  return choose_format(output, {"png", "svg", "pdf", "eps"});
}

bool is_standard_output(const OutputSettings& output) {
  return output.path == "-" || output.path == "/dev/stdout";
}

void check_inputs(const std::string& first, const std::string& second) {
  if (first == "-" && second == "-")
    throw UsageError("only one of the two inputs can be standard input");
}

void check_output(const std::string& output,
                  std::initializer_list<std::string_view> inputs) {
  for (const std::string_view input : inputs) {
    if (is_same_plain_file(output, input)) {
      throw UsageError(output +
                       ": the output would overwrite the input; name another file");
    }
  }
  // Opening a pipe here would wait for its reader, or let the reader see an end too
  // early.
  if (output != "-" && is_plain_or_absent(output)) const io::OutputFile probe(output);
}

void print(std::string_view text) { io::write_text("/dev/stdout", text); }

void report_failure(std::string_view message) {
  fmt::print(stderr, "delone: error: {}\n", one_line(message));
}

std::string counted(std::int64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string json_string(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      json += '\\';
      json += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      json += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      json += c;
    }
  }
  return json + '"';
}

}  // namespace delone::cli
