#include "interp/arc_tension_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"
#include "interp/arc_tension.hpp"
#include "interp/blend_variable.hpp"
#include "interp/east_north.hpp"
#include "interp/node_gradients.hpp"

namespace delone::interp {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t chunk_size = 1024;

PlaneSpace space_of(const PlaneCells& cells) { return {cells.scale()}; }
SphereSpace space_of(const SphereCells&) { return {}; }

/// `visit(arc)` for the arcs that leave a site towards a larger one.
template <class Visit>
void for_each_upward_arc(const Adjacency& t, Site v, Visit visit) {
  if (t.degree(v) == 0) return;
  Arc a = t.first_arc(v);
  for (std::int32_t i = 0; i < t.degree(v); ++i) {
    if (i > 0) a = t.next(a);
    if (t.target(a) > v) visit(a);
  }
}

/// Arcs with the rows of their ends, the smaller row first, sorted.
struct RowArc {
  std::array<delaunay::Node, 2> rows;
  Arc arc;
};
std::vector<RowArc> arcs_by_row(const auto& t) {
  std::vector<RowArc> result;
  const Adjacency& adjacency = t.adjacency();
  for (Site v = 0; v < t.num_sites(); ++v) {
    for_each_upward_arc(adjacency, v, [&](Arc a) {
      const delaunay::Node from = t.rows()[at(v)], to = t.rows()[at(adjacency.target(a))];
      result.push_back({{std::min(from, to), std::max(from, to)}, a});
    });
  }
  std::ranges::sort(result, {}, &RowArc::rows);
  return result;
}

std::vector<std::array<delaunay::Node, 2>> rows_of_arcs(const auto& t) {
  std::vector<std::array<delaunay::Node, 2>> result;
  for (const RowArc& a : arcs_by_row(t)) result.push_back(a.rows);
  return result;
}

void check_factor(double factor, const std::string& what) {
  if (factor >= 0 && factor <= tension_factor_max) return;
  throw Error(what + " must lie between 0 and " +
              std::to_string(static_cast<int>(tension_factor_max)));
}

/// The derivatives of a surface that is linear by pieces: no second ones, unless all is
/// missing.
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

/// Beyond a hull edge at the distance `height` from its place: along the normal with the
/// normal derivative of the place, which is linear along the edge. For the surface to be
/// flat across the lines through the edge's ends its slope gives way there, the sooner
/// the farther out.
template <class S>
S beyond_side(const ArcCorner<PlaneSpace>& a, const ArcCorner<PlaneSpace>& b,
              double factor, const PlaneSpace::Position<S>& p) {
  const Point2 d = PlaneSpace::difference(b.p, a.p);
  const double length = std::hypot(d.x, d.y);
  const Point2 along{d.x / length, d.y / length}, normal{-along.y, along.x};
  const auto from_a = PlaneSpace::difference(p, a.p),
             from_b = PlaneSpace::difference(p, b.p);
  const S part = (1 / length) * PlaneSpace::dot(along, from_a),
          rest = (-1 / length) * PlaneSpace::dot(along, from_b),
          height = PlaneSpace::dot(normal, from_a);
  const HermiteArc arc = hermite_arc(a, b);
  const double rise = arc.end - arc.start;
  const TensionBasis<S> basis{S(factor)};
  const S on_side =
      rise * part + 0.5 * (arc.start_slope - arc.end_slope) * basis.even(part, rest) +
      0.5 * ((arc.start_slope - rise) + (arc.end_slope - rise)) * basis.odd(part, rest);
  const double at_a = PlaneSpace::dot(a.gradient, normal),
               change = PlaneSpace::dot(b.gradient, normal) - at_a;
  const S inside = part * rest, squared = inside * inside, out = (1 / length) * height,
          reach = squared + out * out;
  S slope = S(at_a) + change * (part * part * (3.0 * rest + part));
  if (value_of(reach) > 0)
    slope = slope + change * (inside * (rest - part)) * (squared / reach);
  return S(a.value) + on_side + height * slope;
}

}  // namespace

