#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "delaunay/site_queries.hpp"
#include "interp/index.hpp"
#include "stripack/predicates.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/predicates.hpp"
#include "tripack/triangulation.hpp"

namespace delone::interp {

using delaunay::Adjacency;
using delaunay::Arc;
using delaunay::Node;
using delaunay::none;
using delaunay::Site;

[[nodiscard]] inline double squared_distance(tripack::Point2 a,
                                             tripack::Point2 b) noexcept {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

/// The square of the chord.
[[nodiscard]] inline double squared_distance(const stripack::Direction& a,
                                             const stripack::Direction& b) noexcept {
  const double dx = a.x() - b.x(), dy = a.y() - b.y(), dz = a.z() - b.z();
  return dx * dx + dy * dy + dz * dz;
}

/// What holds a query point, named so that every way of finding it names it alike: a
/// node, an edge with its smaller site first, or a triangle counter-clockwise with its
/// smallest site first.
struct Spot {
  enum class Kind : std::uint8_t { node, edge, triangle, outside };
  Kind kind = Kind::outside;
  std::array<Site, 3> sites{none, none, none};
};

/// The corners turned so that the smallest comes first.
[[nodiscard]] inline std::array<Site, 3> smallest_first(std::array<Site, 3> c) noexcept {
  const auto smallest = std::min_element(c.begin(), c.end());
  std::rotate(c.begin(), smallest, c.end());
  return c;
}

/// The arc that leaves the smallest corner of the triangle on the left of `a`, with the
/// triangle on its left.
[[nodiscard]] inline Arc from_smallest_corner(const Adjacency& t, Arc a) noexcept {
  const std::array<Site, 3> c = t.left(a);
  if (c[0] < c[1] && c[0] < c[2]) return a;
  return c[1] < c[2] ? t.previous(t.reverse(a)) : t.reverse(t.next(a));
}

[[nodiscard]] inline Spot edge_spot(Site a, Site b) noexcept {
  return {Spot::Kind::edge, {std::min(a, b), std::max(a, b), none}};
}

/// Names what holds `p` within the closed triangle with the given corners, exactly.
template <class Triangulation, class Point>
[[nodiscard]] Spot spot_in_triangle(const Triangulation& t,
                                    const std::array<Site, 3>& corners, const Point& p) {
  const auto points = t.points();
  std::array<bool, 3> is_on{};  // is_on[k]: on the line from corner k to the next
  for (std::size_t k = 0; k < 3; ++k) {
    is_on[k] =
        orientation(points[at(corners[k])], points[at(corners[(k + 1) % 3])], p) == 0;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_on[k] && is_on[(k + 1) % 3])
      return {Spot::Kind::node, {corners[(k + 1) % 3], none, none}};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_on[k]) return edge_spot(corners[k], corners[(k + 1) % 3]);
  }
  return {Spot::Kind::triangle, smallest_first(corners)};
}

/// What holds `p`. `cursor` is where the walk starts and is left where it ended: hand it
/// on to the next query nearby. The answer does not depend on it.
template <class Triangulation, class Point>
[[nodiscard]] Spot find_spot(const Triangulation& t, const Point& p, Arc& cursor) {
  if (t.dimension() == 2) {
    cursor = t.find(p, cursor);
    const Adjacency& adjacency = t.adjacency();
    return adjacency.has_left(cursor) ? spot_in_triangle(t, adjacency.left(cursor), p)
                                      : Spot{};
  }
  const delaunay::Location place = t.locate(p);
  const auto site = [&](std::size_t k) { return t.sites()[at(place.nodes[k])]; };
  if (place.kind == delaunay::Location::Kind::node)
    return {Spot::Kind::node, {site(0), none, none}};
  if (place.kind == delaunay::Location::Kind::edge) return edge_spot(site(0), site(1));
  return {};
}

/// Of the triangles that meet in a node or an edge the one with the smallest sites; a
/// triangle spot itself. {} if none.
[[nodiscard]] inline Spot smallest_triangle(const Adjacency& t, const Spot& spot) {
  if (spot.kind == Spot::Kind::triangle || spot.kind == Spot::Kind::outside) return spot;
  Spot best;
  Arc a{spot.sites[0], none};
  for (std::int32_t i = 0; i < t.degree(spot.sites[0]); ++i) {
    a = i == 0 ? t.first_arc(spot.sites[0]) : t.next(a);
    if (!t.has_left(a)) continue;
    const std::array<Site, 3> corners = t.left(a);
    if (spot.kind == Spot::Kind::edge && corners[1] != spot.sites[1] &&
        corners[2] != spot.sites[1])
      continue;
    const std::array<Site, 3> named = smallest_first(corners);
    if (best.kind == Spot::Kind::outside || named < best.sites)
      best = {Spot::Kind::triangle, named};
  }
  return best;
}

/// Of sites that tie with `found` for the smallest `distance(site)` up to rounding the
/// nearest, and of those at the same distance the one with the smallest number: what a
/// descent found, made independent of where it began.
///
/// The sites within some radius of a point are connected in a Delaunay triangulation, so
/// the tied ones are reached from `found` without leaving the tie.
template <class Distance>
[[nodiscard]] Site settle_tie(const Adjacency& t, Site found, Distance distance) {
  const double limit = distance(found) * (1 + 0x1p-48);
  const auto is_tied = [&](Site s) { return distance(s) <= limit; };
  const auto around = t.neighbors(found);
  if (std::none_of(around.begin(), around.end(), is_tied)) return found;
  std::set<Site> tied{found};
  std::vector<Site> open{found};
  while (!open.empty()) {
    const Site s = open.back();
    open.pop_back();
    for (const Site w : t.neighbors(s)) {
      if (is_tied(w) && tied.insert(w).second) open.push_back(w);
    }
  }
  return *std::min_element(tied.begin(), tied.end(),
                           [&](Site a, Site b) { return distance(a) < distance(b); });
}

/// May sites tie that are not connected? On the far side of a hemispherical set: 90
/// degrees and more from the nearest site (and its rounding).
[[nodiscard]] inline bool is_beyond_neighbors(const Adjacency&, Site, tripack::Point2,
                                              double) noexcept {
  return false;
}
[[nodiscard]] inline bool is_beyond_neighbors(const Adjacency& t, Site found,
                                              const stripack::Direction&,
                                              double squared_chord) noexcept {
  return t.is_boundary(found) && squared_chord > 2 - 0x1p-40;
}

/// The nearest site to `p`, walking from `start`; of several the one with the smallest
/// number. There must be a site.
template <class Triangulation, class Point>
[[nodiscard]] Site nearest_site(const Triangulation& t, const Point& p, Site start) {
  const auto distance = [&](Site s) { return squared_distance(t.points()[at(s)], p); };
  const Site found = t.nearest_site(p, start);
  if (!is_beyond_neighbors(t.adjacency(), found, p, distance(found))) {
    return settle_tie(t.adjacency(), found, distance);
  }
  Site nearest = 0;
  for (Site s = 1; s < t.num_sites(); ++s) {
    if (distance(s) < distance(nearest)) nearest = s;
  }
  return nearest;
}

}  // namespace delone::interp
