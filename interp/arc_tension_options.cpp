#include "interp/arc_tension_options.hpp"

#include <algorithm>
#include <cmath>

#include "delaunay/error.hpp"

namespace delone::interp {

namespace {

ShapeFactor limited(double factor) noexcept {
  return {std::min(factor, tension_factor_max), factor > tension_factor_max};
}

bool is_straight(const HermiteArc& arc) noexcept {
  const double rise = arc.end - arc.start, a = arc.start_slope * arc.length,
               b = arc.end_slope * arc.length;
  const double size = 0x1p-40 * (std::abs(rise) + std::abs(a) + std::abs(b));
  return std::abs(a - rise) <= size && std::abs(b - rise) <= size;
}

bool is_bent_one_way(const HermiteArc& arc) noexcept {
  const double mean = (arc.end - arc.start) / arc.length;
  return (arc.start_slope < mean && mean < arc.end_slope) ||
         (arc.start_slope > mean && mean > arc.end_slope);
}

bool is_monotone(const HermiteArc& arc) noexcept {
  const double sign = arc.end > arc.start ? 1 : -1;
  return arc.end != arc.start && sign * arc.start_slope >= 0 && sign * arc.end_slope >= 0;
}

}  // namespace

void check(const ArcDemand& demand) {
  if (demand.least <= demand.most) return;
  throw Error("the least value asked for must not be above the largest");
}

// A convex curve between slopes of one sign is monotone.
ShapeFactor shape_factor(const HermiteArc& arc, ArcShape shape) noexcept {
  if (shape == ArcShape::free || is_straight(arc)) return {};
  if (shape == ArcShape::convex && is_bent_one_way(arc))
    return limited(least_tension_convex(arc));
  return is_monotone(arc) ? limited(least_tension_monotone(arc)) : ShapeFactor{};
}

double range_factor(const HermiteArc& arc, const ArcDemand& demand) noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double factor = 0;
  if (demand.most < infinity) factor = least_tension_below(arc, demand.most);
  if (demand.least > -infinity)
    factor = std::max(factor, least_tension_above(arc, demand.least));
  return factor;
}

}  // namespace delone::interp
