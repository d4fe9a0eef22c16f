#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/editable_star.hpp"
#include "delaunay/segment_cavity.hpp"

namespace delone::delaunay {

/// How many forced arcs share an edge, where it is more than one.
class SharedWalls {
 public:
  using Edge = std::array<Site, 2>;

  void clear() { more_.clear(); }
  void add(const Edge& edge) { ++more_[key(edge)]; }
  /// One arc fewer; false if there is only one.
  bool take(const Edge& edge) {
    const auto found = more_.find(key(edge));
    if (found == more_.end()) return false;
    if (--found->second == 0) more_.erase(found);
    return true;
  }
  /// The edge has become two with the node `at` between.
  void divide(const Edge& edge, Site at) {
    const int more = forget(edge);
    if (more == 0) return;
    more_[key({edge[0], at})] = more;
    more_[key({at, edge[1]})] = more;
  }
  /// The node `at` between two edges has gone.
  void unite(const Edge& edge, Site at) {
    const int more = forget({edge[0], at});
    forget({at, edge[1]});
    if (more != 0) more_[key(edge)] = more;
  }

 private:
  static std::uint64_t key(const Edge& edge) noexcept {
    const auto a = static_cast<std::uint32_t>(edge[0]);
    const auto b = static_cast<std::uint32_t>(edge[1]);
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
  }
  int forget(const Edge& edge) {
    const auto found = more_.find(key(edge));
    if (found == more_.end()) return 0;
    const int more = found->second;
    more_.erase(found);
    return more;
  }

  std::unordered_map<std::uint64_t, int> more_;
};

/// The hole of a removed node where the node's faces are not those of a convex corner:
/// because it was on a wall, or on the boundary.
///
/// What is to be filled then are polygons with an edge that every corner sees: from the
/// wall's or the new boundary's edge the removed node was seen, and it saw all corners.
class EditableGap {
 public:
  /// The node was between the rim nodes number `from` and `to`, on the edge that joins
  /// them from now on, a wall.
  template <SegmentGeometry G>
  void fill_along(ClosedMesh& mesh, const EditableStar& star, std::size_t from,
                  std::size_t to, const G& g);
  /// The node was on the boundary, and rim node number `ghost` is what closes it.
  template <SegmentGeometry G>
  void fill_boundary(ClosedMesh& mesh, const EditableStar& star, std::size_t ghost,
                     const G& g);

 private:
  static std::size_t after(const EditableStar& star, std::size_t i) noexcept {
    return i + 1 == star.rim().size() ? 0 : i + 1;
  }
  /// The rim from one node to another, counter-clockwise, as a side of a cavity.
  static void gather(CavitySide& side, const ClosedMesh& mesh, const EditableStar& star,
                     std::size_t from, std::size_t to);
  static void clear(ClosedMesh& mesh, const EditableStar& star);
  /// The rim nodes that are on the boundary once the node is gone, clockwise along it.
  template <SegmentGeometry G>
  void scan_boundary(const EditableStar& star, std::size_t ghost, const G& g);
  static void mark_like(ClosedMesh& mesh, HalfEdge e) {
    if (mesh.is_constraint(e)) mesh.set_constraint(e, Constraint::on);
  }

  CavitySide left_, right_;
  std::vector<std::size_t> boundary_;
  std::vector<CavitySide> pockets_;
};

template <SegmentGeometry G>
void EditableGap::fill_along(ClosedMesh& mesh, const EditableStar& star, std::size_t from,
                             std::size_t to, const G& g) {
  gather(left_, mesh, star, to, from);
  gather(right_, mesh, star, from, to);
  clear(mesh, star);
  const HalfEdge forward = left_.fill(mesh, g), backward = right_.fill(mesh, g);
  mesh.join(forward, backward);
  mesh.set_constraint(forward, Constraint::on);
}

template <SegmentGeometry G>
void EditableGap::fill_boundary(ClosedMesh& mesh, const EditableStar& star,
                                std::size_t ghost, const G& g) {
  scan_boundary(star, ghost, g);
  pockets_.clear();
  for (std::size_t i = 1; i < boundary_.size(); ++i) {
    if (after(star, boundary_[i - 1]) == boundary_[i]) continue;
    gather(pockets_.emplace_back(), mesh, star, boundary_[i - 1], boundary_[i]);
  }
  clear(mesh, star);
  auto pocket = pockets_.begin();
  HalfEdge spoke = star.outside()[ghost];  // from the boundary node before to the ghost
  for (std::size_t i = 1; i < boundary_.size(); ++i) {
    const std::size_t a = boundary_[i - 1], b = boundary_[i];
    const HalfEdge base =
        after(star, a) == b ? star.outside()[a] : (pocket++)->fill(mesh, g);
    const std::int32_t f =
        mesh.add_face({star.rim()[a], star.rim()[b], star.rim()[ghost]});
    mesh.join(ClosedMesh::half_edge(f, 0), base);
    mark_like(mesh, base);
    mesh.join(ClosedMesh::half_edge(f, 2), spoke);
    spoke = ClosedMesh::half_edge(f, 1);
  }
  mesh.join(spoke, star.outside()[boundary_.back()]);
}

// The boundary without the node turns as it turned before: the other way only where a
// node lies behind those beside it.
template <SegmentGeometry G>
void EditableGap::scan_boundary(const EditableStar& star, std::size_t ghost, const G& g) {
  const auto rim = star.rim();
  boundary_.clear();
  for (std::size_t i = after(star, ghost); i != ghost; i = after(star, i)) {
    while (boundary_.size() > 1 && g.orientation(rim[boundary_[boundary_.size() - 2]],
                                                 rim[boundary_.back()], rim[i]) > 0)
      boundary_.pop_back();
    boundary_.push_back(i);
  }
}

inline void EditableGap::gather(CavitySide& side, const ClosedMesh& mesh,
                                const EditableStar& star, std::size_t from,
                                std::size_t to) {
  side.begin(star.rim()[from]);
  for (std::size_t i = from; i != to; i = after(star, i))
    side.add(star.rim()[after(star, i)], mesh.reverse(star.outside()[i]));
  side.look_around(mesh);
}

inline void EditableGap::clear(ClosedMesh& mesh, const EditableStar& star) {
  for (const std::int32_t f : star.faces()) mesh.remove_face(f);
}

}  // namespace delone::delaunay
