#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "delaunay/adjacency.hpp"

/// Checking triangulations: what tripack::find_defect and stripack::find_defect share.
///
/// The check is local and yet complete. Call the fan of a site the triangles around it.
/// If
///   1. every triangle is counter-clockwise,
///   2. the fan of every interior site goes round exactly once, and that of every
///   boundary site
///      covers an angle of at most pi,
///   3. Euler's formula holds: 2n - 2 - b triangles (2n - 4 without a boundary),
/// then the triangles are glued to an immersed surface of constant curvature (0 or 1)
/// with locally convex boundary. By Gauss-Bonnet each component of it is a disk or a
/// sphere, so that 3. leaves one. Any two of its points are joined by a geodesic shorter
/// than a full circle, which the immersion maps to a straight line or great-circle arc:
/// no two points fall together. The triangles therefore tile a convex region, whatever
/// the list was, and
///   4. no edge has the opposite corner of its one triangle inside the circle of the
///   other
/// makes the tiling Delaunay: the lifted surface is locally convex over a convex region.
namespace delone::delaunay {

/// What the checks need to know about positions. For sites v, w, x, y:
///   orientation(v, w, x)    +1 counter-clockwise, -1 clockwise, 0 on one line; exact
///   is_ahead(v, w, x)       v, w, x on one line: are w and x on the same side of v?
///   is_violated(v, w, x, y) y must not be inside the circle of the triangle v, w, x: is
///   it? row(v)                  the caller's number for v, for the sentence
template <class G>
concept CheckedGeometry = requires(const G& g, Site v) {
  { g.orientation(v, v, v) } -> std::same_as<int>;
  { g.is_ahead(v, v, v) } -> std::same_as<bool>;
  { g.is_violated(v, v, v, v) } -> std::same_as<bool>;
  { g.row(v) } -> std::same_as<Node>;
};

/// Which of several cocircular triangulations are right: only the canonical one, or all.
enum class Ties : std::uint8_t { canonical, any };

/// Nothing, or one sentence that says what is violated and where.
using Defect = std::optional<std::string>;

using Triple = std::array<std::int32_t, 3>;

/// "triangle (3, 7, 9)" and "edge (3, 7)", in the caller's rows.
[[nodiscard]] std::string name_of_triangle(const Triple& rows);
[[nodiscard]] std::string name_of_edge(Node a, Node b);

/// Are the lists rings: every arc with its reverse, every triangle the same seen from its
/// three corners, boundary lists from boundary neighbour to boundary neighbour, interior
/// ones from the smallest neighbour on, every site in a triangle? `rows` names the sites.
/// O(n).
[[nodiscard]] Defect find_ring_defect(const Adjacency& adjacency,
                                      std::span<const Node> rows);

/// Do the numbers of triangles and edges agree with Euler's formula? O(n).
[[nodiscard]] Defect find_euler_defect(const Adjacency& adjacency);

/// Are `rows` (first row of every site) and `sites` (site of every row) maps of one
/// another?
[[nodiscard]] Defect find_map_defect(std::span<const Node> rows,
                                     std::span<const Site> sites);

/// Do sites in this order, and no others, form a chain of neighbours (a ring if
/// `is_closed`)?
enum class Chain : std::uint8_t { open, closed };
[[nodiscard]] Defect find_chain_defect(const Adjacency& adjacency,
                                       std::span<const Site> order, Chain kind,
                                       std::span<const Node> rows);

/// The different positions of an array: rows of equal position share a site.
struct Positions {
  std::vector<Site> sites;  ///< for every row its site
  std::vector<Node> rows;   ///< for every site its first row
};
template <class P, std::strict_weak_order<P, P> Less>
[[nodiscard]] Positions merge_positions(std::span<const P> points, Less less) {
  std::vector<Node> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](Node row) -> const P& {
    return points[static_cast<std::size_t>(row)];
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](Node a, Node b) { return less(at(a), at(b)); });
  Positions result{std::vector<Site>(points.size()), {}};
  for (const Node row : order) {
    if (result.rows.empty() || less(at(result.rows.back()), at(row)))
      result.rows.push_back(row);
    result.sites[static_cast<std::size_t>(row)] =
        static_cast<Site>(result.rows.size() - 1);
  }
  return result;
}

/// A list of triangles in sites instead of rows, or why there is none: a row that does
/// not exist, a position twice in one triangle.
struct SiteTriangles {
  std::vector<Triple> triangles;
  Defect defect;
};
[[nodiscard]] SiteTriangles site_triangles(std::span<const Triple> triangles,
                                           const Positions& positions);

/// Counter-clockwise triangles glued to adjacency lists, or why they cannot be: an edge
/// with two triangles on one side, a site whose triangles form several fans or none. O(n
/// log n).
struct GluedTriangles {
  Adjacency adjacency;
  Defect defect;
};
[[nodiscard]] GluedTriangles glue(std::span<const Triple> triangles,
                                  std::span<const Node> rows);

