#include "interp/plane_cells.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "delaunay/error.hpp"

namespace delone::interp {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double coordinate_scale(std::span<const Point2> points) {
  double largest = 0;
  for (const Point2 p : points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  if (largest == 0 || (largest > 0x1p-200 && largest < 0x1p200)) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1022, 1022));
}

void check(const SurfaceOptions& options) {
  if (!(options.max_distance >= 0)) throw Error("max_distance must be zero or more");
}

PlaneCells::PlaneCells(std::shared_ptr<const tripack::Triangulation> triangulation,
                       std::vector<double> site_values, const SurfaceOptions& options)
    : triangulation_(std::move(triangulation)),
      values_(std::move(site_values)),
      options_(options),
      scale_(coordinate_scale(triangulation_->points())),
      reach_(*triangulation_, options.max_distance),
      extension_(*triangulation_, scale_) {
  check(options);
}

PlaneFacet PlaneCells::facet(const std::array<Site, 3>& corners) const noexcept {
  return {corner(corners[0]), corner(corners[1]), corner(corners[2])};
}

PlaneFacet PlaneCells::edge_facet(Site from, Site to) const noexcept {
  return {corner(from), corner(to)};
}

bool PlaneCells::is_reached(Point2 p, const Spot& spot, Cursor& cursor) const {
  if (spot.kind != Spot::Kind::outside) cursor.site = spot.sites[0];
  return reach_.covers(p, cursor.site);
}

double PlaneCells::value(Point2 p, Cursor& cursor) const {
  if (!is_finite(p) || triangulation_->num_sites() == 0) return missing;
  const Spot spot = find_spot(*triangulation_, p, cursor.arc);
  if (spot.kind == Spot::Kind::outside) return outside_value(p, cursor);
  if (!is_reached(p, spot, cursor)) return missing;
  if (spot.kind == Spot::Kind::node) return site_value(spot.sites[0]);
  if (spot.kind == Spot::Kind::edge)
    return edge_facet(spot.sites[0], spot.sites[1])(scaled(p));
  return facet(spot.sites)(scaled(p));
}

double PlaneCells::outside_value(Point2 p, Cursor& cursor) const {
  if (options_.outside == Outside::missing) return missing;
  if (options_.outside == Outside::linear)
    return outside_combination(p, cursor).value(values_);
  cursor.site = nearest_site(*triangulation_, p, cursor.site);
  return reach_.covers(p, cursor.site) ? site_value(cursor.site) : missing;
}

Combination PlaneCells::combination(Point2 p, Cursor& cursor) const {
  if (!is_finite(p) || triangulation_->num_sites() == 0) return {};
  const Spot spot = find_spot(*triangulation_, p, cursor.arc);
  if (spot.kind == Spot::Kind::outside) return outside_combination(p, cursor);
  return is_reached(p, spot, cursor) ? inside_combination(p, spot) : Combination{};
}

Combination PlaneCells::inside_combination(Point2 p, const Spot& spot) const {
  Combination sum;
  if (spot.kind == Spot::Kind::node) {
    sum.add(spot.sites[0], 1);
  } else if (spot.kind == Spot::Kind::edge) {
    const double t = edge_weight(scaled(spot.sites[0]), scaled(spot.sites[1]), scaled(p));
    sum.add(spot.sites[0], 1 - t);
    sum.add(spot.sites[1], t);
  } else {
    const std::array<double, 3> weights = corner_weights(
        scaled(spot.sites[0]), scaled(spot.sites[1]), scaled(spot.sites[2]), scaled(p));
    for (std::size_t k = 0; k < 3; ++k) sum.add(spot.sites[k], weights[k]);
  }
  return sum;
}

Combination PlaneCells::outside_combination(Point2 p, Cursor& cursor) const {
  Combination sum;
  if (options_.outside == Outside::missing) return sum;
  if (options_.outside == Outside::nearest || reach_.is_limited()) {
    cursor.site = nearest_site(*triangulation_, p, cursor.site);
    if (!reach_.covers(p, cursor.site)) return sum;
  }
  if (options_.outside == Outside::linear) return extension_.combination(p, cursor.arc);
  sum.add(cursor.site, 1);
  return sum;
}

Point2 PlaneCells::gradient(Point2 p, Cursor& cursor) const {
  constexpr Point2 no_gradient{missing, missing};
  if (!is_finite(p) || triangulation_->num_sites() == 0) return no_gradient;
  const Spot spot = find_spot(*triangulation_, p, cursor.arc);
  const bool is_outside = spot.kind == Spot::Kind::outside;
  if (is_outside && options_.outside == Outside::missing) return no_gradient;
  if (!is_reached(p, spot, cursor)) return no_gradient;
  const Point2 g = is_outside ? outside_gradient(p, cursor) : inside_gradient(spot);
  return {g.x * scale_, g.y * scale_};
}

Point2 PlaneCells::inside_gradient(const Spot& spot) const {
  const Spot triangle = smallest_triangle(triangulation_->adjacency(), spot);
  if (triangle.kind == Spot::Kind::triangle) return facet(triangle.sites).gradient();
  // A chain: the slope along the edge, or at a node along the edge to its smaller
  // neighbour.
  const Point2 at_node = triangulation_->points()[at(spot.sites[0])];
  return extension_.gradient(at_node, {}, values_);
}

Point2 PlaneCells::outside_gradient(Point2 p, const Cursor& cursor) const {
  if (options_.outside == Outside::nearest) return {0, 0};
  return extension_.gradient(p, cursor.arc, values_);
}

}  // namespace delone::interp
