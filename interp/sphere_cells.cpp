#include "interp/sphere_cells.hpp"

#include <limits>
#include <utility>

#include "delaunay/error.hpp"

namespace delone::interp {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SphereCells::SphereCells(std::shared_ptr<const stripack::Triangulation> triangulation,
                         std::vector<double> site_values, const SurfaceOptions& options)
    : triangulation_(std::move(triangulation)),
      values_(std::move(site_values)),
      options_(options),
      reach_(*triangulation_, options.max_distance, options.distance) {
  check(options);
  if (options.outside == Outside::linear) {
    throw Error(
        "linear continuation outside the triangulated region is for the plane; take "
        "nearest or missing");
  }
}

SphereFacet SphereCells::facet(const std::array<Site, 3>& corners) const noexcept {
  return {corner(corners[0]), corner(corners[1]), corner(corners[2])};
}

double SphereCells::edge_value(Site from, Site to, const Direction& p) const noexcept {
  return interp::edge_value(corner(from), corner(to), vector(p));
}

bool SphereCells::is_reached(const Direction& p, const Spot& spot, Cursor& cursor) const {
  if (spot.kind != Spot::Kind::outside) cursor.site = spot.sites[0];
  return reach_.covers(p, cursor.site);
}

double SphereCells::value(const Direction& p, Cursor& cursor) const {
  if (triangulation_->num_sites() == 0) return missing;
  const Spot spot = find_spot(*triangulation_, p, cursor.arc);
  if (spot.kind == Spot::Kind::outside) return outside_value(p, cursor);
  if (!is_reached(p, spot, cursor)) return missing;
  if (spot.kind == Spot::Kind::node) return site_value(spot.sites[0]);
  if (spot.kind == Spot::Kind::edge) return edge_value(spot.sites[0], spot.sites[1], p);
  return facet(spot.sites)(vector(p));
}

double SphereCells::outside_value(const Direction& p, Cursor& cursor) const {
  if (options_.outside == Outside::missing) return missing;
  cursor.site = nearest_site(*triangulation_, p, cursor.site);
  return reach_.covers(p, cursor.site) ? site_value(cursor.site) : missing;
}

Combination SphereCells::combination(const Direction& p, Cursor& cursor) const {
  if (triangulation_->num_sites() == 0) return {};
  const Spot spot = find_spot(*triangulation_, p, cursor.arc);
  if (spot.kind != Spot::Kind::outside) {
    return is_reached(p, spot, cursor) ? inside_combination(p, spot) : Combination{};
  }
  Combination sum;
  if (options_.outside == Outside::missing) return sum;
  cursor.site = nearest_site(*triangulation_, p, cursor.site);
  if (reach_.covers(p, cursor.site)) sum.add(cursor.site, 1);
  return sum;
}

Combination SphereCells::inside_combination(const Direction& p, const Spot& spot) const {
  Combination sum;
  const auto point = [&](std::size_t k) { return corner(spot.sites[k]).p; };
  if (spot.kind == Spot::Kind::node) {
    sum.add(spot.sites[0], 1);
  } else if (spot.kind == Spot::Kind::edge) {
    const double t = edge_weight(point(0), point(1), vector(p));
    sum.add(spot.sites[0], 1 - t);
    sum.add(spot.sites[1], t);
  } else {
    const std::array<double, 3> weights =
        corner_weights(point(0), point(1), point(2), vector(p));
    for (std::size_t k = 0; k < 3; ++k) sum.add(spot.sites[k], weights[k]);
  }
  return sum;
}

Vector3 SphereCells::gradient(const Direction& p, Cursor& cursor) const {
  constexpr Vector3 no_gradient{missing, missing, missing};
  if (triangulation_->num_sites() == 0) return no_gradient;
  const Spot spot = find_spot(*triangulation_, p, cursor.arc);
  const bool is_outside = spot.kind == Spot::Kind::outside;
  if (is_outside && options_.outside == Outside::missing) return no_gradient;
  if (!is_reached(p, spot, cursor)) return no_gradient;
  return is_outside ? Vector3{} : inside_gradient(p, spot);
}

Vector3 SphereCells::inside_gradient(const Direction& p, const Spot& spot) const {
  const Adjacency& t = triangulation_->adjacency();
  const Spot triangle = smallest_triangle(t, spot);
  if (triangle.kind == Spot::Kind::triangle)
    return facet(triangle.sites).gradient(vector(p));
  // A great circle: along the edge, or at a node along the edge to its smallest
  // neighbour.
  if (t.degree(spot.sites[0]) == 0) return {};
  const auto around = t.neighbors(spot.sites[0]);
  const Site other = spot.kind == Spot::Kind::edge
                         ? spot.sites[1]
                         : *std::min_element(around.begin(), around.end());
  return edge_gradient(corner(spot.sites[0]), corner(other), vector(p));
}

}  // namespace delone::interp
