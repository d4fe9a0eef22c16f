#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/points.hpp"
#include "tripack/planar_graph.hpp"

namespace delone::cli {

/// Does the path end in .poly?
[[nodiscard]] bool is_poly(const std::string& path);

/// Points and segments, and where they stand in files. Points are the kept rows of the
/// table first, then those of the file of constraints.
struct ConstrainedInput {
  Points points;
  tripack::PlanarGraph graph;
  std::string path;  ///< of the segments
  /// For each segment its line in the file; empty where lines say nothing (GeoJSON).
  std::vector<std::int64_t> segment_lines;
  bool are_rings = false;  ///< inside is what an odd number of rings enclose
  /// Is nothing but the sense of the rings known of their inside, on the globe?
  bool is_sense_open = false;
  /// Segments at the end that repeat others, so that they count for no ring.
  std::int64_t num_doubled = 0;
  /// The attributes of a .poly file's vertices, read instead of a table.
  std::vector<std::vector<double>> attributes;
  std::optional<int> file_base;  ///< the number of the first node in the file
};

/// Reads a .poly file, or a table of points and a file of constraints: a .poly, GeoJSON
/// (.geojson, .json), or a table of rings (ring number, x, y). Says what it found. Throws
/// UsageError and io::ReadError.
[[nodiscard]] ConstrainedInput read_constrained(const PointSettings& points,
                                                const std::string& constraints,
                                                Reporter& reporter);

/// How messages call two segments: "of lines 7 and 8", or by their ends.
[[nodiscard]] std::string names_of_segments(const ConstrainedInput& input,
                                            std::int64_t first, std::int64_t second);

}  // namespace delone::cli
