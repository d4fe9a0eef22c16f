// GeoJSON, read in one pass and without a tree in memory. Source: RFC 7946.

#include "io/geojson_lines.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "io/file_bytes.hpp"
#include "io/line_reader.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

using Json = nlohmann::json;

/// Characters of a text; the place of the last one read is told to whoever asks.
struct TrackedText {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  const char** reached = nullptr;

  const char& operator*() const { return *at; }
  TrackedText& operator++() {
    *reached = ++at;
    return *this;
  }
  bool operator==(const TrackedText& other) const { return at == other.at; }
};

/// Nested arrays of positions, flat: a position is an array of numbers at `depth` (1 for
/// a Point's), a line an array of positions, a polygon an array of lines.
struct Coordinates {
  PlaneRing positions;
  std::size_t depth = 0;                  ///< 0: no position yet
  std::vector<std::size_t> line_ends;     ///< in positions
  std::vector<std::size_t> polygon_ends;  ///< in lines
};

/// How deep the positions of a geometry lie.
struct GeometryType {
  std::string_view name;
  std::size_t depth;
};
constexpr std::array<GeometryType, 6> geometry_types{{{"Point", 1},
                                                      {"MultiPoint", 2},
                                                      {"LineString", 2},
                                                      {"MultiLineString", 3},
                                                      {"Polygon", 3},
                                                      {"MultiPolygon", 4}}};

bool is_collection(std::string_view type) {
  return type == "FeatureCollection" || type == "Feature" || type == "GeometryCollection";
}

std::string text_of(double number) {
  std::array<char, 32> digits{};  // the shortest form of a double has 24 at most
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  return {digits.data(), end.ptr};
}

std::string name_of(const std::array<double, 2>& p) {
  return "(" + text_of(p[0]) + ", " + text_of(p[1]) + ")";
}

/// Twice the signed area.
double area(const PlaneRing& ring) {
  double sum = 0;
  const auto [x0, y0] = ring.front();
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    sum += (ring[i][0] - x0) * (ring[i + 1][1] - y0) -
           (ring[i + 1][0] - x0) * (ring[i][1] - y0);
  return sum;
}

/// What the library calls while it reads (its SAX interface, whose names these are).
class Reader {
 public:
  using number_integer_t = Json::number_integer_t;
  using number_unsigned_t = Json::number_unsigned_t;
  using number_float_t = Json::number_float_t;
  using string_t = Json::string_t;
  using binary_t = Json::binary_t;

  Reader(std::string name, std::string_view text)
      : name_(name == "-" ? "standard input" : std::move(name)),
        text_(text),
        reached_(text.data()) {}

  GeoJsonLines read() {
    const TrackedText begin{text_.data(), &reached_},
        end{text_.data() + text_.size(), &reached_};
    Json::sax_parse(begin, end, this);
    return std::move(result_);
  }

  bool null() {
    const bool may_be_null = is_skipping() || (is_in_object() && slot() != Slot::type &&
                                               slot() != Slot::coordinates);
    return may_be_null || scalar("null");
  }
  bool boolean(bool) { return scalar("true or false"); }
  bool number_integer(number_integer_t n) { return number(static_cast<double>(n)); }
  bool number_unsigned(number_unsigned_t n) { return number(static_cast<double>(n)); }
  bool number_float(number_float_t n, const string_t&) { return number(n); }
  bool binary(binary_t&) { return scalar("binary data"); }
  bool string(string_t& text) {
    if (is_skipping() || !is_in_object() || slot() != Slot::type) return scalar("text");
    stack_.back().type = text;
    return true;
  }
  bool key(string_t& name) {
    if (is_skipping()) return true;
    stack_.back().slot = slot_of(name);
    return true;
  }
  bool start_object(std::size_t);
  bool end_object();
  bool start_array(std::size_t);
  bool end_array();
  bool parse_error(std::size_t, const std::string&, const Json::exception& error);

 private:
  /// What the member of an object that is being read is for.
  enum class Slot : std::uint8_t { type, coordinates, geometry, members, other };

  /// An object, or the list of "features" or "geometries".
  struct Level {
    bool is_list = false;
    Slot slot = Slot::other;
    std::string type{};
    std::optional<Coordinates> coordinates{};
  };

