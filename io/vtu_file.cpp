// VTK's XML format for unstructured grids. Source: "VTK File Formats", The VTK User's
// Guide, Kitware.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "io/base64.hpp"
#include "io/fields.hpp"
#include "io/file_bytes.hpp"
#include "io/line_reader.hpp"
#include "io/mesh_points.hpp"
#include "io/table.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"
#include "io/xml_scanner.hpp"

namespace delone::io {
namespace {

constexpr int vtk_triangle = 5, vtk_polygon = 7, vtk_quad = 9;

template <class T>
std::vector<double> numbers_in(std::string_view bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    T number;
    std::memcpy(&number, bytes.data() + i * sizeof(T), sizeof(T));
    numbers[i] = static_cast<double>(number);
  }
  return numbers;
}

/// Bytes of a VTK type as numbers; nothing if the type is unknown.
std::optional<std::vector<double>> decoded(std::string_view type,
                                           std::string_view bytes) {
  if (type == "Float64") return numbers_in<double>(bytes);
  if (type == "Float32") return numbers_in<float>(bytes);
  if (type == "Int64") return numbers_in<std::int64_t>(bytes);
  if (type == "Int32") return numbers_in<std::int32_t>(bytes);
  if (type == "Int16") return numbers_in<std::int16_t>(bytes);
  if (type == "Int8") return numbers_in<std::int8_t>(bytes);
  if (type == "UInt64") return numbers_in<std::uint64_t>(bytes);
  if (type == "UInt32") return numbers_in<std::uint32_t>(bytes);
  if (type == "UInt16") return numbers_in<std::uint16_t>(bytes);
  if (type == "UInt8") return numbers_in<std::uint8_t>(bytes);
  return std::nullopt;
}

class VtuReader {
 public:
  VtuReader(const std::string& path, std::string_view document)
      : name_(path == "-" ? "standard input" : path), document_(document) {}

  Mesh read() {
    find_arrays();
    const std::vector<double> coordinates = numbers(points_, "Points");
    if (coordinates.size() % 3 != 0) fail("the points have not three coordinates each");
    std::vector<SpacePoint> points;
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
      points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    for (const double coordinate : coordinates)
      if (!std::isfinite(coordinate)) fail("a coordinate is not finite");
    take_points(mesh_, points);
    read_cells();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw ReadError(name_ + ": " + why);
  }

  /// Notes the arrays of points and cells, and where appended data begin.
  void find_arrays() {
    std::string_view section;
    int num_pieces = 0;
    for (auto tag = next_tag(document_); tag; tag = next_tag(tag->rest)) {
      if (tag->name == "VTKFile") read_file_tag(*tag);
      if (tag->name == "Piece" && ++num_pieces > 1)
        fail("more than one piece; merge them into one");
      if (tag->name == "AppendedData") return note_appended(*tag);
      const bool is_section = tag->name == "Points" || tag->name == "Cells" ||
                              tag->name == "PointData" || tag->name == "CellData";
      if (is_section) section = tag->name;
      if (tag->name == "DataArray") note_array(section, *tag);
    }
    if (num_pieces == 0) fail("this is no VTK file of an unstructured grid");
  }

  void read_file_tag(const XmlTag& tag) {
    if (tag.attribute("type") != "UnstructuredGrid")
      fail("this is a VTK file, but not of an unstructured grid");
    is_compressed_ = !tag.attribute("compressor").empty();
    is_header_long_ = tag.attribute("header_type") == "UInt64";
    is_native_ = (tag.attribute("byte_order") != "BigEndian") ==
                 (std::endian::native == std::endian::little);
  }

  void note_array(std::string_view section, const XmlTag& tag) {
    const std::string_view name = tag.attribute("Name");
    if (section == "Points" && !points_) points_ = tag;
    if (section != "Cells") return;
    if (name == "connectivity") connectivity_ = tag;
    if (name == "offsets") offsets_ = tag;
    if (name == "types") types_ = tag;
  }

  void note_appended(const XmlTag& tag) {
    is_appended_raw_ = tag.attribute("encoding") == "raw";
    const std::size_t mark = tag.rest.find('_');
    if (mark == std::string_view::npos) fail("its appended data have no beginning");
    appended_ = tag.rest.substr(mark + 1);
  }

  [[nodiscard]] std::vector<double> numbers(const std::optional<XmlTag>& array,
                                            const char* what) const {
    if (!array) fail(std::string("there is no array of ") + what);
    const std::string_view format = array->attribute("format");
    if (format == "ascii" || format.empty()) return ascii_numbers(array->content());
    if (is_compressed_) fail("its data are compressed; write them without compression");
    if (!is_native_) fail("its data have the other byte order; write them as ascii");
    const bool is_appended = format == "appended";
    const std::string bytes =
        is_appended ? appended_block(*array) : base64_block(array->content());
    auto result = decoded(array->attribute("type"), bytes);
    if (!result)
      fail("'" + excerpt(array->attribute("type")) + "' is no type of numbers");
    return *result;
  }

  [[nodiscard]] std::vector<double> ascii_numbers(std::string_view content) const {
    TextCursor cursor(name_, content);
    std::vector<double> result;
    while (const auto word = cursor.word()) {
      const Number number = parse_number(*word);
      if (number.kind != Number::Kind::finite)
        fail("'" + excerpt(*word) + "' is not a finite number");
      result.push_back(number.value);
    }
    return result;
  }

