#include "interp/blend_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"
#include "interp/blend_choice.hpp"
#include "interp/blend_hump.hpp"
#include "interp/blend_operator_node.hpp"
#include "interp/blend_variable.hpp"
#include "interp/east_north.hpp"
#include "interp/least_curvature.hpp"

namespace delone::interp {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

PlaneSpace space_of(const PlaneCells& cells) { return {cells.scale()}; }
SphereSpace space_of(const SphereCells&) { return {}; }

Point2 scaled_vector(Point2 p) { return p; }
Vector3 scaled_vector(const Direction& p) { return vector(p); }

// Of a surface that is linear by pieces: no second derivatives, unless all is missing.
SecondOrder piecewise(double value, double x, double y) {
  const double second = std::isnan(value) ? missing : 0;
  return {value, x, y, second, second, second};
}

SecondOrder linear_derivatives(const PlaneCells& cells, Point2 p, Cursor& cursor) {
  const Point2 g = cells.gradient(p, cursor);
  return piecewise(cells.value(p, cursor), g.x, g.y);
}

SecondOrder linear_derivatives(const SphereCells& cells, const Direction& p,
                               Cursor& cursor) {
  const GradientSphere g = east_and_north(cells.gradient(p, cursor), p);
  return piecewise(cells.value(p, cursor), g.east, g.north);
}

// On the sphere the blended surface continues itself.
SurfaceOptions linear_options(const PlaneSpace*, SurfaceOptions options) {
  return options;
}
SurfaceOptions linear_options(const SphereSpace*, SurfaceOptions options) {
  if (options.outside == Outside::linear) options.outside = Outside::missing;
  return options;
}

// The linear interpolant of two nodes at the foot of a position on the arc between them.
template <class S>
S value_on_arc(Vector3 a, Vector3 b, double at_a, double at_b,
               const SphereSpace::Position<S>& p) {
  const Vector3 normal = cross(a, b - a);
  const S from_a = SphereSpace::dot(cross(normal, a), p),
          from_b = SphereSpace::dot(cross(b, normal), p);
  return S(at_a) + (at_b - at_a) * (from_a / (from_a + from_b));
}

}  // namespace

void check(const C1Options& options) {
  check(static_cast<const SurfaceOptions&>(options));
  if (options.tension && !(*options.tension >= 0 && *options.tension <= 1))
    throw Error("the tension must lie between 0 and 1");
  if (options.gradients == Gradients::given) {
    throw Error(
        "given gradients are not an option; pass them to the surface with the values");
  }
}

template <BlendSpace Space, int Degree>
BlendCells<Space, Degree>::BlendCells(std::shared_ptr<const Triangulation> triangulation,
                                      std::vector<double> site_values,
                                      const C1Options& options, const RunOptions& run,
                                      std::vector<Vector> site_gradients)
    : options_(options),
      linear_(std::move(triangulation), std::move(site_values),
              linear_options(static_cast<const Space*>(nullptr), options)),
      space_(space_of(linear_)) {
  check(options);
  check_choices(options, this->triangulation().num_sites());
  if constexpr (std::same_as<Space, SphereSpace>) {
    if (options.outside == Outside::linear && this->triangulation().num_sites() > 0)
      rim_.emplace(this->triangulation(), linear_.site_values());
  }
  if (this->triangulation().dimension() < 2) return;
  if (options.choices) {
    fit_fixed_models(*options.choices, std::move(site_gradients), run);
    number_edges();
    fit_edges(std::numeric_limits<double>::infinity(), run);
    return;
  }
  const auto [least, most] = std::ranges::minmax_element(linear_.site_values());
  BlendFitOptions fit;
  fit.bounds = options.bounds;
  fit.range = {*least, *most};
  fit.stiffness = choose(site_gradients, options, fit, run);
  if (fit_.gradients == Gradients::global) {
    site_gradients = least_curvature_gradients(space_, this->triangulation(),
                                               linear_.site_values(), run);
  }
  fit_models(site_gradients, fit, run);
  number_edges();
  fit_edges(most_hump(fit), run);
}

// What options leave open is chosen; fit() tells what is taken.
template <BlendSpace Space, int Degree>
Stiffness BlendCells<Space, Degree>::choose(std::span<const Vector> site_gradients,
                                            const C1Options& options,
                                            const BlendFitOptions& fit,
                                            const RunOptions& run) {
  const BlendChoice choice =
      site_gradients.empty()
          ? choose_blend<Space, Degree>(space_, triangulation(), linear_.site_values(),
                                        options, fit, run)
          : BlendChoice{stiffness_of(options.tension.value_or(0)), Gradients::given};
  fit_ = {choice.stiffness.tension, choice.gradients, choice.num_tested, choice.rms,
          choice.linear_rms};
  return choice.stiffness;
}

