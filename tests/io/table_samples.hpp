#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::test {

using Doubles = std::vector<double>;
using Integers = std::vector<std::int64_t>;

inline io::PointTable read(std::string_view content,
                           const io::TableOptions& options = {}) {
  const TemporaryFolder folder;
  return io::read_table(folder.put("obs.csv", content), options);
}

/// The message for a bad table, the folder's name cut off.
inline std::string complaint(std::string_view content,
                             const io::TableOptions& options = {}) {
  const std::string message =
      message_of<io::ReadError>([&] { return read(content, options); });
  const std::size_t name = message.find("obs.csv");
  return name == std::string::npos ? message : message.substr(name);
}

inline io::TableOptions columns(const std::string& x, const std::string& y,
                                const std::string& value = "") {
  io::TableOptions options;
  options.x = x;
  options.y = y;
  options.value = value;
  return options;
}

inline io::TableOptions skipping() {
  io::TableOptions options;
  options.skip_bad_rows = true;
  return options;
}

inline io::TableOptions positions_only() {
  io::TableOptions options;
  options.needs_value = false;
  return options;
}

/// Two rows (1.5, 2, 3) and (-4, 5e-1, 6).
inline void expect_two_rows(const io::PointTable& table) {
  EXPECT_EQ(table.x, (Doubles{1.5, -4}));
  EXPECT_EQ(table.y, (Doubles{2, 0.5}));
  EXPECT_EQ(table.value, (Doubles{3, 6}));
  EXPECT_EQ(table.num_rows, 2);
}

}  // namespace delone::test
