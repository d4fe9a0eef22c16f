#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "cli/constraints.hpp"
#include "cli/surface.hpp"

namespace delone::cli {

/// Points with values, and the curves across which no value reaches.
struct CurvedData {
  using Plane = std::shared_ptr<const tripack::ConstrainedTriangulation>;
  using Globe = std::shared_ptr<const stripack::ConstrainedTriangulation>;

  ConstrainedInput input;  ///< `input.points` with values
  std::variant<Plane, Globe> curves;
  std::vector<double> values;  ///< of all rows of `curves`; NaN: a vertex without
  Triangulated domain;  ///< the corners of the domain, for the region that it covers
};

/// Throws UsageError for what goes with no segments: methods that look across them,
/// their options, and continuations; and for options of tables if the points are those of
/// a .poly file.
void check_curved_options(const PointSettings& points, const SurfaceSettings& settings);

/// Reads points and segments and triangulates the domain. Of a .poly file the value is
/// the attribute that `points.columns.value` names (attribute_1 if it names none); a
/// table's values are its points', and vertices of segments have none. Throws as
/// read_constrained and build_domain, and Error if there are no values.
[[nodiscard]] CurvedData read_curved(const PointSettings& points,
                                     const ConstraintSettings& constraints,
                                     Reporter& reporter);

/// Fits the surface of the method that was asked for. Throws as the other fit.
[[nodiscard]] Surface fit(const CurvedData& data, const SurfaceSettings& settings,
                          Reporter& reporter);

}  // namespace delone::cli
