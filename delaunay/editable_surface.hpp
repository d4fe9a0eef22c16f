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
#include "delaunay/editable_walls.hpp"
#include "delaunay/mesh_walk.hpp"
#include "delaunay/place_index.hpp"
#include "delaunay/segment_mesh.hpp"

namespace delone::delaunay {

/// What the plane and the sphere tell the editor about themselves. Points are those of
/// all nodes, by node; node 0 stands for what is beyond the boundary where there is such
/// a node.
///
/// `sees(points, corners, q)`: exact, ties broken canonically: does the point see the
/// face? True for a face whose triangle holds q, edges included; anything if q is a
/// corner. `is_front(points, corners)`: is the face part of the triangulation (not of the
/// outside)? `side(a, b, q)`: exact: +1 if q is left of a -> b, -1 right, 0 on it.
/// `is_same(p, q)`: one position? `is_flat(points, nodes)`: are the nodes too few or too
/// much in line for a triangle? `Chart(points, p)`: a chart of the surface that covers
/// the points and p; `covers(p)`, `place(p)`. `Star(points, v, rim)`: `sees(corners, i)`
/// for EditableStar. `Segments(points)`: what forced arcs want to know.
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
  requires SegmentGeometry<typename G::Segments>;
};

/// The Delaunay triangulation of a changing set of nodes, as a closed surface.
///
/// In the plane closed by the node at infinity, on the sphere the polyhedron itself, the
/// outside of a hemispherical set included, so that a node on the boundary is inserted
/// and removed like any other. Flat sets (too few points, or all in line) have no
/// surface: `is_flat()`; the caller keeps them.
///
/// Once an arc has been forced, the surface is the constrained Delaunay triangulation.
/// This is no polyhedron: beside a wall on the boundary of a hemispherical set what is in
/// front and what is behind would not fit together. So from then on it is closed by node
/// 0 on the sphere, too. A new node's faces are those that it sees and that are not
/// behind walls. Where a node goes that is on no wall, its faces are still a convex
/// corner (every edge at it is locally Delaunay), to be filled like that of a polyhedron.
template <EditableGeometry G>
class EditableSurface {
 public:
  using Point = typename G::Point;

  /// Where a point lies.
  struct Found {
    std::int32_t face = none;  ///< a face that the point sees, or with `node`
    Site node = none;          ///< the node with this position, or none
    bool was_long = false;     ///< the search was
    HalfEdge wall = none;      ///< the forced edge that it is on, or none
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
    const std::array<Site, 3>& corner = mesh_.face(f).node;
    return corner[0] != 0 && corner[1] != 0 && corner[2] != 0 &&
           G::is_front(points_, corner);
  }

  // Forced arcs. Not for flat sets, but for `open`.

  /// Prepares for forced arcs. O(n) on the sphere when called first.
  void open();
  /// Forces the arc from a to b, over the nodes on it. Where it crosses a forced edge
  /// calls `on_crossing(u, v)` with that one's ends, which must throw; then nothing has
  /// changed.
  template <class OnCrossing>
  void force(Site a, Site b, OnCrossing on_crossing);
  /// Undoes force(a, b).
  void release(Site a, Site b);
  [[nodiscard]] typename G::Segments segments() const {
    return typename G::Segments(points_);
  }
  /// How many forced edges end at the node?
  [[nodiscard]] int num_walls_at(Site v) const;
  /// Gives a node another form of the same position.
  void restate(Site v, const Point& p);

 private:
  // Longer walks than this from the node that the index named are worth a finer index.
  static constexpr int patience = 6;

  static std::size_t at(std::int32_t i) noexcept { return static_cast<std::size_t>(i); }
  [[nodiscard]] bool sees(std::int32_t f, const Point& p) const {
    return G::sees(points_, mesh_.face(f).node, p);
  }
  using Segments = typename G::Segments;
  using Walls = SegmentMesh<Segments>;