  static Slot slot_of(std::string_view name) {
    if (name == "type") return Slot::type;
    if (name == "coordinates") return Slot::coordinates;
    if (name == "geometry") return Slot::geometry;
    return name == "features" || name == "geometries" ? Slot::members : Slot::other;
  }

  [[nodiscard]] bool is_skipping() const noexcept { return skipped_depth_ > 0; }
  [[nodiscard]] bool is_in_object() const noexcept {
    return !stack_.empty() && !stack_.back().is_list && depth_ == 0;
  }
  [[nodiscard]] Slot slot() const { return stack_.back().slot; }
  [[nodiscard]] Coordinates& coordinates() { return *stack_.back().coordinates; }

  bool number(double value);
  bool scalar(std::string_view what);
  void push(bool is_list);
  void end_coordinates();
  void take_geometry(const Level& level);
  void take_line(std::span<const std::array<double, 2>> positions);
  void take_ring(std::span<const std::array<double, 2>> positions, bool is_outline);
  [[noreturn]] void fail(const std::string& why) const;

  std::string name_;
  std::string_view text_;
  const char* reached_;
  std::vector<Level> stack_;
  std::size_t depth_ = 0;          // of arrays, within coordinates
  std::size_t num_numbers_ = 0;    // of the position that is being read
  std::size_t skipped_depth_ = 0;  // within a value that does not matter
  GeoJsonLines result_;
};

