// PLY, the polygon file format of G. Turk (Stanford, 1994): a text header that names
// elements and their properties, then the elements as text or binary.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/byte_order.hpp"
#include "io/file_bytes.hpp"
#include "io/line_reader.hpp"
#include "io/mesh_points.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

enum class NumberType : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

constexpr std::array<std::pair<std::string_view, NumberType>, 16> type_names{{
    {"char", NumberType::i8},
    {"int8", NumberType::i8},
    {"uchar", NumberType::u8},
    {"uint8", NumberType::u8},
    {"short", NumberType::i16},
    {"int16", NumberType::i16},
    {"ushort", NumberType::u16},
    {"uint16", NumberType::u16},
    {"int", NumberType::i32},
    {"int32", NumberType::i32},
    {"uint", NumberType::u32},
    {"uint32", NumberType::u32},
    {"float", NumberType::f32},
    {"float32", NumberType::f32},
    {"double", NumberType::f64},
    {"float64", NumberType::f64},
}};

constexpr std::array<std::size_t, 8> type_bytes{1, 1, 2, 2, 4, 4, 4, 8};

std::size_t bytes_of(NumberType type) {
  return type_bytes[static_cast<std::size_t>(type)];
}

enum class Encoding : std::uint8_t { ascii, little_endian, big_endian };

struct Property {
  std::string name;
  NumberType type = NumberType::f32;
  std::optional<NumberType> count_type;  ///< of lists
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;

