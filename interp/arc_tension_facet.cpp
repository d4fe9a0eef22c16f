#include "interp/arc_tension_facet.hpp"

#include <algorithm>
#include <cmath>

#include "interp/node_gradients.hpp"

namespace delone::interp {

namespace {

constexpr std::array<std::size_t, 5> turn{0, 1, 2, 0, 1};

double inverse_or_none(double length) noexcept {
  return length > 0x1p-500 ? 1 / length : 0;
}

ArcSide<PlaneSpace> side_between(Point2 a, Point2 b) noexcept {
  const Point2 d = PlaneSpace::difference(b, a);
  const double length = std::hypot(d.x, d.y);
  if (!(length > 0)) return {};
  const Point2 along{d.x / length, d.y / length};
  return {along, {along.y, -along.x}, length, inverse_or_none(length), 0, 0};
}

ArcSide<SphereSpace> side_between(Vector3 a, Vector3 b) noexcept {
  const Vector3 d = b - a, normal = cross(a, d);
  const double sine = length(normal), bend = -0.5 * dot(d, d);
  if (!(sine > 0x1p-1000)) return {};
  const double angle = std::atan2(sine, 1 + bend);
  return {{}, (1 / sine) * normal, angle, inverse_or_none(angle), sine, bend};
}

/// The direction along a side at its places, times a vector from the corner: on the
/// sphere the direction is normal x place.
double along_side(const ArcSide<PlaneSpace>& side, Point2, Point2 d) noexcept {
  return PlaneSpace::dot(side.along, d);
}
double along_side(const ArcSide<SphereSpace>& side, Vector3 corner, Vector3 d) noexcept {
  return dot(cross(side.outward, corner), d);
}

/// Of length, from each end, what a place that divides the chord lies at.
template <class S>
struct Place {
  S part, rest;
};
template <class S>
Place<S> place_on(const ArcSide<PlaneSpace>&, const S& to_j, const S& to_k) noexcept {
  return {to_k, to_j};
}
template <class S>
Place<S> place_on(const ArcSide<SphereSpace>& side, const S& to_j,
                  const S& to_k) noexcept {
  if (side.per_length == 0) return {to_k, to_j};
  return {side.per_length * angle_of(to_k * side.sine, 1.0 + to_k * side.bend),
          side.per_length * angle_of(to_j * side.sine, 1.0 + to_j * side.bend)};
}

/// A ray in units that make it one formula: `part` and `rest` of its length lie before
/// and after the point, `stretch` times a component of the chord gives that of the ray's
/// beginning or, along the side, of its end, and `outward_stretch` across the side.
template <class S>
struct Ray {
  S part, rest, stretch, outward_stretch;
  bool is_point = false;  ///< of no length
};
template <class S>
Ray<S> ray_to(PlaneSpace, const S& from_corner, const S& to_corner, const S&,
              const S&) noexcept {
  return {from_corner, to_corner, S(1.0), S(1.0)};
}
// The place is the direction of corner + m, m the chord to it: `lift` = corner . m.
// Through the tangents of angles nothing cancels, and nothing is singular on the side.
template <class S>
Ray<S> ray_to(SphereSpace, const S& from_corner, const S& to_corner, const S& lift,
              const S& squared_chord) noexcept {
  const S squared_sine = squared_chord - lift * lift;
  if (!(value_of(squared_sine) > 0)) return {{}, {}, {}, {}, true};
  const S sine = root(squared_sine), cosine = 1.0 + lift;
  const S squared_size = 1.0 + 2.0 * lift + squared_chord;
  const S angle = angle_of(sine, cosine);
  return {
      angle_of(from_corner * sine, to_corner + from_corner * cosine) / angle,
      angle_of(to_corner * sine, to_corner * cosine + from_corner * squared_size) / angle,
      angle / sine, angle / sine * root(squared_size)};
}

template <class S>
S spline(const TensionBasis<S>& basis, const Place<S>& place, const S& even,
         const S& odd) noexcept {
  return even * basis.even(place.part, place.rest) +
         odd * basis.odd(place.part, place.rest);
}

bool is_finite_slope(const SecondOrder& f) noexcept {
  return std::isfinite(f.x) && std::isfinite(f.y);
}
bool has_finite_bend(const SecondOrder& f) noexcept {
  return std::isfinite(f.xx) && std::isfinite(f.xy) && std::isfinite(f.yy);
}

/// A corner's weight: its value, and its derivatives by the place.
SecondOrder with_value(SecondOrder weight, double value) noexcept {
  weight.value = value;
  return weight;
}

PlaneSpace::Position<double> position_of(
    const PlaneSpace::Position<SecondOrder>& p) noexcept {
  return {p.x.value, p.y.value};
}
SphereSpace::Position<double> position_of(
    const SphereSpace::Position<SecondOrder>& p) noexcept {
  return {p.x.value, p.y.value, p.z.value};
}

using PlanePosition = PlaneSpace::Position<SecondOrder>;
using SpherePosition = SphereSpace::Position<SecondOrder>;

/// The weights of the second and third corner.
std::array<SecondOrder, 2> later_weights(const std::array<Point2, 3>& c,
                                         const PlanePosition& p) noexcept {
  const auto weight = [&](double b, double d) {
    const Point2 g = PlaneFacet({c[0], 0}, {c[1], b}, {c[2], d}).gradient();
    return g.x * p.x + g.y * p.y;
  };
  return {weight(1, 0), weight(0, 1)};
}
std::array<SecondOrder, 2> later_weights(const std::array<Vector3, 3>& c,
                                         const SpherePosition& p) noexcept {
  const bool thin = is_thin(c[0], c[1], c[2]);
  const Vector3 u = c[1] - c[0], w = c[2] - c[0];
  const ThinTriangle::Slopes slopes =
      thin ? ThinTriangle(c[0], c[1], c[2]).slopes()
           : ThinTriangle::Slopes{cross(w, c[0]), cross(c[0], u), cross(u, w)};
  const SpherePosition d = SphereSpace::difference(p, c[0]);
  const SecondOrder height = SphereSpace::dot(slopes.normal, p);
  return {SphereSpace::dot(slopes.b, d) / height, SphereSpace::dot(slopes.c, d) / height};
}

}  // namespace

template <BlendSpace Space>
HermiteArc hermite_arc(const ArcCorner<Space>& a, const ArcCorner<Space>& b) noexcept {
  const auto d = Space::difference(b.p, a.p);
  double stretch = 1;
  if constexpr (std::same_as<Space, SphereSpace>) {
    const ArcSide<Space> side = side_between(a.p, b.p);
    if (side.sine > 0) stretch = side.length / side.sine;
  }
  return {a.value, b.value, stretch * Space::dot(a.gradient, d),
          stretch * Space::dot(b.gradient, d), 1};
}

template <BlendSpace Space>
ArcTensionFacet<Space>::ArcTensionFacet(const Corners& corners,
                                        const std::array<double, 3>& factors) noexcept
    : corners_(corners),
      factors_(factors),
      opposites_{opposite(0), opposite(1), opposite(2)} {
  constexpr double harmless = 4, most = 0x1p30;
  const double varies = variation();
  for (Opposite& o : opposites_) {
    const double longest = std::max(std::abs(o.along_j), std::abs(o.along_k));
    const double steep = 1.5 * longest * o.side.per_length *
                         (std::abs(o.rise) + std::abs(o.even) + std::abs(o.odd));
    if (steep > harmless * varies) o.extra = std::min(steep / varies - harmless, most);
  }
}

template <BlendSpace Space>
double ArcTensionFacet<Space>::variation() const noexcept {
  double rise = 0, slope = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const HermiteArc arc = hermite_arc(corners_[k], corners_[turn[k + 1]]);
    rise = std::max(rise, std::abs(arc.end - arc.start));
    slope = std::max({slope, std::abs(arc.start_slope), std::abs(arc.end_slope)});
  }
  return rise + slope;
}

