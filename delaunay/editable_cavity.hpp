#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "delaunay/closed_mesh.hpp"

namespace delone::delaunay {

/// The faces that see a new node, and their replacement by the node's fan.
///
/// The faces are a disc without a node inside, so the dual of the disc is a tree, walked
/// depth first without marks; its rim comes out in counter-clockwise order. Keeps its
/// memory from one use to the next.
///
/// Sources: A. Bowyer, Comput. J. 24 (1981) 162-166; D. F. Watson, ibid. 167-172.
class EditableCavity {
 public:
  /// The face `seed` and all that are reached from it across edges that `gives_way(e)`
  /// holds for; e: the half-edge of the face beyond.
  template <class GivesWay>
  void dig(const ClosedMesh& mesh, std::int32_t seed, GivesWay gives_way);
  /// Replaces the faces by triangles from `q` to every edge of the rim, which keep their
  /// marks. O(their number).
  void fill(ClosedMesh& mesh, Site q);

 private:
  struct RimEdge {
    Site from;
    HalfEdge outside;  // of the face that stays
  };
  std::vector<std::int32_t> faces_;
  std::vector<HalfEdge> stack_;
  std::vector<RimEdge> rim_;
};

template <class GivesWay>
void EditableCavity::dig(const ClosedMesh& mesh, std::int32_t seed, GivesWay gives_way) {
  faces_.assign(1, seed);
  rim_.clear();
  const auto& link = mesh.face(seed).link;
  stack_.assign({link[2], link[1], link[0]});
  while (!stack_.empty()) {
    // An edge seen from beyond; next one in counter-clockwise order on top.
    HalfEdge e = stack_.back();
    stack_.pop_back();
    while (gives_way(e)) {
      faces_.push_back(ClosedMesh::face_of(e));
      stack_.push_back(mesh.reverse(ClosedMesh::previous(e)));
      e = mesh.reverse(ClosedMesh::next(e));
    }
    rim_.push_back({mesh.target(e), e});
  }
}

inline void EditableCavity::fill(ClosedMesh& mesh, Site q) {
  // A disc of k faces has k + 2 edges on its rim.
  for (std::size_t i = faces_.size(); i < rim_.size(); ++i) faces_.push_back(none);
  Site to = rim_.front().from;
  HalfEdge first_spoke = none, spoke = none;  // spoke: q -> to, to be joined
  for (std::size_t i = rim_.size(); i-- > 0;) {
    const auto [from, outside] = rim_[i];
    std::int32_t& f = faces_[i];
    if (f == none) {
      f = mesh.add_face({q, from, to});
    } else {
      mesh.replace_face(f, {q, from, to});
    }
    mesh.join(ClosedMesh::half_edge(f, 1), outside);
    if (mesh.is_constraint(outside)) mesh.set_constraint(outside, Constraint::on);
    const HalfEdge last = ClosedMesh::half_edge(f, 2);  // to -> q
    if (spoke == none) {
      first_spoke = last;
    } else {
      mesh.join(last, spoke);
    }
    spoke = ClosedMesh::half_edge(f, 0);
    to = from;
  }
  mesh.join(first_spoke, spoke);
}

}  // namespace delone::delaunay