  [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const {
    const auto found = std::ranges::find(properties, property, &Property::name);
    if (found == properties.end()) return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
  }
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

class HeaderReader {
 public:
  explicit HeaderReader(TextCursor& cursor) : cursor_(cursor) {}

  Header read() {
    if (cursor_.word() != "ply")
      cursor_.fail("this is no PLY file: it lacks the word ply");
    cursor_.skip_line();
    for (;;) {
      const std::string_view word = cursor_.need_word("end_header");
      if (word == "format") read_format();
      if (word == "element") read_element();
      if (word == "property") read_property();
      // Binary data begin right behind this line's end, so nothing may look for words.
      cursor_.skip_line();
      if (word == "end_header") return std::move(header_);
    }
  }

 private:
  void read_format() {
    const std::string_view name = cursor_.need_word("the format");
    if (name == "ascii") return;
    if (name != "binary_little_endian" && name != "binary_big_endian")
      cursor_.fail("'" + excerpt(name) + "' is no format of PLY");
    header_.encoding =
        name == "binary_little_endian" ? Encoding::little_endian : Encoding::big_endian;
  }

  void read_element() {
    const std::string name(cursor_.need_word("an element's name"));
    header_.elements.push_back({name, cursor_.count("the number of " + name, 1), {}});
  }

  NumberType read_type() {
    const std::string_view name = cursor_.need_word("a type");
    for (const auto& [known, type] : type_names)
      if (known == name) return type;
    cursor_.fail("'" + excerpt(name) + "' is no type of PLY");
  }

  void read_property() {
    if (header_.elements.empty()) cursor_.fail("a property before the first element");
    Property property;
    const TextCursor before = cursor_;
    if (cursor_.need_word("a type") == "list") {
      property.count_type = read_type();
    } else {
      cursor_ = before;
    }
    property.type = read_type();
    property.name = cursor_.need_word("a property's name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  TextCursor& cursor_;
  Header header_;
};

/// The numbers behind the header.
class Body {
 public:
  Body(TextCursor& cursor, Encoding encoding)
      : cursor_(cursor), encoding_(encoding), bytes_(cursor.rest()) {}

  double number(NumberType type) {
    if (encoding_ == Encoding::ascii) return cursor_.real("a number");
    const std::size_t size = bytes_of(type);
    if (bytes_.size() < size) cursor_.fail("the file ends within its elements");
    const double value = decoded(bytes_.data(), type);
    bytes_.remove_prefix(size);
    return value;
  }

  /// Throws if `count` things of `least_bytes` each cannot be there.
  void require_room(std::int64_t count, std::size_t least_bytes) {
    const std::size_t left =
        encoding_ == Encoding::ascii ? cursor_.rest().size() + 1 : bytes_.size();
    if (count < 0 || static_cast<std::uint64_t>(count) > left / least_bytes)
      cursor_.fail("the file is too short: " + std::to_string(count) +
                   " elements or entries are announced, and only " +
                   std::to_string(left) + " bytes follow");
  }

  [[nodiscard]] std::size_t least_bytes(const Property& property) const {
    if (encoding_ == Encoding::ascii) return 2;
    return bytes_of(property.count_type.value_or(property.type));
  }

 private:
  template <class T>
  [[nodiscard]] double as(const char* bytes) const {
    return static_cast<double>(number_at<T>(bytes, encoding_ == Encoding::little_endian
                                                       ? std::endian::little
                                                       : std::endian::big));
  }
  [[nodiscard]] double decoded(const char* bytes, NumberType type) const {
    switch (type) {
      case NumberType::i8:
        return as<std::int8_t>(bytes);
      case NumberType::u8:
        return as<std::uint8_t>(bytes);
      case NumberType::i16:
        return as<std::int16_t>(bytes);
      case NumberType::u16:
        return as<std::uint16_t>(bytes);
      case NumberType::i32:
        return as<std::int32_t>(bytes);
      case NumberType::u32:
        return as<std::uint32_t>(bytes);
      case NumberType::f32:
        return as<float>(bytes);
      case NumberType::f64:
        return as<double>(bytes);
    }
    return 0;
  }

  TextCursor& cursor_;
  Encoding encoding_;
  std::string_view bytes_;  // binary only
};

class PlyReader {
 public:
  explicit PlyReader(TextCursor& cursor)
      : cursor_(cursor),
        header_(HeaderReader(cursor).read()),
        body_(cursor, header_.encoding) {}

  Mesh read() {
    find_vertices();
    for (const Element& element : header_.elements) read_elements(element);
    take_points(mesh_, points_);
    return std::move(mesh_);
  }

 private:
  /// Corners are held against the number of vertices, so there must be one such number
  /// and that many positions.
  void find_vertices() {
    bool is_found = false;
    for (const Element& element : header_.elements) {
      if (element.name != "vertex") continue;
      if (is_found) cursor_.fail("two elements are called vertex");
      if (!element.find("x") || !element.find("y"))
        cursor_.fail("the vertices have no properties x and y");
      num_nodes_ = element.count;
      is_found = true;
    }
  }

  void read_elements(const Element& element) {
    std::size_t least_bytes = 0;
    for (const Property& property : element.properties)
      least_bytes += body_.least_bytes(property);
    if (least_bytes == 0) return;
    body_.require_room(element.count, least_bytes);
    if (element.name == "vertex") return read_nodes(element);
    const auto list = element.find("vertex_indices") ? element.find("vertex_indices")
                                                     : element.find("vertex_index");
    const bool is_cells = element.name == "face" && list;
    for (std::int64_t i = 0; i < element.count; ++i)
      read_element(element, is_cells ? list : std::nullopt);
  }

  void read_nodes(const Element& element) {
    const auto x = element.find("x"), y = element.find("y"), z = element.find("z");
    points_.reserve(static_cast<std::size_t>(element.count));
    for (std::int64_t i = 0; i < element.count; ++i) {
      const std::vector<double> values = read_element(element, std::nullopt);
      const SpacePoint point{values[*x], values[*y], z ? values[*z] : 0};
      if (!std::isfinite(point[0] + point[1] + point[2]))
        cursor_.fail("vertex " + std::to_string(i) + " is not finite");
      points_.push_back(point);
    }
  }

  /// The values of the properties, 0 for lists. The list number `cell`, if any, is taken
  /// as a cell of the mesh.
  std::vector<double> read_element(const Element& element,
                                   std::optional<std::size_t> cell) {
    std::vector<double> values;
    values.reserve(element.properties.size());
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Property& property = element.properties[k];
      if (!property.count_type) {
        values.push_back(body_.number(property.type));
        continue;
      }
      values.push_back(0);
      const std::vector<double> list = read_list(property);
      if (cell == k) add_cell(list);
    }
    return values;
  }

  std::vector<double> read_list(const Property& property) {
    const double length = body_.number(*property.count_type);
    if (!(length >= 0 && length < 0x1p53) || length != std::floor(length))
      cursor_.fail("the length of a list is no whole number");
    const auto count = static_cast<std::int64_t>(length);
    body_.require_room(count,
                       header_.encoding == Encoding::ascii ? 2 : bytes_of(property.type));
    std::vector<double> list;
    for (std::int64_t i = 0; i < count; ++i) list.push_back(body_.number(property.type));
    return list;
  }

  void add_cell(const std::vector<double>& list) {
    for (const double corner : list) {
      if (!(corner >= 0 && corner < static_cast<double>(num_nodes_)) ||
          corner != std::floor(corner))
        cursor_.fail("a corner of face " + std::to_string(mesh_.num_cells()) +
                     " is not one of the " + std::to_string(num_nodes_) + " vertices");
      mesh_.corners.push_back(static_cast<std::int32_t>(corner));
    }
    mesh_.offsets.push_back(std::ssize(mesh_.corners));
  }

  TextCursor& cursor_;
  Header header_;
  Body body_;
  std::int64_t num_nodes_ = 0;
  std::vector<SpacePoint> points_;
  Mesh mesh_;
};

}  // namespace

Mesh read_ply(const std::string& path) {
  const std::string bytes = read_bytes(path);
  TextCursor cursor(path, bytes);
  return PlyReader(cursor).read();
}

void write_ply(const std::string& path, const Mesh& mesh) {
  TextWriter text(path);
  text << "ply\nformat ascii 1.0\nelement vertex " << mesh.num_nodes()
       << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
       << mesh.num_cells() << "\nproperty list "
       << "int int vertex_indices\nend_header\n";
  for (const auto& [x, y, z] : space_points(mesh))
    text << x << ' ' << y << ' ' << z << '\n';
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    text << mesh.cell(i).size();
    for (const std::int32_t corner : mesh.cell(i)) text << ' ' << corner;
    text << '\n';
  }
  text.commit();
}

}  // namespace delone::io
