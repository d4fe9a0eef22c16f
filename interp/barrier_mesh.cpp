#include "interp/barrier_mesh.hpp"

#include <utility>

namespace delone::interp {

namespace {

using delaunay::none;

}  // namespace

template <class Constrained>
BarrierMesh<Constrained>::BarrierMesh(std::shared_ptr<const Constrained> constrained)
    : constrained_(std::move(constrained)) {
  first_edges_.assign(at(num_sites()), none);
  if (dimension() < 2) return;
  adjacency_ =
      Adjacency(mesh().to_lists(num_sites(), [](std::int32_t) { return false; }));
  match_arcs();
  // Every face of the domain is marked before wedges are numbered: barriers are told by
  // it.
  wedges_.assign(4 * static_cast<std::size_t>(mesh().num_face_slots()), none);
  for (std::int32_t f = 0; f < mesh().num_face_slots(); ++f) {
    if (mesh().is_free(f) || constrained_->region_of(f) == none) continue;
    for (std::size_t k = 0; k < 3; ++k)
      wedges_[static_cast<std::size_t>(ClosedMesh::half_edge(f, k))] = 0;
  }
  for (Site s = 0; s < num_sites(); ++s) number_wedges(s);
}

// Lists and half-edges go round a site in the same sense.
template <class Constrained>
void BarrierMesh<Constrained>::match_arcs() {
  half_edges_.assign(at(adjacency_.num_arcs()), none);
  for (Site s = 0; s < num_sites(); ++s) {
    if (adjacency_.degree(s) == 0) continue;
    Arc a = adjacency_.first_arc(s);
    HalfEdge e = mesh().edge_at(s);
    while (mesh().target(e) != adjacency_.target(a)) e = mesh().next_around(e);
    for (std::int32_t i = 0; i < adjacency_.degree(s); ++i, a = adjacency_.next(a)) {
      half_edges_[at(a.index)] = e;
      e = mesh().next_around(e);
    }
  }
}

// Of the edges that leave the site along barriers, or of all if there is no barrier, the
// one to the smallest site: what a mesh calls a site's first edge depends on its history.
template <class Constrained>
HalfEdge BarrierMesh<Constrained>::start_of_wedges(Site s) const noexcept {
  const HalfEdge first = mesh().edge_at(s);
  HalfEdge best = first;
  const auto is_better = [&](HalfEdge e) {
    const bool is_new = is_barrier(e), is_old = is_barrier(best);
    return is_new != is_old ? is_new : mesh().target(e) < mesh().target(best);
  };
  for (HalfEdge e = first; e != none;) {
    if (is_better(e)) best = e;
    e = mesh().next_around(e);
    if (e == first) break;
  }
  return best;
}

template <class Constrained>
void BarrierMesh<Constrained>::number_wedges(Site s) {
  const HalfEdge start = start_of_wedges(s);
  if (start == none) return;
  Wedge wedge = none;
  HalfEdge e = start;
  do {
    if (!is_inside(e)) {
      wedge = none;
    } else {
      if (wedge == none || is_barrier(e)) {
        const bool is_first = first_edges_[at(s)] == none;
        wedge = is_first ? s : num_wedges();
        if (is_first)
          first_edges_[at(s)] = e;
        else
          first_edges_.push_back(e);
      }
      wedges_[static_cast<std::size_t>(e)] = wedge;
    }
    e = mesh().next_around(e);
  } while (e != start);
}

template class BarrierMesh<tripack::ConstrainedTriangulation>;
template class BarrierMesh<stripack::ConstrainedTriangulation>;

}  // namespace delone::interp