template <class Triangulation>
void check_arcs(const Triangulation& t, std::span<const double> site_values,
                const TensionSplineOptions& options) {
  check(options.demand);
  for (std::size_t s = 0; s < site_values.size(); ++s) {
    if (site_values[s] >= options.demand.least && site_values[s] <= options.demand.most)
      continue;
    const std::int64_t row = t.rows()[s];
    throw Error("row " + std::to_string(row) +
                    ": the value is outside the range asked for; widen the range or "
                    "leave out the row",
                {row});
  }
  check_factor(options.factor, "the tension factor");
  const auto num_arcs = static_cast<std::size_t>(t.adjacency().num_arcs()) / 2;
  if (!options.factors.empty() && options.factors.size() != num_arcs) {
    throw Error("there are " + std::to_string(options.factors.size()) +
                " tension factors for " + std::to_string(num_arcs) +
                " arcs; give one an arc, in the order of tension_arcs()");
  }
  for (std::size_t k = 0; k < options.factors.size(); ++k)
    check_factor(options.factors[k], "tension factor " + std::to_string(k));
}
template void check_arcs(const tripack::Triangulation&, std::span<const double>,
                         const TensionSplineOptions&);
template void check_arcs(const stripack::Triangulation&, std::span<const double>,
                         const TensionSplineOptions&);

template <BlendSpace Space>
ArcNetwork<Space>::ArcNetwork(std::shared_ptr<const Triangulation> triangulation,
                              const Space& space, std::vector<double> site_values,
                              std::vector<Vector> site_gradients,
                              const TensionSplineOptions& options, const RunOptions& run)
    : triangulation_(std::move(triangulation)),
      space_(space),
      values_(std::move(site_values)),
      gradients_(std::move(site_gradients)),
      factors_(at(triangulation_->adjacency().num_arcs())) {
  set_given(options);
  if (triangulation_->dimension() < 2) {
    factors_.clear();
    return;
  }
  shorten_gradients(options.demand, run);
  tighten(options.demand, run);
}

template <BlendSpace Space>
void ArcNetwork<Space>::set_given(const TensionSplineOptions& options) {
  std::ranges::fill(factors_, options.factor);
  if (options.factors.empty()) return;
  const std::vector<RowArc> arcs = arcs_by_row(*triangulation_);
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const double factor = std::max(options.factor, options.factors[k]);
    factors_[at(arcs[k].arc.index)] = factor;
    factors_[at(triangulation_->adjacency().reverse(arcs[k].arc).index)] = factor;
  }
}

