#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/buffer.hpp"
#include "delaunay/closed_mesh.hpp"
#include "delaunay/editable_cavity.hpp"
#include "delaunay/editable_star.hpp"
#include "delaunay/place_index.hpp"

namespace delone::delaunay {

/// What the plane and the sphere tell the editor about themselves. Points are those of
/// all nodes, by node; node 0 stands for infinity where there is such a node.
///
/// `sees(points, corners, q)`: exact, ties broken canonically: does the point see the
/// face? True for a face whose triangle holds q, edges included; anything if q is a
/// corner. `is_front(points, corners)`: is the face part of the triangulation (not of the
/// outside)? `side(a, b, q)`: exact: +1 if q is left of a -> b, -1 right, 0 on it.
/// `is_same(p, q)`: one position? `is_flat(points, nodes)`: are the nodes too few or too
/// much in line for a triangle? `Chart(points, p)`: a chart of the surface that covers
/// the points and p; `covers(p)`, `place(p)`. `Star(points, v, rim)`: `sees(corners, i)`
/// for EditableStar.
template <class G>
concept EditableGeometry = requires(const typename G::Point& p,
                                    std::span<const typename G::Point> points,
                                    const std::array<Site, 3>& corners,
                                    std::span<const Site> nodes,
                                    const typename G::Chart& chart,
                                    const typename G::Star& star) {
  { G::has_infinity } -> std::convertible_to<bool>;
  { G::sees(points, corners, p) } -> std::same_as<bool>;
  { G::is_front(points, corners) } -> std::same_as<bool>;
  { G::side(p, p, p) } -> std::same_as<int>;
  { G::is_same(p, p) } -> std::same_as<bool>;
  { G::is_flat(points, nodes) } -> std::same_as<bool>;
  {typename G::Chart(points, p)};
  { chart.covers(p) } -> std::same_as<bool>;
  { chart.place(p) } -> std::same_as<Place>;
  {typename G::Star(points, Site{}, nodes)};
  { star.sees(corners, Site{}) } -> std::same_as<bool>;
};

/// The Delaunay triangulation of a changing set of nodes, as a closed surface.
///
/// In the plane closed by the node at infinity, on the sphere the polyhedron itself, the
/// outside of a hemispherical set included, so that a node on the boundary is inserted
/// and removed like any other. Flat sets (too few points, or all in line) have no
/// surface: `is_flat()`; the caller keeps them.
template <EditableGeometry G>
class EditableSurface {
 public:
  using Point = typename G::Point;

  /// Where a point lies.
  struct Found {
    std::int32_t face = none;  ///< a face that the point sees, or with `node`
    Site node = none;          ///< the node with this position, or none
    bool was_long = false;     ///< the search was
  };

  [[nodiscard]] bool is_flat() const noexcept { return mesh_.num_faces() == 0; }
  [[nodiscard]] const ClosedMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] std::span<const Point> points() const noexcept { return points_; }
  [[nodiscard]] const Point& point(Site v) const noexcept { return points_[at(v)]; }
  void set_point(Site v, const Point& p);

  /// The surface over `t`, whose site s is the node number[s] here; points are set. O(n).
  void build(const Adjacency& t, std::vector<Site> number);

  /// Not for flat sets. `hint`: a node near p, or none.
  [[nodiscard]] Found locate(const Point& p, Site hint);
  /// `found` as locate gave it for the node's point, which is no other node's. Expected
  /// O(degree).
  void insert(Site v, const Found& found);
  /// Removes the node and returns nothing; if the rest is flat, removes all and returns
  /// the rest. Expected O(degree).
  [[nodiscard]] std::vector<Site> remove(Site v);
  /// A node next to the one removed last.
  [[nodiscard]] Site last() const noexcept { return last_; }

  [[nodiscard]] bool is_front(std::int32_t f) const {
    return G::is_front(points_, mesh_.face(f).node);
  }

 private:
  // Longer walks than this from the node that the index named are worth a finer index.
  static constexpr int patience = 6;

  static std::size_t at(std::int32_t i) noexcept { return static_cast<std::size_t>(i); }
  [[nodiscard]] bool sees(std::int32_t f, const Point& p) const {
    return G::sees(points_, mesh_.face(f).node, p);
  }
  void make_index(const Point& p);
  void fill_star(Site v);
  [[nodiscard]] Site node_near(Place place);
  [[nodiscard]] std::int32_t front_face_at(Site v) const;
  [[nodiscard]] Found walk(const Point& p, std::int32_t f) const;
  [[nodiscard]] std::size_t edge_before(const Point& p, std::int32_t f,
                                        std::size_t entered) const;
  [[nodiscard]] Site corner_at(const Point& p, std::int32_t f) const;

  ClosedMesh mesh_{1};
  Buffer<Point> points_{Point{}};
  Site num_nodes_ = 0;  // with a star, infinity not counted
  Site last_ = none;    // a node with a star
  typename G::Chart chart_{std::span<const Point>{}, Point{}};
  PlaceIndex index_;
  EditableCavity cavity_;
  EditableStar star_;
};

template <EditableGeometry G>
void EditableSurface<G>::set_point(Site v, const Point& p) {
  if (at(v) >= points_.size()) points_.resize(at(v) + 1);
  points_[at(v)] = p;
  while (mesh_.num_nodes() <= v) mesh_.add_node();
}

