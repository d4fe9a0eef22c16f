#pragma once

#include <string>
#include <vector>

#include "cli/points.hpp"
#include "cli/reporter.hpp"
#include "cli/surface.hpp"
#include "interp/grid.hpp"
#include "interp/vector_field.hpp"
#include "io/grid_file.hpp"

namespace delone::cli {

/// --vector, and whether its derivatives are wanted.
struct VectorSettings {
  bool is_wanted = false;
  bool wants_derivatives = false;
};

/// --vector U,V, which takes the place of --value.
void add_vector_option(CLI::App& app, PointSettings& points, VectorSettings& settings);

/// Throws UsageError unless the points lie on the globe and method and repeats suit
/// vectors.
[[nodiscard]] interp::SphereVectorField fit_vectors(const Points& points,
                                                    const Triangulated& triangulated,
                                                    const SurfaceSettings& settings,
                                                    Reporter& reporter);

/// Both components, and with derivatives divergence and curl for each kilometre, at the
/// positions of `queries`, in their order. At a pole they count from the longitude of the
/// query.
[[nodiscard]] std::vector<io::GridVariable> vectors_at(
    const interp::SphereVectorField& field, const VectorSettings& settings,
    const Points& points, const Points& queries, Reporter& reporter);

/// The same on a grid, the eastward component first.
[[nodiscard]] io::GridFile vectors_on(const interp::SphereVectorField& field,
                                      const VectorSettings& settings,
                                      const Points& points, const interp::Grid& grid,
                                      Reporter& reporter);

}  // namespace delone::cli
