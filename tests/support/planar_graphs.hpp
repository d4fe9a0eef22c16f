#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/plane_sets.hpp"
#include "tripack/planar_graph.hpp"

namespace delone::support {

/// A closed ring through the points: segments from each row to the next.
[[nodiscard]] inline std::vector<std::array<std::int32_t, 2>> ring_segments(
    std::int32_t first, std::int32_t count) {
  std::vector<std::array<std::int32_t, 2>> segments;
  for (std::int32_t i = 0; i < count; ++i)
    segments.push_back({first + i, first + (i + 1) % count});
  return segments;
}

/// Adds a ring of points and its segments.
inline void add_ring(tripack::PlanarGraph& graph, const PlanePoints& ring) {
  const auto first = static_cast<std::int32_t>(graph.points.size());
  graph.points.insert(graph.points.end(), ring.begin(), ring.end());
  const auto segments = ring_segments(first, static_cast<std::int32_t>(ring.size()));
  graph.segments.insert(graph.segments.end(), segments.begin(), segments.end());
}

/// An axis-parallel square ring about a centre, counter-clockwise.
[[nodiscard]] inline PlanePoints square_ring(tripack::Point2 centre, double half) {
  return {{centre.x - half, centre.y - half},
          {centre.x + half, centre.y - half},
          {centre.x + half, centre.y + half},
          {centre.x - half, centre.y + half}};
}

}  // namespace delone::support