namespace internal {

template <CheckedGeometry G>
Triple rows_of(const G& g, const std::array<Site, 3>& t) {
  return {g.row(t[0]), g.row(t[1]), g.row(t[2])};
}

// Seen from v, is x at an angle in [0, pi) counter-clockwise from w?
template <CheckedGeometry G>
bool is_in_upper_half(const G& g, Site v, Site w, Site x) {
  const int side = g.orientation(v, w, x);
  return side > 0 || (side == 0 && g.is_ahead(v, w, x));
}

// How often the neighbours of an interior site go round it. Each step is less than pi, so
// that none can jump over a half: turns are the entries into the upper one.
template <CheckedGeometry G>
int num_turns(const Adjacency& adjacency, const G& g, Site v) {
  const auto ring = adjacency.neighbors(v);
  int turns = 0;
  bool was_upper = is_in_upper_half(g, v, ring.front(), ring.back());
  for (const Site w : ring) {
    const bool is_upper = is_in_upper_half(g, v, ring.front(), w);
    turns += is_upper && !was_upper ? 1 : 0;
    was_upper = is_upper;
  }
  return turns;
}

// Do the triangles of a boundary site cover an angle of at most pi?
template <CheckedGeometry G>
bool is_convex_fan(const Adjacency& adjacency, const G& g, Site v) {
  const auto ring = adjacency.neighbors(v);
  const auto is_left = [&](Site w) { return g.orientation(v, ring.front(), w) > 0; };
  if (!std::all_of(ring.begin() + 1, ring.end() - 1, is_left)) return false;
  const int last = g.orientation(v, ring.front(), ring.back());
  return last > 0 || (last == 0 && !g.is_ahead(v, ring.front(), ring.back()));
}

}  // namespace internal

/// Is every triangle counter-clockwise? O(n).
template <CheckedGeometry G>
[[nodiscard]] Defect find_orientation_defect(const Adjacency& adjacency, const G& g) {
  Defect defect;
  adjacency.for_each_triangle([&](Arc a) {
    const auto t = adjacency.left(a);
    if (defect || g.orientation(t[0], t[1], t[2]) > 0) return;
    defect = name_of_triangle(internal::rows_of(g, t)) + " is not counter-clockwise";
  });
  return defect;
}

/// Does every fan go round once (boundary: through at most pi)? The triangles must be
/// counter-clockwise. O(n).
template <CheckedGeometry G>
[[nodiscard]] Defect find_fan_defect(const Adjacency& adjacency, const G& g) {
  for (Site v = 0; v < adjacency.num_sites(); ++v) {
    if (adjacency.is_boundary(v) && !internal::is_convex_fan(adjacency, g, v)) {
      return "the boundary is not convex at row " + std::to_string(g.row(v));
    }
    if (!adjacency.is_boundary(v) && internal::num_turns(adjacency, g, v) != 1) {
      return "the triangles around row " + std::to_string(g.row(v)) + " overlap";
    }
  }
  return std::nullopt;
}

/// Is every edge locally Delaunay? Each is looked at from one side: the predicate is
/// antisymmetric. O(n).
template <CheckedGeometry G>
[[nodiscard]] Defect find_circle_defect(const Adjacency& adjacency, const G& g) {
  for (Site v = 0; v < adjacency.num_sites(); ++v) {
    Arc a = adjacency.first_arc(v);
    for (std::int32_t i = 0; i < adjacency.degree(v); ++i, a = adjacency.next(a)) {
      const Site w = adjacency.target(a);
      if (w < v || !adjacency.has_left(a)) continue;
      const Arc back = adjacency.reverse(a);
      if (!adjacency.has_left(back)) continue;
      const Site x = adjacency.target(adjacency.next(a));
      const Site y = adjacency.target(adjacency.next(back));
      if (!g.is_violated(v, w, x, y)) continue;
      return name_of_edge(g.row(v), g.row(w)) + " is not Delaunay: row " +
             std::to_string(g.row(y)) + " is inside the circle of " +
             name_of_triangle({g.row(v), g.row(w), g.row(x)});
    }
  }
  return std::nullopt;
}

/// All that depends on positions, for lists that are rings (find_ring_defect). O(n).
template <CheckedGeometry G>
[[nodiscard]] Defect find_geometry_defect(const Adjacency& adjacency, const G& g) {
  if (auto defect = find_orientation_defect(adjacency, g)) return defect;
  if (auto defect = find_fan_defect(adjacency, g)) return defect;
  if (auto defect = find_euler_defect(adjacency)) return defect;
  return find_circle_defect(adjacency, g);
}

/// A list of triangles in sites, all in one orientation, either one. O(n log n).
template <CheckedGeometry G>
[[nodiscard]] Defect find_list_defect(std::vector<Triple> triangles,
                                      std::span<const Node> rows, const G& g) {
  const Triple& first = triangles.front();
  if (g.orientation(first[0], first[1], first[2]) < 0) {
    for (Triple& t : triangles) std::swap(t[1], t[2]);
  }
  for (const Triple& t : triangles) {
    const int turn = g.orientation(t[0], t[1], t[2]);
    if (turn > 0) continue;
    return name_of_triangle(internal::rows_of(g, t)) +
           (turn == 0 ? " has no area" : " turns the other way than the first triangle");
  }
  const GluedTriangles glued = glue(triangles, rows);
  if (glued.defect) return glued.defect;
  return find_geometry_defect(glued.adjacency, g);
}

}  // namespace delone::delaunay
