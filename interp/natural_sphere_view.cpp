#include <algorithm>
#include <cmath>

#include "interp/natural_view.hpp"
#include "interp/sphere_facet.hpp"

namespace delone::interp {

namespace {

// A site as seen from the query: its tangential part, and 1 - cosine of its distance.
template <class T>
struct Seen {
  Pair<T> across;
  T rise;
};
Seen<double> seen(const stripack::Spoke& v, double) { return {{v.x, v.y}, v.rise}; }
// The query moves along the axes of its frame, and they turn with it.
Seen<Dual<double>> seen(const stripack::Spoke& v, Dual<double>) {
  const double cosine = 1 - v.rise;
  return {{{v.x, -cosine, 0}, {v.y, 0, -cosine}}, {v.rise, -v.x, -v.y}};
}

template <class T>
Pair<T> stereographic(const Seen<T>& v) {
  return (T{2} / (T{2} - v.rise)) * v.across;
}

// An axis, as a multiple of the query plus a tangential part, of any length.
template <class T>
struct Axis {
  T up;
  Pair<T> across;
};

// Of the circle through the query and two sites; never on the far side.
template <class T>
Axis<T> new_axis(const Seen<T>& b, const Seen<T>& c) {
  const T up = cross(b.across, c.across);
  return {value_of(up) > 0 ? up : T{},
          {b.rise * c.across.y - c.rise * b.across.y,
           b.across.x * c.rise - c.across.x * b.rise}};
}

// Of the circle through three sites: the normal of their plane.
template <class T>
Axis<T> old_axis(const Seen<T>& a, const Seen<T>& b, const Seen<T>& c) {
  const Seen<T> u{b.across - a.across, b.rise - a.rise},
      v{c.across - a.across, c.rise - a.rise};
  return new_axis(u, v);
}

// The stereographic image, seen from the far side, of where an axis leaves the sphere:
// the tangent of half its distance from the query.
template <class T>
[[gnu::noinline]] Pair<T> far_half_tangent(const Axis<T>& axis) {
  const double size = std::max({value_of(axis.up), std::abs(value_of(axis.across.x)),
                                std::abs(value_of(axis.across.y))});
  const T per_size = T{1 / size};
  const T up = axis.up * per_size;
  const Pair<T> across = per_size * axis.across;
  return (T{1} / (up + square_root(up * up + dot(across, across)))) * across;
}

// Near the query (sqrt(1 + s) - 1) / s as a series, s the square of the tangent.
template <class T>
[[gnu::always_inline]] inline Pair<T> half_tangent(const Axis<T>& axis) {
  const Pair<T> tangent = (T{1} / axis.up) * axis.across;
  const T s = dot(tangent, tangent);
  if (!(value_of(s) < 0x1p-10)) return far_half_tangent(axis);
  const T factor =
      T{0.5} - s * (T{1.0 / 8} -
                    s * (T{1.0 / 16} -
                         s * (T{5.0 / 128} - s * (T{7.0 / 256} - s * T{21.0 / 1024}))));
  return factor * tangent;
}

// Half the area of the spherical triangle between the query and two points.
template <class T>
T half_area(const Pair<T>& a, const Pair<T>& b) {
  return arc_tangent(cross(a, b) / (T{1} + dot(a, b)));
}

template <class T>
PerCorner<Seen<T>> corners_of(const Cavity<stripack::Spoke>& cavity) {
  PerCorner<Seen<T>> corners(cavity.vertices.size());
  Seen<T>* corner = corners.data();
  for (const stripack::Spoke& v : cavity.vertices) *corner++ = seen(v, T{});
  return corners;
}

template <class T>
PerCorner<T> spherical_areas(const Cavity<stripack::Spoke>& cavity) {
  const PerCorner<Seen<T>> corners = corners_of<T>(cavity);
  const Seen<T>* const corner = corners.data();
  PerCorner<Pair<T>> old_centers(cavity.shape.triangles.size());
  Pair<T>* old_center = old_centers.data();
  for (const CavityShape::Triangle& t : cavity.shape.triangles) {
    const auto& c = t.corners;
    *old_center++ =
        half_tangent(old_axis(corner[at(c[0])], corner[at(c[1])], corner[at(c[2])]));
  }
  PerCorner<Pair<T>> new_centers(cavity.shape.ring.size());
  Pair<T>* const new_center = new_centers.data();
  cavity.shape.for_each_side([&](std::size_t i, std::size_t j, std::size_t k) {
    new_center[k] = half_tangent(new_axis(corner[i], corner[j]));
  });
  return stolen_areas<T, Pair<T>>(
      cavity.shape, corners.size(), {old_centers.data(), old_centers.size()},
      {new_centers.data(), new_centers.size()},
      [](const Pair<T>& a, const Pair<T>& b) { return half_area(a, b); });
}

// Length of the arc between two places on the bisector of the query and a site over the
// site's distance. Cosine and sine of that arc come from the chord normal to the
// bisector.
template <class T>
T arc_ratio(const Pair<T>& from, const Pair<T>& to, const Seen<T>& v) {
  // Directions of the two ends: (1 - s, 2 x, 2 y) / (1 + s).
  const T s = dot(from, from), t = dot(to, to);
  const T chord = square_root(T{2} * v.rise), two{2}, one{1};
  const Pair<T> difference = (one - s) * to - (one - t) * from;
  const T sine =
      (two * cross(v.across, difference) + T{4} * v.rise * cross(from, to)) / chord;
  const T cosine = (one - s) * (one - t) + T{4} * dot(from, to);
  const T half_chord = chord * T{0.5};
  const T distance =
      two * arc_tangent(half_chord, square_root(one - half_chord * half_chord));
  return arc_tangent(sine, cosine) / distance;
}

template <class T>
PerCorner<T> spherical_ratios(const Cavity<stripack::Spoke>& cavity) {
  const PerCorner<Seen<T>> corners = corners_of<T>(cavity);
  PerCorner<Pair<T>> centers;
  cavity.shape.for_each_side([&](std::size_t i, std::size_t j, std::size_t) {
    centers.push_back(half_tangent(new_axis(corners[i], corners[j])));
  });
  PerCorner<T> ratios(corners.size(), T{});
  cavity.shape.for_each_side([&](std::size_t i, std::size_t, std::size_t k) {
    const Pair<T>& before = centers[k == 0 ? centers.size() - 1 : k - 1];
    ratios[i] = arc_ratio(before, centers[k], corners[i]);
  });
  return ratios;
}

// The same number, to be calculated with in twice the precision.
DoubleDouble widened(double a) { return {a, 0}; }
Dual<DoubleDouble> widened(const Dual<double>& a) {
  return {widened(a.value), widened(a.x), widened(a.y)};
}

// Sibson's coordinates of the images in the tangent plane. Triangles that are nearly
// flat, as at the rim of a hemispherical set, in double-double arithmetic.
template <class T>
PerCorner<T> flat_weights(const Cavity<stripack::Spoke>& cavity) {
  PerCorner<Pair<T>> images;
  for (const stripack::Spoke& v : cavity.vertices)
    images.push_back(stereographic(seen(v, T{})));
  PerCorner<T> weights =
      normalized(sibson_areas<T>(cavity.shape, {images.data(), images.size()}));
  if (!weights.empty()) return weights;
  using Wide = decltype(widened(T{}));
  PerCorner<Pair<Wide>> wide;
  for (const Pair<T>& image : images)
    wide.push_back({widened(image.x), widened(image.y)});
  for (const Wide& w :
       normalized(sibson_areas<Wide>(cavity.shape, {wide.data(), wide.size()})))
    weights.push_back(rounded(w));
  return weights;
}

template <class T>
PerCorner<T> weights_of(NaturalKind kind, const Cavity<stripack::Spoke>& cavity) {
  if (kind == NaturalKind::sibson) return normalized(spherical_areas<T>(cavity));
  return kind == NaturalKind::laplace ? normalized(spherical_ratios<T>(cavity))
                                      : flat_weights<T>(cavity);
}

// Of a function on the sphere with the gradient g at v, the gradient of the same as a
// function of the stereographic image.
template <class T>
Pair<T> flat_gradient(const Seen<T>& v, const Pair<T>& image, const T& g_up,
                      const Pair<T>& g) {
  const T shrink = T{1} - v.rise * T{0.5};
  return shrink * g - (shrink * shrink * (g_up + dot(image, g) * T{0.5})) * image;
}

// The axes of stripack::LocalFrame.
struct Axes {
  Vector3 first, second;
};
Axes axes(const Direction& v) {
  const double sign = std::copysign(1.0, v.z()), a = -1 / (sign + v.z());
  const double b = v.x() * v.y() * a;
  return {{1 + sign * v.x() * v.x() * a, sign * b, -sign * v.x()},
          {b, sign + v.y() * v.y() * a, -v.y()}};
}

}  // namespace

stripack::LocalVector SphereView::local(const Vector3& v) const noexcept {
  const Axes a = axes(p_);
  return {dot(v, interp::vector(p_)), dot(v, a.first), dot(v, a.second)};
}

Vector3 SphereView::slope(Pair<double> components) const noexcept {
  const Axes a = axes(p_);
  return components.x * a.first + components.y * a.second;
}

BezierCorner<double> SphereView::bezier_corner(const Vertex& v, double weight,
                                               double value,
                                               const Slope& slope) const noexcept {
  const Seen<double> site = seen(v, 0.0);
  const Pair<double> image = stereographic(site);
  const stripack::LocalVector g = local(slope);
  return {weight, image, value, flat_gradient(site, image, g.up, {g.x, g.y})};
}

BezierCorner<Dual<double>> SphereView::bezier_corner(const Vertex& v,
                                                     const Dual<double>& weight,
                                                     double value,
                                                     const Slope& slope) const noexcept {
  const Seen<Dual<double>> site = seen(v, Dual<double>{});
  const Pair<Dual<double>> image = stereographic(site);
  const stripack::LocalVector g = local(slope);
  const Dual<double> up{g.up, g.x, g.y}, x{g.x, -g.up, 0}, y{g.y, 0, -g.up};
  return {weight, image, {value}, flat_gradient(site, image, up, {x, y})};
}

PerCorner<double> SphereView::linear_weights(const Cavity<Vertex>& cavity) const {
  const auto point = [&](std::size_t k) {
    return interp::vector(points_[at(cavity.sites[k])]);
  };
  PerCorner<double> weights(cavity.sites.size(), 0.0);
  const std::array<double, 3> w =
      corner_weights(point(0), point(1), point(2), interp::vector(p_));
  std::copy(w.begin(), w.end(), weights.begin());
  return weights;
}

PerCorner<double> SphereView::weights(NaturalKind kind,
                                      const Cavity<Vertex>& cavity) const {
  PerCorner<double> weights = weights_of<double>(kind, cavity);
  return weights.empty() ? linear_weights(cavity) : weights;
}

PerCorner<Dual<double>> SphereView::sloped_weights(NaturalKind kind,
                                                   const Cavity<Vertex>& cavity) const {
  return weights_of<Dual<double>>(kind, cavity);
}

}  // namespace delone::interp
