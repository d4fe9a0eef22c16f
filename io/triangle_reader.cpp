#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "delaunay/error.hpp"
#include "io/fields.hpp"
#include "io/file_bytes.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"
#include "io/renka_file.hpp"
#include "io/table.hpp"
#include "io/text_cursor.hpp"
#include "io/triangle_file.hpp"

namespace delone::io {
namespace {

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

/// The number of a line that holds one number and nothing else.
std::optional<std::int64_t> single_count(std::string_view line) {
  const auto numbers = whole_numbers(line);
  if (!numbers || numbers->size() != 1) return std::nullopt;
  return numbers->front();
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
    const auto first = next_text();
    // Qhull's options i and Fv begin with the number of triangles.
    const auto announced = first ? single_count(*first) : std::nullopt;
    if (first && !announced && !is_header(*first)) add_tri_line(*first);
    while (const auto line = next_text()) add_tri_line(*line);
    const auto count = std::ssize(file_.triangles);
    if (announced && *announced != count)
      fail("its first line announces " + std::to_string(*announced) + " triangles, and " +
           std::to_string(count) + " follow");
    const bool is_from_one = !announced && line_of_last_ != 0 && line_of_zero_ == 0;
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
    // Fv: the number of corners stands in front.
    const bool is_counted = numbers->size() == 4 && numbers->front() == 3;
    if (numbers->size() != 3 && !is_counted)
      fail(std::to_string(numbers->size()) + " numbers where a triangle has 3 corners");
    add(std::span(*numbers).subspan(is_counted ? 1 : 0));
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

/// Reads rings and finds their base, as TriangleReader does for triangles.
class RingReader {
 public:
  RingReader(const std::string& path, const std::string& text, std::int64_t num_nodes)
      : cursor_(path, text, ",{}"), num_nodes_(num_nodes), is_seen_(seen_size()) {
    rings_.resize(is_seen_.size());
    is_mathematica_ = text.find('{') != std::string::npos;
  }

  RingFile read() {
    while (!cursor_.is_at_end()) {
      const std::int32_t node = read_number(cursor_.need_word("a node"));
      if (is_seen_[static_cast<std::size_t>(node)])
        cursor_.fail("node " + std::to_string(node) + " has a list already");
      is_seen_[static_cast<std::size_t>(node)] = true;
      read_ring(node);
    }
    return finish();
  }

 private:
  /// Both bases are possible at first, so there is room for one node more.
  [[nodiscard]] std::size_t seen_size() const {
    return static_cast<std::size_t>(num_nodes_) + 1;
  }

  std::int32_t read_number(std::string_view word) {
    const auto number = to_integer(word);
    if (!number) cursor_.fail("'" + excerpt(word) + "' is not a whole number");
    if (*number < 0 || *number > num_nodes_)
      cursor_.fail("index " + std::to_string(*number) + " with " +
                   std::to_string(num_nodes_) + " nodes");
    if (*number == 0) has_zero_ = true;
    if (*number == num_nodes_) has_last_ = true;
    return static_cast<std::int32_t>(*number);
  }

  /// To the end of the line, or in Mathematica's form of the braces.
  void read_ring(std::int32_t node) {
    auto& ring = rings_[static_cast<std::size_t>(node)];
    while (!(is_mathematica_ && is_at_closing_brace())) {
      const auto word = is_mathematica_ ? cursor_.word() : cursor_.word_in_line();
      if (!word) return;
      ring.push_back(read_number(*word));
    }
  }

  /// Is a closing brace the next thing but blanks, line ends, commas and the brace that
  /// opens the list?
  [[nodiscard]] bool is_at_closing_brace() const {
    const std::string_view rest = cursor_.rest();
    const std::size_t at = rest.find_first_not_of(" \t\r\n,{");
    return at == std::string_view::npos || rest[at] == '}';
  }

  RingFile finish() {
    if (has_zero_ && has_last_)
      cursor_.fail("indices 0 and " + std::to_string(num_nodes_) + " with " +
                   std::to_string(num_nodes_) + " nodes");
    RingFile file;
    file.base = has_last_ ? 1 : 0;
    if (file.base == 1) rings_.erase(rings_.begin());
    rings_.resize(static_cast<std::size_t>(num_nodes_));
    for (auto& ring : rings_)
      for (std::int32_t& neighbour : ring) neighbour -= file.base;
    file.rings = std::move(rings_);
    return file;
  }

  TextCursor cursor_;
  std::int64_t num_nodes_;
  std::vector<bool> is_seen_;
  delaunay::NeighborRings rings_;
  bool is_mathematica_ = false, has_zero_ = false, has_last_ = false;
};

TriangleFile read_mesh_triangles(const std::string& path, std::int64_t num_nodes) {
  const Mesh mesh = read_mesh(path);
  if (mesh.num_nodes() != num_nodes)
    throw ReadError(path + ": it has " + std::to_string(mesh.num_nodes()) +
                    " nodes where " + std::to_string(num_nodes) +
                    " are due; are these the triangles of these points?");
  try {
    return {triangles_of(mesh), 0};
  } catch (const Error& error) {
    throw ReadError(path + ": " + error.what());
  }
}

RingFile read_renka_rings(const std::string& path, std::int64_t num_nodes) {
  const delaunay::RenkaLists lists = read_renka(path);
  if (std::ssize(lists.lend) != num_nodes)
    throw ReadError(path + ": it has " + std::to_string(lists.lend.size()) +
                    " nodes where " + std::to_string(num_nodes) + " are due");
  try {
    const delaunay::Adjacency adjacency = from_renka(lists);
    RingFile file{{}, 1};
    for (delaunay::Site v = 0; v < adjacency.num_sites(); ++v)
      file.rings.emplace_back(adjacency.neighbors(v).begin(),
                              adjacency.neighbors(v).end());
    return file;
  } catch (const Error& error) {
    throw ReadError(path + ": " + error.what());
  }
}

void require_32_bits(const char* reader, std::int64_t num_nodes) {
  if (num_nodes < 0 || num_nodes >= std::numeric_limits<std::int32_t>::max())
    throw Error(std::string(reader) + ": " + std::to_string(num_nodes) +
                " nodes; node numbers are 32-bit");
}

/// Reads the first number of the lines of a file of Triangle, which counts them.
class LineNumbers {
 public:
  explicit LineNumbers(TextCursor& cursor) : cursor_(cursor) {}
  void read_next(const char* what) {
    const std::int64_t number = cursor_.integer(what);
    if (count_ == 0 && number == 1) base_ = 1;
    if (number != base_ + count_)
      cursor_.fail("number " + std::to_string(number) + " where " +
                   std::to_string(base_ + count_) + " is due");
    ++count_;
  }
  [[nodiscard]] int base() const noexcept { return base_; }

 private:
  TextCursor& cursor_;
  int base_ = 0;
  std::int64_t count_ = 0;
};

void require_end(TextCursor& cursor, std::int64_t count) {
  if (!cursor.is_at_end())
    cursor.fail("there is more than the " + std::to_string(count) +
                " lines that the header announces");
}

/// The second end of an edge, or a ray: -1 and its direction.
void read_far_end(TextCursor& cursor, std::int64_t num_nodes, int base,
                  EdgeFile::Edge& edge) {
  const TextCursor before = cursor;
  if (cursor.integer("the end of an edge") == -1) {
    edge.to = -1;
    edge.dx = cursor.real("the direction of a ray");
    edge.dy = cursor.real("the direction of a ray");
    return;
  }
  cursor = before;
  edge.to = cursor.index("the end of an edge", num_nodes, base);
}

}  // namespace

TriangleFile read_triangles(const std::string& path, std::int64_t num_nodes) {
  require_32_bits("read_triangles", num_nodes);
  const std::string format = file_format(path);
  if (is_mesh_format(format)) return read_mesh_triangles(path, num_nodes);
  if (format == "adj" || format == "renka") {
    const RingFile file = read_rings(path, num_nodes);
    return {delaunay::triangles_of_rings(file.rings), file.base};
  }
  TriangleReader reader(path, num_nodes);
  return format == "ele" ? reader.read_ele() : reader.read_tri();
}

RingFile read_rings(const std::string& path, std::int64_t num_nodes) {
  require_32_bits("read_rings", num_nodes);
  if (file_format(path) == "renka") return read_renka_rings(path, num_nodes);
  const std::string text = read_bytes(path);
  return RingReader(path, text, num_nodes).read();
}

std::vector<std::array<std::int32_t, 3>> read_neigh(const std::string& path) {
  const std::string text = read_bytes(path);
  TextCursor cursor(path, text);
  const std::int64_t count = cursor.count("the number of triangles", 8);
  if (cursor.integer("the number of neighbours") != 3)
    cursor.fail("only triangles with three neighbours are read");
  LineNumbers numbers(cursor);
  std::vector<std::array<std::int32_t, 3>> result;
  for (std::int64_t i = 0; i < count; ++i) {
    numbers.read_next("a triangle's number");
    auto& triangle = result.emplace_back();
    for (std::int32_t& neighbour : triangle) {
      const TextCursor before = cursor;
      neighbour = -1;
      if (cursor.integer("a neighbour") == -1) continue;
      cursor = before;
      neighbour = cursor.index("a neighbour", count, numbers.base());
    }
  }
  require_end(cursor, count);
  return result;
}

std::vector<std::vector<std::int32_t>> read_qhull_fn(const std::string& path,
                                                     std::int64_t num_triangles) {
  const std::string text = read_bytes(path);
  TextCursor cursor(path, text);
  const std::int64_t num_nodes = cursor.count("the number of nodes", 2);
  std::vector<std::vector<std::int32_t>> result;
  for (std::int64_t i = 0; i < num_nodes; ++i) {
    auto& list = result.emplace_back();
    const std::int64_t count = cursor.count("the number of triangles of a node", 2);
    for (std::int64_t k = 0; k < count; ++k) {
      const std::int64_t triangle = cursor.integer("a triangle");
      if (triangle >= num_triangles)
        cursor.fail("triangle " + std::to_string(triangle) + " of " +
                    std::to_string(num_triangles));
      if (triangle >= 0) list.push_back(static_cast<std::int32_t>(triangle));
    }
  }
  require_end(cursor, num_nodes);
  return result;
}

EdgeFile read_edges(const std::string& path, std::int64_t num_nodes) {
  const std::string text = read_bytes(path);
  TextCursor cursor(path, text);
  const std::int64_t count = cursor.count("the number of edges", 6);
  const std::int64_t num_markers = cursor.integer("the number of markers");
  if (num_markers != 0 && num_markers != 1)
    cursor.fail("the number of markers must be 0 or 1");
  LineNumbers numbers(cursor);
  EdgeFile file;
  for (std::int64_t i = 0; i < count; ++i) {
    numbers.read_next("an edge's number");
    auto& edge = file.edges.emplace_back();
    edge.from = cursor.index("the start of an edge", num_nodes, numbers.base());
    read_far_end(cursor, num_nodes, numbers.base(), edge);
    if (num_markers == 1)
      edge.marker = cursor.index("a marker", std::numeric_limits<std::int32_t>::max());
  }
  file.base = numbers.base();
  require_end(cursor, count);
  return file;
}

}  // namespace delone::io
