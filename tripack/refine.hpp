#pragma once

#include <cstdint>

#include "tripack/constrained_triangulation.hpp"

namespace delone::tripack {

struct RefineOptions {
  /// No angle of the result is smaller, as far as the input's angles allow. Up to 20.7
  /// degrees refinement is proven to end; up to about 33 it does in practice.
  double min_angle_deg = 20.7;
  /// No triangle is larger; 0: no limit. Regions may have one of their own
  /// (RegionSeed::max_area); the smaller counts.
  double max_area = 0;
  /// Vertices after which refinement stops with what it has.
  std::int64_t max_added = 10'000'000;
  ConstraintOptions constraints{};
};

/// A refined domain and what could not be had.
struct Refinement {
  ConstrainedTriangulation triangulation;
  std::int64_t num_added = 0;  ///< vertices that refinement added
  /// Triangles left with a smaller angle: at angles of the input that are too small, or
  /// because max_added or the resolution of doubles was reached.
  std::int64_t num_below_angle = 0;
  std::int64_t num_above_area = 0;
  double smallest_angle_deg = 0;
};

/// Adds vertices to the domain of a graph until its triangles are good: quality meshes
/// for finite elements.
///
/// Segments stay, as chains of edges. A segment with a vertex inside the circle over it
/// is halved; where segments meet at an acute angle, at distances from the common end
/// that are powers of two, so that pieces of both become equally long. A bad triangle
/// gets a vertex at the centre of its circle, unless that would be too close to a
/// segment, which is then halved instead. Triangles across an acute angle of the input
/// whose shortest side joins pieces of the same length are left as they are.
///
/// Vertices on segments are rounded to doubles, as with crossings. The result depends on
/// the set of points and segments only. Throws Error: what ConstrainedTriangulation
/// throws; an angle that is not in 0..60 or an area below 0.
///
/// Sources: J. Ruppert, J. Algorithms 18 (1995) 548-585; J. R. Shewchuk, Comput. Geom. 22
/// (2002) 21-74; G. L. Miller, S. E. Pav, N. J. Walkington, Proc. 11th Int. Meshing
/// Roundtable (2002) 1-12.
[[nodiscard]] Refinement refine(const PlanarGraph& graph,
                                const RefineOptions& options = {},
                                const RunOptions& run = {});

}  // namespace delone::tripack
