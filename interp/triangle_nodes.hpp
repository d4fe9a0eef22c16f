#pragma once

#include <array>
#include <span>

#include "interp/spot.hpp"

namespace delone::interp {

// Which grid nodes a triangle writes. Every node of the closed triangulated region is
// written exactly once: by the triangle that holds it in its interior; for a node inside
// an edge by the triangle on the left of the edge's arc from the smaller to the larger
// site (at the boundary, the only triangle); for a node at a site by the site. So threads
// write to different places, and no node is missed.

/// How a closed triangle holds a point. `edge` k leads from corner k to the next.
struct Holding {
  enum class Kind : std::uint8_t { outside, corner, edge, interior };
  Kind kind = Kind::outside;
  std::size_t edge = 0;
};

/// Exact.
template <class Point>
[[nodiscard]] Holding holding(std::span<const Point> points,
                              const std::array<Site, 3>& corners, const Point& p) {
  Holding result{Holding::Kind::interior};
  for (std::size_t k = 0; k < 3; ++k) {
    const int side =
        orientation(points[at(corners[k])], points[at(corners[(k + 1) % 3])], p);
    if (side < 0) return {};
    if (side > 0) continue;
    result = {result.kind == Holding::Kind::interior ? Holding::Kind::edge
                                                     : Holding::Kind::corner,
              k};
  }
  return result;
}

/// Does the triangle on the left of `arc` write the nodes inside its k-th edge?
[[nodiscard]] inline bool owns_edge(const Adjacency& t, Arc arc, std::size_t k) noexcept {
  const std::array<Site, 3> corners = t.left(arc);
  if (corners[k] < corners[(k + 1) % 3]) return true;
  const Arc back = k == 0   ? t.reverse(arc)
                   : k == 1 ? t.reverse(t.previous(t.reverse(arc)))
                            : t.next(arc);
  return !t.has_left(back);
}

/// Calls f(arc) for the triangles whose smallest site is in [first, last), with the arc
/// that leaves it.
template <class F>
void for_each_triangle(const Adjacency& t, Site first, Site last, F f) {
  for (Site v = first; v < last; ++v) {
    Arc a = t.first_arc(v);
    for (std::int32_t i = 0; i < t.degree(v); ++i, a = t.next(a)) {
      if (t.target(a) > v && t.has_left(a) && t.target(t.next(a)) > v) f(a);
    }
  }
}

}  // namespace delone::interp
