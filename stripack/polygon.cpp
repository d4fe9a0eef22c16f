#include "stripack/polygon.hpp"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/PolygonArea.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "stripack/arcs.hpp"
#include "stripack/fan.hpp"
#include "stripack/great_circle.hpp"
#include "stripack/predicates.hpp"

namespace delone::stripack {

namespace {

using std::numbers::pi;

Direction opposite(const Direction& d) { return Direction::from(-d.x(), -d.y(), -d.z()); }

// Does the arc p-q cross the arc a-b? Corners on the circle of p-q count as on its left,
// so that a boundary that crosses there is counted once and one that touches, not at all
// or twice.
bool is_crossed(const Direction& p, const Direction& q, const Direction& a,
                const Direction& b) noexcept {
  const int side_a = orientation(p, q, a) >= 0 ? 1 : -1,
            side_b = orientation(p, q, b) >= 0 ? 1 : -1;
  if (side_a == side_b) return false;
  return orientation(a, b, p) == side_b && orientation(a, b, q) == -side_b;
}

// A point a fraction of the side away from its middle, to the left or right.
Direction beside_middle(const Direction& a, const Direction& b, double offset) {
  const Direction middle = midpoint(a, b), pole = pole_of(a, b);
  const double step = offset * angle(a, b);
  return Direction::from(middle.x() + step * pole.x(), middle.y() + step * pole.y(),
                         middle.z() + step * pole.z());
}

// From the corner's next neighbour counter-clockwise to its previous one, 0 .. 2 pi.
double interior_angle(const Direction& before, const Direction& at,
                      const Direction& after) {
  const LocalFrame frame(at);
  const Spoke u = frame.spoke(after), v = frame.spoke(before);
  const double turn = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
  return turn < 0 ? turn + 2 * pi : turn;
}

/// Sums over the fan from the first corner, if the polygon is near enough to it.
struct FanSums {
  HalfAreas halves;
  LocalVector moment;
};

std::optional<FanSums> fan_sums(std::span<const Direction> corners) {
  const LocalFrame frame(corners[0]);
  const auto seen = [&](const Direction& d) {
    const Spoke s = frame.spoke(d);
    return project({1 - s.rise, s.x, s.y});
  };
  FanSums sums;
  std::optional<Corner> p = Corner{0, 0, 1};
  for (std::size_t i = 1; i <= corners.size(); ++i) {
    const auto q = i < corners.size() ? seen(corners[i]) : Corner{0, 0, 1};
    if (!q) return std::nullopt;
    const LocalVector part = fan_moment(*p, *q);
    sums.halves.turn(1, tan_half_excess(*p, *q));
    sums.moment.up += part.up;
    sums.moment.x += part.x;
    sums.moment.y += part.y;
    p = q;
  }
  return sums;
}

GeographicLib::PolygonArea geodesic_polygon(std::span<const Direction> corners) {
  GeographicLib::PolygonArea polygon(GeographicLib::Geodesic::WGS84());
  for (const Direction& corner : corners) {
    const LonLat p = lonlat(corner);
    polygon.AddPoint(p.lat_deg, p.lon_deg);
  }
  return polygon;
}

}  // namespace

Polygon::Polygon(std::vector<Direction> corners) : corners_(std::move(corners)) {
  check();
  add_references();
}

Polygon::Polygon(std::vector<Direction> corners, const Direction& inside)
    : Polygon(std::move(corners)) {
  const Containment side = locate(inside);
  if (side == Containment::boundary)
    throw Error("the point that says where the inside is lies on the boundary");
  if (side == Containment::inside) return;
  is_reversed_ = true;
  for (Reference& reference : references_) {
    reference.side = reference.side == Containment::inside ? Containment::outside
                                                           : Containment::inside;
  }
}

void Polygon::check() const {
  if (corners_.size() < 3) throw Error("a polygon on the sphere needs three corners");
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const bool is_same = is_same_direction(corner(i), corner(i + 1));
    if (!is_same && !is_same_direction(corner(i), opposite(corner(i + 1)))) continue;
    const std::size_t next = (i + 1) % corners_.size();
    throw Error("corners " + std::to_string(i) + " and " + std::to_string(next) +
                    (is_same ? " are the same; remove one"
                             : " are opposite; give a corner in between"),
                {static_cast<std::int64_t>(i), static_cast<std::int64_t>(next)});
  }
}

