#include "interp/hull_extension.hpp"

#include <cmath>

namespace delone::interp {

namespace {

using delaunay::two_difference;

// Sign of (p - origin) . (to - from), to about 100 bits: neighbouring zones must agree on
// whose side a point is, or its value would depend on where the walk began.
int sign_of_dot(Point2 p, Point2 origin, Point2 from, Point2 to) noexcept {
  const double x = (p.x - origin.x) * (to.x - from.x),
               y = (p.y - origin.y) * (to.y - from.y);
  const double dot = x + y;
  if (std::abs(dot) > 0x1p-49 * (std::abs(x) + std::abs(y))) return dot > 0 ? 1 : -1;
  const double accurate = (two_difference(p.x, origin.x) * two_difference(to.x, from.x) +
                           two_difference(p.y, origin.y) * two_difference(to.y, from.y))
                              .high;
  return accurate > 0 ? 1 : accurate < 0 ? -1 : 0;
}

double cross(Point2 a, Point2 b) noexcept { return a.x * b.y - a.y * b.x; }
double dot(Point2 a, Point2 b) noexcept { return a.x * b.x + a.y * b.y; }
Point2 difference(Point2 a, Point2 b) noexcept { return {a.x - b.x, a.y - b.y}; }

}  // namespace

Point2 HullExtension::scaled(Site s) const noexcept {
  const Point2 p = triangulation_->points()[at(s)];
  return {p.x * scale_, p.y * scale_};
}

// The outside is on the left of boundary arcs, so they lead clockwise around the hull;
// each is the last in the list of its origin.
Arc HullExtension::next(Arc boundary) const noexcept {
  const Adjacency& t = triangulation_->adjacency();
  return t.previous(t.first_arc(t.target(boundary)));
}

Arc HullExtension::previous(Arc boundary) const noexcept {
  const Adjacency& t = triangulation_->adjacency();
  return t.reverse(t.first_arc(boundary.origin));
}

HullExtension::Zone HullExtension::zone(Point2 p, Arc boundary) const noexcept {
  const Adjacency& t = triangulation_->adjacency();
  const auto is_past = [&](Arc a, Site corner) {  // along a, p is past the corner
    return sign_of_dot(p, scaled(corner), scaled(a.origin), scaled(t.target(a))) > 0;
  };
  while (!is_past(boundary, boundary.origin)) {
    const Arc before = previous(boundary);
    if (is_past(before, boundary.origin)) return {before, boundary};
    boundary = before;
  }
  while (is_past(boundary, t.target(boundary))) {
    const Arc after = next(boundary);
    if (!is_past(after, after.origin)) return {boundary, after};
    boundary = after;
  }
  return {boundary, boundary};
}

std::array<Site, 3> HullExtension::triangle_at(Arc boundary) const noexcept {
  const Adjacency& t = triangulation_->adjacency();
  return smallest_first(t.left(t.reverse(boundary)));
}

Point2 HullExtension::outward_normal(Arc boundary) const noexcept {
  const Point2 d = difference(scaled(triangulation_->adjacency().target(boundary)),
                              scaled(boundary.origin));
  const double length = std::hypot(d.x, d.y);
  return {-d.y / length, d.x / length};
}

HullExtension::Wedge HullExtension::wedge(Point2 p, const Zone& zone) const noexcept {
  const Point2 m = outward_normal(zone.before), n = outward_normal(zone.after);
  const Point2 d = difference(p, scaled(zone.after.origin));
  // Clockwise around the hull the normal turns clockwise: m x n < 0. Edges in one line up
  // to rounding leave no room for a wedge; then d is along both normals.
  const double turn = cross(m, n);
  if (!(turn < 0)) return {m, n, 0.5 * dot(d, m), 0.5 * dot(d, n)};
  return {m, n, std::max(0.0, cross(d, n) / turn), std::max(0.0, cross(m, d) / turn)};
}

void HullExtension::add_derivative(Combination& sum, Arc boundary,
                                   Point2 along) const noexcept {
  const std::array<Site, 3> corners = triangle_at(boundary);
  const Point2 a = scaled(corners[0]), b = scaled(corners[1]), c = scaled(corners[2]);
  const DoubleDouble ux = two_difference(b.x, a.x), uy = two_difference(b.y, a.y);
  const DoubleDouble vx = two_difference(c.x, a.x), vy = two_difference(c.y, a.y);
  const DoubleDouble x{along.x, 0}, y{along.y, 0}, area = ux * vy - uy * vx;
  if (!(area.high > 0)) return;  // flat to 100 bits: no slope can be told
  const double wb = ((x * vy - y * vx) / area).rounded(),
               wc = ((ux * y - uy * x) / area).rounded();
  sum.add(corners[0], -(wb + wc));
  sum.add(corners[1], wb);
  sum.add(corners[2], wc);
}

Combination HullExtension::combination(Point2 p, Arc boundary) const {
  p = {p.x * scale_, p.y * scale_};
  if (triangulation_->dimension() < 2) return chain_combination(p);
  const Zone z = zone(p, boundary);
  Combination sum;
  if (z.is_strip()) {
    const Site from = z.before.origin, to = triangulation_->adjacency().target(z.before);
    const Point2 a = scaled(from), d = difference(scaled(to), a);
    const double t = dot(difference(p, a), d) / dot(d, d);
    sum.add(from, 1 - t);
    sum.add(to, t);
    const Point2 normal = outward_normal(z.before);
    const double height = dot(difference(p, a), normal);
    add_derivative(sum, z.before, {normal.x * height, normal.y * height});
    return sum;
  }
  const Wedge w = wedge(p, z);
  sum.add(z.after.origin, 1);
  add_derivative(sum, z.before,
                 {w.before_normal.x * w.before_part, w.before_normal.y * w.before_part});
  add_derivative(sum, z.after,
                 {w.after_normal.x * w.after_part, w.after_normal.y * w.after_part});
  return sum;
}

Point2 HullExtension::gradient(Point2 p, Arc boundary,
                               std::span<const double> site_values) const {
  p = {p.x * scale_, p.y * scale_};
  if (triangulation_->dimension() < 2) return chain_gradient(p, site_values);
  const auto triangle_gradient = [&](Arc a) {
    const std::array<Site, 3> s = triangle_at(a);
    const auto corner = [&](std::size_t k) {
      return PlaneCorner{scaled(s[k]), site_values[at(s[k])]};
    };
    return PlaneFacet(corner(0), corner(1), corner(2)).gradient();
  };
  const Zone z = zone(p, boundary);
  if (z.is_strip()) return triangle_gradient(z.before);
  const Wedge w = wedge(p, z);
  const Point2 m = w.before_normal, n = w.after_normal;
  const Point2 g = triangle_gradient(z.before), h = triangle_gradient(z.after);
  const double turn = cross(m, n), along_m = dot(g, m), along_n = dot(h, n);
  if (!(turn < 0)) return {(g.x + h.x) / 2, (g.y + h.y) / 2};
  return {(along_m * n.y - along_n * m.y) / turn, (along_n * m.x - along_m * n.x) / turn};
}

// Sites of a chain are numbered along it.
std::pair<Site, Site> HullExtension::chain_segment(Point2 p) const noexcept {
  const Site last = triangulation_->num_sites() - 1;
  Site low = 0, high = last;
  while (high - low > 1) {
    const Site middle = low + (high - low) / 2;
    (sign_of_dot(p, scaled(middle), scaled(0), scaled(last)) < 0 ? high : low) = middle;
  }
  return {low, high};
}

Combination HullExtension::chain_combination(Point2 p) const noexcept {
  const auto [from, to] = chain_segment(p);
  Combination sum;
  if (from == to) {
    sum.add(from, 1);
    return sum;
  }
  const Point2 a = scaled(from), d = difference(scaled(to), a);
  const double t = dot(difference(p, a), d) / dot(d, d);
  sum.add(from, 1 - t);
  sum.add(to, t);
  return sum;
}

Point2 HullExtension::chain_gradient(Point2 p,
                                     std::span<const double> site_values) const noexcept {
  const auto [from, to] = chain_segment(p);
  if (from == to) return {};
  const Point2 d = difference(scaled(to), scaled(from));
  const double slope = (site_values[at(to)] - site_values[at(from)]) / dot(d, d);
  return {d.x * slope, d.y * slope};
}

}  // namespace delone::interp
