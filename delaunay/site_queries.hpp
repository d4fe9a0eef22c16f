#pragma once

#include <array>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"

namespace delone::delaunay {

/// The visibility walk: from the triangle at `start` across any edge that has the query
/// strictly on its outer side. Ends in the closed triangle that holds the query, or at a
/// boundary arc with the query strictly on its left, outside. `side(u, v)`: exact sign,
/// +1 if the query is left of u -> v.
///
/// Ends because a Delaunay triangulation has no cyclic order of visibility:
/// H. Edelsbrunner, Combinatorica 10 (1990) 251-260.
template <class Side>
[[nodiscard]] Arc walk(const Adjacency& t, Arc start, Side side) {
  Arc a = start.origin == none ? t.first_arc(0) : start;
  if (!t.has_left(a)) {
    if (side(a.origin, t.target(a)) > 0) return a;
    a = t.reverse(a);
  } else if (side(a.origin, t.target(a)) < 0) {
    a = t.reverse(a);
    if (!t.has_left(a)) return a;
  }
  for (;;) {  // the query is on the left of a, or on it
    const Arc b = t.next(a);
    const Site v = a.origin, w = t.target(a), x = t.target(b);
    if (side(v, x) > 0) {
      a = b;
    } else if (side(x, w) > 0) {
      a = t.reverse(t.previous(t.reverse(a)));
    } else {
      return a;
    }
    if (!t.has_left(a)) return a;
  }
}

/// Moves to a neighbour that is nearer to the query until there is none. On a Delaunay
/// triangulation that neighbour exists until the nearest site is reached.
template <class Distance>
[[nodiscard]] Site descend(const Adjacency& t, Site start, Distance distance) {
  Site best = start;
  double shortest = distance(best);
  for (bool moved = true; moved;) {
    moved = false;
    for (const Site w : t.neighbors(best)) {
      const double d = distance(w);
      if (d < shortest) {
        shortest = d;
        best = w;
        moved = true;
      }
    }
  }
  return best;
}

/// Names what holds the query, given an arc that `walk` returned.
template <class Side>
[[nodiscard]] Location describe(const Adjacency& t, std::span<const Node> rows, Arc a,
                                Side side) {
  if (!t.has_left(a)) return {};
  const std::array<Site, 3> corner = t.left(a);
  const auto row = [&](int k) {
    return rows[static_cast<std::size_t>(corner[static_cast<std::size_t>(k % 3)])];
  };
  std::array<bool, 3> is_on{};  // is_on[k]: on the edge from corner k to the next
  for (std::size_t k = 0; k < 3; ++k)
    is_on[k] = side(corner[k], corner[(k + 1) % 3]) == 0;
  for (int k = 0; k < 3; ++k) {
    const bool on_next = is_on[static_cast<std::size_t>((k + 1) % 3)];
    if (is_on[static_cast<std::size_t>(k)] && on_next)
      return {Location::Kind::node, {row(k + 1), none, none}};
  }
  for (int k = 0; k < 3; ++k) {
    if (is_on[static_cast<std::size_t>(k)])
      return {Location::Kind::edge, {row(k), row(k + 1), none}};
  }
  return {Location::Kind::triangle, {row(0), row(1), row(2)}};
}

/// All triangles in rows: counter-clockwise, smallest row first, sorted. O(n) for bounded
/// degrees.
[[nodiscard]] std::vector<std::array<Node, 3>> list_triangles(
    const Adjacency& t, std::span<const Node> rows, std::span<const Site> sites);

/// Rows along the boundary, counter-clockwise, beginning at the smallest; a chain from
/// its first site on; empty if there is no boundary.
[[nodiscard]] std::vector<Node> list_boundary(const Adjacency& t,
                                              std::span<const Node> rows);

}  // namespace delone::delaunay
