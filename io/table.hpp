#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "delaunay/error.hpp"

namespace delone::io {

/// A file that cannot be read or used: unreadable, malformed. One line naming file, line,
/// column and mend.
class ReadError : public Error {
 public:
  using Error::Error;
};
/// An output that cannot be written.
class WriteError : public Error {
 public:
  using Error::Error;
};

/// Which columns to read, by 1-based number or by name (exact, else in any case of
/// letters). Empty: columns called lon/longitude and lat/latitude, else x and y (units as
/// in `x_m`, `Lon (deg)` allowed), and the first other column of numbers; without a
/// header the first two and the next.
struct TableOptions {
  /// Rings: without a header, or with one that names no coordinates, the first three
  /// columns are the ring's number (the value), x and y; with one, the value is the first
  /// other column.
  enum class Content : std::uint8_t { points, rings };
  Content content = Content::points;
  std::string x, y, value;
  /// A second column of values, of vectors; empty: none. Rows that lack either value are
  /// dropped.
  std::string second_value;
  /// false: a value column is read only if `value` names it.
  bool needs_value = true;
  bool skip_bad_rows = false;
  /// Keep every kept line's text and the header's, for outputs that repeat the columns.
  bool keep_text = false;
  /// What a message tells to choose columns with.
  std::string x_option = "--x", y_option = "--y";
};

/// The columns of a table of points. Only rows that are sound and have a value are kept;
/// they keep the number that they have among all data rows (header, comments and blank
/// lines not counted).
struct PointTable {
  /// One entry a kept row; `value` is empty where none was read.
  std::vector<double> x, y, value, second_value;
  /// For each kept row its data row number, from 0; empty if that is its index here.
  std::vector<std::int64_t> row;
  /// For each kept row its line in the file, from 1; empty if that is first_line + row.
  std::vector<std::int64_t> line;
  std::int64_t first_line = 1;
  std::int64_t num_rows = 0;     ///< data rows in the file, dropped ones counted
  std::int64_t num_missing = 0;  ///< dropped: value missing (nan, NA, empty) or infinite
  std::int64_t num_bad = 0;      ///< dropped by skip_bad_rows
  std::string x_name, y_name, value_name, second_value_name;  ///< or "column 1" and so on
  bool is_lonlat = false;  ///< the coordinate columns are called longitude/latitude
  /// From `name [unit]`, `name (unit)`, `name_unit`, or empty.
  std::string value_units, second_value_units;
  std::string header;             ///< the header line as it stands (keep_text)
  std::vector<std::string> text;  ///< the kept lines as they stand (keep_text)
  char delimiter = ',';       ///< ',', ';', '\t' or ' ' (any number of blanks and tabs)
  bool is_node_file = false;  ///< the file is a .node file of Triangle
  int base = 0;               ///< the number that a .node file gives to its first node

  /// The data row number of kept row i.
  [[nodiscard]] std::int64_t row_of(std::size_t i) const {
    return row.empty() ? static_cast<std::int64_t>(i) : row[i];
  }
  /// The line in the file of kept row i.
  [[nodiscard]] std::int64_t line_of(std::size_t i) const {
    return line.empty() ? first_line + row_of(i) : line[i];
  }
};

/// Reads a CSV, TSV, semicolon- or blank-separated table in one pass; "-" is standard
/// input.
///
/// Header or none (a first line with a field that is no number is a header), # comment
/// lines, CRLF, byte order mark, quoted fields ("" for a quote; no line breaks inside),
/// no final newline. A decimal point whatever the locale. Numbers are correctly rounded.
///
/// A row is bad, and so an error naming line and column or dropped by skip_bad_rows, if
/// its number of fields differs from the first line's, if one of the chosen fields is no
/// number, or if a coordinate is missing or infinite. Ranges (latitude) are not checked
/// here: see PointTable::line_of.
///
/// Two formats of points are known besides. A file called `.node` is Triangle's: its
/// columns are number, x, y, attribute_1, ..., marker, the value by default the first
/// attribute; `#` starts a comment anywhere. A file that begins with Qhull's two lines,
/// dimension and number of points, is read without them. Both must keep their counts.
///
/// Memory: the columns and a buffer of 256 KiB, or the longest line. Time: about 0.1 s a
/// million rows of three numbers.
///
/// Throws ReadError: unreadable, not text, bad row, no such column, no data rows or none
/// left.
[[nodiscard]] PointTable read_table(const std::string& path,
                                    const TableOptions& options = {});

}  // namespace delone::io
