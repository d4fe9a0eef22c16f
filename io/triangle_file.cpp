#include "io/triangle_file.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "io/fields.hpp"
#include "io/line_reader.hpp"
#include "io/table.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

/// The side of a triangle opposite its corner `corner`.
struct Side {
  std::int32_t low, high;  // its ends
  std::size_t triangle;
  std::size_t corner;
  [[nodiscard]] auto ends() const { return std::tie(low, high); }
  [[nodiscard]] auto key() const { return std::tie(low, high, triangle, corner); }
};

std::vector<Side> sorted_sides(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax(triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]);
      sides.push_back({low, high, t, k});
    }
  std::ranges::sort(sides, {}, &Side::key);
  return sides;
}

/// neighbours[t][k]: the triangle across the side opposite corner k of t, -1 if there is
/// none.
std::vector<std::array<std::int64_t, 3>> neighbours_of(
    std::span<const Triangle> triangles) {
  std::vector<std::array<std::int64_t, 3>> result(triangles.size(), {-1, -1, -1});
  const std::vector<Side> sides = sorted_sides(triangles);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side& a = sides[i];
    const Side& b = sides[i + 1];
    if (a.ends() != b.ends()) continue;
    result[a.triangle][a.corner] = static_cast<std::int64_t>(b.triangle);
    result[b.triangle][b.corner] = static_cast<std::int64_t>(a.triangle);
    ++i;
  }
  return result;
}

void append_corners(TextWriter& text, const Triangle& t, int base) {
  text << t[0] + base << ' ' << t[1] + base << ' ' << t[2] + base << '\n';
}

/// All whole numbers of a line; nothing if it holds anything else.
std::optional<std::vector<std::int64_t>> whole_numbers(std::string_view line) {
  constexpr std::string_view separators = " \t,;";
  std::vector<std::int64_t> numbers;
  numbers.reserve(4);
  const char* const end = line.data() + line.size();
  for (const char* p = line.data();;) {
    while (p != end && separators.find(*p) != separators.npos) ++p;
    if (p == end) return numbers;
    std::int64_t number = 0;
    const auto parsed = std::from_chars(p, end, number);
    if (parsed.ec != std::errc{}) return std::nullopt;
    if (parsed.ptr != end && separators.find(*parsed.ptr) == separators.npos)
      return std::nullopt;
    numbers.push_back(number);
    p = parsed.ptr;
  }
}

/// Does the first line name the columns?
bool is_header(std::string_view line) {
  const auto fields = split_fields(line, detect_delimiter(line));
  return fields && parse_number(fields->front()).kind == Number::Kind::text;
}

/// The lines of a triangle file as whole numbers, and the triangles found so far. Which
/// base the file has is known only at the end, so indices 0..num_nodes are taken first,
/// and the first line is kept where either end of that range occurs.
class TriangleReader {
 public:
  TriangleReader(const std::string& path, std::int64_t num_nodes)
      : lines_(path), num_nodes_(num_nodes) {}

  [[nodiscard]] TriangleFile read_tri() {
    if (const auto first = next_text(); first && !is_header(*first)) add_tri_line(*first);
    while (const auto line = next_text()) add_tri_line(*line);
    const bool is_from_one = line_of_last_ != 0 && line_of_zero_ == 0;
    return finish(is_from_one ? 1 : 0);
  }

