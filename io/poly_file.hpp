#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/node_file.hpp"
#include "tripack/planar_graph.hpp"

namespace delone::io {

/// A .poly file of Triangle: a planar straight-line graph.
struct PolyFile {
  tripack::PlanarGraph graph;  ///< rows counted from 0, whatever the file does
  NodeFile nodes;              ///< the points with their attributes, markers and base
  std::vector<std::int32_t> segment_markers;  ///< empty if the file has none
  std::string node_path;  ///< the .node file that holds the points; empty: this one
  /// For each segment its line in the file, from 1.
  std::vector<std::int64_t> segment_lines;
};

/// Reads a .poly file. Its parts:
///   - points as in a .node file; if it says that there are 0, those of the .node file of
///     the same name;
///   - "number of segments, number of markers (0 or 1)", then for each its number, its
///     two ends and perhaps a marker;
///   - "number of holes", then for each its number, x and y;
///   - "number of regions" (the part may be missing), then for each its number, x, y,
///     attribute, and perhaps a largest area, negative for none.
/// `#` starts a comment anywhere. Nodes are numbered from 0 or 1, in order.
///
/// Memory follows what the file holds, not what it claims. Throws ReadError naming the
/// line: a number out of order, an end that is no node, a count that the file does not
/// keep, anything after the last part.
[[nodiscard]] PolyFile read_poly(const std::string& path);

/// Writes a .poly file that read_poly gives back: the points of `nodes` with their
/// attributes, markers and base, then segments, holes and regions. The points of `graph`
/// are not looked at. Throws WriteError, and Error if lists have different lengths or a
/// segment ends at no node.
void write_poly(const std::string& path, const PolyFile& file);

}  // namespace delone::io
