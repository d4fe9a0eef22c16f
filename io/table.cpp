#include "io/table.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/fields.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"
#include "io/point_headers.hpp"
#include "io/table_layout.hpp"

namespace delone::io {
namespace {

/// A chosen column and what it is.
struct Target {
  enum Role : std::size_t { x, y, value, second_value };
  std::size_t column = 0;
  Role role = x;
  [[nodiscard]] bool may_be_missing() const noexcept { return role >= value; }
};

/// What became of a row. Only `good` rows are kept.
struct Row {
  enum class Verdict { good, missing_value, bad };
  Verdict verdict = Verdict::good;
  std::array<double, 4> numbers{};  // by Target::Role
};

/// Reads the chosen fields of the lines of one layout.
class RowParser {
 public:
  explicit RowParser(const TableLayout& layout)
      : layout_(layout), delimiter_(layout.delimiter) {
    targets_ = {{layout.x, Target::x}, {layout.y, Target::y}};
    if (layout.value) targets_.push_back({*layout.value, Target::value});
    if (layout.second_value)
      targets_.push_back({*layout.second_value, Target::second_value});
    std::ranges::sort(targets_, {}, &Target::column);
  }

  [[nodiscard]] Row parse(std::string_view line) const {
    const Row row = parse_plain(line);
    return row.verdict == Row::Verdict::good ? row : parse_carefully(line);
  }

  /// What is wrong with a line that parse() calls bad, naming the column.
  [[nodiscard]] std::string complaint(std::string_view line) const;

 private:
  [[nodiscard]] Row parse_plain(std::string_view line) const;
  [[nodiscard]] Row parse_carefully(std::string_view line) const;
  [[nodiscard]] const char* skip_blanks(const char* p, const char* end) const;
  [[nodiscard]] const char* next_field(const char* p, const char* end) const;
  [[nodiscard]] bool is_field_end(const char* p, const char* end) const;

  const TableLayout& layout_;
  char delimiter_;
  std::vector<Target> targets_;  // by column
};

const char* RowParser::skip_blanks(const char* p, const char* end) const {
  while (p != end && is_blank(*p) && (*p != delimiter_ || delimiter_ == ' ')) ++p;
  return p;
}

/// From anywhere in a field without quotes to the start of the next one; nullptr if it
/// was the last.
const char* RowParser::next_field(const char* p, const char* end) const {
  if (delimiter_ == ' ') {
    while (p != end && !is_blank(*p)) ++p;
    p = skip_blanks(p, end);
    return p == end ? nullptr : p;
  }
  while (p != end && *p != delimiter_) ++p;
  return p == end ? nullptr : skip_blanks(p + 1, end);
}

/// Does nothing but blanks stand between `p` and the end of its field?
bool RowParser::is_field_end(const char* p, const char* end) const {
  if (p == end || is_blank(*p)) p = skip_blanks(p, end);
  return p == end || *p == delimiter_ || (delimiter_ == ' ' && is_blank(p[-1]));
}

/// The quick way for lines of finite numbers in fields without quotes; whatever else is
/// there makes the row "bad", which only means that parse_carefully has to look.
Row RowParser::parse_plain(std::string_view line) const {
  Row row{.verdict = Row::Verdict::bad};
  const char* const end = line.data() + line.size();
  const char* p = skip_blanks(line.data(), end);
  std::size_t column = 0;
  for (const Target& target : targets_) {
    for (; column < target.column; ++column) {
      p = next_field(p, end);
      if (p == nullptr || p == end || *p == '"') return row;
    }
    double& number = row.numbers[target.role];
    const auto [number_end, error] = fast_float::from_chars(p, end, number);
    if (error != std::errc{} || !std::isfinite(number) || !is_field_end(number_end, end))
      return row;
  }
  while ((p = next_field(p, end)) != nullptr) {
    if (p != end && *p == '"') return row;
    ++column;
  }
  if (column + 1 == layout_.num_columns) row.verdict = Row::Verdict::good;
  return row;
}

Row RowParser::parse_carefully(std::string_view line) const {
  Row row{.verdict = Row::Verdict::bad};
  const auto fields = split_fields(line, delimiter_);
  if (!fields || fields->size() != layout_.num_columns) return row;
  bool has_value = true;
  for (const Target& target : targets_) {
    const Number number = parse_number((*fields)[target.column]);
    row.numbers[target.role] = number.value;
    if (number.kind == Number::Kind::finite) continue;
    if (!target.may_be_missing() || number.kind == Number::Kind::text) return row;
    has_value = false;
  }
  row.verdict = has_value ? Row::Verdict::good : Row::Verdict::missing_value;
  return row;
}

std::string RowParser::complaint(std::string_view line) const {
  const auto fields = split_fields(line, delimiter_);
  if (!fields) return ": a quoted field does not end on this line";
  if (fields->size() != layout_.num_columns)
    return ": " + std::to_string(fields->size()) + " fields where the first line has " +
           std::to_string(layout_.num_columns);
  for (const Target& target : targets_) {
    const std::string_view field = (*fields)[target.column];
    const Number::Kind kind = parse_number(field).kind;
    const std::string place = ", " + column_label(layout_, target.column) + ": ";
    if (kind == Number::Kind::text)
      return place + "'" + excerpt(field) + "' is not a number";
    if (target.may_be_missing() || kind == Number::Kind::finite) continue;
    if (kind == Number::Kind::missing && field.empty())
      return place + "the coordinate is empty";
    return place + "the coordinate '" + excerpt(field) + "' is not finite";
  }
  return ": the row cannot be used";
}

/// Collects rows, keeping row and line numbers only once they cannot be computed.
class TableBuilder {
 public:
  TableBuilder(const LineReader& reader, const TableLayout& layout,
               const TableOptions& options)
      : reader_(reader),
        options_(options),
        parser_(layout),
        has_value_(layout.value),
        has_second_value_(layout.second_value) {}

