#include "interp/barrier_cells.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "delaunay/error.hpp"
#include "interp/east_north.hpp"
#include "interp/plane_cells.hpp"
#include "interp/plane_scan.hpp"
#include "interp/sphere_scan.hpp"

namespace delone::interp {

namespace {

using delaunay::MeshPlace;
using delaunay::none;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

PlaneSpace space_over(std::span<const Point2> points) {
  return {coordinate_scale(points)};
}
SphereSpace space_over(std::span<const Direction>) { return {}; }

double value_on_edge(const PlaneCorner& a, const PlaneCorner& b, Point2 p) {
  return PlaneFacet(a, b)(p);
}
double value_on_edge(const SphereCorner& a, const SphereCorner& b, const Direction& p) {
  return interp::edge_value(a, b, vector(p));
}

}  // namespace

template <BlendSpace Space>
BarrierLinearCells<Space>::BarrierLinearCells(
    std::shared_ptr<const ConstrainedIn<Space>> constrained,
    std::span<const double> row_values, const SurfaceOptions& options, Bounds bounds)
    : mesh_(std::move(constrained)),
      space_(space_over(mesh_.points())),
      options_(options),
      values_(
          barrier_values<Space>(space_, mesh_, row_values, options.duplicates, bounds)),
      reach_(mesh_, values_.of_sites, options) {}

template <BlendSpace Space>
auto BarrierLinearCells<Space>::facet(HalfEdge e) const -> Facet {
  if (!is_covered(e)) return {};
  e = from_smallest_site(mesh_.mesh(), e);
  return Facet(PlainFacet(corner(e), corner(ClosedMesh::next(e)),
                          corner(ClosedMesh::previous(e))));
}

template <BlendSpace Space>
double BarrierLinearCells<Space>::site_value(Site s) const {
  if (!reach_.covers(mesh_.points()[at(s)], s)) return missing;
  const HalfEdge e =
      mesh_.smallest_face(s, [&](HalfEdge side) { return is_covered(side); });
  return e == none ? missing : values_.of_wedges[at(mesh_.wedge_of(e))];
}

template <BlendSpace Space>
double BarrierLinearCells<Space>::side_value(HalfEdge e, Site from,
                                             const Point& scaled) const {
  const HalfEdge side =
      mesh_.smallest_side(e, [&](HalfEdge either) { return is_covered(either); });
  if (side == none) return missing;
  Corner a = corner(side), b = corner(ClosedMesh::next(side));
  if (mesh_.mesh().origin(side) != from) std::swap(a, b);
  return value_on_edge(a, b, scaled);
}

template <BlendSpace Space>
HalfEdge BarrierLinearCells<Space>::deciding_face(const MeshPlace& place) const {
  const auto is_usable = [&](HalfEdge e) { return is_covered(e); };
  if (place.kind == MeshPlace::Kind::site)
    return mesh_.smallest_face(place.site, is_usable);
  if (place.kind == MeshPlace::Kind::edge)
    return mesh_.smallest_side(place.at, is_usable);
  return is_covered(place.at) ? place.at : none;
}

template <BlendSpace Space>
double BarrierLinearCells<Space>::value(const Point& p, Cursor& cursor) const {
  if (!is_finite(p) || mesh_.dimension() < 2) return missing;
  const MeshPlace place = find_place<Space>(mesh_, p, cursor);
  const HalfEdge e = deciding_face(place);
  if (e == none || !reach_.covers(p, cursor.site)) return missing;
  if (place.kind == MeshPlace::Kind::site) return site_value(place.site);
  if (place.kind == MeshPlace::Kind::face) return facet(e)(scaled(p));
  const Site from =
      std::min(mesh_.mesh().origin(place.at), mesh_.mesh().target(place.at));
  if constexpr (is_planar)
    return side_value(place.at, from, scaled(p));
  else
    return side_value(place.at, from, p);
}

template <BlendSpace Space>
SecondOrder BarrierLinearCells<Space>::derivatives(const Point& p, Cursor& cursor) const {
  const SecondOrder nothing(missing, missing, missing, missing, missing, missing);
  const double f = value(p, cursor);
  if (std::isnan(f)) return nothing;
  const Facet found = facet(deciding_face(find_place<Space>(mesh_, p, cursor)));
  if (!found.plain()) return nothing;
  if constexpr (is_planar) {
    const Point2 g = found.plain()->gradient();
    return {f, g.x * space_.scale, g.y * space_.scale};
  } else {
    const GradientSphere g = east_and_north(found.plain()->gradient(vector(p)), p);
    return {f, g.east, g.north};
  }
}

template <>
std::vector<double> scan(const BarrierLinearCells<PlaneSpace>& cells, const Grid& grid,
                         const RunOptions& run) {
  return scan_plane(cells, grid, run);
}
template <>
std::vector<double> scan(const BarrierLinearCells<SphereSpace>& cells, const Grid& grid,
                         const RunOptions& run) {
  return scan_sphere(cells, grid, run);
}

template class BarrierLinearCells<PlaneSpace>;
template class BarrierLinearCells<SphereSpace>;

}  // namespace delone::interp
