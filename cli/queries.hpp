#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "cli/points.hpp"

namespace delone::cli {

/// How a file of query points is read.
struct QuerySettings {
  std::string path;
  std::string x, y;  ///< columns; empty: by the rules of points
};

/// The positional QUERIES and --query-x, --query-y.
void add_query_options(CLI::App& app, QuerySettings& settings);

/// Reads the queries in the order of their file, on the domain of `points`. The lines are
/// kept, for csv_header and csv_columns. Bad rows are treated as `point_settings` treats
/// those of the points.
[[nodiscard]] Points read_queries(const QuerySettings& settings,
                                  const PointSettings& point_settings,
                                  const Points& points, Reporter& reporter);

/// `line` of a table as CSV: as it stands if it is CSV already.
[[nodiscard]] std::string as_csv(std::string_view line, char delimiter);

/// `field` in quotes if a comma would cut it in two.
[[nodiscard]] std::string csv_field(std::string_view field);

/// Appends a comma and a number in the fewest digits that read back the same; NaN, which
/// is missing, becomes an empty field.
void append_number(fmt::memory_buffer& buffer, double number);

/// A CSV of the queries' columns followed by `names`, whose fields `append(buffer, i)`
/// writes for query i, each with a comma before it. Queries without a header give a table
/// without one.
template <std::invocable<fmt::memory_buffer&, std::size_t> Append>
[[nodiscard]] std::string query_csv(const Points& queries,
                                    const std::vector<std::string>& names,
                                    Append append) {
  fmt::memory_buffer buffer;
  const auto add = [&buffer](std::string_view text) {
    buffer.append(text.data(), text.data() + text.size());
  };
  if (!queries.table.header.empty()) {
    add(as_csv(queries.table.header, queries.table.delimiter));
    for (const std::string& name : names) add("," + csv_field(name));
    add("\n");
  }
  for (std::size_t i = 0; i < queries.table.text.size(); ++i) {
    add(as_csv(queries.table.text[i], queries.table.delimiter));
    append(buffer, i);
    add("\n");
  }
  return {buffer.data(), buffer.size()};
}

}  // namespace delone::cli
