#pragma once

#include "stripack/direction.hpp"

/// Which side, and inside or outside: the only questions topology is built on.
///
/// Exact for the directions p/|p| of the stored triples, which are not exactly of unit
/// length: the plane through three stored points is not the plane of the circle, and from
/// 1e-7 radians down the difference hides points. There is no least separation. Each is a
/// cascade of rungs, every one of which answers only when certain: a filter in doubles
/// with a proven bound (4 to 8 ns; on the equator and the meridians of 0 and 90 degrees a
/// look at the zeros settles ties), integers of 192 or 320 bits (30 to 70 ns; near-ties
/// of longitude/latitude grids), again integers of 192 bits (exact ties, 80 to 90 ns) and
/// integers of any length (0.4 microseconds and more; components below 2^-8 or so in a
/// tie, directions an ulp apart).
///
/// Source of the perturbation: H. Edelsbrunner, E. P. Muecke, ACM Trans. Graph. 9
/// (1990) 66-104.
namespace delone::stripack {

/// Sign of det(a, b, c): +1 if counter-clockwise seen from outside, 0 on a great circle.
///
/// Even permutations of the arguments do not change the answer, odd ones negate it.
[[nodiscard]] int orientation(const Direction& a, const Direction& b,
                              const Direction& c) noexcept;

/// Is `p` beyond the plane through the unit vectors a/|a|, b/|b|, c/|c|, on the side from
/// which a, b, c are counter-clockwise? +1 beyond, -1 not, 0 on it.
///
/// For a counter-clockwise triangle beyond means inside its circle. The sign is that of
/// the determinant with rows (x, y, z, |v|), negated: an odd permutation of the four
/// negates it, also where (a, b, c) is clockwise or on a great circle.
[[nodiscard]] int in_circle(const Direction& a, const Direction& b, const Direction& c,
                            const Direction& p) noexcept;

/// in_circle with ties broken canonically; never 0 for four different directions.
///
/// The answer for unit vectors that are shortened by infinitesimals, the more the lower
/// they are in the order of (x, y, z), and for those of one great circle also shifted
/// along z (y, x) by still smaller ones. It depends on coordinates only; the triangles
/// with every other site at -1 are the faces of a closed convex polyhedron that uses
/// every site, even if all sites lie on a great circle.
[[nodiscard]] int in_circle_perturbed(const Direction& a, const Direction& b,
                                      const Direction& c, const Direction& p) noexcept;

}  // namespace delone::stripack