template <EditableGeometry G>
void EditableSurface<G>::build(const Adjacency& t, std::vector<Site> number) {
  num_nodes_ = t.num_sites();
  last_ = number.front();
  number.push_back(0);
  mesh_ = ClosedMesh::from(t).renumbered(number, static_cast<Site>(points_.size()));
  // The outside of a hemispherical set is what closes the hole around the ghost.
  if (!G::has_infinity && mesh_.edge_at(0) != none) {
    star_.gather(mesh_, 0);
    fill_star(0);
  }
  make_index(point(last_));
}

// Every fourth node settles the parts of the index; searches do the rest.
template <EditableGeometry G>
void EditableSurface<G>::make_index(const Point& p) {
  constexpr Site stride = 4;
  chart_ = typename G::Chart(std::span(points_).subspan(1), p);
  index_.clear();
  for (Site v = 1; v < mesh_.num_nodes(); v += stride) {
    if (mesh_.edge_at(v) != none) index_.improve(chart_.place(point(v)), v);
  }
}

// A name in the index may be out of date: of a node removed, or put elsewhere since.
template <EditableGeometry G>
Site EditableSurface<G>::node_near(Place place) {
  const auto is_within = [](std::uint32_t a, std::uint32_t b, std::uint64_t reach) {
    return (a < b ? b - a : a - b) < reach;
  };
  const Site v = index_.near(place, [&](Site w, std::uint64_t reach) {
    if (mesh_.edge_at(w) == none) return false;
    const Place there = chart_.place(point(w));
    return is_within(there.u, place.u, reach) && is_within(there.v, place.v, reach);
  });
  return v == none ? last_ : v;
}

// Every node is a corner of a face that is not outside.
template <EditableGeometry G>
std::int32_t EditableSurface<G>::front_face_at(Site v) const {
  HalfEdge e = mesh_.edge_at(v);
  while (!is_front(ClosedMesh::face_of(e))) e = mesh_.next_around(e);
  return ClosedMesh::face_of(e);
}

template <EditableGeometry G>
auto EditableSurface<G>::locate(const Point& p, Site hint) -> Found {
  if (!chart_.covers(p)) make_index(p);
  if (hint != none && mesh_.edge_at(hint) != none) return walk(p, front_face_at(hint));
  return walk(p, front_face_at(node_near(chart_.place(p))));
}

// From a front face across any edge that has p strictly on its outer side, until a face
// sees p or has it at a corner. The walk brings p nearer to the circle of each next face,
// so there is no cycle (H. Edelsbrunner, Combinatorica 10 (1990) 251-260); beyond the
// boundary is a face that p sees.
template <EditableGeometry G>
auto EditableSurface<G>::walk(const Point& p, std::int32_t f) const -> Found {
  std::size_t entered = 3;
  for (int step = 0;; ++step) {
    std::size_t out = 3;
    if (!sees(f, p)) out = edge_before(p, f, entered);
    if (out == 3) return {f, corner_at(p, f), step > patience};
    const HalfEdge e = mesh_.face(f).link[out];
    entered = ClosedMesh::corner_of(e);
    f = ClosedMesh::face_of(e);
  }
}

/// An edge, but for the one entered by, that has p strictly on its outer side; 3 if none.
template <EditableGeometry G>
std::size_t EditableSurface<G>::edge_before(const Point& p, std::int32_t f,
                                            std::size_t entered) const {
  const std::array<Site, 3>& corner = mesh_.face(f).node;
  std::size_t k = 0;
  while (k < 3 &&
         (k == entered || G::side(point(corner[k]), point(corner[(k + 1) % 3]), p) >= 0))
    ++k;
  return k;
}

template <EditableGeometry G>
Site EditableSurface<G>::corner_at(const Point& p, std::int32_t f) const {
  for (const Site v : mesh_.face(f).node) {
    if (!(G::has_infinity && v == 0) && G::is_same(point(v), p)) return v;
  }
  return none;
}

template <EditableGeometry G>
void EditableSurface<G>::insert(Site v, const Found& found) {
  const Point& p = point(v);
  cavity_.dig(mesh_, found.face, [&](std::int32_t f) { return sees(f, p); });
  cavity_.fill(mesh_, v);
  ++num_nodes_;
  last_ = v;
  if (found.was_long) index_.improve(chart_.place(p), v);
}

template <EditableGeometry G>
std::vector<Site> EditableSurface<G>::remove(Site v) {
  star_.gather(mesh_, v);
  std::span<const Site> rim = star_.rim();
  const auto infinity =
      G::has_infinity ? std::find(rim.begin(), rim.end(), 0) : rim.end();
  const auto degree = static_cast<Site>(rim.size()) - (infinity == rim.end() ? 0 : 1);
  --num_nodes_;
  last_ = rim[0] == 0 ? rim[1] : rim[0];
  // The rest can only be flat if v holds it all together.
  if (degree == num_nodes_) {
    std::vector<Site> rest(rim.begin(), rim.end());
    std::erase(rest, 0);
    if (G::is_flat(points_, rest)) {
      mesh_.clear(mesh_.num_nodes());
      num_nodes_ = 0;
      return rest;
    }
  }
  index_.replace(chart_.place(point(v)), v, last_);
  fill_star(v);
  return {};
}

template <EditableGeometry G>
void EditableSurface<G>::fill_star(Site v) {
  const typename G::Star star(points_, v, star_.rim());
  star_.fill(mesh_, [&](const std::array<Site, 3>& corner, Site i) {
    return star.sees(corner, i);
  });
}

}  // namespace delone::delaunay
