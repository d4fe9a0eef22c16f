#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "delaunay/adjacency.hpp"
#include "interp/index.hpp"
#include "interp/small_vector.hpp"

namespace delone::interp {

/// How the sites around a point are joined: the triangles that a new site there would
/// remove, and the polygon around them. Corners are numbered as they were found.
struct CavityShape {
  static constexpr std::size_t usual = 24;
  /// Counter-clockwise. The parent lies across the side from corner 0 to corner 1; the
  /// first triangle has none.
  struct Triangle {
    std::array<std::int32_t, 3> corners;
    std::int32_t parent;
  };
  /// The polygon's side from `corner` to the next one's, and the triangle inside of it.
  struct Side {
    std::int32_t corner, triangle;
  };
  SmallVector<Triangle, usual> triangles;
  SmallVector<Side, usual> ring;  // counter-clockwise

  /// f(corner, next corner, side) for every side of the polygon.
  template <class F>
  void for_each_side(F f) const {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Side& next = ring[k + 1 == ring.size() ? 0 : k + 1];
      f(at(ring[k].corner), at(next.corner), k);
    }
  }
};

/// The same with the sites, and what a query knows of each.
template <class Vertex>
struct Cavity {
  CavityShape shape;
  SmallVector<delaunay::Site, CavityShape::usual> sites;
  SmallVector<Vertex, CavityShape::usual> vertices;

  std::int32_t add(delaunay::Site site, const Vertex& vertex) {
    sites.push_back(site);
    vertices.push_back(vertex);
    return static_cast<std::int32_t>(sites.size()) - 1;
  }
};

/// What a search for a cavity asks: what it keeps of a site, and whether the query is
/// strictly inside the circle through three of them.
template <class G>
concept CavityGeometry = requires(const G& g, delaunay::Site s,
                                  std::span<const delaunay::Site, 3> sites,
                                  const typename G::Vertex& v) {
  { g.vertex(s) } -> std::same_as<typename G::Vertex>;
  { g.is_inside_circle(sites, v, v, v) } -> std::same_as<bool>;
};

/// The cavity of a query in the triangle on the left of `start`: all triangles with the
/// query strictly inside their circles (Bowyer and Watson). They are connected, and their
/// union is star-shaped around the query. Depends on `start` in the numbering only.
///
/// Sources: A. Bowyer, Comput. J. 24 (1981) 162-166; D. F. Watson, ibid. 167-172.
template <CavityGeometry Geometry>
[[nodiscard]] Cavity<typename Geometry::Vertex> find_cavity(const delaunay::Adjacency& t,
                                                            const Geometry& geometry,
                                                            delaunay::Arc start) {
  using delaunay::Arc;
  // A side of what has been found, with the triangle beyond it on the left of `beyond`.
  struct OpenSide {
    Arc beyond;
    std::int32_t from, to, triangle;
  };
  Cavity<typename Geometry::Vertex> cavity;
  for (const delaunay::Site s : t.left(start)) cavity.add(s, geometry.vertex(s));
  cavity.shape.triangles.push_back({{0, 1, 2}, -1});
  const Arc last = t.next(start);
  // Last in, first out: sides come in the order of the polygon.
  SmallVector<OpenSide, 2 * CavityShape::usual> open;
  open.push_back({last, 2, 0, 0});
  open.push_back({t.next(t.reverse(last)), 1, 2, 0});
  for (OpenSide side{t.reverse(start), 0, 1, 0};;) {
    if (t.has_left(side.beyond)) {
      const Arc far = t.next(side.beyond);
      const delaunay::Site apex = t.target(far);
      const auto vertex = geometry.vertex(apex);
      const std::array<delaunay::Site, 3> sites{cavity.sites[at(side.to)],
                                                cavity.sites[at(side.from)], apex};
      if (geometry.is_inside_circle(sites, cavity.vertices[at(side.to)],
                                    cavity.vertices[at(side.from)], vertex)) {
        const std::int32_t corner = cavity.add(apex, vertex);
        const auto number = static_cast<std::int32_t>(cavity.shape.triangles.size());
        cavity.shape.triangles.push_back({{side.to, side.from, corner}, side.triangle});
        open.push_back({far, corner, side.to, number});
        side = {t.next(t.reverse(far)), side.from, corner, number};
        continue;
      }
    }
    cavity.shape.ring.push_back({side.from, side.triangle});
    if (open.empty()) break;
    side = open.back();
    open.pop_back();
  }
  return cavity;
}

}  // namespace delone::interp
