#include "io/point_headers.hpp"

#include <span>

#include "io/fields.hpp"
#include "io/line_reader.hpp"

namespace delone::io {
namespace {

[[noreturn]] void fail(const std::string& file_name, std::int64_t line,
                       const std::string& why) {
  throw ReadError(file_name + ": line " + std::to_string(line) + ": " + why);
}

/// The fields that are whole numbers, up to the first that is none.
std::vector<std::int64_t> leading_integers(std::string_view line) {
  std::vector<std::int64_t> numbers;
  const auto fields = split_fields(trim(line), ' ');
  for (std::size_t i = 0; fields && i < fields->size(); ++i) {
    const auto number = parse_integer((*fields)[i]);
    if (!number) break;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Counts that a header may leave out are 0.
std::int64_t number_at(std::span<const std::int64_t> numbers, std::size_t i) {
  return i < numbers.size() ? numbers[i] : 0;
}

}  // namespace

std::optional<std::int64_t> qhull_count(const std::string& file_name,
                                        std::string_view first_line,
                                        const std::vector<std::string_view>& following) {
  const auto dimension = leading_integers(first_line);
  if (dimension.size() != 1 || dimension[0] < 2) return std::nullopt;
  for (const std::string_view line : following) {
    if (!holds_data(line)) continue;
    const auto fields = split_fields(trim(line), ' ');
    const auto count = leading_integers(line);
    if (!fields || fields->size() != 1 || count.size() != 1 || count[0] < 0)
      return std::nullopt;
    if (dimension[0] != 2)
      throw ReadError(file_name + ": points of dimension " +
                      std::to_string(dimension[0]) + "; only dimension 2 is read");
    return count[0];
  }
  return std::nullopt;
}

NodeTableHeader parse_node_header(const std::string& file_name, std::int64_t line_number,
                                  std::string_view line) {
  const auto numbers = leading_integers(line);
  if (numbers.size() < 2)
    fail(file_name, line_number,
         "a .node file begins with the number of nodes, the dimension 2, and the numbers "
         "of attributes and markers");
  NodeTableHeader header{numbers[0], number_at(numbers, 2), "number x y"};
  if (numbers[0] < 0 || numbers[1] != 2)
    fail(file_name, line_number, "only nodes of dimension 2 are read");
  constexpr std::int64_t most_attributes = 10000;
  if (header.num_attributes < 0 || header.num_attributes > most_attributes)
    fail(file_name, line_number,
         std::to_string(header.num_attributes) + " attributes; this is no .node file");
  const std::int64_t num_markers = number_at(numbers, 3);
  if (num_markers != 0 && num_markers != 1)
    fail(file_name, line_number, "the number of boundary markers must be 0 or 1");
  for (std::int64_t i = 1; i <= header.num_attributes; ++i)
    header.column_names += " attribute_" + std::to_string(i);
  if (num_markers == 1) header.column_names += " marker";
  return header;
}

TableOptions with_node_defaults(const std::string& file_name,
                                const NodeTableHeader& header, TableOptions options) {
  if (options.x.empty()) options.x = "x";
  if (options.y.empty()) options.y = "y";
  if (!options.needs_value || !options.value.empty()) return options;
  if (header.num_attributes == 0)
    throw ReadError(file_name +
                    ": the nodes have no attributes, so there are no values; use a file "
                    "that has some");
  options.value = "attribute_1";
  return options;
}

void check_announced_rows(const std::string& file_name, std::int64_t announced,
                          std::int64_t num_rows) {
  if (announced == num_rows) return;
  throw ReadError(file_name + ": its header announces " + std::to_string(announced) +
                  " points, and " + std::to_string(num_rows) + " follow");
}

}  // namespace delone::io