// Of an arc that no factor keeps in the range the ends whose slopes alone would lead out
// of it, or both.
template <BlendSpace Space>
std::vector<Site> ArcNetwork<Space>::sites_beyond_range(const ArcDemand& demand,
                                                        const RunOptions& run) const {
  const Adjacency& t = triangulation_->adjacency();
  std::vector<std::vector<Site>> found(at((t.num_sites() + chunk_size - 1) / chunk_size));
  const auto is_beyond = [&](const HermiteArc& arc) {
    return range_factor(arc, demand) > tension_factor_max;
  };
  const auto visit = [&](Arc a, std::vector<Site>& list) {
    const HermiteArc arc = hermite(a);
    if (!is_beyond(arc)) return;
    HermiteArc only_start = arc, only_end = arc;
    only_start.end_slope = only_end.start_slope = 0;
    const bool start = is_beyond(only_start), end = is_beyond(only_end);
    if (start || !end) list.push_back(a.origin);
    if (end || !start) list.push_back(t.target(a));
  };
  delaunay::parallel_chunks(
      t.num_sites(), chunk_size, run, [&](std::int64_t first, std::int64_t last) {
        for (auto v = static_cast<Site>(first); v < last; ++v)
          for_each_upward_arc(t, v,
                              [&](Arc a) { visit(a, found[at(first / chunk_size)]); });
      });
  std::vector<Site> all;
  for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

template <BlendSpace Space>
void ArcNetwork<Space>::shorten_gradients(const ArcDemand& demand,
                                          const RunOptions& run) {
  constexpr int most_halvings = 60;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (demand.least == -infinity && demand.most == infinity) return;
  std::vector<bool> is_shortened(values_.size());
  for (std::size_t s = 0; s < values_.size(); ++s) {
    if (values_[s] != demand.least && values_[s] != demand.most) continue;
    is_shortened[s] = Space::dot(gradients_[s], gradients_[s]) > 0;
    gradients_[s] = Vector{};
  }
  for (int step = 0; step <= most_halvings; ++step) {
    const std::vector<Site> beyond = sites_beyond_range(demand, run);
    if (beyond.empty()) break;
    for (const Site s : beyond) {
      gradients_[at(s)] = part_of(gradients_[at(s)], step < most_halvings ? 0.5 : 0);
      is_shortened[at(s)] = true;
    }
  }
  fit_.num_shortened = std::ranges::count(is_shortened, true);
}

template <BlendSpace Space>
void ArcNetwork<Space>::tighten(const ArcDemand& demand, const RunOptions& run) {
  const Adjacency& t = triangulation_->adjacency();
  std::vector<std::int64_t> limited(at((t.num_sites() + chunk_size - 1) / chunk_size));
  const auto tighten_arc = [&](Arc a, std::int64_t& num_limited) {
    const HermiteArc arc = hermite(a);
    const ShapeFactor shape = shape_factor(arc, demand.shape);
    num_limited += shape.is_limited ? 1 : 0;
    const double range = std::min(range_factor(arc, demand), tension_factor_max);
    const double factor = std::max({factors_[at(a.index)], shape.factor, range});
    factors_[at(a.index)] = factors_[at(t.reverse(a).index)] = factor;
  };
  delaunay::parallel_chunks(
      t.num_sites(), chunk_size, run, [&](std::int64_t first, std::int64_t last) {
        for (auto v = static_cast<Site>(first); v < last; ++v)
          for_each_upward_arc(
              t, v, [&](Arc a) { tighten_arc(a, limited[at(first / chunk_size)]); });
      });
  for (const std::int64_t n : limited) fit_.num_limited += n;
  for (const double factor : factors_) {
    fit_.num_tightened += factor > 0 ? 1 : 0;
    fit_.largest = std::max(fit_.largest, factor);
  }
  fit_.num_tightened /= 2;  // both directions
  fit_.num_arcs = std::ssize(factors_) / 2;
}

template <BlendSpace Space>
std::vector<double> ArcNetwork<Space>::factors() const {
  if (factors_.empty()) return {};
  std::vector<double> result;
  for (const RowArc& a : arcs_by_row(*triangulation_)) result.push_back(factor(a.arc));
  return result;
}

template <BlendSpace Space>
ArcTensionCells<Space>::ArcTensionCells(Linear linear, ArcNetwork<Space> network,
                                        const C1Fit& fit)
    : linear_(std::move(linear)),
      space_(space_of(linear_)),
      network_(std::move(network)),
      fit_(network_.fit()) {
  fit_.c1 = fit;
}

template <BlendSpace Space>
auto ArcTensionCells<Space>::facet(Arc arc) const noexcept -> Facet {
  const Adjacency& t = triangulation().adjacency();
  arc = from_smallest_corner(t, arc);
  const Arc second = t.previous(t.reverse(arc)), third = t.reverse(t.next(arc));
  const std::array<Site, 3> c = t.left(arc);
  return Facet({network_.corner(c[0]), network_.corner(c[1]), network_.corner(c[2])},
               {network_.factor(arc), network_.factor(second), network_.factor(third)});
}

template <BlendSpace Space>
Arc ArcTensionCells<Space>::arc_of(const std::array<Site, 3>& corners) const noexcept {
  const Adjacency& t = triangulation().adjacency();
  Arc a = t.first_arc(corners[0]);
  while (t.target(a) != corners[1]) a = t.next(a);
  return a;
}

template <BlendSpace Space>
double ArcTensionCells<Space>::value(const Point& p, Cursor& cursor) const {
  if (!is_finite(p) || triangulation().dimension() < 2) return linear_.value(p, cursor);
  const Spot spot = find_spot(triangulation(), p, cursor.arc);
  if (spot.kind == Spot::Kind::outside) {
    if (linear_.options().outside == Outside::linear)
      return continued<double>(Space::position(space_.vector(p)), p, cursor);
    return linear_.outside_value(p, cursor);
  }
  if (!linear_.is_reached(p, spot, cursor)) return missing;
  if (spot.kind == Spot::Kind::node) return linear_.site_value(spot.sites[0]);
  return facet(arc_of(smallest_triangle(triangulation().adjacency(), spot).sites))(
      space_.vector(p));
}

template <BlendSpace Space>
SecondOrder ArcTensionCells<Space>::derivatives(const Point& p, Cursor& cursor) const {
  if (!is_finite(p) || triangulation().dimension() < 2)
    return linear_derivatives(linear_, p, cursor);
  const Spot spot = find_spot(triangulation(), p, cursor.arc);
  if (spot.kind == Spot::Kind::outside) {
    if (linear_.options().outside == Outside::linear)
      return continued<SecondOrder>(variable(space_, p), p, cursor);
    return linear_derivatives(linear_, p, cursor);
  }
  if (!linear_.is_reached(p, spot, cursor))
    return {missing, missing, missing, missing, missing, missing};
  if (spot.kind == Spot::Kind::node) return node_derivatives(spot.sites[0], p);
  return facet(arc_of(smallest_triangle(triangulation().adjacency(), spot).sites))
      .derivatives(variable(space_, p));
}

template <BlendSpace Space>
SecondOrder ArcTensionCells<Space>::node_derivatives(Site s, const Point& p) const {
  const Spot node{Spot::Kind::node, {s, none, none}};
  const std::array<Site, 3> corners =
      smallest_triangle(triangulation().adjacency(), node).sites;
  const auto k =
      static_cast<std::size_t>(std::ranges::find(corners, s) - corners.begin());
  const auto place = variable(space_, p);
  const SecondOrder bend = facet(arc_of(corners)).derivatives_beside(k, place);
  // Along the gradient as a constant vector; on the sphere it is tangent at p.
  const SecondOrder slope = Space::dot(network_.corner(s).gradient, place);
  return {linear_.site_value(s), slope.x, slope.y, bend.xx, bend.xy, bend.yy};
}

template <BlendSpace Space>
template <class S>
S ArcTensionCells<Space>::continued(const Position<S>& p, const Point& at,
                                    Cursor& cursor) const {
  if constexpr (std::same_as<Space, PlaneSpace>) {
    if (linear_.reach().is_limited()) {
      cursor.site = nearest_site(triangulation(), at, cursor.site);
      if (!linear_.reach().covers(at, cursor.site)) return missing * S(1.0);
    }
    const HullExtension::Zone zone =
        linear_.extension().zone(space_.vector(at), cursor.arc);
    const ArcCorner<Space> a = network_.corner(zone.after.origin);
    if (!zone.is_strip())
      return S(a.value) + Space::dot(a.gradient, Space::difference(p, a.p));
    const Site to = triangulation().adjacency().target(zone.after);
    return beyond_side<S>(a, network_.corner(to), network_.factor(zone.after), p);
  } else {
    return missing * S(1.0);  // refused by SphereCells
  }
}

template class ArcNetwork<PlaneSpace>;
template class ArcNetwork<SphereSpace>;
template class ArcTensionCells<PlaneSpace>;
template class ArcTensionCells<SphereSpace>;

std::vector<std::array<delaunay::Node, 2>> tension_arcs(
    const tripack::Triangulation& triangulation) {
  return rows_of_arcs(triangulation);
}
std::vector<std::array<delaunay::Node, 2>> tension_arcs(
    const stripack::Triangulation& triangulation) {
  return rows_of_arcs(triangulation);
}

}  // namespace delone::interp
