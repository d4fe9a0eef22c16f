#pragma once

#include <memory>
#include <vector>

#include "interp/combination.hpp"
#include "interp/cursor.hpp"
#include "interp/grid.hpp"
#include "interp/reach.hpp"
#include "interp/sphere_facet.hpp"
#include "interp/spot.hpp"
#include "interp/surface_options.hpp"

namespace delone::interp {

/// The piecewise linear function on a triangulation of directions: what SphereLinear, its
/// grids and its operator share.
///
/// A point's value depends on the point alone, as in PlaneCells.
class SphereCells {
 public:
  /// `site_values` may be empty if only combinations are asked for.
  SphereCells(std::shared_ptr<const stripack::Triangulation> triangulation,
              std::vector<double> site_values, const SurfaceOptions& options);

  [[nodiscard]] const stripack::Triangulation& triangulation() const noexcept {
    return *triangulation_;
  }
  [[nodiscard]] const SurfaceOptions& options() const noexcept { return options_; }
  [[nodiscard]] const SphereReach& reach() const noexcept { return reach_; }
  [[nodiscard]] double site_value(Site s) const noexcept { return values_[at(s)]; }
  [[nodiscard]] std::span<const double> site_values() const noexcept { return values_; }

  [[nodiscard]] double value(const Direction& p, Cursor& cursor) const;
  /// Tangent to the unit sphere; NaN if missing.
  [[nodiscard]] Vector3 gradient(const Direction& p, Cursor& cursor) const;
  [[nodiscard]] Combination combination(const Direction& p, Cursor& cursor) const;

  using Facet = SphereFacet;
  /// The triangle on the left of an arc that leaves its smallest site.
  [[nodiscard]] SphereFacet facet(Arc arc) const noexcept {
    return facet(triangulation_->adjacency().left(arc));
  }
  /// Corners with the smallest site first.
  [[nodiscard]] SphereFacet facet(const std::array<Site, 3>& corners) const noexcept;
  /// On an edge, the smaller site first.
  [[nodiscard]] double edge_value(Site from, Site to, const Direction& p) const noexcept;
  /// Whether the cell that holds p (`spot`) is known not to reach as far as max_distance.
  [[nodiscard]] bool is_reached(const Direction& p, const Spot& spot,
                                Cursor& cursor) const;
  /// The value of a point that the triangulation does not hold.
  [[nodiscard]] double outside_value(const Direction& p, Cursor& cursor) const;

 private:
  [[nodiscard]] SphereCorner corner(Site s) const noexcept {
    return {interp::vector(triangulation_->points()[at(s)]),
            values_.empty() ? 0 : values_[at(s)]};
  }
  [[nodiscard]] Combination inside_combination(const Direction& p,
                                               const Spot& spot) const;
  [[nodiscard]] Vector3 inside_gradient(const Direction& p, const Spot& spot) const;

  std::shared_ptr<const stripack::Triangulation> triangulation_;
  std::vector<double> values_;
  SurfaceOptions options_;
  SphereReach reach_;
};

/// The function on a longitude-latitude grid in degrees. Throws Error as check(Grid) does
/// and for latitudes outside -90..90; Cancelled.
[[nodiscard]] std::vector<double> scan(const SphereCells& cells, const Grid& grid,
                                       const RunOptions& run);

}  // namespace delone::interp
