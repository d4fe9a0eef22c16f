#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/output_file.hpp"

namespace delone::io {

/// Text written in large pieces to an OutputFile. Locale-free. Throws WriteError as
/// OutputFile does.
class TextWriter {
 public:
  explicit TextWriter(const std::string& path) : file_(path) {}

  TextWriter& operator<<(std::string_view text);
  TextWriter& operator<<(char c) { return *this << std::string_view(&c, 1); }
  /// The shortest decimal that reads back as the same double; nothing for NaN.
  TextWriter& operator<<(std::floating_point auto number) {
    return append_number(static_cast<double>(number));
  }
  TextWriter& operator<<(std::integral auto number) {
    return append_number(static_cast<std::int64_t>(number));
  }

  void commit();

 private:
  TextWriter& append_number(double number);
  TextWriter& append_number(std::int64_t number);

  OutputFile file_;
  std::string pending_;
};

/// `text` as a field of a CSV file: quoted where it holds a delimiter, a quote or a line
/// end.
[[nodiscard]] std::string csv_field(std::string_view text);

}  // namespace delone::io
