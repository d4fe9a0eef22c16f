// VTK's XML format for unstructured grids. Source: "VTK File Formats", The VTK User's
// Guide, Kitware.

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "io/fields.hpp"
#include "io/file_bytes.hpp"
#include "io/line_reader.hpp"
#include "io/mesh_points.hpp"
#include "io/table.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"
#include "io/vtk_data.hpp"
#include "io/xml_scanner.hpp"

namespace delone::io {
namespace {

constexpr int vtk_triangle = 5, vtk_polygon = 7, vtk_quad = 9;

constexpr std::string_view blanks = " \t\r\n";

/// Longer arrays are refused before their size in bytes is formed.
constexpr double most_numbers = 0x1p53;

class VtuReader {
 public:
  VtuReader(const std::string& path, std::string_view document)
      : name_(path == "-" ? "standard input" : path), document_(document) {}

  Mesh read() {
    find_arrays();
    read_points();
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
    for (auto tag = next_tag(document_); tag; tag = next_tag(tag->rest)) {
      if (tag->name == "VTKFile") note_file(*tag);
      if (tag->name == "Piece") note_piece(*tag);
      if (tag->name == "AppendedData") {
        note_appended(*tag);
        break;  // no tags behind it, but bytes that may look like them
      }
      const bool is_section = tag->name == "Points" || tag->name == "Cells" ||
                              tag->name == "PointData" || tag->name == "CellData";
      if (is_section) section = tag->name;
      if (tag->name == "DataArray") note_array(section, *tag);
    }
    if (!file_ || !has_piece_) fail("this is no VTK file of an unstructured grid");
  }

  void note_file(const XmlTag& tag) {
    if (tag.attribute("type") != "UnstructuredGrid")
      fail("this is a VTK file, but not of an unstructured grid");
    check_end();
    file_ = tag;
  }

  /// Numbers whose text is cut short are still numbers.
  void check_end() const {
    constexpr std::string_view end_tag = "</VTKFile";
    const std::size_t at = document_.rfind(end_tag);
    const std::size_t close =
        at == document_.npos ? at
                             : document_.find_first_not_of(blanks, at + end_tag.size());
    if (close == document_.npos || document_[close] != '>')
      fail("the file is cut short: it does not end with </VTKFile>");
  }

  void note_piece(const XmlTag& tag) {
    if (has_piece_) fail("more than one piece; merge them into one");
    has_piece_ = true;
    num_nodes_ = piece_count(tag, "NumberOfPoints");
    num_cells_ = piece_count(tag, "NumberOfCells");
  }

  [[nodiscard]] std::size_t piece_count(const XmlTag& tag, const char* attribute) const {
    const auto count = parse_integer(tag.attribute(attribute));
    if (!count || *count < 0 || *count > std::numeric_limits<std::int32_t>::max())
      fail(std::string("its piece has no ") + attribute + " between 0 and 2147483647");
    return static_cast<std::size_t>(*count);
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
    const std::string_view encoding = tag.attribute("encoding");
    if (encoding != "raw" && encoding != "base64" && !encoding.empty())
      fail("its appended data are encoded as '" + excerpt(encoding) +
           "', neither raw nor base64");
    if (encoding == "raw") appended_encoding_ = PackedArray::Encoding::raw;
    const std::size_t mark = tag.rest.find_first_not_of(blanks);
    if (mark == std::string_view::npos || tag.rest[mark] != '_')
      fail("its appended data do not begin with _");
    const std::size_t end = tag.rest.rfind("</AppendedData");
    if (end == std::string_view::npos) fail("its appended data have no end");
    appended_ = tag.rest.substr(mark + 1, end - mark - 1);
  }

  [[nodiscard]] std::vector<double> numbers(const std::optional<XmlTag>& array,
                                            const char* what, std::size_t count) const {
    if (!array) fail(std::string("there is no array of ") + what);
    const std::string_view format = array->attribute("format");
    if (format == "ascii" || format.empty())
      return ascii_numbers(text_of(*array), what, count);
    PackedArray packed{.name = name_ + ": the array of " + what};
    if (format == "binary") {
      packed.text = text_of(*array);
    } else if (format == "appended") {
      packed.text = appended_from(*array);
      packed.encoding = appended_encoding_;
    } else {
      fail("'" + excerpt(format) + "' is no format of an array");
    }
    return unpacked_numbers(packed, vtk_packing(*file_, name_), array->attribute("type"),
                            count);
  }

  /// What an array holds before any element inside it: VTK ends it with InformationKey.
  [[nodiscard]] static std::string_view text_of(const XmlTag& array) {
    const std::string_view content = array.content();
    return content.substr(0, content.find('<'));
  }

  [[nodiscard]] std::vector<double> ascii_numbers(std::string_view content,
                                                  const char* what,
                                                  std::size_t count) const {
    TextCursor cursor(name_, content);
    std::vector<double> result;
    while (const auto word = cursor.word()) {
      const Number number = parse_number(*word);
      if (number.kind != Number::Kind::finite)
        fail("'" + excerpt(*word) + "' is not a finite number");
      result.push_back(number.value);
    }
    if (result.size() != count)
      fail(std::string("the array of ") + what + " holds " +
           std::to_string(result.size()) + " numbers, and " + std::to_string(count) +
           " are due");
    return result;
  }

  [[nodiscard]] std::string_view appended_from(const XmlTag& array) const {
    const auto offset = parse_integer(array.attribute("offset"));
    if (!offset || *offset < 0 || *offset > std::ssize(appended_))
      fail("an array's offset lies outside the appended data");
    return appended_.substr(static_cast<std::size_t>(*offset));
  }

  void read_points() {
    const std::vector<double> coordinates = numbers(points_, "points", 3 * num_nodes_);
    std::vector<SpacePoint> points;
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
      points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    for (const double coordinate : coordinates)
      if (!std::isfinite(coordinate)) fail("a coordinate is not finite");
    take_points(mesh_, points);
  }

  void read_cells() {
    const std::vector<double> ends = numbers(offsets_, "offsets", num_cells_);
    const std::vector<double> types = numbers(types_, "types", num_cells_);
    const double num_corners = ends.empty() ? 0 : ends.back();
    if (!(num_corners >= 0 && num_corners < most_numbers) ||
        num_corners != std::floor(num_corners))
      fail("the last of its offsets is no number of corners");
    const std::vector<double> corners =
        numbers(connectivity_, "connectivity", static_cast<std::size_t>(num_corners));
    for (const double corner : corners) add_corner(corner);
    for (std::size_t i = 0; i < ends.size(); ++i) end_cell(ends[i], types[i]);
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
  PackedArray::Encoding appended_encoding_ = PackedArray::Encoding::base64;
  std::optional<XmlTag> file_, points_, connectivity_, offsets_, types_;
  bool has_piece_ = false;
  std::size_t num_nodes_ = 0, num_cells_ = 0;
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
