#pragma once

#include "interp/tension_basis.hpp"

namespace delone::interp {

/// The largest tension factor that surfaces use: above it a curve is next to straight,
/// with bends at its ends that are a hundredth of the arc wide.
inline constexpr double tension_factor_max = 85;

/// What a curve over an arc interpolates: values and derivatives by arc length at both
/// ends. The length is positive.
struct HermiteArc {
  double start = 0, end = 0;
  double start_slope = 0, end_slope = 0;
  double length = 1;
};

/// Hermite tension spline: the curve f over an arc with given values and slopes at both
/// ends and f'''' = (tension / length)^2 f''. With tension 0 the cubic; with growing
/// tension, uniformly, the straight line. Of all curves with these ends it has the least
/// integral of f''^2 + (tension / length)^2 f'^2.
///
/// `part`: of the length from the start, 0 .. 1. Tension: a factor that is not negative,
/// without unit and unchanged by scaling values or lengths. Ends are met bit for bit, and
/// everywhere the error is a few units in the last place of the largest of the values and
/// of slope x length, for every tension.
///
/// Source: D. G. Schweikert, J. Math. Phys. 45 (1966) 312-317.
class TensionSpline {
 public:
  TensionSpline(const HermiteArc& arc, double tension) noexcept
      : arc_(arc),
        rise_(arc.end - arc.start),
        even_(0.5 * (arc.start_slope - arc.end_slope) * arc.length),
        odd_(0.5 * (arc.start_slope * arc.length - rise_) +
             0.5 * (arc.end_slope * arc.length - rise_)),
        basis_(tension) {}

  [[nodiscard]] double value(double part) const noexcept {
    if (part <= 0) return arc_.start;
    if (part >= 1) return arc_.end;
    return arc_.start + above_start(part);
  }
  /// The value above that of the start.
  [[nodiscard]] double above_start(double part) const noexcept {
    const double rest = 1 - part;
    return rise_ * part + even_ * basis_.even(part, rest) + odd_ * basis_.odd(part, rest);
  }
  /// The derivative by arc length.
  [[nodiscard]] double slope(double part) const noexcept {
    if (part <= 0) return arc_.start_slope;
    if (part >= 1) return arc_.end_slope;
    const double rest = 1 - part;
    return (rise_ + even_ * basis_.even_slope(part, rest) +
            odd_ * basis_.odd_slope(part, rest)) /
           arc_.length;
  }
  /// The second derivative by arc length.
  [[nodiscard]] double second(double part) const noexcept {
    const double rest = 1 - part;
    return (even_ * basis_.even_second(part, rest) +
            odd_ * basis_.odd_second(part, rest)) /
           arc_.length / arc_.length;
  }

  /// Extreme slopes and values of the whole curve.
  struct Extremes {
    double least = 0, most = 0;
  };
  [[nodiscard]] Extremes slopes() const noexcept;
  /// Above the value of the start.
  [[nodiscard]] Extremes rises() const noexcept;

 private:
  /// Where the second derivative changes its sign, 0 .. 1; NaN if nowhere.
  [[nodiscard]] double inflection() const noexcept;
  [[nodiscard]] double level_part(double from, double to) const noexcept;

  HermiteArc arc_;
  double rise_, even_, odd_;
  TensionBasis<double> basis_;
};

// The least tension factor with which a Hermite tension spline keeps a shape. Infinity
// where none does, the straight line being no spline with these ends; so are factors
// beyond 2^30. Otherwise the shape is kept with the result, to rounding, and not with a
// factor smaller by one part in 10^7. Deviations from the straight line fall as the
// tension grows, so all larger factors keep it too. Cost: below a microsecond where no
// tension is needed, else some 20 evaluations of the extremes.
//
// What they find: R. J. Renka, SIAM J. Sci. Stat. Comput. 8 (1987) 393-415 (there SIG0,
// SIG1, SIG2).

/// The curve nowhere above `upper`. Infinite if an end is above, or at it with a slope
/// that leads above.
[[nodiscard]] double least_tension_below(const HermiteArc& arc, double upper) noexcept;
/// The curve nowhere below `lower`.
[[nodiscard]] double least_tension_above(const HermiteArc& arc, double lower) noexcept;

/// Its derivative by arc length nowhere above `upper`. Infinite if that of an end is, or
/// if the mean slope is not below it (unless the curve is straight anyway).
[[nodiscard]] double least_tension_slope_below(const HermiteArc& arc,
                                               double upper) noexcept;
/// Its derivative nowhere below `lower`.
[[nodiscard]] double least_tension_slope_above(const HermiteArc& arc,
                                               double lower) noexcept;

/// The curve monotone. Infinite if a slope leads against the rise, and if the ends are
/// level but a slope is not.
[[nodiscard]] double least_tension_monotone(const HermiteArc& arc) noexcept;

/// The curve convex or concave, whichever the ends allow: the mean slope strictly between
/// the slopes, or equal to both. Infinite otherwise.
[[nodiscard]] double least_tension_convex(const HermiteArc& arc) noexcept;

}  // namespace delone::interp