// Beside the middle of a side, so near that nothing else of the boundary comes between it
// and the side: there left is known. Two, for not both can be opposite to one point.
void Polygon::add_references() {
  constexpr std::size_t wanted = 2;
  for (std::size_t i = 0; i < corners_.size() && references_.size() < wanted; ++i) {
    for (double offset = 0.25; offset > 1e-12; offset /= 8) {
      const Direction left = beside_middle(corner(i), corner(i + 1), offset),
                      right = beside_middle(corner(i), corner(i + 1), -offset);
      const bool is_free = is_crossed(left, right, corner(i), corner(i + 1)) &&
                           num_crossings(left, right) == 1 && !is_on_boundary(left);
      if (!is_free) continue;
      references_.push_back({left, Containment::inside});
      break;
    }
  }
  if (references_.size() < wanted)
    throw Error("the polygon's boundary runs along itself; remove what is there twice");
}

bool Polygon::is_on_boundary(const Direction& p) const noexcept {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (orientation(corner(i), corner(i + 1), p) != 0) continue;
    if (is_same_direction(corner(i), p) || is_inside_arc(corner(i), corner(i + 1), p))
      return true;
  }
  return false;
}

int Polygon::num_crossings(const Direction& p, const Direction& q) const noexcept {
  int count = 0;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    count += static_cast<int>(is_crossed(p, q, corner(i), corner(i + 1)));
  return count;
}

Containment Polygon::locate(const Direction& p) const noexcept {
  if (is_on_boundary(p)) return Containment::boundary;
  const std::size_t other = is_same_direction(opposite(p), references_[0].point) ? 1 : 0;
  const Reference& reference = references_[other];
  const bool is_same_side = num_crossings(p, reference.point) % 2 == 0;
  if (is_same_side) return reference.side;
  return reference.side == Containment::inside ? Containment::outside
                                               : Containment::inside;
}

double Polygon::area() const {
  if (const auto sums = fan_sums(corners_)) {
    const double left = sums->halves.signed_area();
    const double area = is_reversed_ ? -left : left;
    return area < 0 ? area + 4 * pi : area;
  }
  double left = -pi * (static_cast<double>(corners_.size()) - 2);
  for (std::size_t i = 0; i < corners_.size(); ++i)
    left += interior_angle(corner(i), corner(i + 1), corner(i + 2));
  left = std::clamp(left, 0.0, 4 * pi);
  return is_reversed_ ? 4 * pi - left : left;
}

Direction Polygon::centroid() const {
  const double sign = is_reversed_ ? -1 : 1;
  if (const auto sums = fan_sums(corners_)) {
    const LocalVector& m = sums->moment;
    return LocalFrame(corners_[0]).direction({sign * m.up, sign * m.x, sign * m.y});
  }
  SpaceVector moment;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Direction pole = pole_of(corner(i), corner(i + 1));
    const double half = sign * angle(corner(i), corner(i + 1)) / 2;
    moment.x += half * pole.x();
    moment.y += half * pole.y();
    moment.z += half * pole.z();
  }
  return Direction::from(moment.x, moment.y, moment.z);
}

double Polygon::perimeter() const noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    sum += angle(corner(i), corner(i + 1));
  return sum;
}

double wgs84_area_km2() { return GeographicLib::Geodesic::WGS84().EllipsoidArea() / 1e6; }

// A polygon without area may come out as a little less than nothing, which is not the
// whole ellipsoid.
double polygon_area_km2_wgs84(std::span<const Direction> corners) {
  if (corners.size() < 3) return 0;
  double perimeter_m = 0, area_m2 = 0;
  geodesic_polygon(corners).Compute(false, true, perimeter_m, area_m2);
  const double area = area_m2 / 1e6;
  return area < -1e-6 ? area + wgs84_area_km2() : std::max(area, 0.0);
}

double polygon_perimeter_km_wgs84(std::span<const Direction> corners) {
  if (corners.empty()) return 0;
  double perimeter_m = 0, area_m2 = 0;
  geodesic_polygon(corners).Compute(false, true, perimeter_m, area_m2);
  return perimeter_m / 1e3;
}

}  // namespace delone::stripack
