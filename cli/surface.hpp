#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/options.hpp"
#include "cli/points.hpp"
#include "interp/arc_tension_surface.hpp"
#include "interp/c1_surface.hpp"
#include "interp/constrained_surface.hpp"
#include "interp/idw_surface.hpp"
#include "interp/linear_surface.hpp"
#include "interp/natural_surface.hpp"
#include "interp/nearest_surface.hpp"
#include "interp/rbf_surface.hpp"
#include "interp/shepard_surface.hpp"
#include "interp/smooth_surface.hpp"

namespace delone::cli {

/// How values come about between the points.
enum class Method : std::uint8_t {
  nearest,
  linear,
  c1,
  natural,
  natural_c1,
  idw,
  shepard,
  rbf,
  smooth
};

/// The word that --method takes.
[[nodiscard]] std::string_view name_of(Method method);

/// What --smooth says.
struct SmoothSettings {
  interp::SmoothBy by = interp::SmoothBy::cross_validation;
  double length = 0;  ///< on the globe kilometres
  bool is_given = false;
};

/// What --shape, --range and --arc-tension say.
struct ArcTensionSettings {
  interp::ArcDemand demand;
  double factor = 0;
  bool is_given = false;  ///< a range or a factor
  bool has_range = false;
  [[nodiscard]] bool is_wanted() const noexcept {
    return is_given || demand.shape != interp::ArcShape::free;
  }
};

struct SurfaceSettings {
  Method method = Method::linear;
  interp::Outside outside = interp::Outside::missing;
  double max_distance = std::numeric_limits<double>::infinity();
  // For c1.
  std::optional<double> tension;  ///< empty: chosen by leave-one-out errors
  interp::Gradients gradients = interp::Gradients::automatic;
  bool is_bounded = false;
  interp::FitDegree degree = interp::FitDegree::cubic;
  ArcTensionSettings arcs;
  SmoothSettings smooth;
  std::vector<const CLI::Option*> c1_options;  ///< those that other methods do not take
};

/// --method, --extrapolate, --max-distance, and what c1 takes: --gradients, --tension,
/// --bounded, --fit-degree.
void add_surface_options(CLI::App& app, SurfaceSettings& settings);

/// The same for what stays within the triangles: --method linear or c1, and what c1
/// takes.
void add_triangle_surface_options(CLI::App& app, SurfaceSettings& settings);

/// Throws UsageError for an option of c1 on the command line with another method, also
/// one with the default's meaning.
void check_c1_options(const SurfaceSettings& settings);

/// What the surfaces on the globe take.
struct GlobeOptions {
  interp::SurfaceOptions common;
  interp::C1Options c1;
  interp::NaturalOptions natural;
};
/// Throws UsageError if the domain or the method does not have what was asked for.
[[nodiscard]] GlobeOptions globe_options(const Points& points,
                                         const SurfaceSettings& settings);

/// An interpolant over points, whatever they lie on.
using Surface =
    std::variant<interp::PlaneLinear, interp::PlaneNearest, interp::PlaneC1,
                 interp::PlaneNatural, interp::PlaneInverseDistance, interp::PlaneShepard,
                 interp::PlaneRadial, interp::SphereLinear, interp::SphereNearest,
                 interp::SphereC1, interp::SphereNatural, interp::SphereInverseDistance,
                 interp::SphereShepard, interp::SphereRadial, interp::PlaneConstrained,
                 interp::SphereConstrained, interp::PlaneSmooth, interp::SphereSmooth,
                 interp::PlaneTensionSpline, interp::SphereTensionSpline>;

/// Fits the surface, and says how where there was a choice. Throws UsageError if the
/// domain or the method does not have what was asked for, Error naming file and line for
/// values that cannot be used.
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