  void make_index(const Point& p);
  void fill_star(Site v);
  void fill_hole(Site v);
  void open_outside();
  void dig_in(Site v, const Found& found);
  [[nodiscard]] bool sees_all_outside(const Point& p, std::int32_t f) const;
  void fill_outside(Site v);
  void open_outside_at(std::int32_t f);
  void undo(Walls& walls, Site a, Site b) const;
  [[nodiscard]] std::vector<Site> path(Site a, Site b) const;
  [[nodiscard]] Site next_on_path(Site v, Site end) const;
  [[nodiscard]] std::vector<Site> wall_ends(Site v) const;
  [[nodiscard]] Found find_among_walls(const Point& p, Site start) const;
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
  EditableGap gap_;
  bool is_open_ = G::has_infinity;  // node 0 closes the boundary
  int num_forced_ = 0;              // arcs on the surface
  SharedWalls shared_;
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
  num_forced_ = 0;
  shared_.clear();
  // The outside of a hemispherical set is what closes the hole around the ghost.
  if (!is_open_ && mesh_.edge_at(0) != none) {
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
  const bool has_hint = hint != none && mesh_.edge_at(hint) != none;
  const Site start = has_hint ? hint : node_near(chart_.place(p));
  return num_forced_ > 0 ? find_among_walls(p, start) : walk(p, front_face_at(start));
}

// A face that sees p may be behind a wall: here the face that holds p is needed.
template <EditableGeometry G>
auto EditableSurface<G>::find_among_walls(const Point& p, Site start) const -> Found {
  int num_questions = 0;
  const MeshPlace place =
      delaunay::walk(mesh_, 0, real_edge_at(mesh_, start, 0), [&](Site u, Site v) {
        ++num_questions;
        return G::side(point(u), point(v), p);
      });
  const bool is_on_wall =
      place.kind == MeshPlace::Kind::edge && mesh_.is_constraint(place.at);
  return {ClosedMesh::face_of(place.at), place.site, num_questions > 3 * patience,
          is_on_wall ? place.at : none};
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
    if (v != 0 && G::is_same(point(v), p)) return v;
  }
  return none;
}

template <EditableGeometry G>
void EditableSurface<G>::insert(Site v, const Found& found) {
  const Point& p = point(v);
  if (!G::has_infinity && is_open_ && sees_all_outside(p, found.face)) {
    fill_outside(v);
  } else {
    dig_in(v, found);
  }
  ++num_nodes_;
  last_ = v;
  if (found.was_long) index_.improve(chart_.place(p), v);
}

template <EditableGeometry G>
void EditableSurface<G>::dig_in(Site v, const Found& found) {
  const Point& p = point(v);
  std::array<Site, 2> wall{none, none};
  if (found.wall != none) {
    wall = {mesh_.origin(found.wall), mesh_.target(found.wall)};
    mesh_.set_constraint(found.wall, Constraint::off);
    shared_.divide(wall, v);
  }
  cavity_.dig(mesh_, found.face, [&](HalfEdge e) {
    return !mesh_.is_constraint(e) && sees(ClosedMesh::face_of(e), p);
  });
  cavity_.fill(mesh_, v);
  for (const Site end : wall) {
    if (end != none) mesh_.set_constraint(mesh_.find(v, end), Constraint::on);
  }
}

// The faces at node 0 that a point sees are consecutive.
template <EditableGeometry G>
bool EditableSurface<G>::sees_all_outside(const Point& p, std::int32_t f) const {
  std::size_t k = 0;
  while (k < 3 && mesh_.face(f).node[k] != 0) ++k;
  if (k == 3) return false;
  const HalfEdge first = ClosedMesh::half_edge(f, k);
  HalfEdge e = first;
  do {
    if (!sees(ClosedMesh::face_of(e), p)) return false;
    e = mesh_.next_around(e);
  } while (e != first);
  return true;
}

// The node takes the place of node 0: its faces tile the sphere.
template <EditableGeometry G>
void EditableSurface<G>::fill_outside(Site v) {
  star_.gather(mesh_, 0);
  for (const std::int32_t f : star_.faces()) {
    std::array<Site, 3> corner = mesh_.face(f).node;
    std::replace(corner.begin(), corner.end(), Site{0}, v);
    mesh_.replace_face(f, corner);
  }
  for (const HalfEdge e : star_.outside()) {
    if (mesh_.is_constraint(e)) mesh_.set_constraint(e, Constraint::on);
  }
  mesh_.forget(0);
  restate(v, point(v));
}

template <EditableGeometry G>
std::vector<Site> EditableSurface<G>::remove(Site v) {
  star_.gather(mesh_, v);
  std::span<const Site> rim = star_.rim();
  const auto infinity = std::find(rim.begin(), rim.end(), 0);
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
      num_forced_ = 0;
      shared_.clear();
      return rest;
    }
  }
  index_.replace(chart_.place(point(v)), v, last_);
  fill_hole(v);
  return {};
}

template <EditableGeometry G>
void EditableSurface<G>::fill_hole(Site v) {
  if (num_forced_ == 0 && G::has_infinity == is_open_) return fill_star(v);
  const auto rim = star_.rim();
  const auto place = [&](Site w) {
    return static_cast<std::size_t>(std::find(rim.begin(), rim.end(), w) - rim.begin());
  };
  if (const std::vector<Site> ends = wall_ends(v); !ends.empty()) {
    gap_.fill_along(mesh_, star_, place(ends[0]), place(ends[1]), segments());
    return shared_.unite({ends[0], ends[1]}, v);
  }
  if (const std::size_t ghost = place(0); ghost < rim.size())
    return gap_.fill_boundary(mesh_, star_, ghost, segments());
  fill_star(v);
  if (is_open_ && mesh_.edge_at(0) == none) open_outside();
}