template <BlendSpace Space>
auto ArcTensionFacet<Space>::opposite(std::size_t corner) const noexcept -> Opposite {
  const ArcCorner<Space>&i = corners_[corner], &j = corners_[turn[corner + 1]],
        &k = corners_[turn[corner + 2]];
  Opposite o;
  o.side = side_between(j.p, k.p);
  o.factor = factors_[turn[corner + 1]];
  const HermiteArc arc = hermite_arc(j, k);
  o.rise = arc.end - arc.start;
  o.even = 0.5 * (arc.start_slope - arc.end_slope);
  o.odd = 0.5 * ((arc.start_slope - o.rise) + (arc.end_slope - o.rise));
  o.normal_j = Space::dot(j.gradient, o.side.outward);
  o.normal_k = Space::dot(k.gradient, o.side.outward);
  const Vector to_j = Space::difference(j.p, i.p), to_k = Space::difference(k.p, i.p);
  o.slope_j = Space::dot(i.gradient, to_j);
  o.slope_k = Space::dot(i.gradient, to_k);
  o.along_j = along_side(o.side, i.p, to_j);
  o.along_k = along_side(o.side, i.p, to_k);
  o.height = Space::dot(o.side.outward, to_j);
  o.squared_j = Space::dot(to_j, to_j);
  o.product = Space::dot(to_j, to_k);
  o.squared_k = Space::dot(to_k, to_k);
  return o;
}

