#pragma once

#include <optional>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/edge_rings.hpp"

namespace delone::delaunay {

/// The faces of the rings: what ClosedMesh::from makes of their neighbour lists, number
/// for number, without the lists. The rings are used up. Every site has neighbours, and
/// the outside, if any, lies along `hull`. Nothing if the numbers of half-edges and
/// triangles are not those of Euler's formula: then they are not the rings of a
/// triangulation. O(n).
[[nodiscard]] std::optional<ClosedMesh> take_faces(EdgeRings rings);

}  // namespace delone::delaunay
