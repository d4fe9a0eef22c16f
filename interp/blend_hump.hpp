#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "interp/blend_facet.hpp"
#include "interp/blend_space.hpp"

namespace delone::interp {

// An edge seen from its middle: x is the length along it, -half .. half. The curves are
// cubics in the plane and, on the sphere, in the span of 1, cos, sin and sin 2x, so that
// first-degree harmonics come out exactly.

/// Values and derivatives along an edge at both ends.
struct EdgeEnds {
  double first = 0, second = 0;              ///< values
  double first_slope = 0, second_slope = 0;  ///< by length, from the first to the second
  double first_bend = 0, second_bend = 0;    ///< second derivatives
};

/// The curve with the values and slopes of the ends.
class PlaneEdgeCurve {
 public:
  PlaneEdgeCurve(const EdgeEnds& ends, double half) noexcept
      : half_(half),
        mean_((ends.first + ends.second) / 2),
        even_((ends.second_slope - ends.first_slope) / (4 * half)),
        odd_((ends.second - ends.first) / (2 * half)),
        cubic_(((ends.first_slope + ends.second_slope) / 2 - odd_) / (2 * half * half)),
        even_bend_((ends.first_bend + ends.second_bend) / 2 - 2 * even_),
        odd_bend_((ends.second_bend - ends.first_bend) / 2 - 6 * cubic_ * half) {}
  [[nodiscard]] double operator()(double x) const noexcept {
    return mean_ + odd_ * x + (even_ + cubic_ * x) * (x * x - half_ * half_);
  }
  /// What second derivatives of the ends add to it.
  [[nodiscard]] double quintic_part(double x) const noexcept {
    const double room = x * x - half_ * half_;
    return (even_bend_ + odd_bend_ * x / half_) * room * room / (8 * half_ * half_);
  }

 private:
  double half_, mean_, even_, odd_, cubic_, even_bend_, odd_bend_;
};

class SphereEdgeCurve {
 public:
  SphereEdgeCurve(const EdgeEnds& ends, double half) noexcept
      : cosine_(std::cos(half)),
        sine_(std::sin(half)),
        mean_((ends.first + ends.second) / 2),
        even_((ends.first_slope - ends.second_slope) / (2 * sine_)),
        odd_((ends.second - ends.first) / (2 * sine_)),
        cubic_((odd_ * cosine_ - (ends.first_slope + ends.second_slope) / 2) /
               (sine_ * sine_)),
        even_bend_((ends.first_bend + ends.second_bend) / 2 + even_ * cosine_),
        odd_bend_((ends.second_bend - ends.first_bend) / 2 + odd_ * sine_ +
                  3 * cubic_ * sine_ * cosine_) {}
  [[nodiscard]] double operator()(double x) const noexcept {
    const double room = std::cos(x) - cosine_;
    return mean_ + even_ * room + std::sin(x) * (odd_ + cubic_ * room);
  }
  [[nodiscard]] double quintic_part(double x) const noexcept {
    const double room = (std::cos(x) - cosine_) / sine_;
    return (even_bend_ + odd_bend_ * std::sin(x) / sine_) * room * room / 2;
  }