  [[nodiscard]] std::size_t header_bytes() const { return is_header_long_ ? 8 : 4; }

  /// The number of bytes that a block announces in front.
  [[nodiscard]] std::size_t announced(std::string_view header, std::size_t most) const {
    if (header.size() < header_bytes()) fail("a block of data is cut short");
    std::uint64_t size = 0;
    std::uint32_t short_size = 0;
    if (is_header_long_) {
      std::memcpy(&size, header.data(), 8);
    } else {
      std::memcpy(&short_size, header.data(), 4);
      size = short_size;
    }
    if (size > most)
      fail("a block of data announces " + std::to_string(size) + " bytes; at most " +
           std::to_string(most) + " are there");
    return static_cast<std::size_t>(size);
  }

  [[nodiscard]] std::string base64_block(std::string_view text) const {
    const std::size_t size = announced(decode_base64(text, header_bytes()), text.size());
    const std::string bytes = decode_base64(text, header_bytes() + size);
    if (bytes.size() < header_bytes() + size) fail("a block of data is cut short");
    return bytes.substr(header_bytes());
  }

  [[nodiscard]] std::string appended_block(const XmlTag& array) const {
    const auto offset = parse_integer(array.attribute("offset"));
    if (!offset || *offset < 0 || *offset > std::ssize(appended_))
      fail("an array's offset lies outside the appended data");
    const std::string_view block = appended_.substr(static_cast<std::size_t>(*offset));
    if (!is_appended_raw_) return base64_block(block);
    const std::size_t size = announced(block, block.size());
    if (block.size() < header_bytes() + size) fail("a block of data is cut short");
    return std::string(block.substr(header_bytes(), size));
  }

  void read_cells() {
    const std::vector<double> corners = numbers(connectivity_, "connectivity");
    const std::vector<double> ends = numbers(offsets_, "offsets");
    const std::vector<double> types = numbers(types_, "types");
    if (types.size() != ends.size()) fail("there are not as many types as cells");
    for (const double corner : corners) add_corner(corner);
    for (std::size_t i = 0; i < ends.size(); ++i) end_cell(ends[i], types[i]);
    if (mesh_.offsets.back() != std::ssize(mesh_.corners))
      fail("the cells do not use up the connectivity");
  }

  void add_corner(double corner) {
    if (!(corner >= 0 && corner < static_cast<double>(mesh_.num_nodes())) ||
        corner != std::floor(corner))
      fail("a corner is not one of the " + std::to_string(mesh_.num_nodes()) + " points");
    mesh_.corners.push_back(static_cast<std::int32_t>(corner));
  }

  void end_cell(double end, double type) {
    const double begin = static_cast<double>(mesh_.offsets.back());
    const std::string cell = "cell " + std::to_string(mesh_.num_cells());
    if (type != vtk_triangle && type != vtk_polygon && type != vtk_quad)
      fail(cell + " is no triangle, quadrilateral or polygon");
    if (!(end >= begin && end <= static_cast<double>(mesh_.corners.size())) ||
        end != std::floor(end))
      fail(cell + " ends outside the connectivity");
    if (type == vtk_triangle && end != begin + 3) fail(cell + " has not three corners");
    mesh_.offsets.push_back(static_cast<std::int64_t>(end));
  }

  std::string name_;
  std::string_view document_, appended_;
  std::optional<XmlTag> points_, connectivity_, offsets_, types_;
  bool is_compressed_ = false, is_header_long_ = false, is_native_ = true,
       is_appended_raw_ = false;
  Mesh mesh_;
};

void open_array(TextWriter& text, std::string_view attributes) {
  text << "        <DataArray " << attributes << " format=\"ascii\">\n";
}

void close_array(TextWriter& text) { text << "        </DataArray>\n"; }

void write_cells(TextWriter& text, const Mesh& mesh) {
  open_array(text, R"(type="Int32" Name="connectivity")");
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    std::string_view gap = "          ";
    for (const std::int32_t corner : mesh.cell(i)) {
      text << gap << corner;
      gap = " ";
    }
    text << '\n';
  }
  close_array(text);
  open_array(text, R"(type="Int64" Name="offsets")");
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i)
    text << "          " << mesh.offsets[static_cast<std::size_t>(i) + 1] << '\n';
  close_array(text);
  open_array(text, R"(type="UInt8" Name="types")");
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i)
    text << "          " << (mesh.cell(i).size() == 3 ? vtk_triangle : vtk_polygon)
         << '\n';
  close_array(text);
}

}  // namespace

Mesh read_vtu(const std::string& path) {
  const std::string document = read_bytes(path);
  return VtuReader(path, document).read();
}

void write_vtu(const std::string& path, const Mesh& mesh) {
  TextWriter text(path);
  text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
          "byte_order=\"LittleEndian\">\n  <UnstructuredGrid>\n    <Piece "
          "NumberOfPoints=\""
       << mesh.num_nodes() << "\" NumberOfCells=\"" << mesh.num_cells()
       << "\">\n      <Points>\n";
  open_array(text, R"(type="Float64" Name="Points" NumberOfComponents="3")");
  for (const auto& [x, y, z] : space_points(mesh))
    text << "          " << x << ' ' << y << ' ' << z << '\n';
  close_array(text);
  text << "      </Points>\n      <Cells>\n";
  write_cells(text, mesh);
  text << "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
  text.commit();
}

}  // namespace delone::io