template <BlendSpace Space>
template <class S>
auto ArcTensionFacet<Space>::end_of_ray(std::size_t corner, const S& to_j, const S& to_k,
                                        double base) const noexcept -> End<S> {
  const Opposite& o = opposites_[corner];
  const Place<S> place = place_on(o.side, to_j, to_k);
  const TensionBasis<S> basis{S(o.factor)};
  const double j = corners_[turn[corner + 1]].value - base,
               k = corners_[turn[corner + 2]].value - base;
  return {j * place.rest + k * place.part + spline(basis, place, S(o.even), S(o.odd)),
          S(o.rise) + o.even * basis.even_slope(place.part, place.rest) +
              o.odd * basis.odd_slope(place.part, place.rest),
          o.normal_j * place.rest + o.normal_k * place.part};
}

template <BlendSpace Space>
template <class S>
S ArcTensionFacet<Space>::along_ray(std::size_t corner, const Weights<S>& b,
                                    double base) const noexcept {
  const Opposite& o = opposites_[corner];
  const double from = corners_[corner].value - base;
  const S across = b[turn[corner + 1]] + b[turn[corner + 2]];
  if (!(value_of(across) > 0)) return S(from);
  const S to_j = b[turn[corner + 1]] / across, to_k = b[turn[corner + 2]] / across;
  const End<S> end = end_of_ray(corner, to_j, to_k, base);
  const Ray<S> ray =
      ray_to(Space{}, across, b[corner], -0.5 * (to_j * o.squared_j + to_k * o.squared_k),
             to_j * to_j * o.squared_j + 2.0 * to_j * to_k * o.product +
                 to_k * to_k * o.squared_k);
  if (ray.is_point) return end.value;
  const S start_slope = ray.stretch * (to_j * o.slope_j + to_k * o.slope_k);
  const S end_slope = ray.stretch *
                          ((to_j * o.along_j + to_k * o.along_k) * o.side.per_length) *
                          end.slope +
                      o.height * ray.outward_stretch * end.normal;
  const S rise = end.value - S(from);
  const TensionBasis<S> basis(to_j * factors_[corner] +
                              to_k * factors_[turn[corner + 2]] +
                              (4 * o.extra) * (to_j * to_k));
  const Place<S> place{ray.part, ray.rest};
  return from * ray.rest + end.value * ray.part +
         spline(basis, place, 0.5 * (start_slope - end_slope),
                0.5 * ((start_slope - rise) + (end_slope - rise)));
}

