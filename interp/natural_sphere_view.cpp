#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

// Half the area of the spherical triangle between the query and two points. Not a number,
// which then reaches the sum of the weights, where these are nearly antipodal, as
// circumcentres over sets near a great circle are: there it loses too many digits.
template <class T>
T half_area(const Pair<T>& a, const Pair<T>& b) {
  constexpr double least = 0x1p-10;
  const T cosine = T{1} + dot(a, b);
  const double good =
      value_of(cosine) > least ? 1 : std::numeric_limits<double>::quiet_NaN();
  return arc_tangent(T{good} * cross(a, b) / cosine);
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

using WideVector = std::array<DoubleDouble, 3>;
DoubleDouble dot(const WideVector& a, const WideVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
WideVector combined(const WideVector& a, const DoubleDouble& s, const WideVector& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

// The unit vectors of a query and of its axes.
struct WideFrame {
  explicit WideFrame(const Direction& p) : query(p), of_query(stripack::stretch(p)) {
    const WideVector raw{{{p.x(), 0}, {p.y(), 0}, {p.z(), 0}}};
    const WideVector up = combined(raw, {of_query, 0}, raw);
    const Vector3 rounded_first = axes(p).first;
    first = {{{rounded_first.x, 0}, {rounded_first.y, 0}, {rounded_first.z, 0}}};
    first = combined(first, -dot(first, up), up);
    const DoubleDouble size = delaunay::sqrt(dot(first, first));
    for (DoubleDouble& c : first) c = c / size;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      second[k] = up[i] * first[j] - up[j] * first[i];
    }
  }
  Direction query;
  double of_query;
  WideVector first, second;
};

// A site as seen from the query, of the exact directions of both.
Seen<DoubleDouble> seen_exactly(const Direction& site, const WideFrame& frame,
                                DoubleDouble) {
  const double of_site = stripack::stretch(site);
  const auto part = [&](double s, double q) {
    return delaunay::two_difference(s, q) + delaunay::two_product(s, of_site) -
           delaunay::two_product(q, frame.of_query);
  };
  const WideVector d{part(site.x(), frame.query.x()), part(site.y(), frame.query.y()),
                     part(site.z(), frame.query.z())};
  return {{dot(d, frame.first), dot(d, frame.second)}, dot(d, d) * 0.5};
}
Seen<Dual<DoubleDouble>> seen_exactly(const Direction& site, const WideFrame& frame,
                                      Dual<DoubleDouble>) {
  const Seen<DoubleDouble> v = seen_exactly(site, frame, DoubleDouble{});
  const DoubleDouble turn = v.rise - DoubleDouble{1};
  const DoubleDouble x = v.across.x, y = v.across.y;
  return {{{x, turn, {}}, {y, {}, turn}}, {v.rise, -x, -y}};
}

DoubleDouble wide_root(const DoubleDouble& a) { return delaunay::sqrt(a); }
Dual<DoubleDouble> wide_root(const Dual<DoubleDouble>& a) {
  const DoubleDouble root = delaunay::sqrt(a.value), slope = DoubleDouble{0.5} / root;
  return {root, slope * a.x, slope * a.y};
}

template <class T>
Pair<T> wide_half_tangent(const Axis<T>& axis) {
  const T root = wide_root(axis.up * axis.up + dot(axis.across, axis.across));
  return (Constant<T>::of(1) / (axis.up + root)) * axis.across;
}

// spherical_areas with centres in twice the precision, T with or without derivatives.
template <class T>
auto wide_areas(const CavityShape& shape, std::span<const Seen<T>> corners) {
  using Area = decltype(rounded(T{}));
  PerCorner<Pair<T>> old_centers, new_centers;
  for (const CavityShape::Triangle& t : shape.triangles)
    old_centers.push_back(
        wide_half_tangent(old_axis(corners[at(t.corners[0])], corners[at(t.corners[1])],
                                   corners[at(t.corners[2])])));
  shape.for_each_side([&](std::size_t i, std::size_t j, std::size_t) {
    new_centers.push_back(wide_half_tangent(new_axis(corners[i], corners[j])));
  });
  return stolen_areas<Area, Pair<T>>(
      shape, corners.size(), {old_centers.data(), old_centers.size()},
      {new_centers.data(), new_centers.size()}, [](const Pair<T>& a, const Pair<T>& b) {
        return arc_tangent(rounded(cross(a, b)), rounded(Constant<T>::of(1) + dot(a, b)));
      });
}

// Sibson's coordinates where plain doubles lose digits.
template <class T>
auto wide_weights(std::span<const Direction> points, const Direction& query,
                  const Cavity<stripack::Spoke>& cavity) {
  const WideFrame frame(query);
  PerCorner<Seen<T>> corners;
  for (const Site s : cavity.sites)
    corners.push_back(seen_exactly(points[at(s)], frame, T{}));
  return normalized(wide_areas<T>(cavity.shape, {corners.data(), corners.size()}));
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
  if (weights.empty() && kind == NaturalKind::sibson)
    weights = wide_weights<DoubleDouble>(points_, p_, cavity);
  return weights.empty() ? linear_weights(cavity) : weights;
}

PerCorner<Dual<double>> SphereView::sloped_weights(NaturalKind kind,
                                                   const Cavity<Vertex>& cavity) const {
  PerCorner<Dual<double>> weights = weights_of<Dual<double>>(kind, cavity);
  if (weights.empty() && kind == NaturalKind::sibson)
    weights = wide_weights<Dual<DoubleDouble>>(points_, p_, cavity);
  return weights;
}

}  // namespace delone::interp
