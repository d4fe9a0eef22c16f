#include "delaunay/closed_mesh.hpp"

namespace delone::delaunay {

HalfEdge ClosedMesh::find(Site v, Site w) const noexcept {
  const HalfEdge start = edge_at(v);
  if (start == none) return none;
  HalfEdge e = start;
  do {
    if (target(e) == w) return e;
    e = next_around(e);
  } while (e != start);
  return none;
}

Site ClosedMesh::add_node() {
  edges_.push_back(none);
  return num_nodes() - 1;
}

std::int32_t ClosedMesh::add_face(const std::array<Site, 3>& node) {
  std::int32_t f = free_;
  if (f == none) {
    f = num_face_slots();
    faces_.emplace_back();
  } else {
    free_ = face(f).link[0];
  }
  ++num_faces_;
  slot(f) = Face{node, {none, none, none}, 0};
  for (std::size_t k = 0; k < 3; ++k) edges_[index(node[k])] = half_edge(f, k);
  return f;
}

void ClosedMesh::remove_face(std::int32_t f) noexcept {
  Face& removed = slot(f);
  for (const Site v : removed.node) {
    HalfEdge& edge = edges_[index(v)];
    if (face_of(edge) == f) edge = none;
  }
  removed.node.fill(none);
  removed.link[0] = free_;
  free_ = f;
  --num_faces_;
}

void ClosedMesh::clear(Site num_nodes) {
  faces_.clear();
  edges_.assign(index(num_nodes), none);
  num_faces_ = 0;
  free_ = none;
}

ClosedMesh ClosedMesh::renumbered(std::span<const Site> number, Site num_nodes) const {
  ClosedMesh copy(num_nodes);
  copy.faces_ = faces_;
  copy.num_faces_ = num_faces_;
  copy.free_ = free_;
  for (Face& f : copy.faces_) {
    if (f.node[0] == none) continue;
    for (Site& v : f.node) v = number[index(v)];
  }
  for (Site v = 0; v < this->num_nodes(); ++v) {
    if (edge_at(v) != none) copy.edges_[index(number[index(v)])] = edge_at(v);
  }
  return copy;
}

void ClosedMesh::set_face(std::int32_t f, const std::array<Site, 3>& node,
                          const std::array<HalfEdge, 3>& outer) noexcept {
  slot(f).node = node;
  for (std::size_t k = 0; k < 3; ++k) {
    edges_[index(node[k])] = half_edge(f, k);
    if (outer[k] != none) join(half_edge(f, k), outer[k]);
  }
}

HalfEdge ClosedMesh::flip(HalfEdge e) noexcept {
  const HalfEdge r = reverse(e);
  const std::int32_t f = face_of(e), g = face_of(r);
  const Site a = origin(e), b = origin(r), c = apex(e), d = apex(r);
  const HalfEdge bc = next(e), ca = previous(e), ad = next(r), db = previous(r);
  const HalfEdge outside_bc = reverse(bc), outside_ca = reverse(ca);
  const HalfEdge outside_ad = reverse(ad), outside_db = reverse(db);
  const auto bit = [&](HalfEdge side, unsigned k) {
    return static_cast<unsigned>(is_constraint(side)) << k;
  };
  const unsigned marks_f = bit(ad, 0) | bit(ca, 2), marks_g = bit(bc, 0) | bit(db, 2);
  set_face(f, {a, d, c}, {outside_ad, none, outside_ca});
  set_face(g, {b, c, d}, {outside_bc, none, outside_db});
  slot(f).constraints = static_cast<std::uint8_t>(marks_f);
  slot(g).constraints = static_cast<std::uint8_t>(marks_g);
  join(half_edge(f, 1), half_edge(g, 1));
  return half_edge(f, 1);
}

/// Makes faces from lists: those of the triangles, then those to the ghost.
class ClosedMesh::ListReader {
 public:
  explicit ListReader(const Adjacency& lists)
      : t_(lists), mesh_(lists.num_sites() + 1), edge_of_(index(lists.num_arcs())) {}

  [[nodiscard]] ClosedMesh read() {
    if (t_.is_chain()) return std::move(mesh_);
    make_room();
    add_ghost_faces();
    for (Site v = 0; v < t_.num_sites(); ++v) {
      if (t_.degree(v) == 0) continue;
      add_triangles(v);
      join_to_smaller(v);
    }
    for (std::int32_t f = num_triangles_; f < mesh_.num_faces_; ++f) note_edges(f);
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] HalfEdge& edge(Arc a) { return edge_of_[index(a.index)]; }
  // A boundary site's last arc has the outside on its left.
  [[nodiscard]] Arc last_arc(Site v) const { return t_.previous(t_.first_arc(v)); }
  template <class F>
  void for_each_boundary_site(F f) const {
    for (Site v = 0; v < t_.num_sites(); ++v)
      if (t_.is_boundary(v) && t_.degree(v) != 0) f(v);
  }

  // Every arc has a corner of a face on its left: of a triangle, or of a face to the
  // ghost.
  void make_room() {
    std::int32_t num_ghosts = 0;
    for_each_boundary_site([&](Site) { ++num_ghosts; });
    num_triangles_ = (t_.num_arcs() - num_ghosts) / 3;
    mesh_.num_faces_ = num_triangles_ + num_ghosts;
    mesh_.faces_.resize(index(mesh_.num_faces_));
  }