// Values are taken above that of the nearest corner, so that next to it digits of the
// distance count, not of the value.
template <BlendSpace Space>
template <class S>
S ArcTensionFacet<Space>::at_weights(const Weights<S>& b) const noexcept {
  const auto less = [](const S& p, const S& q) { return value_of(p) < value_of(q); };
  const auto nearest =
      static_cast<std::size_t>(std::max_element(b.begin(), b.end(), less) - b.begin());
  const double base = corners_[nearest].value;
  Weights<S> shares{b[1] * b[2], b[2] * b[0], b[0] * b[1]};
  const S sum = shares[0] + shares[1] + shares[2];
  if (!(value_of(sum) > 0)) return S(base);
  S result(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    if constexpr (std::same_as<S, double>) {
      if (shares[k] == 0) continue;
    }
    result = result + shares[k] / sum * along_ray(k, b, base);
  }
  return S(base) + result;
}

template <BlendSpace Space>
double ArcTensionFacet<Space>::operator()(Vector p) const noexcept {
  return at_weights(corner_weights(corners_[0].p, corners_[1].p, corners_[2].p, p));
}

template <BlendSpace Space>
auto ArcTensionFacet<Space>::weights(
    const typename Space::template Position<SecondOrder>& p,
    const std::array<double, 3>& values) const noexcept -> Weights<SecondOrder> {
  const auto [b, c] = later_weights({corners_[0].p, corners_[1].p, corners_[2].p}, p);
  if (!is_finite_slope(b) || !is_finite_slope(c))
    return {values[0], values[1], values[2]};
  return {with_value(SecondOrder(0.0) - b - c, values[0]), with_value(b, values[1]),
          with_value(c, values[2])};
}

// Triangles that are flat to rounding leave no derivative of their own: there the mean of
// the corners' gradients, and no second derivatives.
template <BlendSpace Space>
SecondOrder ArcTensionFacet<Space>::sound(
    const SecondOrder& f, const Weights<SecondOrder>& b,
    const typename Space::template Position<SecondOrder>& p) const noexcept {
  if (is_finite_slope(f) && has_finite_bend(f)) return f;
  SecondOrder result(f.value, f.x, f.y);
  if (!is_finite_slope(f)) {
    SecondOrder mean;
    for (std::size_t k = 0; k < 3; ++k)
      mean = mean + b[k].value * Space::dot(corners_[k].gradient, p);
    result.x = mean.x, result.y = mean.y;
  }
  return result;
}

template <BlendSpace Space>
SecondOrder ArcTensionFacet<Space>::derivatives(
    const typename Space::template Position<SecondOrder>& p) const noexcept {
  const Vector place = Space::vector_of(position_of(p));
  const Weights<SecondOrder> b =
      weights(p, corner_weights(corners_[0].p, corners_[1].p, corners_[2].p, place));
  return sound(at_weights(b), b, p);
}

template <BlendSpace Space>
SecondOrder ArcTensionFacet<Space>::derivatives_beside(
    std::size_t corner,
    const typename Space::template Position<SecondOrder>& p) const noexcept {
  std::array<double, 3> values{0x1p-20, 0x1p-20, 0x1p-20};
  values[corner] = 1 - 0x1p-19;
  const Weights<SecondOrder> b = weights(p, values);
  return sound(at_weights(b), b, p);
}

template class ArcTensionFacet<PlaneSpace>;
template class ArcTensionFacet<SphereSpace>;
template HermiteArc hermite_arc(const ArcCorner<PlaneSpace>&,
                                const ArcCorner<PlaneSpace>&) noexcept;
template HermiteArc hermite_arc(const ArcCorner<SphereSpace>&,
                                const ArcCorner<SphereSpace>&) noexcept;

}  // namespace delone::interp
