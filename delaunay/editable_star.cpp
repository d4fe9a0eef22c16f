#include "delaunay/editable_star.hpp"

#include <numeric>
#include <utility>

namespace delone::delaunay {

void EditableStar::gather(const ClosedMesh& mesh, Site v) {
  removed_ = v;
  rim_.clear();
  faces_.clear();
  outside_.clear();
  const HalfEdge start = mesh.edge_at(v);
  HalfEdge e = start;
  do {
    rim_.push_back(mesh.target(e));
    faces_.push_back(ClosedMesh::face_of(e));
    outside_.push_back(mesh.reverse(ClosedMesh::next(e)));
    e = mesh.next_around(e);
  } while (e != start);
}

// Any order gives the same faces; a random one is fast for every input.
void EditableStar::shuffle() {
  order_.resize(rim_.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::uint64_t state = 0x9E3779B97F4A7C15u + rim_.size();
  for (std::size_t i = order_.size(); i > 1; --i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    std::swap(order_[i - 1], order_[static_cast<std::size_t>((state >> 33) % i)]);
  }
}

void EditableStar::unlink() {
  const Site d = apex();
  neighbors_.resize(rim_.size());
  for (Site i = 0; i < d; ++i)
    neighbors_[at(i)] = {i == 0 ? d - 1 : i - 1, i == d - 1 ? 0 : i + 1};
  for (std::size_t i = order_.size(); i-- > 3;) {
    const auto [before, after] = neighbors_[at(order_[i])];
    neighbors_[at(before)].after = after;
    neighbors_[at(after)].before = before;
  }
}

void EditableStar::start() {
  patch_.clear(apex() + 1);
  cone_.resize(rim_.size());
  const Site a = order_[0], b = neighbors_[at(a)].after, c = neighbors_[at(b)].after;
  const std::array<Site, 4> corner{a, b, c, a};
  const std::int32_t base = patch_.add_face({a, b, c});
  std::array<std::int32_t, 3> cone{};
  for (std::size_t k = 0; k < 3; ++k) {
    cone[k] = patch_.add_face({corner[k + 1], corner[k], apex()});
    patch_.join(ClosedMesh::half_edge(base, k), ClosedMesh::half_edge(cone[k], 0));
    cone_[at(corner[k])] = ClosedMesh::half_edge(cone[k], 2);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    patch_.join(ClosedMesh::half_edge(cone[k], 1),
                ClosedMesh::half_edge(cone[(k + 2) % 3], 2));
  }
}

void EditableStar::put_back_cone(Site u, HalfEdge to_before, HalfEdge to_after) {
  cone_[at(neighbors_[at(u)].before)] = ClosedMesh::next(patch_.reverse(to_before));
  cone_[at(u)] = patch_.reverse(to_after);
}

// The star had d faces and leaves d - 2: their places are taken first to last.
void EditableStar::move_in(ClosedMesh& mesh) {
  mesh.forget(removed_);
  slots_.assign(at(patch_.num_face_slots()), none);
  std::size_t num_used = 0;
  for (std::int32_t f = 0; f < patch_.num_face_slots(); ++f) {
    const auto& [a, b, c] = patch_.face(f).node;
    if (a == apex() || b == apex() || c == apex()) continue;
    slots_[at(f)] = faces_[num_used++];
    mesh.replace_face(slots_[at(f)], {rim_[at(a)], rim_[at(b)], rim_[at(c)]});
  }
  for (std::int32_t f = 0; f < patch_.num_face_slots(); ++f) {
    if (slots_[at(f)] == none) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(f, k), r = patch_.reverse(e);
      const std::int32_t beyond = slots_[at(ClosedMesh::face_of(r))];
      const HalfEdge other =
          beyond == none ? outside_[at(patch_.origin(e))]
                         : ClosedMesh::half_edge(beyond, ClosedMesh::corner_of(r));
      mesh.join(ClosedMesh::half_edge(slots_[at(f)], k), other);
      if (beyond == none && mesh.is_constraint(other))
        mesh.set_constraint(other, Constraint::on);
    }
  }
  while (num_used < faces_.size()) mesh.remove_face(faces_[num_used++]);
}

}  // namespace delone::delaunay
