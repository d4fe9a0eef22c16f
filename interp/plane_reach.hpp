#pragma once

#include <cmath>
#include <limits>

#include "interp/plane_facet.hpp"
#include "interp/spot.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

/// Which points of the plane are no farther than `limit` from a site.
class PlaneReach {
 public:
  PlaneReach(const tripack::Triangulation& triangulation, double limit)
      : triangulation_(&triangulation), limit_(limit) {}

  [[nodiscard]] bool is_limited() const noexcept {
    return limit_ < std::numeric_limits<double>::infinity();
  }

  /// `start`: a site near p.
  [[nodiscard]] bool covers(tripack::Point2 p, Site start) const {
    if (!is_limited() || is_near(p, start)) return true;
    return is_near(p, nearest_site(*triangulation_, p, start));
  }
  /// Does it cover the whole triangle? A point of a triangle is no farther from its
  /// nearest corner than the circumradius.
  [[nodiscard]] bool covers_triangle(const std::array<Site, 3>& corners) const noexcept {
    if (!is_limited()) return true;
    const tripack::Point2 a = point(corners[0]), b = point(corners[1]),
                          c = point(corners[2]);
    if (is_thin(a, b, c)) return false;  // its circumcircle is not known well enough
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double radius = distance(a, b) * distance(b, c) * distance(c, a) / (2 * area);
    return radius * (1 + 0x1p-20) <= limit_;
  }

 private:
  [[nodiscard]] tripack::Point2 point(Site s) const noexcept {
    return triangulation_->points()[at(s)];
  }
  [[nodiscard]] static double distance(tripack::Point2 a, tripack::Point2 b) noexcept {
    return std::hypot(a.x - b.x, a.y - b.y);
  }
  [[nodiscard]] bool is_near(tripack::Point2 p, Site s) const noexcept {
    return distance(p, point(s)) <= limit_;
  }

  const tripack::Triangulation* triangulation_;
  double limit_;
};

}  // namespace delone::interp
