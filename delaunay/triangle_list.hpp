#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"

/// Triangulations as lists of triangles, which know no coordinates: nodes are numbers
/// from 0, in whatever numbering the caller has.
namespace delone::delaunay {

using TriangleCorners = std::array<Node, 3>;

/// Each triangle turned so that its smallest corner comes first, its orientation kept,
/// and the triangles sorted. O(n log n).
[[nodiscard]] std::vector<TriangleCorners> canonical(
    std::vector<TriangleCorners> triangles);

/// Which side entry k of a triangle's neighbours belongs to.
enum class SideOrder : std::uint8_t {
  opposite_corner,  ///< opposite corner k: Triangle's .neigh, TRIPACK's TRLIST, Qhull
  after_corner,     ///< from corner k to corner k + 1: tnbr of GEOMPACK's DTRIS2
};

/// For each triangle the numbers of the three triangles across its sides, `none` at the
/// boundary. Any orientation. Of a side that has more than two triangles, which no
/// triangulation has, the first two are neighbours. O(n log n).
[[nodiscard]] std::vector<std::array<std::int32_t, 3>> triangle_neighbors(
    std::span<const TriangleCorners> triangles, SideOrder order);

/// Neighbours of nodes as a foreign program gives them: rings[v] lists the neighbours of
/// node v counter-clockwise, starting anywhere.
using NeighborRings = std::vector<std::vector<Node>>;

/// The triangles (v, w, x) for which each corner's ring has the other two in a row,
/// counter-clockwise, smallest corner first, sorted. Rings do not say where the outside
/// is, so if it has three nodes around it it is one of the triangles, clockwise.
/// Neighbours that are no nodes are passed over. O(n log n).
[[nodiscard]] std::vector<TriangleCorners> triangles_of_rings(const NeighborRings& rings);

/// An arc v -> w whose reverse w -> v is in no ring; {none, none} if there is none.
struct LoneArc {
  Node from = none, to = none;
  friend bool operator==(const LoneArc&, const LoneArc&) = default;
};
[[nodiscard]] LoneArc find_lone_arc(const NeighborRings& rings);

}  // namespace delone::delaunay
