#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "delaunay/mesh_walk.hpp"
#include "delaunay/options.hpp"
#include "interp/barrier_reach.hpp"
#include "interp/barrier_values.hpp"
#include "interp/cursor.hpp"
#include "interp/grid.hpp"
#include "interp/node_batch.hpp"
#include "interp/plane_facet.hpp"
#include "interp/sphere_facet.hpp"

namespace delone::interp {

/// A surface in one triangle, or nothing: outside the domain, and where its side of the
/// curves holds no data.
template <class Plain>
class DomainFacet {
 public:
  DomainFacet() = default;
  explicit DomainFacet(const Plain& plain) : plain_(plain) {}

  template <class Position>
  [[nodiscard]] double operator()(const Position& p) const {
    return plain_ ? (*plain_)(p) : std::numeric_limits<double>::quiet_NaN();
  }
  // Grids are filled as the plain facet does it; nodes of nothing stay missing.
  template <class Columns, class Row>
  void fill_row(double* row, const Columns& columns, IndexRange range, Row y) const {
    if (plain_) plain_->fill_row(row, columns, range, y);
  }
  [[nodiscard]] auto formula() const requires(!FillsBatches<Plain>) {
    return plain_ ? plain_->formula() : decltype(plain_->formula()){};
  }
  void fill(NodeBatch& batch) const requires FillsBatches<Plain> {
    if (plain_)
      plain_->fill(batch);
    else
      batch.clear();
  }
  [[nodiscard]] const std::optional<Plain>& plain() const noexcept { return plain_; }

 private:
  std::optional<Plain> plain_;
};

/// What holds a point of a mesh: a site, or an edge or face by a half-edge. A face of the
/// ghost is outside.
template <BlendSpace Space>
[[nodiscard]] delaunay::MeshPlace find_place(const BarrierMeshIn<Space>& mesh,
                                             const typename Space::Point& p,
                                             Cursor& cursor) {
  const auto points = mesh.points();
  const delaunay::MeshPlace place = delaunay::walk(
      mesh.mesh(), mesh.ghost(),
      delaunay::real_edge_at(mesh.mesh(), cursor.site, mesh.ghost()),
      [&](Site u, Site v) { return orientation(points[at(u)], points[at(v)], p); });
  if (place.kind == delaunay::MeshPlace::Kind::site) {
    cursor.site = place.site;
  } else {
    const Site origin = mesh.mesh().origin(place.at);
    cursor.site = origin == mesh.ghost() ? mesh.mesh().target(place.at) : origin;
  }
  return place;
}

/// The piecewise linear function on a constrained triangulation: PlaneCells and
/// SphereCells with values of wedges in the place of sites'.
///
/// A point's value depends on the point alone: on an edge and at a site it is that of the
/// triangle of the domain with the smallest sites there.
template <BlendSpace Space>
class BarrierLinearCells {
 public:
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;
  using Mesh = BarrierMeshIn<Space>;
  static constexpr bool is_planar = std::same_as<Space, PlaneSpace>;
  using PlainFacet = std::conditional_t<is_planar, PlaneFacet, SphereFacet>;
  using Corner = std::conditional_t<is_planar, PlaneCorner, SphereCorner>;
  using Facet = DomainFacet<PlainFacet>;

  BarrierLinearCells(std::shared_ptr<const ConstrainedIn<Space>> constrained,
                     std::span<const double> row_values, const SurfaceOptions& options,
                     Bounds bounds);

  /// What grids are scanned by.
  [[nodiscard]] const Mesh& triangulation() const noexcept { return mesh_; }
  [[nodiscard]] const SurfaceOptions& options() const noexcept { return options_; }
  [[nodiscard]] const BarrierReach<Space>& reach() const noexcept { return reach_; }
  [[nodiscard]] const Space& space() const noexcept { return space_; }
  [[nodiscard]] const BarrierValues& values() const noexcept { return values_; }
  [[nodiscard]] double scale() const noexcept { return space_.scale; }
  [[nodiscard]] Vector scaled(Point p) const noexcept { return space_.vector(p); }

  [[nodiscard]] double value(const Point& p, Cursor& cursor) const;
  /// By x and y; on the sphere by radians towards east and north.
  [[nodiscard]] SecondOrder derivatives(const Point& p, Cursor& cursor) const;

  // For scanning.

  [[nodiscard]] double site_value(Site s) const;
  [[nodiscard]] Facet facet(Arc arc) const { return facet(mesh_.half_edge(arc)); }
  /// The face on the left of an edge.
  [[nodiscard]] Facet facet(HalfEdge e) const;
  /// At a point of an edge, in the plane scaled.
  [[nodiscard]] double edge_value(Site from, Site to, const Point& p) const {
    return side_value(mesh_.mesh().find(from, to), from, p);
  }
  /// Is there a surface in the face on the left of an edge?
  [[nodiscard]] bool is_covered(HalfEdge e) const noexcept {
    const Wedge w = mesh_.wedge_of(e);
    return w != delaunay::none && !std::isnan(values_.of_wedges[at(w)]);
  }
  /// The half-edge of the triangle that says what a place's value is; none: missing.
  [[nodiscard]] HalfEdge deciding_face(const delaunay::MeshPlace& place) const;

  /// Takes other estimates for wedges without data.
  void set_wedge_values(std::vector<double> values) noexcept {
    values_.of_wedges = std::move(values);
  }

 private:
  [[nodiscard]] Corner corner(HalfEdge e) const noexcept {
    const Wedge w = mesh_.wedge_of(e);
    return {space_.vector(mesh_.point_of(w)), values_.of_wedges[at(w)]};
  }
  /// At a point of an edge, from one of its ends on.
  [[nodiscard]] double side_value(HalfEdge e, Site from, const Point& scaled) const;

  Mesh mesh_;
  Space space_;
  SurfaceOptions options_;
  BarrierValues values_;
  BarrierReach<Space> reach_;
};

/// The half-edge of the same face that leaves its smallest site.
[[nodiscard]] inline HalfEdge from_smallest_site(const ClosedMesh& mesh,
                                                 HalfEdge e) noexcept {
  const HalfEdge next = ClosedMesh::next(e), last = ClosedMesh::previous(e);
  const Site a = mesh.origin(e), b = mesh.origin(next), c = mesh.origin(last);
  if (a < b && a < c) return e;
  return b < c ? next : last;
}

/// The function on a grid. Errors as the surface without barriers.
template <BlendSpace Space>
[[nodiscard]] std::vector<double> scan(const BarrierLinearCells<Space>& cells,
                                       const Grid& grid, const RunOptions& run);

}  // namespace delone::interp
