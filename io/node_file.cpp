#include "io/node_file.hpp"

#include <algorithm>
#include <limits>

#include "delaunay/error.hpp"
#include "io/file_bytes.hpp"
#include "io/node_section.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

struct NodeHeader {
  std::int64_t num_nodes = 0, num_attributes = 0, num_markers = 0;
};

/// The counts of attributes and markers may be left out.
NodeHeader read_header(TextCursor& cursor) {
  NodeHeader header;
  header.num_nodes = cursor.count("the number of nodes", 6);
  if (cursor.integer("the dimension") != 2)
    cursor.fail("only nodes of dimension 2 are read");
  if (const auto word = cursor.word_in_line()) {
    const auto number = to_integer(*word);
    // Each node has a blank and a digit for each.
    const std::int64_t room = std::ssize(cursor.rest()) / 2;
    if (!number || *number < 0 ||
        *number > room / std::max<std::int64_t>(1, header.num_nodes))
      cursor.fail("the number of attributes is too large for the file, or no number");
    header.num_attributes = *number;
  }
  if (const auto word = cursor.word_in_line()) {
    const auto number = to_integer(*word);
    if (number != 0 && number != 1)
      cursor.fail("the number of boundary markers must be 0 or 1");
    header.num_markers = *number;
  }
  return header;
}

void read_row(TextCursor& cursor, const NodeHeader& header, NodeFile& nodes) {
  nodes.x.push_back(cursor.real("x"));
  nodes.y.push_back(cursor.real("y"));
  for (auto& attribute : nodes.attributes)
    attribute.push_back(cursor.real("an attribute"));
  if (header.num_markers == 0) return;
  const std::int64_t marker = cursor.integer("a boundary marker");
  if (marker < std::numeric_limits<std::int32_t>::min() ||
      marker > std::numeric_limits<std::int32_t>::max())
    cursor.fail("boundary marker " + std::to_string(marker) + " is out of range");
  nodes.markers.push_back(static_cast<std::int32_t>(marker));
}

void require(bool holds) {
  if (!holds)
    throw Error("write_node: give every node x, y, all attributes and a marker");
}

}  // namespace

NodeFile read_node_section(TextCursor& cursor) {
  const NodeHeader header = read_header(cursor);
  NodeFile nodes;
  nodes.attributes.resize(
      header.num_nodes == 0 ? 0 : static_cast<std::size_t>(header.num_attributes));
  for (std::int64_t i = 0; i < header.num_nodes; ++i) {
    const std::int64_t number = cursor.integer("a node's number");
    if (i == 0 && number == 1) nodes.base = 1;
    if (number != i + nodes.base)
      cursor.fail("node number " + std::to_string(number) + " where " +
                  std::to_string(i + nodes.base) + " is due");
    read_row(cursor, header, nodes);
  }
  return nodes;
}

NodeFile read_node(const std::string& path) {
  const std::string text = read_bytes(path);
  TextCursor cursor(path, text);
  NodeFile nodes = read_node_section(cursor);
  if (!cursor.is_at_end())
    cursor.fail("there is more than the " + std::to_string(nodes.x.size()) +
                " nodes of the header");
  return nodes;
}

void write_node_section(TextWriter& text, const NodeFile& nodes) {
  const std::size_t count = nodes.x.size();
  require(nodes.y.size() == count);
  require(nodes.markers.empty() || nodes.markers.size() == count);
  for (const auto& attribute : nodes.attributes) require(attribute.size() == count);
  text << count << " 2 " << nodes.attributes.size() << ' '
       << (nodes.markers.empty() ? 0 : 1) << '\n';
  for (std::size_t i = 0; i < count; ++i) {
    text << i + static_cast<std::size_t>(nodes.base) << ' ' << nodes.x[i] << ' '
         << nodes.y[i];
    for (const auto& attribute : nodes.attributes) text << ' ' << attribute[i];
    if (!nodes.markers.empty()) text << ' ' << nodes.markers[i];
    text << '\n';
  }
}

void write_node(const std::string& path, const NodeFile& nodes) {
  TextWriter text(path);
  write_node_section(text, nodes);
  text.commit();
}

void write_xy(const std::string& path, std::span<const double> x,
              std::span<const double> y) {
  if (x.size() != y.size()) throw Error("write_xy: give every node x and y");
  TextWriter text(path);
  for (std::size_t i = 0; i < x.size(); ++i) text << x[i] << ' ' << y[i] << '\n';
  text.commit();
}

void write_qhull_points(const std::string& path, std::span<const double> x,
                        std::span<const double> y) {
  if (x.size() != y.size()) throw Error("write_qhull_points: give every point x and y");
  TextWriter text(path);
  text << "2\n" << x.size() << '\n';
  for (std::size_t i = 0; i < x.size(); ++i) text << x[i] << ' ' << y[i] << '\n';
  text.commit();
}

}  // namespace delone::io
