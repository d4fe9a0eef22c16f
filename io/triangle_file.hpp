#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "delaunay/triangle_list.hpp"
#include "io/mesh.hpp"

namespace delone::io {

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

/// .edge of Triangle: header "count 1", then number, two ends and the boundary marker: 1
/// for an edge that only one triangle has, else 0. Sorted by their ends. O(n log n).
void write_edge(const std::string& path, std::span<const Triangle> triangles, int base);

/// .adj: a line a node: the node, then its neighbours counter-clockwise. lists[i] belongs
/// to nodes[i]. Throws Error if the numbers of nodes and lists differ.
void write_adj(const std::string& path, std::span<const std::int32_t> nodes,
               const std::vector<std::vector<std::int32_t>>& lists, int base);

/// The same as Mathematica's DelaunayTriangulation printed it: {{1, {2, 3}}, ...}.
void write_mathematica(const std::string& path, std::span<const std::int32_t> nodes,
                       const std::vector<std::vector<std::int32_t>>& lists, int base);

/// Qhull's output options for facets, which count from 0: `i` (the number of triangles,
/// then their corners), `Fv` (each triangle's number of corners in front) and `FN` (the
/// number of nodes, then for each node how many triangles it has and which).
void write_qhull_i(const std::string& path, std::span<const Triangle> triangles);
void write_qhull_fv(const std::string& path, std::span<const Triangle> triangles);
void write_qhull_fn(const std::string& path, std::span<const Triangle> triangles,
                    std::int64_t num_nodes);

struct TriangleFile {
  std::vector<Triangle> triangles;  ///< 0-based
  /// As the file had it. A .tri file does not say; 1 if it holds no 0 but `num_nodes`.
  int base = 0;
};

/// Reads the triangles of a file by its extension: .ele (also of 6-node triangles, whose
/// corners are taken), .adj or .renka (see read_rings: triangles_of_rings), .off, .ply,
/// .vtu or .nc (see read_mesh; it must have `num_nodes` nodes), and whatever else as
/// .tri: index triples separated by blanks, commas, semicolons or tabs, with or without a
/// header line, or what Qhull's options `i` and `Fv` print. "-" is standard input; #
/// starts a comment anywhere in a line. Orientation and order are left as they are.
///
/// An .ele file has the base of its first triangle's number. No triangles is a valid file
/// (all nodes on a line). Memory follows what the file holds, not what its header claims.
/// Throws ReadError naming the line: not a whole number, not three corners, an index
/// outside 0..num_nodes-1, a count that the file does not keep.
[[nodiscard]] TriangleFile read_triangles(const std::string& path,
                                          std::int64_t num_nodes);

/// Lists of neighbours, one for each of `num_nodes` nodes, 0-based.
struct RingFile {
  delaunay::NeighborRings rings;
  int base = 0;  ///< as the file had it; 1 if it holds no 0 but `num_nodes`
};

/// Reads .adj (a line a node: the node, then its neighbours), Mathematica's {{1, {2,
/// 3}}, ...} or, by its extension, .renka (see read_renka). Nodes without a line have no
/// neighbours. Throws ReadError naming the line: not a whole number, an index outside
/// 0..num_nodes-1, a node twice.
[[nodiscard]] RingFile read_rings(const std::string& path, std::int64_t num_nodes);

/// Reads .neigh: for each triangle its three neighbours opposite the corners, -1 at the
/// boundary; 0-based. Throws ReadError naming the line.
[[nodiscard]] std::vector<std::array<std::int32_t, 3>> read_neigh(
    const std::string& path);

/// Reads what Qhull's `FN` prints: for each node the triangles around it. Negative
/// numbers, Qhull's facets of the outside, are left out. Throws ReadError naming the
/// line.
[[nodiscard]] std::vector<std::vector<std::int32_t>> read_qhull_fn(
    const std::string& path, std::int64_t num_triangles);

/// An .edge or .v.edge file.
struct EdgeFile {
  struct Edge {
    std::int32_t from = 0;
    std::int32_t to = 0;      ///< -1: a ray
    double dx = 0, dy = 0;    ///< where a ray goes
    std::int32_t marker = 0;  ///< 0 where the file has none
  };
  std::vector<Edge> edges;  ///< 0-based
  int base = 0;             ///< as the file had it: the number of its first edge
};

/// Reads .edge, or .v.edge if any edge is a ray ("number from -1 dx dy"). Throws
/// ReadError naming the line: an index outside 0..num_nodes-1, a count that is not kept.
[[nodiscard]] EdgeFile read_edges(const std::string& path, std::int64_t num_nodes);

/// Writes .v.edge of Triangle: header "count 0", then number and two ends, or number, one
/// end, -1 and the direction of a ray.
void write_v_edge(const std::string& path, const EdgeFile& edges);

}  // namespace delone::io