 private:
  double cosine_, sine_, mean_, even_, odd_, cubic_, even_bend_, odd_bend_;
};

/// Lengths and directions of an edge.
struct PlaneEdge {
  using Curve = PlaneEdgeCurve;
  Point2 from, to, direction;
  double chord = 0, half = 0;
  PlaneEdge(Point2 a, Point2 b) noexcept
      : from(a), to(b), chord(std::hypot(b.x - a.x, b.y - a.y)), half(chord / 2) {
    direction = {(b.x - a.x) / chord, (b.y - a.y) / chord};
  }
  [[nodiscard]] Point2 direction_at_first() const noexcept { return direction; }
  [[nodiscard]] Point2 direction_at_second() const noexcept { return direction; }
  /// The point at x from the middle, and its place along the chord less 1/2.
  [[nodiscard]] Point2 point(double x) const noexcept {
    return {0.5 * (from.x + to.x) + x * direction.x,
            0.5 * (from.y + to.y) + x * direction.y};
  }
  [[nodiscard]] double place(double x) const noexcept { return x / chord; }
};

struct SphereArc {
  using Curve = SphereEdgeCurve;
  Vector3 middle, direction;
  double chord = 0, half = 0;
  SphereArc(Vector3 a, Vector3 b) noexcept {
    const Vector3 along = b - a, sum = a + b;
    chord = length(along);
    half = std::asin(std::min(1.0, chord / 2));
    direction = (1 / chord) * along;
    middle = (1 / length(sum)) * sum;
  }
  [[nodiscard]] Vector3 direction_at_first() const noexcept {
    return std::cos(half) * direction + std::sin(half) * middle;
  }
  [[nodiscard]] Vector3 direction_at_second() const noexcept {
    return std::cos(half) * direction - std::sin(half) * middle;
  }
  [[nodiscard]] Vector3 point(double x) const noexcept {
    return std::cos(x) * middle + std::sin(x) * direction;
  }
  [[nodiscard]] double place(double x) const noexcept { return std::sin(x) / chord; }
};

[[nodiscard]] inline PlaneEdge edge_between(PlaneSpace, Point2 a, Point2 b) noexcept {
  return {a, b};
}
[[nodiscard]] inline SphereArc edge_between(SphereSpace, Vector3 a, Vector3 b) noexcept {
  return {a, b};
}

/// Slope and second derivative of a nodal polynomial at its node, along a unit tangent.
template <BlendSpace Space, int Degree>
[[nodiscard]] std::array<double, 2> derivatives_along(
    typename Space::Vector node, const BlendModel<Degree>& model,
    typename Space::Vector tangent) noexcept {
  const LocalPosition<double> d =
      Space::local(Space::axes(node), Space::position(tangent), 1);
  const auto& c = model.coefficients;
  const double r = model.per_radius;
  return {r * (c[0] * d.u + c[1] * d.v),
          r * r * (c[2] + 2 * c[3] * d.u * d.v + c[4] * (d.u * d.u - d.v * d.v))};
}

/// What an edge adds to the blend of its ends, so that the surface along it is their
/// Hermite curve: cubic, for degree 4 quintic. Matched at three places, which leaves out
/// nothing in the plane for degree 3. Nowhere more than `limit`.
template <BlendSpace Space, int Degree>
[[nodiscard]] EdgeHump edge_hump(typename Space::Vector a, typename Space::Vector b,
                                 const BlendModel<Degree>& first,
                                 const BlendModel<Degree>& second,
                                 double limit) noexcept {
  const auto edge = edge_between(Space{}, a, b);
  const auto [first_slope, first_bend] =
      derivatives_along<Space, Degree>(a, first, edge.direction_at_first());
  const auto [second_slope, second_bend] =
      derivatives_along<Space, Degree>(b, second, edge.direction_at_second());
  const double base = first.value, rise = second.value - base;
  const typename decltype(edge)::Curve curve(
      {0, rise, first_slope, second_slope, first_bend, second_bend}, edge.half);
  const double tension = 0.5 * (first.tension + second.tension);
  const auto rise_of = [&](typename Space::Vector node, const BlendModel<Degree>& m,
                           typename Space::Vector p) {
    const auto local = Space::local(
        Space::axes(node), Space::position(Space::difference(p, node)), m.per_radius);
    return softened(polynomial_rise<Degree, double>(m, local), m.least, m.most);
  };
  const auto wanted = [&](double x) {
    const auto p = edge.point(x);
    const double t = 0.5 + edge.place(x), step = edge_step(t, tension), u = t - t * t;
    const double near_first = rise_of(a, first, p),
                 near_second = rise + rise_of(b, second, p);
    const double target = curve(x) + (Degree == 4 ? curve.quintic_part(x) : 0);
    return (target - (near_first + step * (near_second - near_first))) / (u * u);
  };
  const double x = edge.half / 2, place = edge.place(x);
  const double before = wanted(-x), middle = wanted(0), after = wanted(x);
  const EdgeHump hump{middle, (after - before) / (2 * place),
                      (after + before - 2 * middle) / (2 * place * place)};
  const double height =
      (std::abs(hump.a) + std::abs(hump.b) / 2 + std::abs(hump.c) / 4) / 16;
  if (!(height < std::numeric_limits<double>::infinity())) return {};
  const double part = height > limit ? limit / height : 1;
  return {part * hump.a, part * hump.b, part * hump.c};
}

}  // namespace delone::interp
