#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/constrained_input.hpp"
#include "cli/options.hpp"
#include "cli/points.hpp"
#include "io/mesh.hpp"
#include "stripack/constrained_triangulation.hpp"
#include "tripack/constrained_triangulation.hpp"

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

/// --constraints, --keep-outside, --outside, --split-intersections.
void add_domain_options(CLI::App& app, ConstraintSettings& settings);
/// --min-angle, --max-area.
void add_refinement_options(CLI::App& app, ConstraintSettings& settings);

/// Are there segments: in the file of points, or of their own? Throws UsageError if there
/// are none for options that need them.
[[nodiscard]] bool has_segments(const std::string& points,
                                const ConstraintSettings& settings);

/// A point set with segments in it, on the plane or the globe.
using Constrained =
    std::variant<tripack::ConstrainedTriangulation, stripack::ConstrainedTriangulation>;

/// The triangulation of the input as it is, nothing refined. Throws Error naming the file
/// and its lines (also for a domain that holds nothing), and UsageError for options of
/// the plane on the globe and the other way round.
[[nodiscard]] Constrained build_constrained(const ConstrainedInput& input,
                                            const ConstraintSettings& settings,
                                            Reporter& reporter);

/// The same; says what was not clean and how large the domain is. Throws besides for a
/// domain that holds nothing.
[[nodiscard]] Constrained build_domain(const ConstrainedInput& input,
                                       const ConstraintSettings& settings,
                                       Reporter& reporter);

/// A triangulated domain in the numbers of the output: data rows, then the vertices of
/// the constraints, then added ones.
struct ConstrainedOutput {
  io::Mesh nodes;
  std::vector<io::Triangle> triangles;
  std::vector<std::array<std::int32_t, 2>> pieces;  ///< of the segments
  std::int64_t num_added = 0;  ///< the last nodes, which no file holds
  Constrained triangulation{};
};

/// Triangulates, refines if asked to, and says what was not clean or could not be had.
/// Throws as build_constrained does.
[[nodiscard]] ConstrainedOutput triangulate(const ConstrainedInput& input,
                                            const ConstraintSettings& settings,
                                            Reporter& reporter);

/// Points that name the holes in a .poly file: those of the input, or, where rings were
/// counted or --outside says what is left out, one in each hole of the domain (none where
/// all is kept); on the globe longitude and latitude. Throws Error for a hole too narrow
/// for a point.
[[nodiscard]] std::vector<tripack::Point2> hole_points(const ConstrainedInput& input,
                                                       const ConstraintSettings& settings,
                                                       const ConstrainedOutput& output);

}  // namespace delone::cli