void Reader::fail(const std::string& why) const {
  const std::string_view before(text_.data(),
                                static_cast<std::size_t>(reached_ - text_.data()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  throw ReadError(name_ + ": line " + std::to_string(line) + ", column " +
                  std::to_string(std::max<std::size_t>(1, before.size() - line_begin)) +
                  ": " + why);
}

bool Reader::parse_error(std::size_t, const std::string&, const Json::exception& error) {
  // "[json.exception...] parse error at line 1, column 2: what was read - what is wrong"
  const std::string_view text = error.what();
  const std::size_t at = text.find(" - ");
  std::string why(at == text.npos ? text : text.substr(at + 3));
  constexpr std::size_t longest = 160;
  if (why.size() > longest) why = why.substr(0, longest) + "...";
  std::ranges::replace_if(
      why, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
  fail("this is no valid JSON (" + why + "); write the file anew");
}

bool Reader::scalar(std::string_view what) {
  if (is_skipping() || (is_in_object() && slot() == Slot::other)) return true;
  const std::string found(what);
  if (stack_.empty()) fail("a GeoJSON file holds an object, not " + found);
  if (depth_ > 0) fail("coordinates are numbers in arrays, not " + found);
  if (stack_.back().is_list) fail("features and geometries are objects, not " + found);
  if (slot() == Slot::type) fail("the type is a word like \"Polygon\", not " + found);
  fail("this member cannot be " + found);
}

bool Reader::number(double value) {
  if (is_skipping() || depth_ == 0) return scalar("a number");
  Coordinates& c = coordinates();
  if (c.depth == 0) c.depth = depth_;
  if (c.depth != depth_) fail("numbers and arrays are mixed in the coordinates");
  if (num_numbers_ == 0) c.positions.push_back({value, 0});
  if (num_numbers_ == 1) c.positions.back()[1] = value;
  ++num_numbers_;
  return true;
}

void Reader::push(bool is_list) {
  constexpr std::size_t deepest = 100;
  if (stack_.size() >= deepest)
    fail("collections within collections more than 100 deep; flatten them");
  stack_.push_back({is_list});
}

bool Reader::start_object(std::size_t) {
  if (is_skipping() || (is_in_object() && slot() == Slot::other)) {
    ++skipped_depth_;
    return true;
  }
  const bool is_due = stack_.empty() || (depth_ == 0 && stack_.back().is_list) ||
                      (is_in_object() && slot() == Slot::geometry);
  if (!is_due) return scalar("an object");
  push(false);
  return true;
}

bool Reader::end_object() {
  if (is_skipping()) {
    --skipped_depth_;
    return true;
  }
  take_geometry(stack_.back());
  stack_.pop_back();
  return true;
}

bool Reader::start_array(std::size_t) {
  if (is_skipping() || (is_in_object() && slot() == Slot::other)) {
    ++skipped_depth_;
    return true;
  }
  constexpr std::size_t deepest = 4;  // a MultiPolygon's
  if (depth_ >= deepest) fail("coordinates are at most four arrays deep");
  if (depth_ == 0 && is_in_object() && slot() == Slot::members) {
    push(true);
    return true;
  }
  const bool is_first = is_in_object() && slot() == Slot::coordinates;
  if (depth_ == 0 && !is_first) return scalar("an array");
  if (is_first) stack_.back().coordinates = Coordinates();
  if (num_numbers_ > 0) fail("numbers and arrays are mixed in the coordinates");
  ++depth_;
  return true;
}

bool Reader::end_array() {
  if (is_skipping()) {
    --skipped_depth_;
  } else if (depth_ > 0) {
    end_coordinates();
    --depth_;
  } else {
    stack_.pop_back();
  }
  return true;
}

void Reader::end_coordinates() {
  Coordinates& c = coordinates();
  if (c.depth == depth_ && num_numbers_ < 2)
    fail("a position needs two numbers, longitude and latitude or x and y");
  if (c.depth == depth_ + 1) c.line_ends.push_back(c.positions.size());
  if (c.depth == depth_ + 2) c.polygon_ends.push_back(c.line_ends.size());
  num_numbers_ = 0;
}

void Reader::take_geometry(const Level& level) {
  if (is_collection(level.type)) return;
  const auto* const type =
      std::ranges::find(geometry_types, level.type, &GeometryType::name);
  if (level.type.empty()) fail("an object without a type; this is no GeoJSON");
  if (type == geometry_types.end())
    fail("GeoJSON has no type '" + excerpt(level.type) + "'; convert the file");
  if (!level.coordinates) fail("a " + level.type + " without coordinates");
  const Coordinates& c = *level.coordinates;
  if (c.depth == 0) return;  // empty arrays: an empty geometry
  if (c.depth != type->depth)
    fail("the positions of a " + level.type + " lie " + std::to_string(type->depth) +
         " arrays deep; here they lie " + std::to_string(c.depth) + " deep");
  const std::span<const std::array<double, 2>> positions(c.positions);
  if (level.type.ends_with("Point")) result_.num_points += std::ssize(positions);
  if (level.type.ends_with("Point")) return;
  std::size_t begin = 0, polygon = 0;
  bool is_outline = true;
  for (std::size_t line = 0; line < c.line_ends.size(); ++line) {
    const auto part = positions.subspan(begin, c.line_ends[line] - begin);
    level.type.ends_with("Polygon") ? take_ring(part, is_outline) : take_line(part);
    begin = c.line_ends[line];
    // An empty polygon ends where the one before it does.
    is_outline = false;
    for (; polygon < c.polygon_ends.size() && c.polygon_ends[polygon] <= line + 1;
         ++polygon)
      is_outline = true;
  }
  const std::size_t num_rings = result_.rings.size();
  const auto& ends = result_.region_ends;
  if (num_rings > (ends.empty() ? 0 : ends.back()))
    result_.region_ends.push_back(num_rings);
}

void Reader::take_line(std::span<const std::array<double, 2>> positions) {
  if (positions.size() == 1)
    fail("the line at " + name_of(positions.front()) +
         " has one position; it needs two or more");
  if (!positions.empty()) result_.lines.emplace_back(positions.begin(), positions.end());
}

void Reader::take_ring(std::span<const std::array<double, 2>> positions,
                       bool is_outline) {
  if (positions.empty()) return;
  const std::string ring = "the ring from " + name_of(positions.front());
  if (positions.front() != positions.back())
    fail(ring + " ends at " + name_of(positions.back()) +
         "; repeat its first position at its end");
  if (positions.size() < 4)
    fail(ring + " has " + std::to_string(positions.size()) +
         " positions; it needs four or more, the last repeating the first");
  auto& corners = result_.rings.emplace_back(positions.begin(), positions.end() - 1);
  if (is_outline ? area(corners) < 0 : area(corners) > 0) std::ranges::reverse(corners);
}

}  // namespace

GeoJsonLines read_geojson_lines(const std::string& path) {
  const std::string text = read_bytes(path);
  return Reader(path, text).read();
}

}  // namespace delone::io
