#pragma once

#include <array>
#include <cstdint>

#include "delaunay/closed_mesh.hpp"

namespace delone::delaunay {

/// Where a query lies in a closed mesh: at `site`; on the edge `at`; or inside the face
/// of `at`, which has the ghost as a corner if the query is outside.
struct MeshPlace {
  enum class Kind : std::uint8_t { site, edge, face };
  Kind kind = Kind::face;
  HalfEdge at = none;
  Site site = none;
};

/// Is the ghost none of the corners of the face on the left of `e`?
[[nodiscard]] inline bool is_real(const ClosedMesh& mesh, HalfEdge e, Site ghost) {
  const auto& node = mesh.face(ClosedMesh::face_of(e)).node;
  return node[0] != ghost && node[1] != ghost && node[2] != ghost;
}

/// A half-edge that leaves `v` and has a face without the ghost on its left, or none.
[[nodiscard]] inline HalfEdge real_edge_at(const ClosedMesh& mesh, Site v, Site ghost) {
  const HalfEdge first = mesh.edge_at(v);
  HalfEdge e = first;
  do {
    if (e == none || is_real(mesh, e, ghost)) return e;
    e = mesh.next_around(e);
  } while (e != first);
  return none;
}

/// Walks to a query from the face of `start`, which is real. `side(u, v)`: exact sign, +1
/// if the query is left of u -> v.
///
/// Which edge of a face is looked at first changes from face to face without order: in a
/// constrained triangulation a walk that always asks in one order could go round in
/// circles.
///
/// Source: O. Devillers, S. Pion, M. Teillaud, Int. J. Found. Comput. Sci. 13 (2002)
/// 181-199.
template <class Side>
[[nodiscard]] MeshPlace walk(const ClosedMesh& mesh, Site ghost, HalfEdge start,
                             Side side) {
  HalfEdge e = start;
  for (std::uint32_t random = 0x9E3779B9u; is_real(mesh, e, ghost);) {
    random = random * 1664525u + 1013904223u;
    // The query is inside of the edge it came through: only the order of the others
    // counts.
    if ((random >> 31) != 0) e = ClosedMesh::previous(e);
    std::array<HalfEdge, 3> on{};
    std::size_t num_on = 0;
    HalfEdge out = none;
    for (int k = 0; k < 3 && out == none; ++k, e = ClosedMesh::next(e)) {
      const int s = side(mesh.origin(e), mesh.target(e));
      if (s < 0) out = e;
      if (s == 0) on[num_on++] = e;
    }
    if (out != none) {
      e = mesh.reverse(out);
    } else if (num_on == 0) {
      return {MeshPlace::Kind::face, e, none};
    } else if (num_on == 1) {
      return {MeshPlace::Kind::edge, on[0], none};
    } else {
      const bool in_order = ClosedMesh::next(on[0]) == on[1];
      return {MeshPlace::Kind::site, on[0], mesh.origin(in_order ? on[1] : on[0])};
    }
  }
  return {MeshPlace::Kind::face, e, none};
}

}  // namespace delone::delaunay
