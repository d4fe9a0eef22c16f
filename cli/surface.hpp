#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "cli/options.hpp"
#include "cli/points.hpp"
#include "interp/linear_surface.hpp"
#include "interp/nearest_surface.hpp"

namespace delone::cli {

/// How values come about between the points.
enum class Method : std::uint8_t { nearest, linear };

struct SurfaceSettings {
  Method method = Method::linear;
  interp::Outside outside = interp::Outside::missing;
  double max_distance = std::numeric_limits<double>::infinity();
};

/// --method, --extrapolate, --max-distance.
void add_surface_options(CLI::App& app, SurfaceSettings& settings);

/// An interpolant over points, whatever they lie on.
using Surface = std::variant<interp::PlaneLinear, interp::PlaneNearest,
                             interp::SphereLinear, interp::SphereNearest>;

/// Fits the surface. Throws UsageError if the
/// domain does not have what was asked for, Error naming file and line for values that
/// cannot be used.
[[nodiscard]] Surface fit(const Points& points, const Triangulated& triangulated,
                          const SurfaceSettings& settings, Reporter& reporter);

/// Values at the positions of `queries`, in their order; NaN is missing.
[[nodiscard]] std::vector<double> values_at(const Surface& surface, const Points& queries,
                                            const RunOptions& run);

/// Derivatives at the positions of `queries`: by x and y on the plane, towards east and
/// north for each kilometre on the globe; NaN is missing.
[[nodiscard]] std::vector<std::array<double, 2>> gradients_at(const Surface& surface,
                                                              const Points& queries,
                                                              const RunOptions& run);

}  // namespace delone::cli
