#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/triangle_list.hpp"

namespace delone::delaunay {

/// The arcs of a list of triangles, numbered: what TRLIST gives in rows 7 to 9 (NROW =
/// 9).
struct TriangleArcs {
  /// For each triangle the numbers of its sides, each opposite its corner.
  std::vector<std::array<std::int32_t, 3>> of_triangles;
  /// For each arc its ends, the smaller first.
  std::vector<std::array<Node, 2>> ends;
};

/// Arcs are numbered from 0 in the order of their ends, so that the numbering depends on
/// the set of triangles only. Any orientation. O(n log n).
[[nodiscard]] TriangleArcs triangle_arcs(std::span<const TriangleCorners> triangles);

/// The boundary of a list of counter-clockwise triangles as closed loops of nodes, the
/// region on their left: the outer boundary, and one for each hole. Each begins at its
/// smallest node; loops are in the order of those. Where loops touch in a node they turn
/// as far to the left as the triangles there allow, so that no loop crosses another. O(n
/// log n).
[[nodiscard]] std::vector<std::vector<Node>> boundary_loops(
    std::span<const TriangleCorners> triangles);

}  // namespace delone::delaunay