  // Behind the triangles.
  void add_ghost_faces() {
    std::int32_t f = num_triangles_;
    for_each_boundary_site([&](Site v) {
      const Arc a = last_arc(v);
      set(f, {v, t_.target(a), t_.num_sites()});
      edge(a) = half_edge(f, 0);
      ++f;
    });
    for_each_boundary_site([&](Site v) {
      const Arc out = last_arc(v);
      mesh_.join(next(edge(out)), previous(edge(last_arc(t_.target(out)))));
    });
  }
  void set(std::int32_t f, const std::array<Site, 3>& node) {
    mesh_.slot(f) = Face{node, {none, none, none}, 0};
  }

  // The last face of a node gives its edge.
  void note_edges(std::int32_t f) {
    for (std::size_t k = 0; k < 3; ++k)
      mesh_.edges_[index(mesh_.face(f).node[k])] = half_edge(f, k);
  }

  // Those of which v is the smallest corner.
  void add_triangles(Site v) {
    Arc a = t_.first_arc(v);
    for (std::int32_t i = 0; i < t_.degree(v); ++i, a = t_.next(a)) {
      const Arc after = t_.next(a);
      if (t_.target(a) < v || t_.target(after) < v || !t_.has_left(a)) continue;
      const std::int32_t f = next_triangle_++;
      set(f, {v, t_.target(a), t_.target(after)});
      note_edges(f);
      edge(a) = half_edge(f, 0);
      edge(t_.previous(t_.reverse(a))) = half_edge(f, 1);
      edge(t_.reverse(after)) = half_edge(f, 2);
    }
  }
  // All faces at v and at smaller sites are there.
  void join_to_smaller(Site v) {
    Arc a = t_.first_arc(v);
    for (std::int32_t i = 0; i < t_.degree(v); ++i, a = t_.next(a)) {
      if (t_.target(a) < v) mesh_.join(edge(a), edge(t_.reverse(a)));
    }
  }

  const Adjacency& t_;
  ClosedMesh mesh_;
  Buffer<HalfEdge> edge_of_;  // arc -> the face on its left
  std::int32_t num_triangles_ = 0, next_triangle_ = 0;
};

ClosedMesh ClosedMesh::from(const Adjacency& t) { return ListReader(t).read(); }

/// Writes the lists site by site, then the places of the reverse arcs.
class ClosedMesh::ListWriter {
 public:
  ListWriter(const ClosedMesh& mesh, Site num_sites, const std::vector<bool>& is_outside)
      : mesh_(mesh), num_sites_(num_sites), is_outside_(is_outside) {}

  [[nodiscard]] Adjacency::Lists write() {
    const std::size_t num_slots = 4 * mesh_.faces_.size();
    positions_.resize(num_slots);
    lists_.neighbors.reserve(3 * mesh_.faces_.size());
    edges_.reserve(3 * mesh_.faces_.size());
    lists_.offsets.assign(index(num_sites_) + 1, 0);
    lists_.is_boundary.assign(index(num_sites_), false);
    for (Site v = 0; v < num_sites_; ++v) {
      write_list(v);
      lists_.offsets[index(v) + 1] = static_cast<std::int32_t>(lists_.neighbors.size());
    }
    lists_.reverse.resize(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i)
      lists_.reverse[i] = positions_[index(mesh_.reverse(edges_[i]))];
    return std::move(lists_);
  }

 private:
  [[nodiscard]] bool is_outside(HalfEdge e) const {
    return is_outside_[index(face_of(e))];
  }

  void write_list(Site v) {
    const HalfEdge start = mesh_.edge_at(v);
    if (start == none) return;
    const HalfEdge first = first_after_outside(start);
    if (is_outside(first)) return;
    if (is_outside(mesh_.previous_around(first))) {
      lists_.is_boundary[index(v)] = true;
      HalfEdge e = first;
      for (; !is_outside(e); e = mesh_.next_around(e)) write_arc(v, e);
      write_arc(v, e);
      return;
    }
    const HalfEdge smallest = smallest_target(first);
    HalfEdge e = smallest;
    do {
      write_arc(v, e);
      e = mesh_.next_around(e);
    } while (e != smallest);
  }

  /// The edge after the outside, if there is an outside and an inside; else any.
  [[nodiscard]] HalfEdge first_after_outside(HalfEdge start) const {
    HalfEdge e = start;
    do {
      const HalfEdge after = mesh_.next_around(e);
      if (is_outside(e) && !is_outside(after)) return after;
      e = after;
    } while (e != start);
    return start;
  }

  [[nodiscard]] HalfEdge smallest_target(HalfEdge start) const {
    HalfEdge smallest = start;
    for (HalfEdge e = mesh_.next_around(start); e != start; e = mesh_.next_around(e)) {
      if (mesh_.target(e) < mesh_.target(smallest)) smallest = e;
    }
    return smallest;
  }

  void write_arc(Site v, HalfEdge e) {
    const auto position =
        static_cast<std::int32_t>(edges_.size()) - lists_.offsets[index(v)];
    positions_[index(e)] =
        static_cast<std::uint8_t>(std::min(position, Adjacency::far_reverse));
    edges_.push_back(e);
    lists_.neighbors.push_back(mesh_.target(e));
  }

  const ClosedMesh& mesh_;
  Site num_sites_;
  const std::vector<bool>& is_outside_;
  Buffer<std::uint8_t> positions_;  // of every half-edge in its origin's list
  Buffer<HalfEdge> edges_;          // of every arc
  Adjacency::Lists lists_;
};

Adjacency::Lists ClosedMesh::lists_without(Site num_sites,
                                           const std::vector<bool>& is_outside) const {
  return ListWriter(*this, num_sites, is_outside).write();
}

}  // namespace delone::delaunay
