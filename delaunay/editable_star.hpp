#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/editable_cavity.hpp"

namespace delone::delaunay {

/// The triangulation that fills the hole which a removed node leaves.
///
/// Seen from the removed node v, a corner of a convex polyhedron, its neighbours are the
/// corners of a convex polygon, and the faces that close the hole are those of their own
/// hull that v sees. They are found by taking the neighbours away one by one in random
/// order, which leaves convex polygons, and putting them back in reverse: each comes in
/// beyond one known edge of the polygon so far, and sees a disc of faces there. The
/// polygon so far is kept as a closed surface, its faces and the cone from v over its
/// edges, so that putting back is the insertion of a node. Expected O(d) for d
/// neighbours, whatever their positions: a hub costs no more than its degree.
///
/// Sources: L. P. Chew, Dartmouth TR PCS-TR90-147 (1990); O. Devillers, Int. J. Comput.
/// Geom. Appl. 12 (2002) 193-205.
class EditableStar {
 public:
  /// Takes the star of `v` in hand. O(degree).
  void gather(const ClosedMesh& mesh, Site v);
  /// Its neighbours, counter-clockwise.
  [[nodiscard]] std::span<const Site> rim() const noexcept { return rim_; }
  /// Face i holds v and the rim's edge from node i to the next. Those that `fill` puts in
  /// their places come first, two fewer.
  [[nodiscard]] std::span<const std::int32_t> faces() const noexcept { return faces_; }
  /// The half-edges of that edge which are not the star's own.
  [[nodiscard]] std::span<const HalfEdge> outside() const noexcept { return outside_; }
  /// Removes v and fills the hole. `sees(corners, i)`, all numbers into rim(): is rim
  /// node i above the plane of three others, that is, does the face with these corners
  /// give way to it? It must answer consistently for every four, and an odd permutation
  /// negates.
  template <class Sees>
  void fill(ClosedMesh& mesh, Sees sees);

 private:
  struct Neighbors {
    Site before, after;
  };

  static std::size_t at(std::int32_t i) noexcept { return static_cast<std::size_t>(i); }
  [[nodiscard]] Site apex() const noexcept { return static_cast<Site>(rim_.size()); }
  void shuffle();
  /// Takes the rim away but for three, in reverse of the shuffled order.
  void unlink();
  void start();
  /// Notes the cone faces of the two edges that replaced a -> b when u came in.
  void move_in(ClosedMesh& mesh);
  void put_back_cone(Site u, HalfEdge to_before, HalfEdge to_after);

  Site removed_ = none;
  std::vector<Site> rim_;
  std::vector<std::int32_t> faces_;
  std::vector<HalfEdge> outside_;  // of rim edge i -> i + 1, of the face that stays

  ClosedMesh patch_;                  // nodes: numbers into rim_, and the apex
  std::vector<Site> order_;           // shuffled
  std::vector<Neighbors> neighbors_;  // on the polygon, at the time of leaving it
  std::vector<HalfEdge> cone_;        // i: apex -> the node after i
  std::vector<std::int32_t> slots_;   // face of the patch -> face of the mesh
  EditableCavity cavity_;
};

template <class Sees>
void EditableStar::fill(ClosedMesh& mesh, Sees sees) {
  shuffle();
  unlink();
  start();
  for (std::size_t i = 3; i < order_.size(); ++i) {
    const Site u = order_[i];
    const HalfEdge e = cone_[at(neighbors_[at(u)].before)];
    const HalfEdge to_after = patch_.reverse(e);
    const HalfEdge to_before = patch_.reverse(ClosedMesh::previous(e));
    cavity_.dig(patch_, ClosedMesh::face_of(e), [&](HalfEdge beyond) {
      const std::array<Site, 3>& corner = patch_.face(ClosedMesh::face_of(beyond)).node;
      if (corner[0] == apex() || corner[1] == apex() || corner[2] == apex()) return false;
      return static_cast<bool>(sees(corner, u));
    });
    cavity_.fill(patch_, u);
    put_back_cone(u, to_before, to_after);
  }
  move_in(mesh);
}

}  // namespace delone::delaunay
