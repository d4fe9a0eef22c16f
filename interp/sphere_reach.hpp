#pragma once

#include <array>
#include <limits>

#include "interp/sphere_facet.hpp"
#include "interp/spot.hpp"
#include "interp/surface_options.hpp"
#include "stripack/triangulation.hpp"

namespace delone::interp {

/// Which directions are no farther than `limit` kilometres from a site, by great circle
/// or by geodesic on WGS84.
///
/// A step of the geodetic latitude or longitude is 6335.439 to 6399.594 km for a radian
/// on the unit sphere (the extreme radii of curvature of WGS84), so the geodesic between
/// two directions is as many kilometres a radian of the angle between them; only sites
/// between these bounds are measured along the ellipsoid.
class SphereReach {
 public:
  SphereReach(const stripack::Triangulation& triangulation, double limit_km,
              GlobeDistance distance) noexcept
      : triangulation_(&triangulation), limit_km_(limit_km), distance_(distance) {}

  [[nodiscard]] bool is_limited() const noexcept {
    return limit_km_ < std::numeric_limits<double>::infinity();
  }
  /// `start`: a site near p.
  [[nodiscard]] bool covers(const Direction& p, Site start) const;
  /// Does it cover the whole triangle? A point of a triangle is no farther from its
  /// nearest corner than the circumradius.
  [[nodiscard]] bool covers_triangle(const std::array<Site, 3>& corners) const noexcept;

 private:
  [[nodiscard]] const Direction& point(Site s) const noexcept {
    return triangulation_->points()[at(s)];
  }
  /// Is the site surely within the limit, judged by the angle alone?
  [[nodiscard]] bool is_surely_near(const Direction& p, Site s) const noexcept;
  [[nodiscard]] bool is_near(const Direction& p, Site s) const noexcept;
  [[nodiscard]] bool has_near_geodesic(const Direction& p, Site nearest) const;

  const stripack::Triangulation* triangulation_;
  double limit_km_;
  GlobeDistance distance_;
};

}  // namespace delone::interp
