#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "cli/points.hpp"
#include "io/mesh.hpp"
#include "tripack/planar_graph.hpp"

namespace delone::cli {

/// Where segments come from and what is done with them.
struct ConstraintSettings {
  std::string path;                     ///< --constraints; empty: none
  bool keeps_outside = false;           ///< --keep-outside
  bool splits = false;                  ///< --split-intersections
  std::string outside;                  ///< --outside: "lon/lat"; empty: none
  std::optional<double> min_angle_deg;  ///< --min-angle
  std::optional<double> max_area;       ///< --max-area, squared units of x and y

  /// Is there an option that only segments give a meaning?
  [[nodiscard]] bool needs_segments() const noexcept {
    return keeps_outside || splits || !outside.empty() || refines();
  }
  /// Are points added until the triangles are good?
  [[nodiscard]] bool refines() const noexcept { return min_angle_deg || max_area; }
};

void add_constraint_options(CLI::App& app, ConstraintSettings& settings);

/// Does the path end in .poly?
[[nodiscard]] bool is_poly(const std::string& path);

/// Points and segments, and where they stand in files. Points are the kept rows of the
/// table first, then those of the file of constraints.
struct ConstrainedInput {
  Points points;
  tripack::PlanarGraph graph;
  std::string path;  ///< of the segments
  std::vector<std::int64_t> segment_lines;
  bool are_rings = false;        ///< inside is what an odd number of rings enclose
  std::optional<int> file_base;  ///< the number of the first node in the file
};

/// Reads a .poly file, or a table of points and the file of --constraints: a .poly, or a
/// table of rings with the columns ring number, x, y. Throws UsageError and
/// io::ReadError.
[[nodiscard]] ConstrainedInput read_constrained(const PointSettings& points,
                                                const ConstraintSettings& settings,
                                                Reporter& reporter);

/// A triangulated domain in the numbers of the output: data rows, then the vertices of
/// the constraints, then added ones.
struct ConstrainedOutput {
  io::Mesh nodes;
  std::vector<io::Triangle> triangles;
  std::int64_t num_added = 0;  ///< the last nodes, which no file holds
};

/// Triangulates, refines if asked to, and says what was not clean or could not be had.
/// Throws Error naming the file and its lines, and UsageError for options of the plane on
/// the globe and the other way round.
[[nodiscard]] ConstrainedOutput triangulate(const ConstrainedInput& input,
                                            const ConstraintSettings& settings,
                                            Reporter& reporter);

}  // namespace delone::cli
