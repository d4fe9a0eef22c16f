#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/options.hpp"
#include "interp/blend_facet.hpp"
#include "interp/blend_fit.hpp"
#include "interp/c1_options.hpp"
#include "interp/cursor.hpp"
#include "interp/plane_cells.hpp"
#include "interp/rim_extension.hpp"
#include "interp/sphere_cells.hpp"

namespace delone::interp {

/// The piecewise linear surface of a space, which holds what the blended one does outside
/// triangles.
template <BlendSpace Space>
struct LinearCellsOf;
template <>
struct LinearCellsOf<PlaneSpace> {
  using Type = PlaneCells;
};
template <>
struct LinearCellsOf<SphereSpace> {
  using Type = SphereCells;
};

/// The blended surface over a triangulation: what PlaneC1 and SphereC1, their grids and
/// operators share.
///
/// A point's value depends on the point alone: at a node it is the node's value, on an
/// edge and in a triangle it is computed in the triangle with the smallest sites, from
/// the smallest site on.
template <BlendSpace Space, int Degree>
class BlendCells {
 public:
  using Triangulation = typename Space::Triangulation;
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;
  using Facet = BlendFacet<Space, Degree>;
  using Linear = typename LinearCellsOf<Space>::Type;

  /// `site_gradients`: tangent vectors by scaled length, NaN where none is known; empty:
  /// none is given.
  BlendCells(std::shared_ptr<const Triangulation> triangulation,
             std::vector<double> site_values, const C1Options& options,
             const RunOptions& run, std::vector<Vector> site_gradients = {});

  [[nodiscard]] const Triangulation& triangulation() const noexcept {
    return linear_.triangulation();
  }
  [[nodiscard]] const SurfaceOptions& options() const noexcept { return options_; }
  [[nodiscard]] const C1Fit& fit() const noexcept { return fit_; }
  [[nodiscard]] const Linear& linear() const noexcept { return linear_; }
  [[nodiscard]] double value(const Point& p, Cursor& cursor) const;
  /// The arc with the triangle that holds p in its interior on its left, from the
  /// triangle's smallest site; none for points at nodes, on edges, outside, beyond
  /// max_distance.
  [[nodiscard]] std::optional<Arc> triangle_at(const Point& p, Cursor& cursor) const;
  /// Ask for the memory that facet(arc) reads: first where it is told, later what it is.
  void fetch_places(Arc arc) const noexcept;
  void fetch_parts(Arc arc) const noexcept;
  /// By x and y in the plane; by distance towards east and north on the unit sphere,
  /// second derivatives along geodesics. NaN if missing.
  [[nodiscard]] SecondOrder derivatives(const Point& p, Cursor& cursor) const;

  /// At a point of an edge, in the plane scaled.
  [[nodiscard]] double edge_value(Site from, Site to, const Point& p) const noexcept;
  [[nodiscard]] double site_value(Site s) const noexcept { return linear_.site_value(s); }
  [[nodiscard]] decltype(auto) reach() const noexcept { return linear_.reach(); }
  [[nodiscard]] double scale() const noexcept { return space_.scale; }
  [[nodiscard]] Vector scaled(Point p) const noexcept { return space_.vector(p); }
  /// The triangle on the left of an arc, the smallest site first.
  [[nodiscard]] Facet facet(Arc arc) const noexcept;

 private:
  /// Outside the hull, continued.
  template <class S>
  [[nodiscard]] S continued(const typename Space::template Position<S>& p,
                            const Point& at, Cursor& cursor) const;
  /// Of the triangle at a hull edge, the inside on the left, the edge's number besides.
  struct EdgeFacet {
    Facet facet;
    std::size_t edge;
  };
  [[nodiscard]] EdgeFacet edge_facet(Arc inner) const noexcept;
  /// Is the point near enough to a node?
  [[nodiscard]] bool is_in_reach(const Point& p, Cursor& cursor) const;
  template <class S>
  [[nodiscard]] S beyond_rim(
      const typename Space::template Position<S>& p,
      const Point& at) const requires std::same_as<Space, SphereSpace>;
  /// What the place t of the rim makes of p, without regard to the distance.
  template <class S>
  [[nodiscard]] S near_rim(
      const RimPlace& place, const S& t,
      const SphereSpace::Position<S>& p) const requires std::same_as<Space, SphereSpace>;
  void number_edges();
  [[nodiscard]] Stiffness choose(std::span<const Vector> site_gradients,
                                 const C1Options& options, const BlendFitOptions& fit,
                                 const RunOptions& run);
  void fit_models(std::span<const Vector> site_gradients, const BlendFitOptions& options,
                  const RunOptions& run);
  /// `fit(site, stencil)` for every site.
  template <class Fit>
  void fit_each(const RunOptions& run, Fit fit);
  void fit_fixed_models(const C1Choices& choices, std::vector<Vector> site_gradients,
                        const RunOptions& run);
  void fit_edges(double limit, const RunOptions& run);
  [[nodiscard]] Arc arc_of(const std::array<Site, 3>& corners) const noexcept;
  /// Those of a triangle, in turn.
  [[nodiscard]] std::array<Arc, 3> arcs_around(Arc arc) const noexcept;
  [[nodiscard]] EdgeHump hump(Arc arc) const noexcept;

  SurfaceOptions options_;
  Linear linear_;
  Space space_;
  C1Fit fit_;
  std::vector<BlendModel<Degree>> models_;
  std::vector<std::int32_t> edges_;  ///< of every arc
  std::vector<EdgeHump> humps_;      ///< of every edge
  /// Of directions in a hemisphere that are continued.
  std::optional<RimExtension> rim_;
};

}  // namespace delone::interp
