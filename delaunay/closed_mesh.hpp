#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/buffer.hpp"

namespace delone::delaunay {

/// A directed edge: 4 * face + k, from node[k] to node[k + 1] with the face on its left.
using HalfEdge = std::int32_t;

/// Is an edge to stay, whatever the points say?
enum class Constraint : std::uint8_t { off, on };

/// A closed triangulated surface that can be changed: an array of faces, each of which
/// knows its three neighbours. Knows no coordinates.
///
/// The surface is that of a polyhedron (a sphere, topologically), so nothing is special
/// about a boundary: in the plane it is closed by a node at infinity, on the sphere
/// either by itself or, if a boundary is to stay, by a node in the outside in the same
/// way. Corners are counter-clockwise seen from outside.
///
/// Nodes are numbered from 0; a node without faces is allowed (not yet inserted, or
/// removed). Numbers of removed faces are used again. Everything costs O(1) unless said
/// otherwise. Between a removal and the joins that follow it the surface has a hole; what
/// walks across the hole then is undefined.
///
/// Memory: 32 bytes a face, 4 a node: 68 bytes a node of a full surface.
///
/// Source of the idea: L. Guibas, J. Stolfi, ACM Trans. Graph. 4 (1985) 74-123, with
/// faces in the place of edges.
class ClosedMesh {
 public:
  struct alignas(32) Face {
    std::array<Site, 3> node{none, none, none};
    std::array<HalfEdge, 3> link{none, none,
                                 none};  ///< the same edge from the other side
    std::uint8_t constraints = 0;        ///< bit k: edge k is a constraint
  };

  /// Nodes 0 .. num_nodes - 1, no faces.
  explicit ClosedMesh(Site num_nodes = 0)
      : edges_(static_cast<std::size_t>(num_nodes), none) {}

  /// Faces that are joined already, none of them free, and for every node a half-edge
  /// that leaves it.
  ClosedMesh(Buffer<Face> faces, Buffer<HalfEdge> edges)
      : faces_(std::move(faces)),
        edges_(std::move(edges)),
        num_faces_(static_cast<std::int32_t>(faces_.size())) {}

  /// The triangles of `t`, its boundary, if any, closed by faces to a ghost: the node
  /// t.num_sites(), which is there in any case. Chains have no faces. O(n).
  [[nodiscard]] static ClosedMesh from(const Adjacency& t);

  // Walking.

  [[nodiscard]] static constexpr std::int32_t face_of(HalfEdge e) noexcept {
    return e >> 2;
  }
  [[nodiscard]] static constexpr std::size_t corner_of(HalfEdge e) noexcept {
    return static_cast<std::size_t>(e & 3);
  }
  [[nodiscard]] static constexpr HalfEdge half_edge(std::int32_t f,
                                                    std::size_t k) noexcept {
    return 4 * f + static_cast<HalfEdge>(k);
  }
  /// Next and previous edge of the same face, counter-clockwise.
  [[nodiscard]] static constexpr HalfEdge next(HalfEdge e) noexcept {
    return (e & 3) == 2 ? e - 2 : e + 1;
  }
  [[nodiscard]] static constexpr HalfEdge previous(HalfEdge e) noexcept {
    return (e & 3) == 0 ? e + 2 : e - 1;
  }
  /// The same edge from its other end.
  [[nodiscard]] HalfEdge reverse(HalfEdge e) const noexcept {
    return face(face_of(e)).link[corner_of(e)];
  }
  /// Next edge counter-clockwise around the same origin, cyclically.
  [[nodiscard]] HalfEdge next_around(HalfEdge e) const noexcept {
    return reverse(previous(e));
  }
  /// Next edge clockwise around the same origin, cyclically.
  [[nodiscard]] HalfEdge previous_around(HalfEdge e) const noexcept {
    return next(reverse(e));
  }

  [[nodiscard]] Site origin(HalfEdge e) const noexcept {
    return face(face_of(e)).node[corner_of(e)];
  }
  [[nodiscard]] Site target(HalfEdge e) const noexcept { return origin(next(e)); }
  /// The corner opposite to the edge in the face on its left.
  [[nodiscard]] Site apex(HalfEdge e) const noexcept { return origin(previous(e)); }

  /// Some half-edge that leaves `v`; none if v has no face.
  [[nodiscard]] HalfEdge edge_at(Site v) const noexcept { return edges_[index(v)]; }
  /// The half-edge v -> w, or none. O(degree of v): ask the end with few edges.
  [[nodiscard]] HalfEdge find(Site v, Site w) const noexcept;

  [[nodiscard]] Site num_nodes() const noexcept {
    return static_cast<Site>(edges_.size());
  }
  [[nodiscard]] std::int32_t num_faces() const noexcept { return num_faces_; }
  /// Faces are numbered 0 .. num_face_slots() - 1, with gaps: free numbers.
  [[nodiscard]] std::int32_t num_face_slots() const noexcept {
    return static_cast<std::int32_t>(faces_.size());
  }
  [[nodiscard]] bool is_free(std::int32_t f) const noexcept {
    return face(f).node[0] == none;
  }
  [[nodiscard]] const Face& face(std::int32_t f) const noexcept {
    return faces_[index(f)];
  }

