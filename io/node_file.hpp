#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace delone::io {

/// A .node file of Triangle: positions with any number of attributes and, perhaps,
/// boundary markers.
struct NodeFile {
  std::vector<double> x, y;
  std::vector<std::vector<double>> attributes;  ///< one list of values an attribute
  std::vector<std::int32_t> markers;            ///< empty if the file has none
  int base = 0;                                 ///< the number of the first node: 0 or 1
};

/// Reads a .node (or .v.node) file: a line "number of nodes, 2, number of attributes,
/// number of markers (0 or 1)", then a line a node: its number, x, y, attributes, marker.
/// `#` starts a comment anywhere. Throws ReadError naming the line. (read_table reads
/// .node files too, as columns x, y and attribute_1 and so on.)
[[nodiscard]] NodeFile read_node(const std::string& path);

/// Throws WriteError, and Error if the lists have different lengths.
void write_node(const std::string& path, const NodeFile& nodes);

/// .xy: x and y, a line a node.
void write_xy(const std::string& path, std::span<const double> x,
              std::span<const double> y);

/// Qhull's input: the dimension 2, the number of points, x and y a line.
void write_qhull_points(const std::string& path, std::span<const double> x,
                        std::span<const double> y);

}  // namespace delone::io
