#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "interp/c1_options.hpp"
#include "interp/tension_spline.hpp"

namespace delone::interp {

/// What a curve over an arc takes over from the values and slopes at its ends.
enum class ArcShape : std::uint8_t {
  free,      ///< nothing
  monotone,  ///< it rises or falls all along where both slopes do as the values do
  convex     ///< monotone, and it bends one way only where the slopes at the ends lie on
             ///< both sides of the mean slope
};

/// What is asked of the curves over all arcs.
struct ArcDemand {
  ArcShape shape = ArcShape::free;
  /// Values stay between these. The values of the nodes must.
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

struct TensionSplineOptions {
  /// Where the gradients at the nodes come from: those of PlaneC1, SphereC1 with these
  /// options; and what is outside, the reach, repeats.
  C1Options c1;
  ArcDemand demand;
  /// The least tension factor of all arcs, 0 .. tension_factor_max.
  double factor = 0;
  /// The least tension factor of each arc, in the order of tension_arcs(); empty: none is
  /// given.
  std::vector<double> factors;
};

/// How the arcs of a surface were tightened.
struct TensionSplineFit {
  std::int64_t num_arcs = 0;
  std::int64_t num_tightened = 0;  ///< arcs with a factor above 0
  double largest = 0;              ///< factor
  /// Arcs whose shape would take more than tension_factor_max, which they have.
  std::int64_t num_limited = 0;
  /// Nodes whose gradient was shortened, because no factor keeps an arc at it between
  /// `least` and `most`.
  std::int64_t num_shortened = 0;
  C1Fit c1;  ///< of the surface that the gradients come from
};

/// Throws Error if `least` is above `most` or one is NaN.
void check(const ArcDemand& demand);

/// The least factor, at most tension_factor_max, with which a curve meets a demand of
/// shape; 0 where the ends do not have the shape.
///
/// Not monotone are ends whose slopes lead against the rise, or that are level without
/// level slopes; neither convex nor concave those whose mean slope is not strictly
/// between the slopes. Slopes that differ from the mean by rounding (2^-40) count as
/// straight.
struct ShapeFactor {
  double factor = 0;
  bool is_limited = false;
};
[[nodiscard]] ShapeFactor shape_factor(const HermiteArc& arc, ArcShape shape) noexcept;

/// The least factor that keeps a curve between `least` and `most`; infinity if none does.
[[nodiscard]] double range_factor(const HermiteArc& arc,
                                  const ArcDemand& demand) noexcept;

}  // namespace delone::interp
