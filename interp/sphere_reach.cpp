#include "interp/sphere_reach.hpp"

#include <cmath>
#include <set>
#include <vector>

namespace delone::interp {

namespace {

// Radii of curvature of WGS84: least (meridian at the equator), greatest (at the poles),
// with a margin for rounding.
constexpr double least_radius_km = 6335.439, greatest_radius_km = 6399.594;

}  // namespace

bool SphereReach::is_surely_near(const Direction& p, Site s) const noexcept {
  const double radius = distance_ == GlobeDistance::great_circle
                            ? stripack::earth_radius_km
                            : greatest_radius_km;
  return stripack::angle(p, point(s)) * radius <= limit_km_;
}

bool SphereReach::is_near(const Direction& p, Site s) const noexcept {
  return is_surely_near(p, s) ||
         (distance_ == GlobeDistance::geodesic_wgs84 &&
          stripack::geodesic_km(stripack::lonlat(p), stripack::lonlat(point(s))) <=
              limit_km_);
}

bool SphereReach::covers(const Direction& p, Site start) const {
  if (!is_limited() || is_surely_near(p, start)) return true;
  const Site nearest = nearest_site(*triangulation_, p, start);
  if (is_surely_near(p, nearest)) return true;
  return distance_ == GlobeDistance::geodesic_wgs84 && has_near_geodesic(p, nearest);
}

// The nearest site by angle need not be the nearest by geodesic. Those within an angle
// are connected.
bool SphereReach::has_near_geodesic(const Direction& p, Site nearest) const {
  const double widest_angle = limit_km_ / least_radius_km;
  if (stripack::angle(p, point(nearest)) > widest_angle) return false;
  std::set<Site> seen{nearest};
  std::vector<Site> open{nearest};
  while (!open.empty()) {
    const Site s = open.back();
    open.pop_back();
    if (is_near(p, s)) return true;
    for (const Site w : triangulation_->adjacency().neighbors(s)) {
      if (stripack::angle(p, point(w)) <= widest_angle && seen.insert(w).second)
        open.push_back(w);
    }
  }
  return false;
}

bool SphereReach::covers_triangle(const std::array<Site, 3>& corners) const noexcept {
  if (!is_limited()) return true;
  const Vector3 a = vector(point(corners[0])), b = vector(point(corners[1])),
                c = vector(point(corners[2]));
  if (is_thin(a, b, c)) return false;  // its circumcircle is not known well enough
  const Vector3 normal = cross(b - a, c - a);
  const double along = dot(normal, a),
               across = std::sqrt(dot(cross(normal, a), cross(normal, a)));
  const double radius = distance_ == GlobeDistance::great_circle
                            ? stripack::earth_radius_km
                            : greatest_radius_km;
  return std::atan2(across, along) * radius * (1 + 0x1p-20) <= limit_km_;
}

}  // namespace delone::interp