template <EditableGeometry G>
void EditableSurface<G>::fill_star(Site v) {
  const typename G::Star star(points_, v, star_.rim());
  star_.fill(mesh_, [&](const std::array<Site, 3>& corner, Site i) {
    return star.sees(corner, i);
  });
}

// Some of the faces that have just filled a star may be the outside.
template <EditableGeometry G>
void EditableSurface<G>::open_outside() {
  for (const std::int32_t f : star_.faces()) {
    if (!mesh_.is_free(f) && !is_front(f)) return open_outside_at(f);
  }
}

template <EditableGeometry G>
void EditableSurface<G>::open_outside_at(std::int32_t f) {
  cavity_.dig(mesh_, f, [&](HalfEdge e) { return !is_front(ClosedMesh::face_of(e)); });
  cavity_.fill(mesh_, 0);
}

template <EditableGeometry G>
void EditableSurface<G>::open() {
  if (std::exchange(is_open_, true)) return;
  for (std::int32_t f = 0; f < mesh_.num_face_slots(); ++f) {
    if (!mesh_.is_free(f) && !is_front(f)) return open_outside_at(f);
  }
}

template <EditableGeometry G>
template <class OnCrossing>
void EditableSurface<G>::force(Site a, Site b, OnCrossing on_crossing) {
  const Segments geometry = segments();
  Walls walls(std::move(mesh_), geometry, 0);
  try {
    walls.insert(a, b, [&](const auto&, HalfEdge crossed) {
      on_crossing(walls.mesh().origin(crossed), walls.mesh().target(crossed));
    });
  } catch (...) {
    undo(walls, a, b);
    mesh_ = walls.take_mesh();
    throw;
  }
  for (const auto& edge : walls.shared_pieces()) shared_.add(edge);
  mesh_ = walls.take_mesh();
  ++num_forced_;
}

// The triangulation is unique: releasing what was forced leads back to it.
template <EditableGeometry G>
void EditableSurface<G>::undo(Walls& walls, Site a, Site b) const {
  const std::vector<Site> sites = walls.paths().path(a, b);
  const auto& shared = walls.shared_pieces();
  for (std::size_t i = 1; i < sites.size(); ++i) {
    const HalfEdge e = walls.mesh().find(sites[i - 1], sites[i]);
    const bool is_shared =
        std::any_of(shared.begin(), shared.end(), [&](const auto& edge) {
          return std::minmax(edge[0], edge[1]) == std::minmax(sites[i - 1], sites[i]);
        });
    if (e != none && !is_shared && walls.mesh().is_constraint(e)) walls.release(e);
  }
}

template <EditableGeometry G>
void EditableSurface<G>::release(Site a, Site b) {
  const std::vector<Site> sites = path(a, b);
  const Segments geometry = segments();
  Walls walls(std::move(mesh_), geometry, 0);
  for (std::size_t i = 1; i < sites.size(); ++i) {
    if (!shared_.take({sites[i - 1], sites[i]}))
      walls.release(walls.mesh().find(sites[i - 1], sites[i]));
  }
  mesh_ = walls.take_mesh();
  --num_forced_;
}

template <EditableGeometry G>
std::vector<Site> EditableSurface<G>::path(Site a, Site b) const {
  std::vector<Site> sites{a};
  while (sites.back() != b) sites.push_back(next_on_path(sites.back(), b));
  return sites;
}

template <EditableGeometry G>
Site EditableSurface<G>::next_on_path(Site v, Site end) const {
  const Segments geometry = segments();
  HalfEdge e = mesh_.edge_at(v);
  for (;; e = mesh_.next_around(e)) {
    const Site w = mesh_.target(e);
    if (w == end) return end;
    if (mesh_.is_constraint(e) && geometry.orientation(v, end, w) == 0 &&
        geometry.is_ahead(v, end, w))
      return w;
  }
}

template <EditableGeometry G>
std::vector<Site> EditableSurface<G>::wall_ends(Site v) const {
  std::vector<Site> ends;
  const HalfEdge first = mesh_.edge_at(v);
  HalfEdge e = first;
  do {
    if (mesh_.is_constraint(e)) ends.push_back(mesh_.target(e));
    e = mesh_.next_around(e);
  } while (e != first);
  return ends;
}

template <EditableGeometry G>
int EditableSurface<G>::num_walls_at(Site v) const {
  return static_cast<int>(wall_ends(v).size());
}

template <EditableGeometry G>
void EditableSurface<G>::restate(Site v, const Point& p) {
  set_point(v, p);
  const Segments geometry = segments();
  Walls walls(std::move(mesh_), geometry, 0);
  walls.restore_around(v);
  mesh_ = walls.take_mesh();
}

}  // namespace delone::delaunay
