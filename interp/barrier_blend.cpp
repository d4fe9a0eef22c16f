#include "interp/barrier_blend.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "delaunay/parallel.hpp"
#include "interp/blend_choice.hpp"
#include "interp/blend_hump.hpp"
#include "interp/blend_variable.hpp"
#include "interp/plane_scan.hpp"
#include "interp/sphere_scan.hpp"

namespace delone::interp {

namespace {

using delaunay::MeshPlace;
using delaunay::none;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
/// Data that a wedge must see for its polynomial to do without estimated values.
constexpr std::size_t enough_data = 8;
/// Data of a part of the domain below which its tension is not chosen.
constexpr std::size_t enough_to_choose = 12;

Point2 scaled_vector(Point2 p) { return p; }
Vector3 scaled_vector(const Direction& p) { return vector(p); }

}  // namespace

template <BlendSpace Space, int Degree>
BarrierBlendCells<Space, Degree>::BarrierBlendCells(
    std::shared_ptr<const ConstrainedIn<Space>> constrained,
    std::span<const double> row_values, const SurfaceOptions& options,
    const BarrierBlendOptions& blend, const RunOptions& run)
    : linear_(std::move(constrained), row_values, options, blend.bounds) {
  if (triangulation().dimension() < 2) return;
  const WedgeGraph<Space> graph(triangulation());
  const std::vector<BlendFitOptions> of_parts = fit_options(graph, blend, run);
  fit_models(graph, of_parts, run);
  continue_values();
  fit_models(graph, of_parts, run);
  fit_humps(graph, of_parts);
}

template <BlendSpace Space, int Degree>
std::vector<BlendFitOptions> BarrierBlendCells<Space, Degree>::fit_options(
    const WedgeGraph<Space>& graph, const BarrierBlendOptions& blend,
    const RunOptions& run) const {
  std::vector<std::vector<Wedge>> data(static_cast<std::size_t>(graph.num_parts()));
  const auto& values = linear_.values();
  for (Wedge w = 0; w < triangulation().num_wedges(); ++w) {
    if (graph.degree(w) > 0 && has_data(w) && !std::isnan(values.of_wedges[at(w)]))
      data[at(graph.part(w))].push_back(w);
  }
  std::vector<BlendFitOptions> result;
  result.reserve(data.size());
  for (const auto& of_part : data) result.push_back(part_options(of_part, blend, run));
  return result;
}

// The tension is chosen as if the curves were not there, but by one part's data only.
template <BlendSpace Space, int Degree>
BlendFitOptions BarrierBlendCells<Space, Degree>::part_options(
    std::span<const Wedge> data, const BarrierBlendOptions& blend,
    const RunOptions& run) const {
  BlendFitOptions fit;
  fit.bounds = blend.bounds;
  if (data.empty()) return fit;
  std::vector<Point> points;
  std::vector<double> values;
  for (const Wedge w : data) {
    points.push_back(triangulation().point_of(w));
    values.push_back(linear_.values().of_wedges[at(w)]);
  }
  const auto [least, most] = std::ranges::minmax_element(values);
  fit.range = {*least, *most};
  fit.stiffness = blend.tension ? stiffness_of(*blend.tension) : stiffness_levels.front();
  if (blend.tension) return fit;
  const typename Space::Triangulation t(points);
  if (t.dimension() < 2 || data.size() < enough_to_choose) return fit;
  const std::vector<double> of_sites =
      values_at_sites(t.sites(), t.num_sites(), values, Duplicates::first);
  C1Options options;
  options.gradients = Gradients::local;
  fit.stiffness =
      choose_blend<Space, Degree>(linear_.space(), t, of_sites, options, fit, run)
          .stiffness;
  return fit;
}

// A wedge whose stencil holds data enough does without estimated values, and so needs no
// second fit once these are better.
template <BlendSpace Space, int Degree>
void BarrierBlendCells<Space, Degree>::fit_models(
    const WedgeGraph<Space>& graph, std::span<const BlendFitOptions> options,
    const RunOptions& run) {
  constexpr std::int64_t chunk = 512;
  models_.resize(at(triangulation().num_wedges()));
  is_settled_.resize(models_.size());
  const std::vector<double>& values = linear_.values().of_wedges;
  const auto fit_chunk = [&](std::int64_t first, std::int64_t last) {
    WedgeStencils<Space> stencils(linear_.space(), graph);
    for (auto w = static_cast<Wedge>(first); w < last; ++w) {
      if (graph.degree(w) == 0 || std::isnan(values[at(w)]) || is_settled_[at(w)] != 0)
        continue;
      std::span<const StencilNode> stencil = stencils.around(w, num_nearest(Degree));
      std::vector<StencilNode> data;
      std::ranges::copy_if(stencil, std::back_inserter(data),
                           [&](const StencilNode& n) { return has_data(n.site); });
      const bool is_enough =
          data.size() >= enough_data &&
          std::ranges::any_of(data, [](const StencilNode& n) { return n.is_neighbor; });
      if (is_enough) stencil = data;
      is_settled_[at(w)] = is_enough && has_data(w) ? 1 : 0;
      models_[at(w)] =
          fit_blend_model<Space, Degree>(linear_.space(), graph.points(), values, w,
                                         stencil, options[at(graph.part(w))]);
    }
  };
  delaunay::parallel_chunks(triangulation().num_wedges(), chunk, run, fit_chunk);
}

template <BlendSpace Space, int Degree>
double BarrierBlendCells<Space, Degree>::continued(Wedge w) const {
  const auto& sources = linear_.values().sources[at(w)];
  const double base = models_[at(sources.front().wedge)].value;
  double sum = 0, weights = 0;
  for (const WedgeSource& s : sources) {
    const Model& m = models_[at(s.wedge)];
    const Vector origin = vector_of(s.wedge);
    const LocalPosition<double> local = Space::local(
        Space::axes(origin), Space::position(Space::difference(vector_of(w), origin)),
        m.per_radius);
    const double rise =
        softened(polynomial_rise<Degree, double>(m, local), m.least, m.most);
    const double near = sources.front().distance / s.distance;
    sum += near * near * (m.value - base + rise);
    weights += near * near;
  }
  const double value = base + sum / weights;
  return std::isfinite(value) ? value : linear_.values().of_wedges[at(w)];
}

// As far from their data as these from one another polynomials say little: then planes
// are as good, and hold.
template <BlendSpace Space, int Degree>
void BarrierBlendCells<Space, Degree>::continue_values() {
  std::vector<double> values = linear_.values().of_wedges;
  for (Wedge w = 0; w < triangulation().num_wedges(); ++w) {
    if (has_data(w)) continue;
    const WedgeSource& nearest = linear_.values().sources[at(w)].front();
    if (nearest.distance * models_[at(nearest.wedge)].per_radius < 0.5)
      values[at(w)] = continued(w);
  }
  linear_.set_wedge_values(std::move(values));
}

// From the smaller site on, as BlendCells has it; the other way round the odd term
// changes its sign. Sides of a barrier have humps of their own.
template <BlendSpace Space, int Degree>
void BarrierBlendCells<Space, Degree>::fit_humps(
    const WedgeGraph<Space>& graph, std::span<const BlendFitOptions> options) {
  const Mesh& mesh = triangulation();
  humps_.resize(4 * static_cast<std::size_t>(mesh.mesh().num_face_slots()));
  for (std::size_t i = 0; i < humps_.size(); ++i) {
    const auto e = static_cast<HalfEdge>(i);
    if (ClosedMesh::corner_of(e) == 3 || !linear_.is_covered(e)) continue;
    const bool is_forward = mesh.mesh().origin(e) < mesh.mesh().target(e);
    if (!is_forward && !mesh.is_barrier(e)) continue;
    Wedge from = mesh.wedge_of(e), to = mesh.wedge_of(ClosedMesh::next(e));
    if (!is_forward) std::swap(from, to);
    const EdgeHump hump = edge_hump<Space, Degree>(
        vector_of(from), vector_of(to), models_[at(from)], models_[at(to)],
        most_hump(options[at(graph.part(from))]));
    const EdgeHump reversed{hump.a, -hump.b, hump.c};
    humps_[i] = is_forward ? hump : reversed;
    if (!mesh.is_barrier(e))
      humps_[static_cast<std::size_t>(mesh.mesh().reverse(e))] = reversed;
  }
}

template <BlendSpace Space, int Degree>
bool BarrierBlendCells<Space, Degree>::is_shared(HalfEdge e) const noexcept {
  const Mesh& mesh = triangulation();
  const auto has_value = [&](Site s) {
    return !std::isnan(linear_.values().of_sites[at(s)]);
  };
  return mesh.is_barrier(e) && linear_.is_covered(mesh.mesh().reverse(e)) &&
         has_value(mesh.mesh().origin(e)) && has_value(mesh.mesh().target(e));
}

// From its smallest site on.
template <BlendSpace Space, int Degree>
auto BarrierBlendCells<Space, Degree>::own_facet(HalfEdge e) const -> Own {
  typename Own::Corners parts;
  for (std::size_t k = 0; k < 3; ++k, e = ClosedMesh::next(e)) {
    const Wedge w = triangulation().wedge_of(e);
    parts.points[k] = vector_of(w);
    parts.models[k] = &models_[at(w)];
    parts.humps[k] = humps_[static_cast<std::size_t>(e)];
  }
  return Own(parts);
}

template <BlendSpace Space, int Degree>
auto BarrierBlendCells<Space, Degree>::facet(HalfEdge e) const -> Facet {
  if (!linear_.is_covered(e)) return {};
  const ClosedMesh& mesh = triangulation().mesh();
  const HalfEdge first = from_smallest_site(mesh, e);
  std::array<Vector, 3> points;
  std::vector<typename BarrierFacet<Space, Degree>::Across> across;
  HalfEdge side = first;
  for (std::size_t k = 0; k < 3; ++k, side = ClosedMesh::next(side)) {
    points[k] = vector_of(triangulation().wedge_of(side));
    if (!is_shared(side)) continue;
    const HalfEdge back = mesh.reverse(side), other = from_smallest_site(mesh, back);
    const std::size_t other_k = back == other                     ? 0
                                : back == ClosedMesh::next(other) ? 1
                                                                  : 2;
    across.push_back({k, other_k, own_facet(other)});
  }
  return Facet(BarrierFacet<Space, Degree>(own_facet(first), points, std::move(across)));
}

template <BlendSpace Space, int Degree>
double BarrierBlendCells<Space, Degree>::edge_value(Site from, Site to,
                                                    const Point& p) const {
  const HalfEdge e = triangulation().mesh().find(from, to);
  const HalfEdge side = linear_.deciding_face({MeshPlace::Kind::edge, e, none});
  return side == none ? missing : facet(side)(scaled_vector(p));
}

template <BlendSpace Space, int Degree>
double BarrierBlendCells<Space, Degree>::value(const Point& p, Cursor& cursor) const {
  if (!is_finite(p) || triangulation().dimension() < 2) return missing;
  const MeshPlace place = find_place<Space>(triangulation(), p, cursor);
  const HalfEdge e = linear_.deciding_face(place);
  if (e == none || !reach().covers(p, cursor.site)) return missing;
  if (place.kind == MeshPlace::Kind::site) return site_value(place.site);
  return facet(e)(scaled(p));
}

template <BlendSpace Space, int Degree>
SecondOrder BarrierBlendCells<Space, Degree>::derivatives(const Point& p,
                                                          Cursor& cursor) const {
  const SecondOrder nothing(missing, missing, missing, missing, missing, missing);
  if (!is_finite(p) || triangulation().dimension() < 2) return nothing;
  const MeshPlace place = find_place<Space>(triangulation(), p, cursor);
  const HalfEdge e = linear_.deciding_face(place);
  if (e == none || !reach().covers(p, cursor.site)) return nothing;
  return (*facet(e).plain())(variable(linear_.space(), p));
}

template <int Degree>
std::vector<double> scan(const BarrierBlendCells<PlaneSpace, Degree>& cells,
                         const Grid& grid, const RunOptions& run) {
  return scan_plane(cells, grid, run);
}
template <int Degree>
std::vector<double> scan(const BarrierBlendCells<SphereSpace, Degree>& cells,
                         const Grid& grid, const RunOptions& run) {
  return scan_sphere(cells, grid, run);
}

template class BarrierBlendCells<PlaneSpace, 3>;
template class BarrierBlendCells<PlaneSpace, 4>;
template class BarrierBlendCells<SphereSpace, 3>;
template class BarrierBlendCells<SphereSpace, 4>;
template std::vector<double> scan(const BarrierBlendCells<PlaneSpace, 3>&, const Grid&,
                                  const RunOptions&);
template std::vector<double> scan(const BarrierBlendCells<PlaneSpace, 4>&, const Grid&,
                                  const RunOptions&);
template std::vector<double> scan(const BarrierBlendCells<SphereSpace, 3>&, const Grid&,
                                  const RunOptions&);
template std::vector<double> scan(const BarrierBlendCells<SphereSpace, 4>&, const Grid&,
                                  const RunOptions&);

}  // namespace delone::interp
