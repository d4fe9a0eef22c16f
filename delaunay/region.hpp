#pragma once

#include <cstdint>

namespace delone::delaunay {

/// What remains of a constrained triangulation.
enum class Domain : std::uint8_t {
  /// What segments enclose: all but what can be reached from outside the hull, or from a
  /// hole's point, without crossing a segment.
  enclosed,
  /// What an odd number of rings enclose: islands in lakes in islands. A piece that two
  /// rings share does not count. The segments must form closed rings.
  even_odd,
  /// Everything in the hull; holes only count as regions.
  hull
};

/// What happens where segments cross between their ends.
enum class Crossings : std::uint8_t {
  error,  ///< an Error that names both
  split   ///< both go through an added vertex
};

struct ConstraintOptions {
  Domain domain = Domain::enclosed;
  Crossings crossings = Crossings::error;
};

/// A connected part of the domain, bounded by segments.
struct DomainRegion {
  /// Index of the first region point in it, or none.
  std::int32_t seed = -1;
  double attribute = 0;  ///< of that point
  std::int64_t num_triangles = 0;
};

}  // namespace delone::delaunay
