#include "io/poly_file.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <limits>

#include "delaunay/error.hpp"
#include "io/file_bytes.hpp"
#include "io/node_section.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

using delaunay::Node;
using tripack::Point2;

// Fewest bytes of a line: one character a number and what separates them.
constexpr std::int64_t segment_bytes = 6, seed_bytes = 6;

std::int32_t read_marker(TextCursor& cursor) {
  const std::int64_t marker = cursor.integer("a boundary marker");
  if (marker < std::numeric_limits<std::int32_t>::min() ||
      marker > std::numeric_limits<std::int32_t>::max())
    cursor.fail("boundary marker " + std::to_string(marker) + " is out of range");
  return static_cast<std::int32_t>(marker);
}

// The number of a segment, hole or region; they count like the nodes, or from 0 or 1.
class Numbering {
 public:
  Numbering(TextCursor& cursor, const char* what) : cursor_(cursor), what_(what) {}
  void read() {
    const std::int64_t number = cursor_.integer(std::string("the number of a ") + what_);
    if (due_ < 0 && (number == 0 || number == 1)) due_ = number;
    if (number != due_)
      cursor_.fail(std::string(what_) + " number " + std::to_string(number) + " where " +
                   std::to_string(due_ < 0 ? 1 : due_) + " is due");
    ++due_;
  }

 private:
  TextCursor& cursor_;
  const char* what_;
  std::int64_t due_ = -1;
};

void read_segments(TextCursor& cursor, PolyFile& file) {
  const std::int64_t count = cursor.count("the number of segments", segment_bytes);
  std::int64_t num_markers = 0;
  if (const auto word = cursor.word_in_line()) {
    const auto number = to_integer(*word);
    if (number != 0 && number != 1)
      cursor.fail("the number of boundary markers must be 0 or 1");
    num_markers = *number;
  }
  Numbering numbering(cursor, "segment");
  const auto num_nodes = static_cast<std::int64_t>(file.nodes.x.size());
  for (std::int64_t i = 0; i < count; ++i) {
    numbering.read();
    const Node from = cursor.index("an end of a segment", num_nodes, file.nodes.base);
    const Node to = cursor.index("an end of a segment", num_nodes, file.nodes.base);
    file.graph.segments.push_back({from, to});
    file.segment_lines.push_back(cursor.line_number());
    if (num_markers == 1) file.segment_markers.push_back(read_marker(cursor));
  }
}

Point2 read_point(TextCursor& cursor) {
  const double x = cursor.real("x");
  return {x, cursor.real("y")};
}

void read_holes(TextCursor& cursor, PolyFile& file) {
  if (cursor.is_at_end()) return;
  const std::int64_t count = cursor.count("the number of holes", seed_bytes);
  Numbering numbering(cursor, "hole");
  for (std::int64_t i = 0; i < count; ++i) {
    numbering.read();
    file.graph.holes.push_back(read_point(cursor));
  }
}

double to_real(TextCursor& cursor, std::string_view word) {
  TextCursor number("", word);
  try {
    return number.real("a largest area");
  } catch (const std::exception&) {
    cursor.fail("the largest area of a region is not a finite number");
  }
}

void read_regions(TextCursor& cursor, PolyFile& file) {
  if (cursor.is_at_end()) return;
  const std::int64_t count = cursor.count("the number of regions", seed_bytes);
  Numbering numbering(cursor, "region");
  for (std::int64_t i = 0; i < count; ++i) {
    numbering.read();
    tripack::RegionSeed region{read_point(cursor)};
    region.attribute = cursor.real("the attribute of a region");
    if (const auto area = cursor.word_in_line())
      region.max_area = std::max(0.0, to_real(cursor, *area));
    file.graph.regions.push_back(region);
  }
}

void check_poly(const PolyFile& file) {
  const auto& segments = file.graph.segments;
  if (!file.segment_markers.empty() && file.segment_markers.size() != segments.size())
    throw Error("write_poly: give every segment a marker, or none");
  const std::int64_t num_nodes = std::ssize(file.nodes.x);
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const Node end : segments[i])
      if (end < 0 || end >= num_nodes)
        throw Error("write_poly: segment " + std::to_string(i) + " ends at row " +
                        std::to_string(end) + ", but there are " +
                        std::to_string(num_nodes) + " points; correct its ends",
                    {static_cast<std::int64_t>(i)});
}

void write_segments(TextWriter& text, const PolyFile& file) {
  const auto& segments = file.graph.segments;
  const int base = file.nodes.base;
  text << segments.size() << ' ' << (file.segment_markers.empty() ? 0 : 1) << '\n';
  for (std::size_t i = 0; i < segments.size(); ++i) {
    text << i + static_cast<std::size_t>(base) << ' ' << segments[i][0] + base << ' '
         << segments[i][1] + base;
    if (!file.segment_markers.empty()) text << ' ' << file.segment_markers[i];
    text << '\n';
  }
}

void write_seeds(TextWriter& text, const PolyFile& file) {
  std::int64_t number = file.nodes.base;
  text << file.graph.holes.size() << '\n';
  for (const Point2 p : file.graph.holes)
    text << number++ << ' ' << p.x << ' ' << p.y << '\n';
  if (file.graph.regions.empty()) return;
  number = file.nodes.base;
  text << file.graph.regions.size() << '\n';
  for (const tripack::RegionSeed& region : file.graph.regions) {
    text << number++ << ' ' << region.point.x << ' ' << region.point.y << ' '
         << region.attribute;
    if (region.max_area > 0) text << ' ' << region.max_area;
    text << '\n';
  }
}

}  // namespace

PolyFile read_poly(const std::string& path) {
  const std::string text = read_bytes(path);
  TextCursor cursor(path, text);
  PolyFile file;
  file.nodes = read_node_section(cursor);
  if (file.nodes.x.empty() && path != "-") {
    file.node_path = std::filesystem::path(path).replace_extension(".node").string();
    file.nodes = read_node(file.node_path);
  }
  for (std::size_t i = 0; i < file.nodes.x.size(); ++i)
    file.graph.points.push_back({file.nodes.x[i], file.nodes.y[i]});
  read_segments(cursor, file);
  read_holes(cursor, file);
  read_regions(cursor, file);
  if (!cursor.is_at_end()) cursor.fail("there is more than the regions of the file");
  return file;
}

void write_poly(const std::string& path, const PolyFile& file) {
  check_poly(file);
  TextWriter text(path);
  write_node_section(text, file.nodes);
  write_segments(text, file);
  write_seeds(text, file);
  text.commit();
}

}  // namespace delone::io
