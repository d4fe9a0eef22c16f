#include "delaunay/ring_faces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "delaunay/few_walks.hpp"

namespace delone::delaunay {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Writes the triangles site by site, then the faces to the ghost. A half-edge's
/// `previous` is not needed and becomes the half-edge of the face on its left. The links
/// of a face are half-edges of the rings until all faces are there.
class FaceWriter {
 public:
  explicit FaceWriter(EdgeRings rings)
      : rings_(std::move(rings)),
        ring_(rings_.edges.data()),
        num_sites_(static_cast<Site>(rings_.first.size())) {}

  [[nodiscard]] std::optional<ClosedMesh> write() {
    if (!list_hull()) return std::nullopt;
    make_room();
    write_all_triangles();
    if (num_written_ != num_triangles_ || num_steps_ != 3 * num_triangles_ + num_ghosts())
      return std::nullopt;
    write_ghost_faces();
    link_triangles();
    return ClosedMesh(std::move(faces_), std::move(edge_at_));
  }

 private:
  using Face = ClosedMesh::Face;

  [[nodiscard]] std::int32_t num_ghosts() const {
    return static_cast<std::int32_t>(hull_.size());
  }

  // A boundary site's ring begins with its hull edge. False if the hull comes past a site
  // twice.
  [[nodiscard]] bool list_hull() {
    is_boundary_.assign(at(num_sites_), false);
    std::int32_t e = rings_.hull;
    if (e == none) return true;
    do {
      const Site v = ring_[e ^ 1].target;
      if (is_boundary_[at(v)]) return false;
      is_boundary_[at(v)] = true;
      rings_.first[at(v)] = e;
      hull_.push_back(e);
      e = ring_[e ^ 1].next;
    } while (e != rings_.hull);
    return true;
  }

  void make_room() {
    num_triangles_ = 2 * num_sites_ - (hull_.empty() ? 4 : 2 + num_ghosts());
    faces_.resize(at(num_triangles_) + hull_.size());
    edge_at_.resize(at(num_sites_) + 1);
    edge_at_.back() = none;
    number_ghosts();
  }
  // In the order of the sites whose last half-edge has the outside on its left. That of
  // the target of a hull edge is the hull edge's reverse.
  void number_ghosts() {
    std::int32_t f = num_triangles_;
    for (Site v = 0; v < num_sites_; ++v)
      if (is_boundary_[at(v)]) edge_at_[at(v)] = f++;
    for (const std::int32_t e : hull_) ghosts_.push_back(edge_at_[at(ring_[e].target)]);
  }

  void write_all_triangles() {
    constexpr Site few = FewWalks::num_walks;
    Site v = 0;
    for (; v + few <= num_sites_; v += few) {
      FewWalks::fetch_ahead(ring_, rings_.edges.size(), v);
      write_few(v);
    }
    for (; v < num_sites_; ++v) {
      const std::int32_t first = num_written_;
      write_any(v);
      join_from(first);
    }
  }

  // Nearly all sites are written by the same instructions, whatever their degree: a
  // branch at every corner would go one way or the other without a pattern.
  void write_few(Site begin) {
    const std::int32_t first = num_written_;
    const FewWalks walks(ring_, rings_.first.data(), begin);
    for (Site j = 0; j < FewWalks::num_walks; ++j) {
      if (!walks.is_whole(j) || is_boundary_[at(begin + j)] ||
          num_written_ + FewWalks::num_steps > num_triangles_) [[unlikely]] {
        write_any(begin + j);
      } else {
        write_whole(walks, j, begin + j);
      }
    }
    join_from(first);
  }
  // Which corners at v have larger sites, one bit a step; then the faces there, in the
  // order of the list. No more than four at nearly all sites, so four are written.
  void write_whole(const FewWalks& walks, Site j, Site v) {
    const std::int32_t degree = walks.degree(j), start = walks.smallest(j);
    unsigned larger = 0;
    for (std::int32_t i = 0; i < FewWalks::num_steps; ++i)
      larger |= static_cast<unsigned>(walks.target(i, j) > v) << i;
    larger |= (larger & 1U) << degree;
    unsigned corners = larger & (larger >> 1) & ((1U << degree) - 1);
    corners = ((corners >> start) | (corners << (degree - start))) & ((1U << degree) - 1);
    const unsigned last = 1U << (degree - 1);
    const auto num_faces = std::popcount(corners);
    Face* const faces = faces_.data() + num_written_;
    num_written_ += num_faces;
    num_steps_ += degree;
    const auto write = [&](int i) {
      const std::int32_t place = std::countr_zero(corners | last) + start;
      const std::int32_t here = place < degree ? place : place - degree;
      const std::int32_t after = here + 1 < degree ? here + 1 : 0;
      faces[i].node = {v, walks.target(here, j), walks.target(after, j)};
      faces[i].link = {walks.edge(here, j), none, walks.edge(after, j) ^ 1};
      corners &= corners - 1;
    };
    for (int i = 0; i < 4; ++i) write(i);
    for (int i = 4; i < num_faces; ++i) write(i);
  }

