#pragma once

#include "tripack/point.hpp"

/// Which side, and inside or outside: the only questions topology is built on.
///
/// Exact for every finite double, subnormal numbers and those near the overflow limit
/// included: no tolerance, no scale. Each is a cascade of rungs, every one of which
/// answers only when certain: a filter in doubles with a proven bound (3 to 5 ns),
/// integers of 128 or 256 bits (13 to 30 ns; it decides ties on lattices and grids) and
/// integers of any length (0.1 to 0.4 microseconds). In double rounding to nearest; the
/// arguments must be finite.
///
/// Source of the filters: J. R. Shewchuk, Discrete Comput. Geom. 18 (1997) 305-363; of
/// the perturbation: H. Edelsbrunner, E. P. Muecke, ACM Trans. Graph. 9 (1990) 66-104.
namespace delone::tripack {

/// Which side of the line a -> b is c on? +1 left, -1 right, 0 exactly on it.
///
/// Even permutations of the arguments do not change the answer, odd ones negate it.
[[nodiscard]] int orientation(Point2 a, Point2 b, Point2 c) noexcept;

/// Is `p` inside the circle through `a`, `b`, `c`? +1 inside, -1 outside, 0 on it.
///
/// `a`, `b`, `c` counter-clockwise; clockwise negates the answer. In general an odd
/// permutation of the four does, so the two triangles at an edge always agree.
[[nodiscard]] int in_circle(Point2 a, Point2 b, Point2 c, Point2 p) noexcept;

/// in_circle with ties broken canonically.
///
/// Never 0 for four different points with a, b, c not on a line.
///
/// The answer for points that are lifted to the paraboloid and then raised by
/// infinitesimals, the more the lower they are in the order of (x, y). It depends on
/// coordinates only, and the Delaunay triangulation under it is unique.
[[nodiscard]] int in_circle_perturbed(Point2 a, Point2 b, Point2 c, Point2 p) noexcept;

}  // namespace delone::tripack
