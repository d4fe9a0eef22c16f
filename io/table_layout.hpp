#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/table.hpp"

namespace delone::io {

/// How a table is laid out, as its first lines show it. Columns count from 0 here.
struct TableLayout {
  char delimiter = ',';
  bool has_header = false;
  std::vector<std::string> names;  ///< empty without a header
  std::size_t num_columns = 0;
  std::size_t x = 0, y = 1;
  std::optional<std::size_t> value, second_value;
};

/// Finds delimiter, header and the chosen columns.
///
/// `first_line` is the first that holds data or the header, `following` some of the lines
/// after it: the default value column is the first that holds numbers there. The first
/// line is a header if it holds a field that is no number; where all columns are chosen
/// by number, only those count, so that a table with a column of dates and no header
/// keeps its first row. Throws ReadError, with the columns there are, if a column does
/// not exist or none suits.
[[nodiscard]] TableLayout find_layout(const std::string& file_name,
                                      std::string_view first_line,
                                      const std::vector<std::string_view>& following,
                                      const TableOptions& options);

/// "temp_c", or "column 3" where there is no header.
[[nodiscard]] std::string column_name(const TableLayout& layout, std::size_t column);

/// "column 3 (temp_c)", for messages.
[[nodiscard]] std::string column_label(const TableLayout& layout, std::size_t column);

/// Are the coordinate columns called longitude and latitude?
[[nodiscard]] bool is_lonlat(const TableLayout& layout);

/// Units (as UDUNITS spells them) from `name [unit]`, `name (unit)` or a suffix such as
/// `_m`, `_c`,
/// `_mgal`, `_m_s`. Empty if there is none that is known.
[[nodiscard]] std::string guess_units(std::string_view column_name);

}  // namespace delone::io