  // Editing.

  /// A node without faces: num_nodes() before the call. Amortised.
  Site add_node();
  /// A face without neighbours, for `join`; becomes the place of `edge_at` for its
  /// corners. Edge k of the face is half_edge(result, k). Amortised.
  std::int32_t add_face(const std::array<Site, 3>& node);
  /// The corners whose `edge_at` was in the face have none until a face is added there.
  void remove_face(std::int32_t f) noexcept;
  /// The face number `f` as `add_face` would have made it. A former corner's `edge_at`
  /// may go on to point here: give that node another face, or `forget` it.
  void replace_face(std::int32_t f, const std::array<Site, 3>& node) noexcept {
    slot(f).node = node;
    slot(f).constraints = 0;
    for (std::size_t k = 0; k < 3; ++k) edges_[index(node[k])] = half_edge(f, k);
  }
  /// The node has no face any more.
  void forget(Site v) noexcept { edges_[index(v)] = none; }
  /// Nodes 0 .. num_nodes - 1, no faces; keeps its memory. O(num_nodes).
  void clear(Site num_nodes);
  /// A copy with other node numbers, 0 .. num_nodes - 1; `number[v]` of nodes without
  /// faces is not looked at. O(n).
  [[nodiscard]] ClosedMesh renumbered(std::span<const Site> number, Site num_nodes) const;
  /// Makes `a` and `b` the two sides of one edge.
  void join(HalfEdge a, HalfEdge b) noexcept {
    slot(face_of(a)).link[corner_of(a)] = b;
    slot(face_of(b)).link[corner_of(b)] = a;
  }
  /// Calls every node v `number(v)`, one of 0 .. num_nodes - 1, from now on. Nodes that
  /// get no number in that range must be without faces. O(nodes + faces).
  template <class Number>
  void renumber_nodes(Site num_nodes, Number number);
  /// Replaces the edge a -> b between the faces (a, b, c) and (b, a, d) by d -> c and
  /// returns that: faces (a, d, c) on its left and (b, c, d). The four outer edges keep
  /// their marks, the new edge has none.
  HalfEdge flip(HalfEdge e) noexcept;

  // Constraint marks.

  [[nodiscard]] bool is_constraint(HalfEdge e) const noexcept {
    return ((face(face_of(e)).constraints >> corner_of(e)) & 1) != 0;
  }
  /// Marks both sides of the edge.
  void set_constraint(HalfEdge e, Constraint value) noexcept {
    mark(e, value);
    mark(reverse(e), value);
  }

  /// Adjacency lists of sites 0 .. num_sites - 1 over the faces that have only such
  /// corners and for which `is_outside(face number)` does not hold. At every site these
  /// faces must be consecutive (then the site is interior if they go round, and boundary
  /// otherwise). A site without such faces has an empty list. O(n).
  template <class IsOutside>
  [[nodiscard]] Adjacency::Lists to_lists(Site num_sites, IsOutside is_outside) const;

 private:
  class ListReader;
  class ListWriter;

  static constexpr std::size_t index(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
  }
  [[nodiscard]] Face& slot(std::int32_t f) noexcept { return faces_[index(f)]; }
  void mark(HalfEdge e, Constraint value) noexcept {
    Face& f = slot(face_of(e));
    const auto bit = static_cast<std::uint8_t>(1U << corner_of(e));
    f.constraints = static_cast<std::uint8_t>(
        value == Constraint::on ? f.constraints | bit : f.constraints & ~bit);
  }
  void set_face(std::int32_t f, const std::array<Site, 3>& node,
                const std::array<HalfEdge, 3>& outer) noexcept;
  [[nodiscard]] Adjacency::Lists lists_without(Site num_sites,
                                               const std::vector<bool>& is_outside) const;

  Buffer<Face> faces_;
  Buffer<HalfEdge> edges_;  // one for every node
  std::int32_t num_faces_ = 0;
  std::int32_t free_ = none;  // a free face; its link[0] is the next one
};

template <class Number>
void ClosedMesh::renumber_nodes(Site num_nodes, Number number) {
  edges_.assign(static_cast<std::size_t>(num_nodes), none);
  for (std::int32_t f = 0; f < num_face_slots(); ++f) {
    if (is_free(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      Site& node = faces_[index(f)].node[k];
      node = number(node);
      edges_[index(node)] = half_edge(f, k);
    }
  }
}

template <class IsOutside>
Adjacency::Lists ClosedMesh::to_lists(Site num_sites, IsOutside is_outside) const {
  std::vector<bool> left_out(faces_.size());
  for (std::int32_t f = 0; f < num_face_slots(); ++f) {
    const auto& node = face(f).node;
    left_out[index(f)] =
        is_free(f) || std::max({node[0], node[1], node[2]}) >= num_sites || is_outside(f);
  }
  return lists_without(num_sites, left_out);
}

}  // namespace delone::delaunay