template <BlendSpace Space, int Degree>
template <class Fit>
void BlendCells<Space, Degree>::fit_each(const RunOptions& run, Fit fit) {
  constexpr std::int64_t chunk = 512;
  models_.resize(at(triangulation().num_sites()));
  const auto fit_chunk = [&](std::int64_t first, std::int64_t last) {
    StencilGatherer<Space> gatherer(space_, triangulation());
    for (auto s = static_cast<Site>(first); s < last; ++s)
      models_[at(s)] = fit(s, gatherer.around(s, num_nearest(Degree)));
  };
  delaunay::parallel_chunks(triangulation().num_sites(), chunk, run, fit_chunk, {0, 0.8});
}

template <BlendSpace Space, int Degree>
void BlendCells<Space, Degree>::fit_models(std::span<const Vector> site_gradients,
                                           const BlendFitOptions& options,
                                           const RunOptions& run) {
  fit_each(run, [&](Site s, std::span<const StencilNode> stencil) {
    return fit_blend_model<Space, Degree>(space_, triangulation(), linear_.site_values(),
                                          s, stencil, options,
                                          known_gradient<Space>(site_gradients, s));
  });
}

template <BlendSpace Space, int Degree>
void BlendCells<Space, Degree>::fit_fixed_models(const C1Choices& choices,
                                                 std::vector<Vector> site_gradients,
                                                 const RunOptions& run) {
  fit_.gradients = site_gradients.empty() ? choices.gradients : Gradients::given;
  if (fit_.gradients == Gradients::given && choices.gradients == Gradients::local)
    throw Error("the choices are for local gradients; make them with given ones");
  if (fit_.gradients == Gradients::given && site_gradients.empty())
    throw Error("the choices are for given gradients; pass them with the values");
  if (fit_.gradients == Gradients::global) {
    site_gradients =
        least_curvature_gradients(space_, triangulation(), linear_.site_values(), run);
  }
  fit_each(run, [&](Site s, std::span<const StencilNode> stencil) {
    const auto gradient = known_gradient<Space>(site_gradients, s);
    const bool is_missing = !gradient && choices.gradients != Gradients::local;
    const C1NodeChoice choice = is_missing ? C1NodeChoice{} : choices.nodes[at(s)];
    const BlendNode<Degree> node =
        blend_node<Space, Degree>(space_, triangulation(), s, stencil, choice,
                                  gradient ? Gradients::given : Gradients::local);
    if (!gradient) return node.model(s, linear_.site_values());
    const auto slope =
        Space::local(Space::axes(space_.vector(triangulation().points()[at(s)])),
                     Space::position(*gradient), 1);
    return node.model(s, linear_.site_values(), {slope.u, slope.v});
  });
}

template <BlendSpace Space, int Degree>
void BlendCells<Space, Degree>::number_edges() {
  const Adjacency& t = triangulation().adjacency();
  edges_.resize(at(t.num_arcs()));
  std::int32_t count = 0;
  for (Site v = 0; v < t.num_sites(); ++v) {
    Arc a = t.first_arc(v);
    for (std::int32_t i = 0; i < t.degree(v); ++i, a = t.next(a)) {
      if (t.target(a) < v) continue;
      edges_[at(a.index)] = count;
      edges_[at(t.reverse(a).index)] = count;
      ++count;
    }
  }
  humps_.resize(at(count));
}

template <BlendSpace Space, int Degree>
void BlendCells<Space, Degree>::fit_edges(double limit, const RunOptions& run) {
  constexpr std::int64_t chunk = 2048;
  const Adjacency& t = triangulation().adjacency();
  const auto points = triangulation().points();
  delaunay::parallel_chunks(
      t.num_sites(), chunk, run,
      [&](std::int64_t first, std::int64_t last) {
        for (auto v = static_cast<Site>(first); v < last; ++v) {
          Arc a = t.first_arc(v);
          for (std::int32_t i = 0; i < t.degree(v); ++i, a = t.next(a)) {
            const Site w = t.target(a);
            if (w < v) continue;
            humps_[at(edges_[at(a.index)])] = edge_hump<Space, Degree>(
                space_.vector(points[at(v)]), space_.vector(points[at(w)]),
                models_[at(v)], models_[at(w)], limit);
          }
        }
      },
      {0.8, 1});
}