  void add(std::string_view line) {
    const Row row = parser_.parse(line);
    if (table_.num_rows == 0) table_.first_line = reader_.line_number();
    if (row.verdict == Row::Verdict::good) keep(row, line);
    if (row.verdict == Row::Verdict::missing_value) ++table_.num_missing;
    if (row.verdict == Row::Verdict::bad) drop_bad(line);
    ++table_.num_rows;
  }

  void reserve(std::size_t num_rows) {
    table_.x.reserve(num_rows);
    table_.y.reserve(num_rows);
    if (has_value_) table_.value.reserve(num_rows);
    if (has_second_value_) table_.second_value.reserve(num_rows);
  }

  [[nodiscard]] PointTable take() { return std::move(table_); }

 private:
  void keep(const Row& row, std::string_view line) {
    number(table_.num_rows, reader_.line_number());
    table_.x.push_back(row.numbers[Target::x]);
    table_.y.push_back(row.numbers[Target::y]);
    if (has_value_) table_.value.push_back(row.numbers[Target::value]);
    if (has_second_value_)
      table_.second_value.push_back(row.numbers[Target::second_value]);
    if (options_.keep_text) table_.text.emplace_back(line);
  }

  void number(std::int64_t row, std::int64_t line) {
    const std::size_t kept = table_.x.size();
    const bool is_line_plain = table_.line.empty() && line == table_.first_line + row;
    if (!is_line_plain) {
      for (std::size_t i = table_.line.size(); i < kept; ++i)
        table_.line.push_back(table_.first_line + table_.row_of(i));
      table_.line.push_back(line);
    }
    const bool is_row_plain =
        table_.row.empty() && row == static_cast<std::int64_t>(kept);
    if (!is_row_plain) {
      for (std::size_t i = table_.row.size(); i < kept; ++i)
        table_.row.push_back(static_cast<std::int64_t>(i));
      table_.row.push_back(row);
    }
  }

  void drop_bad(std::string_view line) {
    if (options_.skip_bad_rows) {
      ++table_.num_bad;
      return;
    }
    throw ReadError(reader_.name() + ": line " + std::to_string(reader_.line_number()) +
                        parser_.complaint(line) + "; mend the row or use --skip-bad-rows",
                    {table_.num_rows});
  }

