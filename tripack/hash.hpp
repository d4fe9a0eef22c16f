#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "delaunay/hash.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

using delaunay::Hash;

/// Of the triangulation as a list over the caller's rows: the number of rows and
/// triangles(). Equal for the same points in the same order. O(n).
[[nodiscard]] Hash hash_of_rows(const Triangulation& t);

/// Of the triangulation as a figure: the different positions in the order of (x, y), and
/// the triangles in that numbering. Equal for every order of the input and however often
/// positions repeat. O(n log n).
[[nodiscard]] Hash hash_of_positions(const Triangulation& t);

/// The same of a foreign list of triangles over the caller's rows, of either orientation;
/// equal to that of the Triangulation if the triangles are. Of repeated points any one
/// may be used. Throws Error for a triangle with a corner that is no row. As for the
/// constructor of Triangulation, points must be finite.
[[nodiscard]] Hash hash_of_positions(
    std::span<const Point2> points,
    std::span<const std::array<std::int32_t, 3>> triangles);

}  // namespace delone::tripack