template <BlendSpace Space, int Degree>
EdgeHump BlendCells<Space, Degree>::hump(Arc arc) const noexcept {
  EdgeHump h = humps_[at(edges_[at(arc.index)])];
  if (triangulation().adjacency().target(arc) < arc.origin) h.b = -h.b;
  return h;
}

template <BlendSpace Space, int Degree>
auto BlendCells<Space, Degree>::facet(Arc arc) const noexcept -> Facet {
  const Adjacency& t = triangulation().adjacency();
  arc = from_smallest_corner(t, arc);
  const std::array<Arc, 3> arcs = arcs_around(arc);
  const std::array<Site, 3> corners = t.left(arc);
  typename Facet::Corners parts;
  for (std::size_t k = 0; k < 3; ++k) {
    parts.points[k] = space_.vector(triangulation().points()[at(corners[k])]);
    parts.models[k] = &models_[at(corners[k])];
  }
  parts.humps = {hump(arcs[0]), hump(arcs[1]), hump(arcs[2])};
  return Facet(parts);
}

template <BlendSpace Space, int Degree>
Arc BlendCells<Space, Degree>::arc_of(const std::array<Site, 3>& corners) const noexcept {
  const Adjacency& t = triangulation().adjacency();
  Arc a = t.first_arc(corners[0]);
  while (t.target(a) != corners[1]) a = t.next(a);
  return a;
}

// Nearest to the point is a place on one hull edge: there the edge's blend goes on. At a
// corner it becomes the polynomial of the corner, as the blend of the next edge does.
template <BlendSpace Space, int Degree>
template <class S>
S BlendCells<Space, Degree>::continued(const typename Space::template Position<S>& p,
                                       const Point& at, Cursor& cursor) const {
  if (!is_in_reach(at, cursor)) return missing * S(1.0);
  if constexpr (std::same_as<Space, PlaneSpace>) {
    const Arc hull = linear_.extension().zone(space_.vector(at), cursor.arc).after;
    const EdgeFacet inner = edge_facet(triangulation().adjacency().reverse(hull));
    return inner.facet.template beyond_edge<S>(inner.edge, p);
  } else {
    return beyond_rim<S>(p, at);
  }
}

// What the nearest place of the rim gives fades into one value for all that is far: the
// nearest place is not unique there.
template <BlendSpace Space, int Degree>
template <class S>
S BlendCells<Space, Degree>::beyond_rim(
    const typename Space::template Position<S>& p,
    const Point& at) const requires std::same_as<Space, SphereSpace> {
  const S far(rim_->far_value());
  const RimPlace place = rim_->nearest(at);
  if (place.kind == RimPlace::Kind::far) return far;
  const auto node = [&](Site s) {
    return space_.vector(triangulation().points()[interp::at(s)]);
  };
  const Vector from = node(place.from);
  const bool is_corner = place.kind == RimPlace::Kind::corner;
  const RimFoot<S> foot = is_corner ? RimFoot<S>{S(0.0), SphereSpace::dot(from, p)}
                                    : rim_foot<S>(from, node(place.to), p);
  return far + rim_part(foot.cosine) * (near_rim<S>(place, foot.place, p) - far);
}

template <BlendSpace Space, int Degree>
template <class S>
S BlendCells<Space, Degree>::near_rim(
    const RimPlace& place, const S& t,
    const SphereSpace::Position<S>& p) const requires std::same_as<Space, SphereSpace> {
  if (triangulation().dimension() == 2) {
    const EdgeFacet inner = edge_facet(place.arc);
    return inner.facet.template beyond_edge<S>(inner.edge, p, t);
  }
  const auto node = [&](Site s) {
    return space_.vector(triangulation().points()[interp::at(s)]);
  };
  const double value = site_value(place.from);
  if (place.kind == RimPlace::Kind::corner) return S(value);
  return value_on_arc<S>(node(place.from), node(place.to), value, site_value(place.to),
                         p);
}

template <BlendSpace Space, int Degree>
auto BlendCells<Space, Degree>::edge_facet(Arc inner) const noexcept -> EdgeFacet {
  const std::array<Site, 3> corners =
      smallest_first(triangulation().adjacency().left(inner));
  const auto first = std::find(corners.begin(), corners.end(), inner.origin);
  return {facet(inner), static_cast<std::size_t>(first - corners.begin())};
}

template <BlendSpace Space, int Degree>
bool BlendCells<Space, Degree>::is_in_reach(const Point& p, Cursor& cursor) const {
  if (!linear_.reach().is_limited()) return true;
  cursor.site = nearest_site(triangulation(), p, cursor.site);
  return linear_.reach().covers(p, cursor.site);
}

