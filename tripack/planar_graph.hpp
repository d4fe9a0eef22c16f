#pragma once

#include <array>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "tripack/point.hpp"

namespace delone::tripack {

/// A part of the plane, named by a point in it.
struct RegionSeed {
  Point2 point{};
  double attribute = 0;
  double max_area = 0;  ///< for refinement; 0: no limit
};

/// Points and the segments between them: a planar straight-line graph, as a .poly file
/// holds it. Segments are pairs of rows of `points`; they need not be clean (see
/// ConstrainedTriangulation).
struct PlanarGraph {
  std::vector<Point2> points{};
  std::vector<std::array<delaunay::Node, 2>> segments{};
  std::vector<Point2> holes{};  ///< a point in each hole
  std::vector<RegionSeed> regions{};
};

}  // namespace delone::tripack
