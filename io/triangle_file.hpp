#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace delone::io {

using Triangle = std::array<std::int32_t, 3>;

// Writing: indices are 0-based in memory; `base` (0 or 1) is the number that the file
// gives to the first node and the first triangle. All throw WriteError.

/// .tri: index triples, one a line.
void write_tri(const std::string& path, std::span<const Triangle> triangles, int base);

/// .ele of Triangle: header "count 3 0", then number and three corners.
void write_ele(const std::string& path, std::span<const Triangle> triangles, int base);

/// .neigh of Triangle: header "count 3", then number and the three neighbours opposite
/// its corners, -1 at the boundary. O(n log n). Of an edge that has more than two
/// triangles, which no triangulation has, the first two are neighbours.
void write_neigh(const std::string& path, std::span<const Triangle> triangles, int base);

/// .adj: a line a node: the node, then its neighbours counter-clockwise. lists[i] belongs
/// to nodes[i]. Throws Error if the numbers of nodes and lists differ.
void write_adj(const std::string& path, std::span<const std::int32_t> nodes,
               const std::vector<std::vector<std::int32_t>>& lists, int base);

struct TriangleFile {
  std::vector<Triangle> triangles;  ///< 0-based
  /// As the file had it. A .tri file does not say; 1 if it holds no 0 but `num_nodes`.
  int base = 0;
};

/// Reads .ele (also of 6-node triangles, whose corners are taken) or, whatever the
/// extension, .tri: index triples separated by blanks, commas, semicolons or tabs, with
/// or without a header line. "-" is standard input; # starts a comment anywhere in a
/// line.
///
/// An .ele file has the base of its first triangle's number. No triangles is a valid file
/// (all nodes on a line). Memory follows what the file holds, not what its header claims.
/// Throws ReadError naming the line: not a whole number, not three corners, an index
/// outside 0..num_nodes-1, a count that the file does not keep.
[[nodiscard]] TriangleFile read_triangles(const std::string& path,
                                          std::int64_t num_nodes);

}  // namespace delone::io