  // The triangles of which v is the smallest corner: from its smallest neighbour on, or
  // from one side of the outside to the other.
  void write_any(Site v) {
    const bool is_boundary = is_boundary_[at(v)];
    const std::int32_t start =
        is_boundary ? rings_.first[at(v)] : to_smallest(ring_, rings_.first[at(v)]);
    std::int32_t e = start;
    do {
      const std::int32_t after = ring_[e].next;
      const Site a = ring_[e].target, b = ring_[after].target;
      if (a > v && b > v && !(is_boundary && after == start) &&
          num_written_ < num_triangles_) {
        Face& face = faces_[at(num_written_++)];
        face.node = {v, a, b};
        face.link = {e, none, after ^ 1};
      }
      ++num_steps_;
      e = after;
    } while (e != start);
  }
  // Joins new triangles to those before.
  void join_from(std::int32_t first) {
    RingEdge* const ring = ring_;
    Face* const faces = faces_.data();
    HalfEdge* const edge_at = edge_at_.data();
    for (std::int32_t f = first; f < num_written_; ++f) {
      Face& face = faces[f];
      face.constraints = 0;
      face.link[1] = ring[face.link[2]].next ^ 1;
      for (std::size_t k = 0; k < 3; ++k) {
        ring[face.link[k]].previous = ClosedMesh::half_edge(f, k);
        edge_at[face.node[k]] = ClosedMesh::half_edge(f, k);
      }
    }
  }
  void write_ghost_faces() {
    for (std::size_t i = 0; i < hull_.size(); ++i)
      ring_[hull_[i] ^ 1].previous = ClosedMesh::half_edge(ghosts_[i], 0);
    for (std::size_t i = 0; i < hull_.size(); ++i) {
      const RingEdge &e = ring_[hull_[i]], &back = ring_[hull_[i] ^ 1];
      const std::int32_t before = ghosts_[i == 0 ? hull_.size() - 1 : i - 1];
      const std::int32_t after = ghosts_[i + 1 == hull_.size() ? 0 : i + 1];
      faces_[at(ghosts_[i])] = {
          {e.target, back.target, num_sites_},
          {e.previous, ClosedMesh::half_edge(before, 2), ClosedMesh::half_edge(after, 1)},
          0};
    }
    for (std::int32_t f = num_triangles_; f < num_triangles_ + num_ghosts(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        edge_at_[at(faces_[at(f)].node[k])] = ClosedMesh::half_edge(f, k);
  }
  // There are three half-edges in use for each triangle, in the same order but for that
  // within a block: so the block after this one is fetched.
  void link_triangles() {
    const auto num_edges = std::ssize(rings_.edges);
    for (std::ptrdiff_t f = 0; f < num_triangles_; ++f) {
      __builtin_prefetch(ring_ + std::min(3 * f + 6 * ring_block_size, num_edges - 1));
      for (HalfEdge& link : faces_[static_cast<std::size_t>(f)].link)
        link = ring_[link ^ 1].previous;
    }
  }

  EdgeRings rings_;
  RingEdge* ring_;
  Site num_sites_;
  std::int32_t num_triangles_ = 0, num_written_ = 0;
  std::int64_t num_steps_ = 0;
  std::vector<bool> is_boundary_;
  std::vector<std::int32_t> hull_;    // hull edges in order
  std::vector<std::int32_t> ghosts_;  // the faces beyond them
  Buffer<Face> faces_;
  Buffer<HalfEdge> edge_at_;
};

}  // namespace

std::optional<ClosedMesh> take_faces(EdgeRings rings) {
  return FaceWriter(std::move(rings)).write();
}

}  // namespace delone::delaunay
