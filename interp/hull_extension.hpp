#pragma once

#include "interp/combination.hpp"
#include "interp/plane_facet.hpp"
#include "interp/spot.hpp"

namespace delone::interp {

/// Linear continuation of a piecewise linear surface beyond the convex hull.
///
/// A point p outside is nearest to one point q of the hull. If q lies inside a hull edge,
/// the value is that of the plane of the triangle at that edge. If q is a hull corner,
/// with outward normals m and n of the edges that end and begin there, p - q = s m + t n
/// with s, t >= 0, and the value is f(q) + s df/dm + t df/dn, each derivative taken in
/// the triangle at its edge. The result is continuous everywhere and piecewise linear,
/// reproduces linear functions, and joins the surface continuously; it is not bounded by
/// the data. Collinear points: linear along the line, constant across it; a single
/// position: constant.
class HullExtension {
 public:
  /// `scale`: power of two by which coordinates are multiplied before arithmetic.
  HullExtension(const tripack::Triangulation& triangulation, double scale)
      : triangulation_(&triangulation), scale_(scale) {}

  /// `boundary`: the arc that Triangulation::find gave for p; any for collinear points.
  [[nodiscard]] Combination combination(Point2 p, Arc boundary) const;
  /// In units of the value per scaled length.
  [[nodiscard]] Point2 gradient(Point2 p, Arc boundary,
                                std::span<const double> site_values) const;

  /// Boundary arcs, the outside on their left, on both sides of the nearest point of the
  /// hull; equal if that lies inside an edge.
  struct Zone {
    Arc before, after;
    [[nodiscard]] bool is_strip() const noexcept { return before == after; }
  };
  /// Of a scaled point outside the hull; `boundary` as above.
  [[nodiscard]] Zone zone(Point2 p, Arc boundary) const noexcept;

 private:
  struct Wedge {
    Point2 before_normal, after_normal;
    double before_part, after_part;
  };
  [[nodiscard]] Point2 scaled(Site s) const noexcept;
  [[nodiscard]] Arc next(Arc boundary) const noexcept;
  [[nodiscard]] Arc previous(Arc boundary) const noexcept;
  [[nodiscard]] Wedge wedge(Point2 p, const Zone& zone) const noexcept;
  [[nodiscard]] std::array<Site, 3> triangle_at(Arc boundary) const noexcept;
  [[nodiscard]] Point2 outward_normal(Arc boundary) const noexcept;
  void add_derivative(Combination& sum, Arc boundary, Point2 along) const noexcept;
  [[nodiscard]] std::pair<Site, Site> chain_segment(Point2 p) const noexcept;
  [[nodiscard]] Combination chain_combination(Point2 p) const noexcept;
  [[nodiscard]] Point2 chain_gradient(Point2 p,
                                      std::span<const double> site_values) const noexcept;

  const tripack::Triangulation* triangulation_;
  double scale_;
};

}  // namespace delone::interp
