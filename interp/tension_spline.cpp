#include "interp/tension_spline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delone::interp {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

HermiteArc negated(const HermiteArc& a) noexcept {
  return {-a.start, -a.end, -a.start_slope, -a.end_slope, a.length};
}

/// The arc over unit length, the start at 0.
HermiteArc unit_arc(const HermiteArc& a) noexcept {
  return {0, a.end - a.start, a.start_slope * a.length, a.end_slope * a.length, 1};
}

double size_of(const HermiteArc& unit) noexcept {
  return std::max(
      {std::abs(unit.end), std::abs(unit.start_slope), std::abs(unit.end_slope)});
}

/// The least tension with `margin(tension) >= 0`, given that it is negative at 0 and
/// grows above it. Secant steps, and a halving wherever they do not halve the bracket.
template <class Margin>
double least_tension(Margin margin) noexcept {
  constexpr double precision = 0x1p-30, most = 0x1p30;
  double low = 0, high = 1, at_low = margin(0.0);
  if (at_low >= 0) return 0;
  double at_high = margin(high);
  while (!(at_high >= 0)) {
    if (high >= most) return infinity;
    low = high, at_low = at_high;
    high *= 4, at_high = margin(high);
  }
  bool halves = false;
  while (high - low > precision * high) {
    const double width = high - low;
    const double secant = high - at_high * (width / (at_high - at_low));
    const double middle =
        halves ? low + 0.5 * width
               : std::clamp(secant, low + 0x1p-31 * high, high - 0x1p-31 * high);
    const double at_middle = margin(middle);
    (at_middle >= 0 ? high : low) = middle;
    (at_middle >= 0 ? at_high : at_low) = at_middle;
    halves = !halves && high - low > 0.5 * width;
  }
  return high;
}

/// 1 - even / odd of the second derivatives of the basis at the end: 2/3 without tension,
/// then falling as 2 / tension.
double bend_deficit(double tension) noexcept {
  const TensionBasis<double> basis(tension);
  if (tension < 2) return 1 + basis.even_second(1, 0) / basis.odd_second(1, 0);
  const double x = 0.5 * tension, decay = std::exp(-tension);
  const double tangent = (1 - decay) / (1 + decay);
  const double flat = 4 * decay / ((1 + decay) * (1 + decay));  // 1 - tangent^2
  return (tangent - x * flat) / (x * tangent * tangent);
}

}  // namespace

// The second derivative is even_ K cosh(x w) / cosh(x) + odd_ L sinh(x w) / sinh(x) with
// the values K, L of the basis at the end.
double TensionSpline::inflection() const noexcept {
  const double even = even_ * basis_.even_second(1, 0),
               odd = odd_ * basis_.odd_second(1, 0);
  if (!(std::abs(odd) > std::abs(even))) return none;
  const double x = 0.5 * basis_.tension();
  const double ratio = -even / odd;
  const double w = x > 0 ? std::atanh(ratio * std::tanh(x)) / x : ratio;
  return std::clamp(0.5 * (1 + w), 0.0, 1.0);
}

TensionSpline::Extremes TensionSpline::slopes() const noexcept {
  const double least = std::min(arc_.start_slope, arc_.end_slope),
               most = std::max(arc_.start_slope, arc_.end_slope);
  const double part = inflection();
  if (std::isnan(part)) return {least, most};
  const double there = slope(part);
  return {std::min(least, there), std::max(most, there)};
}

// The slope has one sign at `from`, the other at `to`, and is monotone between: Newton's
// steps, or a halving where they leave the bracket.
double TensionSpline::level_part(double from, double to) const noexcept {
  constexpr int most_steps = 80;
  const bool rises = slope(from) < 0;
  double part = 0.5 * (from + to);
  for (int step = 0; step < most_steps && to - from > 0x1p-50; ++step) {
    const double here = slope(part);
    if (here == 0) return part;
    ((here < 0) == rises ? from : to) = part;
    const double next = part - here / (second(part) * arc_.length);
    const double last = part;
    part = next > from && next < to ? next : 0.5 * (from + to);
    if (std::abs(part - last) < 0x1p-40) break;  // an extreme value forgives its place
  }
  return part;
}

TensionSpline::Extremes TensionSpline::rises() const noexcept {
  Extremes result{std::min(0.0, rise_), std::max(0.0, rise_)};
  const double bend = inflection();
  const auto visit = [&](double from, double to) {
    const double a = slope(from), b = slope(to);
    if (!((a < 0 && b > 0) || (a > 0 && b < 0))) return;
    const double there = above_start(level_part(from, to));
    result = {std::min(result.least, there), std::max(result.most, there)};
  };
  if (std::isnan(bend)) {
    visit(0, 1);
  } else {
    visit(0, bend);
    visit(bend, 1);
  }
  return result;
}

double least_tension_below(const HermiteArc& arc, double upper) noexcept {
  const HermiteArc unit = unit_arc(arc);
  const double at_start = upper - arc.start, at_end = upper - arc.end;
  if (!(at_start >= 0 && at_end >= 0)) return infinity;
  if (at_start == 0 && unit.start_slope > 0) return infinity;
  if (at_end == 0 && unit.end_slope < 0) return infinity;
  // Between values that differ in the last places only, the rise is one of them off.
  const double slack = 0x1p-50 * size_of(unit), bound = std::max(at_start, unit.end);
  return least_tension([&](double tension) {
    return bound + slack - TensionSpline(unit, tension).rises().most;
  });
}

double least_tension_above(const HermiteArc& arc, double lower) noexcept {
  return least_tension_below(negated(arc), -lower);
}

double least_tension_slope_above(const HermiteArc& arc, double lower) noexcept {
  const HermiteArc unit = unit_arc(arc);
  const double bound = lower * arc.length;
  if (unit.start_slope == unit.end && unit.end_slope == unit.end && unit.end >= bound)
    return 0;
  if (!(unit.start_slope >= bound && unit.end_slope >= bound && unit.end > bound))
    return infinity;
  const double slack = 0x1p-50 * size_of(unit);
  return least_tension([&](double tension) {
    return TensionSpline(unit, tension).slopes().least - bound + slack;
  });
}

double least_tension_slope_below(const HermiteArc& arc, double upper) noexcept {
  return least_tension_slope_above(negated(arc), -upper);
}

double least_tension_monotone(const HermiteArc& arc) noexcept {
  if (arc.end == arc.start)
    return arc.start_slope == 0 && arc.end_slope == 0 ? 0 : infinity;
  return arc.end > arc.start ? least_tension_slope_above(arc, 0)
                             : least_tension_slope_below(arc, 0);
}

// The second derivative keeps its sign if it does at the ends. With the parts a, b that
// the slopes differ from the mean slope, c = |a - b| / (a + b): even / odd >= c there.
double least_tension_convex(const HermiteArc& arc) noexcept {
  const HermiteArc unit = unit_arc(arc);
  const double a = unit.end - unit.start_slope, b = unit.end_slope - unit.end;
  if (a == 0 && b == 0) return 0;
  if (!((a > 0 && b > 0) || (a < 0 && b < 0))) return infinity;
  const double smaller = std::min(std::abs(a), std::abs(b)),
               larger = std::max(std::abs(a), std::abs(b));
  const double allowed = 2 * (smaller / larger) / (1 + smaller / larger);  // 1 - c
  return least_tension(
      [&](double tension) { return allowed + 0x1p-50 - bend_deficit(tension); });
}

}  // namespace delone::interp
