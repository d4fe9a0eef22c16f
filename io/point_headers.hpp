#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/table.hpp"

namespace delone::io {

/// The number of points that Qhull's two header lines announce (the dimension, perhaps
/// with a comment behind it, and the count alone in the second line). Nothing if
/// `first_line` and `following` do not begin like that. Throws ReadError for a dimension
/// other than 2.
[[nodiscard]] std::optional<std::int64_t> qhull_count(
    const std::string& file_name, std::string_view first_line,
    const std::vector<std::string_view>& following);

/// The first line of a .node file.
struct NodeTableHeader {
  std::int64_t num_nodes = 0, num_attributes = 0;
  /// "number x y attribute_1 ... marker": the columns of the lines that follow.
  std::string column_names;
};

/// Throws ReadError naming the line.
[[nodiscard]] NodeTableHeader parse_node_header(const std::string& file_name,
                                                std::int64_t line_number,
                                                std::string_view line);

/// The options with the first attribute as the default value column. Throws ReadError if
/// a value is needed and there is no attribute.
[[nodiscard]] TableOptions with_node_defaults(const std::string& file_name,
                                              const NodeTableHeader& header,
                                              TableOptions options);

/// Throws ReadError if a file does not keep the count of its header.
void check_announced_rows(const std::string& file_name, std::int64_t announced,
                          std::int64_t num_rows);

}  // namespace delone::io