  const LineReader& reader_;
  const TableOptions& options_;
  RowParser parser_;
  bool has_value_, has_second_value_;
  PointTable table_;
};

/// The next line that holds data; nothing at the end of the file.
std::optional<std::string_view> next_data_line(LineReader& reader) {
  auto line = reader.next();
  while (line && !holds_data(*line)) line = reader.next();
  return line;
}

/// How many rows the file probably holds, a little too many rather than too few.
std::size_t expected_rows(const LineReader& reader,
                          std::span<const std::string_view> lines) {
  std::int64_t num_bytes = 0;
  for (const std::string_view line : lines) num_bytes += std::ssize(line) + 1;
  if (num_bytes == 0) return 0;
  const double rows_a_byte =
      static_cast<double>(lines.size()) / static_cast<double>(num_bytes);
  return static_cast<std::size_t>(1.02 * rows_a_byte *
                                  static_cast<double>(reader.num_bytes()));
}

void describe_columns(PointTable& table, const TableLayout& layout) {
  table.x_name = column_name(layout, layout.x);
  table.y_name = column_name(layout, layout.y);
  table.is_lonlat = is_lonlat(layout);
  table.delimiter = layout.delimiter;
  if (layout.value) {
    table.value_name = column_name(layout, *layout.value);
    if (layout.has_header) table.value_units = guess_units(table.value_name);
  }
  if (layout.second_value) {
    table.second_value_name = column_name(layout, *layout.second_value);
    if (layout.has_header)
      table.second_value_units = guess_units(table.second_value_name);
  }
}

void check_not_empty(const PointTable& table, const std::string& file_name) {
  if (!table.x.empty()) return;
  if (table.num_rows == 0) throw ReadError(file_name + ": no data rows, only a header");
  throw ReadError(file_name + ": no usable rows: of " + std::to_string(table.num_rows) +
                  ", " + std::to_string(table.num_missing) + " have no value and " +
                  std::to_string(table.num_bad) + " are bad");
}

/// The number, from `base`, of each line of a .node file in turn.
class NodeNumbers {
 public:
  /// Throws unless the line begins with the number that is due.
  void check(const LineReader& reader, std::string_view line) {
    const std::string_view text = trim(line);
    const std::string_view first = text.substr(0, text.find_first_of(" \t"));
    const auto number = parse_integer(first);
    if (count_ == 0 && number == 1) base_ = 1;
    if (number != base_ + count_)
      throw ReadError(reader.name() + ": line " + std::to_string(reader.line_number()) +
                      ": '" + excerpt(first) + "' where node number " +
                      std::to_string(base_ + count_) + " is due");
    ++count_;
  }
  [[nodiscard]] int base() const noexcept { return base_; }

 private:
  int base_ = 0;
  std::int64_t count_ = 0;
};

/// The next line that holds data, with a comment behind it cut off.
std::optional<std::string_view> next_node_line(LineReader& reader) {
  const auto line = next_data_line(reader);
  if (!line) return std::nullopt;
  return line->substr(0, line->find('#'));
}

PointTable read_node_table(LineReader& reader, const TableOptions& options) {
  auto line = next_node_line(reader);
  if (!line) throw ReadError(reader.name() + ": no data rows, the file is empty");
  const NodeTableHeader header =
      parse_node_header(reader.name(), reader.line_number(), *line);
  const TableOptions chosen = with_node_defaults(reader.name(), header, options);
  const TableLayout layout = find_layout(reader.name(), header.column_names, {}, chosen);
  TableBuilder builder(reader, layout, chosen);
  builder.reserve(expected_rows(reader, reader.peek(100)));
  NodeNumbers numbers;
  for (line = next_node_line(reader); line; line = next_node_line(reader)) {
    numbers.check(reader, *line);
    builder.add(*line);
  }
  PointTable table = builder.take();
  check_announced_rows(reader.name(), header.num_nodes, table.num_rows);
  describe_columns(table, layout);
  if (options.keep_text) table.header = header.column_names;
  table.base = numbers.base();
  table.is_node_file = true;
  check_not_empty(table, reader.name());
  return table;
}

}  // namespace

PointTable read_table(const std::string& path, const TableOptions& options) {
  constexpr std::size_t num_peeked = 200;
  LineReader reader(path);
  if (file_format(path) == "node") return read_node_table(reader, options);
  auto line = next_data_line(reader);
  if (!line) throw ReadError(reader.name() + ": no data rows, the file is empty");
  const auto announced = qhull_count(reader.name(), *line, reader.peek(num_peeked));
  if (announced) {
    static_cast<void>(next_data_line(reader));
    line = next_data_line(reader);
    if (!line) throw ReadError(reader.name() + ": no data rows, only a header");
  }
  const auto following = reader.peek(num_peeked);
  const TableLayout layout = find_layout(reader.name(), *line, following, options);
  TableBuilder builder(reader, layout, options);
  builder.reserve(expected_rows(reader, following));
  const std::string header(options.keep_text && layout.has_header ? *line : "");
  if (layout.has_header) line = next_data_line(reader);
  for (; line; line = next_data_line(reader)) builder.add(*line);

  PointTable table = builder.take();
  if (announced) check_announced_rows(reader.name(), *announced, table.num_rows);
  describe_columns(table, layout);
  table.header = header;
  check_not_empty(table, reader.name());
  return table;
}

}  // namespace delone::io