template <BlendSpace Space, int Degree>
double BlendCells<Space, Degree>::edge_value(Site from, Site to,
                                             const Point& p) const noexcept {
  const Adjacency& t = triangulation().adjacency();
  return facet(arc_of(smallest_triangle(t, edge_spot(from, to)).sites))(scaled_vector(p));
}

template <BlendSpace Space, int Degree>
double BlendCells<Space, Degree>::value(const Point& p, Cursor& cursor) const {
  if (!is_finite(p) || triangulation().dimension() < 2) {
    const double value = linear_.value(p, cursor);
    if constexpr (std::same_as<Space, SphereSpace>) {
      if (rim_ && std::isnan(value))
        return continued<double>(Space::position(space_.vector(p)), p, cursor);
    }
    return value;
  }
  const Spot spot = find_spot(triangulation(), p, cursor.arc);
  if (spot.kind == Spot::Kind::outside) {
    if (options().outside == Outside::linear)
      return continued<double>(Space::position(space_.vector(p)), p, cursor);
    return linear_.outside_value(p, cursor);
  }
  if (!linear_.is_reached(p, spot, cursor)) return missing;
  if (spot.kind == Spot::Kind::node) return linear_.site_value(spot.sites[0]);
  const Arc arc =
      spot.kind == Spot::Kind::triangle
          ? cursor.arc
          : arc_of(smallest_triangle(triangulation().adjacency(), spot).sites);
  return facet(arc)(space_.vector(p));
}

template <BlendSpace Space, int Degree>
std::optional<Arc> BlendCells<Space, Degree>::triangle_at(const Point& p,
                                                          Cursor& cursor) const {
  if (!is_finite(p) || triangulation().dimension() < 2) return {};
  const Spot spot = find_spot(triangulation(), p, cursor.arc);
  if (spot.kind != Spot::Kind::triangle || !linear_.is_reached(p, spot, cursor))
    return {};
  return from_smallest_corner(triangulation().adjacency(), cursor.arc);
}

template <BlendSpace Space, int Degree>
std::array<Arc, 3> BlendCells<Space, Degree>::arcs_around(Arc arc) const noexcept {
  const Adjacency& t = triangulation().adjacency();
  return {arc, t.previous(t.reverse(arc)), t.reverse(t.next(arc))};
}

template <BlendSpace Space, int Degree>
void BlendCells<Space, Degree>::fetch_places(Arc arc) const noexcept {
  for (const Arc a : arcs_around(arc)) __builtin_prefetch(&edges_[at(a.index)]);
}

template <BlendSpace Space, int Degree>
void BlendCells<Space, Degree>::fetch_parts(Arc arc) const noexcept {
  constexpr std::size_t line = 64;
  for (const Arc a : arcs_around(arc)) {
    __builtin_prefetch(&humps_[at(edges_[at(a.index)])]);
    __builtin_prefetch(&triangulation().points()[at(a.origin)]);
    const char* const model = reinterpret_cast<const char*>(&models_[at(a.origin)]);
    for (std::size_t k = 0; k < sizeof(BlendModel<Degree>); k += line)
      __builtin_prefetch(model + k);
  }
}

template <BlendSpace Space, int Degree>
SecondOrder BlendCells<Space, Degree>::derivatives(const Point& p, Cursor& cursor) const {
  if (!is_finite(p) || triangulation().dimension() < 2) {
    const SecondOrder found = linear_derivatives(linear_, p, cursor);
    if constexpr (std::same_as<Space, SphereSpace>) {
      if (rim_ && std::isnan(found.value))
        return continued<SecondOrder>(variable(space_, p), p, cursor);
    }
    return found;
  }
  const Spot spot = find_spot(triangulation(), p, cursor.arc);
  if (spot.kind == Spot::Kind::outside) {
    if (options().outside == Outside::linear)
      return continued<SecondOrder>(variable(space_, p), p, cursor);
    return linear_derivatives(linear_, p, cursor);
  }
  if (!linear_.is_reached(p, spot, cursor)) return piecewise(missing, missing, missing);
  const Spot triangle = smallest_triangle(triangulation().adjacency(), spot);
  return facet(arc_of(triangle.sites))(variable(space_, p));
}

template class BlendCells<PlaneSpace, 3>;
template class BlendCells<PlaneSpace, 4>;
template class BlendCells<SphereSpace, 3>;
template class BlendCells<SphereSpace, 4>;

}  // namespace delone::interp