  [[nodiscard]] TriangleFile read_ele() {
    const auto header = next_numbers();
    if (!header || header->size() < 2)
      fail("the first line must be: number of triangles, 3, number of attributes");
    const std::int64_t count = (*header)[0], num_corners = (*header)[1];
    if (count < 0 || (num_corners != 3 && num_corners != 6))
      fail("'" + std::to_string(count) + " " + std::to_string(num_corners) +
           "' is no header of triangles with 3 or 6 nodes");
    int base = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      const auto line = next_text();
      if (!line)
        fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) +
             " triangles");
      const std::int64_t number = add_ele_line(*line, num_corners);
      if (i == 0 && (number == 0 || number == 1)) base = static_cast<int>(number);
      if (number != base + i)
        fail("triangle number " + std::to_string(number) + " where " +
             std::to_string(base + i) + " is due");
    }
    if (next_text())
      fail("there are more than the " + std::to_string(count) +
           " triangles of the header");
    return finish(base);
  }

 private:
  /// The next line that holds more than a comment, its comment cut off.
  [[nodiscard]] std::optional<std::string_view> next_text() {
    while (const auto line = lines_.next()) {
      const std::string_view text = line->substr(0, line->find('#'));
      if (holds_data(text)) return text;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::vector<std::int64_t>> next_numbers() {
    const auto line = next_text();
    return line ? whole_numbers(*line) : std::nullopt;
  }

  void add_tri_line(std::string_view line) {
    const auto numbers = whole_numbers(line);
    if (!numbers) fail("'" + excerpt(line) + "' is not three whole numbers");
    if (numbers->size() != 3)
      fail(std::to_string(numbers->size()) + " numbers where a triangle has 3 corners");
    add(*numbers);
  }

  /// Attributes may follow the corners; they need not be whole numbers. Returns the
  /// triangle's number.
  std::int64_t add_ele_line(std::string_view line, std::int64_t num_corners) {
    const auto fields = split_fields(trim(line), ' ');
    std::vector<std::int64_t> numbers;
    for (std::size_t i = 0;
         fields && i < fields->size() && std::cmp_less_equal(i, num_corners); ++i) {
      const auto number = parse_integer((*fields)[i]);
      if (!number) fail("'" + excerpt((*fields)[i]) + "' is not a whole number");
      numbers.push_back(*number);
    }
    if (std::cmp_less_equal(numbers.size(), num_corners))
      fail("a triangle needs its number and " + std::to_string(num_corners) + " nodes");
    add(std::span(numbers).subspan(1, 3));
    return numbers[0];
  }

  void add(std::span<const std::int64_t> corners) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k] < 0 || corners[k] > num_nodes_)
        fail("index " + std::to_string(corners[k]) + " with " + nodes_in_words());
      if (corners[k] == 0 && line_of_zero_ == 0) line_of_zero_ = lines_.line_number();
      if (corners[k] == num_nodes_ && line_of_last_ == 0)
        line_of_last_ = lines_.line_number();
      triangle[k] = static_cast<std::int32_t>(corners[k]);
    }
    file_.triangles.push_back(triangle);
  }

  [[nodiscard]] TriangleFile finish(int base) {
    file_.base = base;
    if (base == 1 && line_of_zero_ != 0)
      fail_at(line_of_zero_, "index 0 in a file that counts from 1");
    if (base == 0 && line_of_last_ != 0)
      fail_at(line_of_last_, "index " + std::to_string(num_nodes_) +
                                 " in a file that counts from 0, with " +
                                 nodes_in_words());
    for (Triangle& triangle : file_.triangles)
      for (std::int32_t& corner : triangle) corner -= base;
    return std::move(file_);
  }

  [[nodiscard]] std::string nodes_in_words() const {
    return std::to_string(num_nodes_) +
           " nodes; are these the triangles of these points?";
  }
  [[noreturn]] void fail(const std::string& why) const {
    fail_at(lines_.line_number(), why);
  }
  [[noreturn]] void fail_at(std::int64_t line, const std::string& why) const {
    throw ReadError(lines_.name() + ": line " + std::to_string(line) + ": " + why);
  }

  LineReader lines_;
  std::int64_t num_nodes_;
  TriangleFile file_;
  std::int64_t line_of_zero_ = 0, line_of_last_ = 0;
};

}  // namespace

void write_tri(const std::string& path, std::span<const Triangle> triangles, int base) {
  TextWriter text(path);
  for (const Triangle& triangle : triangles) append_corners(text, triangle, base);
  text.commit();
}

void write_ele(const std::string& path, std::span<const Triangle> triangles, int base) {
  TextWriter text(path);
  text << triangles.size() << " 3 0\n";
  std::int64_t number = base;
  for (const Triangle& triangle : triangles) {
    text << number++ << ' ';
    append_corners(text, triangle, base);
  }
  text.commit();
}

void write_neigh(const std::string& path, std::span<const Triangle> triangles, int base) {
  const auto shown = [base](std::int64_t triangle) {
    return triangle < 0 ? -1 : triangle + base;
  };
  TextWriter text(path);
  text << triangles.size() << " 3\n";
  std::int64_t number = base;
  for (const auto& [a, b, c] : neighbours_of(triangles))
    text << number++ << ' ' << shown(a) << ' ' << shown(b) << ' ' << shown(c) << '\n';
  text.commit();
}

void write_adj(const std::string& path, std::span<const std::int32_t> nodes,
               const std::vector<std::vector<std::int32_t>>& lists, int base) {
  if (nodes.size() != lists.size())
    throw Error("write_adj: " + std::to_string(nodes.size()) + " nodes and " +
                std::to_string(lists.size()) +
                " lists of neighbours; give one list a node");
  TextWriter text(path);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    text << nodes[i] + base;
    for (const std::int32_t neighbour : lists[i]) text << ' ' << neighbour + base;
    text << '\n';
  }
  text.commit();
}

TriangleFile read_triangles(const std::string& path, std::int64_t num_nodes) {
  if (num_nodes < 0 || num_nodes > std::numeric_limits<std::int32_t>::max())
    throw Error("read_triangles: " + std::to_string(num_nodes) +
                " nodes; node numbers are 32-bit");
  TriangleReader reader(path, num_nodes);
  return file_format(path) == "ele" ? reader.read_ele() : reader.read_tri();
}

}  // namespace delone::io
