#pragma once

#include <memory>
#include <span>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "interp/spot.hpp"
#include "stripack/constrained_triangulation.hpp"
#include "tripack/constrained_triangulation.hpp"

namespace delone::interp {

using delaunay::ClosedMesh;
using delaunay::HalfEdge;

/// A site as it is seen from one gap between the barriers that meet there. Numbered: the
/// first wedge of every site like the site, others from num_sites() on.
using Wedge = std::int32_t;

/// A constrained triangulation as surfaces read it that do not reach across its curves.
///
/// A barrier is an edge of a constraint, or between a face of the domain and one that is
/// not. Round a site the faces of the domain between two barriers are a wedge; at the end
/// of a curve, as at any site within, one wedge goes all the way round. What belongs to
/// wedges instead of sites (values, polynomials, neighbours) cannot leak across.
///
/// All triangles of the hull are there, so that points are located and grids scanned as
/// in any triangulation; those outside the domain have no wedges. Collinear points have
/// no triangles: dimension() is 1. Cost: O(n); 24 bytes a triangle besides the
/// triangulation, which is shared.
template <class Constrained>
class BarrierMesh {
 public:
  explicit BarrierMesh(std::shared_ptr<const Constrained> constrained);

  [[nodiscard]] const Constrained& constrained() const noexcept { return *constrained_; }
  [[nodiscard]] const ClosedMesh& mesh() const noexcept { return constrained_->mesh(); }
  [[nodiscard]] Site ghost() const noexcept { return num_sites(); }

  // As of a Triangulation.
  [[nodiscard]] Site num_sites() const noexcept { return constrained_->num_sites(); }
  [[nodiscard]] auto points() const noexcept { return constrained_->points(); }
  [[nodiscard]] int dimension() const noexcept { return mesh().num_faces() > 0 ? 2 : 1; }
  [[nodiscard]] const Adjacency& adjacency() const noexcept { return adjacency_; }

  [[nodiscard]] HalfEdge half_edge(Arc arc) const noexcept {
    return half_edges_[at(arc.index)];
  }
  /// Is the face on the left of the edge in the domain?
  [[nodiscard]] bool is_inside(HalfEdge e) const noexcept {
    return wedge_of(e) != delaunay::none;
  }
  [[nodiscard]] bool is_barrier(HalfEdge e) const noexcept {
    return mesh().is_constraint(e) || is_inside(e) != is_inside(mesh().reverse(e));
  }

  /// Wedges, and sites without any.
  [[nodiscard]] Wedge num_wedges() const noexcept {
    return static_cast<Wedge>(first_edges_.size());
  }
  [[nodiscard]] Site site_of(Wedge w) const noexcept {
    return w < num_sites() ? w : mesh().origin(first_edges_[at(w)]);
  }
  [[nodiscard]] const auto& point_of(Wedge w) const noexcept {
    return points()[at(site_of(w))];
  }
  /// The wedge of the edge's origin in the face on its left; none outside the domain.
  [[nodiscard]] Wedge wedge_of(HalfEdge e) const noexcept {
    return wedges_[static_cast<std::size_t>(e)];
  }
  /// The half-edge of its first face, counter-clockwise; none for a site without faces in
  /// the domain.
  [[nodiscard]] HalfEdge first_edge(Wedge w) const noexcept {
    return first_edges_[at(w)];
  }

  /// The edge from the same site to the next face of the wedge, counter-clockwise; none
  /// after the last.
  [[nodiscard]] HalfEdge next_in_wedge(HalfEdge e) const noexcept {
    const HalfEdge last = ClosedMesh::previous(e), next = mesh().reverse(last);
    return is_barrier(last) || next == first_edges_[at(wedge_of(e))] ? delaunay::none
                                                                     : next;
  }
  /// `visit(neighbour)` for the wedges that are joined to one by an edge of its faces.
  template <class Visit>
  void for_each_neighbor(Wedge w, Visit visit) const {
    for (HalfEdge e = first_edge(w); e != delaunay::none;) {
      visit(wedge_of(ClosedMesh::next(e)));
      const HalfEdge last = ClosedMesh::previous(e);
      e = next_in_wedge(e);
      if (e == delaunay::none && is_barrier(last)) visit(wedge_of(last));
    }
  }

  /// Of the faces round a site for which `is_usable(half-edge)` the one with the smallest
  /// sites, as an edge that leaves the site; none if there is none.
  template <class IsUsable>
  [[nodiscard]] HalfEdge smallest_face(Site s, IsUsable is_usable) const {
    const HalfEdge first = mesh().edge_at(s);
    HalfEdge best = delaunay::none;
    for (HalfEdge e = first; e != delaunay::none;) {
      if (is_usable(e)) best = smaller(e, best);
      e = mesh().next_around(e);
      if (e == first) break;
    }
    return best;
  }
  /// The same of an edge and its reverse.
  template <class IsUsable>
  [[nodiscard]] HalfEdge smallest_side(HalfEdge e, IsUsable is_usable) const {
    const HalfEdge back = mesh().reverse(e);
    const HalfEdge best = is_usable(e) ? e : delaunay::none;
    return is_usable(back) ? smaller(back, best) : best;
  }

 private:
  /// Of two half-edges, one of them perhaps none, the one whose face has the smaller
  /// sites.
  [[nodiscard]] HalfEdge smaller(HalfEdge e, HalfEdge other) const noexcept {
    const auto name = [&](HalfEdge edge) {
      return smallest_first(mesh().face(ClosedMesh::face_of(edge)).node);
    };
    return other == delaunay::none || name(e) < name(other) ? e : other;
  }
  void match_arcs();
  void number_wedges(Site s);
  [[nodiscard]] HalfEdge start_of_wedges(Site s) const noexcept;

  std::shared_ptr<const Constrained> constrained_;
  Adjacency adjacency_;
  std::vector<HalfEdge> half_edges_;   // of arcs
  std::vector<Wedge> wedges_;          // of half-edges
  std::vector<HalfEdge> first_edges_;  // of wedges
};

extern template class BarrierMesh<tripack::ConstrainedTriangulation>;
extern template class BarrierMesh<stripack::ConstrainedTriangulation>;

}  // namespace delone::interp
