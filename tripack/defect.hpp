#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "delaunay/triangle_list.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

/// Nothing if `t` is the canonical Delaunay triangulation of its points, else one
/// sentence that says what is violated and where: ring symmetry, orientation, Euler
/// counts, exact local in-circle (perturbed) on every arc, convex boundary, every site
/// used. O(n).
[[nodiscard]] std::optional<std::string> find_defect(const Triangulation& t);

/// The same question for a foreign list of triangles over the caller's rows (either
/// orientation throughout; ties may be broken either way; of repeated points any one may
/// be used).
[[nodiscard]] std::optional<std::string> find_defect(
    std::span<const Point2> points,
    std::span<const std::array<std::int32_t, 3>> triangles);

/// The same question for foreign lists of neighbours: lists[i] holds the rows around row
/// i, in order, from any of them on, counter-clockwise or clockwise throughout, a
/// boundary row's from one boundary neighbour to the other (what Mathematica's
/// DelaunayTriangulation printed and DelaunayTriangulationQ asked). A repeated row may
/// have an empty list. Points of one line form a chain. O(n log n).
[[nodiscard]] std::optional<std::string> find_defect(
    std::span<const Point2> points, const delaunay::NeighborRings& lists);

}  // namespace delone::tripack
