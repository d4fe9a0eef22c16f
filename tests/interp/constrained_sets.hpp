#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "interp/constrained_surface.hpp"
#include "interp/surfaces.hpp"
#include "support/planar_graphs.hpp"
#include "tripack/predicates.hpp"

/// Points with curves between them, and values that the curves' vertices lack.
namespace delone::support {

inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

using PlaneCurves = std::shared_ptr<const tripack::ConstrainedTriangulation>;
using SphereCurves = std::shared_ptr<const stripack::ConstrainedTriangulation>;

inline PlaneCurves constrained(const tripack::PlanarGraph& graph,
                               const delaunay::ConstraintOptions& options = {}) {
  return std::make_shared<const tripack::ConstrainedTriangulation>(graph, options);
}
inline SphereCurves constrained(const stripack::SphereGraph& graph,
                                const stripack::SphereConstraintOptions& options = {}) {
  return std::make_shared<const stripack::ConstrainedTriangulation>(graph, options);
}

/// A line through points, not closed.
inline void add_line(tripack::PlanarGraph& graph, const PlanePoints& line) {
  const auto first = static_cast<std::int32_t>(graph.points.size());
  graph.points.insert(graph.points.end(), line.begin(), line.end());
  for (std::int32_t i = first; i + 1 < std::ssize(graph.points); ++i)
    graph.segments.push_back({i, i + 1});
}

/// A bent line from below the unit square to above it, near x = 0.5.
inline PlanePoints bent_fault() {
  return {{0.5, -0.2}, {0.52, 0.2}, {0.47, 0.45}, {0.51, 0.7}, {0.5, 1.2}};
}
/// Is a point left of bent_fault()?
inline bool is_left_of_fault(tripack::Point2 p) {
  const PlanePoints line = bent_fault();
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    if (p.y <= line[k + 1].y) return tripack::orientation(line[k], line[k + 1], p) > 0;
  return false;
}

/// `f` at the first points of a graph, no value at its curves' vertices.
template <class Points, class F>
std::vector<double> values_beside_curves(const Points& points, std::size_t num_points,
                                         F f) {
  std::vector<double> values(points.size(), no_value);
  for (std::size_t i = 0; i < num_points; ++i) values[i] = f(points[i]);
  return values;
}

/// Adds a ring of latitude, eastwards, `num` vertices, shifted and tilted by `tilt`
/// degrees towards the meridian of 30 degrees.
inline void add_cap_ring(stripack::SphereGraph& graph, double lat_deg, double tilt_deg,
                         std::int32_t num) {
  const auto first = static_cast<std::int32_t>(graph.points.size());
  const double tilt = tilt_deg * std::numbers::pi / 180,
               away = (90 - lat_deg) * std::numbers::pi / 180;
  for (std::int32_t k = 0; k < num; ++k) {
    const double turn = 2 * std::numbers::pi * k / num;
    const double x = std::sin(away) * std::cos(turn), y = std::sin(away) * std::sin(turn),
                 z = std::cos(away);
    graph.points.push_back(
        stripack::Direction::from(x * std::cos(tilt) + z * std::sin(tilt), y,
                                  z * std::cos(tilt) - x * std::sin(tilt)));
  }
  for (const auto& segment : ring_segments(first, num)) graph.arcs.push_back(segment);
}

}  // namespace delone::support
