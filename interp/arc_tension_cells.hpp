#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/arc_tension_facet.hpp"
#include "interp/arc_tension_options.hpp"
#include "interp/blend_cells.hpp"
#include "interp/cursor.hpp"

namespace delone::interp {

/// Throws Error as check(ArcDemand), for values outside the range (naming the row), and
/// for factors out of range or of another number than the arcs.
template <class Triangulation>
void check_arcs(const Triangulation& t, std::span<const double> site_values,
                const TensionSplineOptions& options);

/// The arcs of a triangulation with their tension factors, and the values and gradients
/// at its sites.
template <BlendSpace Space>
class ArcNetwork {
 public:
  using Triangulation = typename Space::Triangulation;
  using Vector = typename Space::Vector;

  /// `site_gradients`: by scaled length, finite. With a range gradients are shortened:
  /// halved until some factor keeps all arcs at the site in it, and none are left at
  /// sites at its ends. Options as check_arcs() has them.
  ArcNetwork(std::shared_ptr<const Triangulation> triangulation, const Space& space,
             std::vector<double> site_values, std::vector<Vector> site_gradients,
             const TensionSplineOptions& options, const RunOptions& run);

  [[nodiscard]] const Triangulation& triangulation() const noexcept {
    return *triangulation_;
  }
  [[nodiscard]] const TensionSplineFit& fit() const noexcept { return fit_; }
  [[nodiscard]] ArcCorner<Space> corner(Site s) const noexcept {
    return {space_.vector(triangulation_->points()[at(s)]), values_[at(s)],
            gradients_[at(s)]};
  }
  [[nodiscard]] double factor(Arc a) const noexcept { return factors_[at(a.index)]; }
  /// In the order of tension_arcs().
  [[nodiscard]] std::vector<double> factors() const;

 private:
  void set_given(const TensionSplineOptions& options);
  void shorten_gradients(const ArcDemand& demand, const RunOptions& run);
  [[nodiscard]] std::vector<Site> sites_beyond_range(const ArcDemand& demand,
                                                     const RunOptions& run) const;
  void tighten(const ArcDemand& demand, const RunOptions& run);
  [[nodiscard]] HermiteArc hermite(Arc a) const noexcept {
    return hermite_arc(corner(a.origin), corner(triangulation_->adjacency().target(a)));
  }

  std::shared_ptr<const Triangulation> triangulation_;
  Space space_;
  std::vector<double> values_;
  std::vector<Vector> gradients_;
  std::vector<double> factors_;  ///< of every directed arc
  TensionSplineFit fit_;
};

/// The surface of Hermite tension splines over a triangulation: what PlaneTensionSpline
/// and SphereTensionSpline share.
///
/// A point's value depends on the point alone: at a node it is the node's value, on an
/// edge and in a triangle it is computed in the triangle with the smallest sites, from
/// the smallest site on.
template <BlendSpace Space>
class ArcTensionCells {
 public:
  using Triangulation = typename Space::Triangulation;
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;
  using Facet = ArcTensionFacet<Space>;
  using Linear = typename LinearCellsOf<Space>::Type;

  ArcTensionCells(Linear linear, ArcNetwork<Space> network, const C1Fit& fit);

  [[nodiscard]] const Triangulation& triangulation() const noexcept {
    return linear_.triangulation();
  }
  [[nodiscard]] const TensionSplineFit& fit() const noexcept { return fit_; }
  [[nodiscard]] const ArcNetwork<Space>& network() const noexcept { return network_; }
  [[nodiscard]] const Space& space() const noexcept { return space_; }
  [[nodiscard]] double value(const Point& p, Cursor& cursor) const;
  /// As BlendCells.
  [[nodiscard]] SecondOrder derivatives(const Point& p, Cursor& cursor) const;
  /// The triangle on the left of an arc, the smallest site first.
  [[nodiscard]] Facet facet(Arc arc) const noexcept;

 private:
  template <class S>
  using Position = typename Space::template Position<S>;
  [[nodiscard]] Arc arc_of(const std::array<Site, 3>& corners) const noexcept;
  [[nodiscard]] SecondOrder node_derivatives(Site s, const Point& p) const;
  template <class S>
  [[nodiscard]] S continued(const Position<S>& p, const Point& at, Cursor& cursor) const;

  Linear linear_;
  Space space_;
  ArcNetwork<Space> network_;
  TensionSplineFit fit_;
};

}  // namespace delone::interp
