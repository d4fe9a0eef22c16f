#pragma once

#include <memory>
#include <span>
#include <vector>

#include "interp/combination.hpp"
#include "interp/cursor.hpp"
#include "interp/grid.hpp"
#include "interp/hull_extension.hpp"
#include "interp/plane_facet.hpp"
#include "interp/reach.hpp"
#include "interp/spot.hpp"
#include "interp/surface_options.hpp"

namespace delone::interp {

/// Power of two by which coordinates are multiplied so that products of them stay within
/// range; 1 unless they are beyond 2^+-200.
[[nodiscard]] double coordinate_scale(std::span<const Point2> points);

/// The piecewise linear function on a planar triangulation: what PlaneLinear, its grids
/// and its operator share.
///
/// A point's value depends on the point alone, not on how it was found: at a node it is
/// the node's value, on an edge it is computed from the two ends with the smaller site
/// first, in a triangle from the corners beginning with the smallest site.
class PlaneCells {
 public:
  /// `site_values` may be empty if only combinations are asked for.
  PlaneCells(std::shared_ptr<const tripack::Triangulation> triangulation,
             std::vector<double> site_values, const SurfaceOptions& options);

  [[nodiscard]] const tripack::Triangulation& triangulation() const noexcept {
    return *triangulation_;
  }
  [[nodiscard]] const SurfaceOptions& options() const noexcept { return options_; }
  [[nodiscard]] const PlaneReach& reach() const noexcept { return reach_; }
  [[nodiscard]] double site_value(Site s) const noexcept { return values_[at(s)]; }
  [[nodiscard]] std::span<const double> site_values() const noexcept { return values_; }

  [[nodiscard]] double value(Point2 p, Cursor& cursor) const;
  [[nodiscard]] Point2 gradient(Point2 p, Cursor& cursor) const;
  [[nodiscard]] Combination combination(Point2 p, Cursor& cursor) const;

  // For scanning, in coordinates multiplied by scale().

  /// Power of two that keeps products of coordinates within range; 1 unless they are
  /// beyond 2^+-200.
  [[nodiscard]] double scale() const noexcept { return scale_; }
  [[nodiscard]] Point2 scaled(Point2 p) const noexcept {
    return {p.x * scale_, p.y * scale_};
  }
  [[nodiscard]] Point2 scaled(Site s) const noexcept {
    return scaled(triangulation_->points()[at(s)]);
  }
  using Facet = PlaneFacet;
  /// Corners with the smallest site first.
  [[nodiscard]] PlaneFacet facet(const std::array<Site, 3>& corners) const noexcept;
  /// The triangle on the left of an arc that leaves its smallest site.
  [[nodiscard]] PlaneFacet facet(Arc arc) const noexcept {
    return facet(triangulation_->adjacency().left(arc));
  }
  /// At a scaled point of an edge, the smaller site first.
  [[nodiscard]] double edge_value(Site from, Site to, Point2 p) const noexcept {
    return edge_facet(from, to)(p);
  }
  /// An edge with the smaller site first.
  [[nodiscard]] PlaneFacet edge_facet(Site from, Site to) const noexcept;
  [[nodiscard]] const HullExtension& extension() const noexcept { return extension_; }
  /// Is p, held by `spot`, within max_distance of a site?
  [[nodiscard]] bool is_reached(Point2 p, const Spot& spot, Cursor& cursor) const;
  /// The value of a point that the triangulation does not hold.
  [[nodiscard]] double outside_value(Point2 p, Cursor& cursor) const;

 private:
  [[nodiscard]] PlaneCorner corner(Site s) const noexcept {
    return {scaled(s), values_[at(s)]};
  }
  [[nodiscard]] Combination inside_combination(Point2 p, const Spot& spot) const;
  [[nodiscard]] Combination outside_combination(Point2 p, Cursor& cursor) const;
  [[nodiscard]] Point2 inside_gradient(const Spot& spot) const;
  [[nodiscard]] Point2 outside_gradient(Point2 p, const Cursor& cursor) const;

  std::shared_ptr<const tripack::Triangulation> triangulation_;
  std::vector<double> values_;
  SurfaceOptions options_;
  double scale_;
  PlaneReach reach_;
  HullExtension extension_;
};

/// The function on a grid. Throws Error if a spacing is not positive or the grid has no
/// nodes; Cancelled.
[[nodiscard]] std::vector<double> scan(const PlaneCells& cells, const Grid& grid,
                                       const RunOptions& run);

}  // namespace delone::interp
