#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/mesh_walk.hpp"
#include "delaunay/segment_cavity.hpp"
#include "delaunay/segment_paths.hpp"

namespace delone::delaunay {

/// A constrained Delaunay triangulation in the making: what the plane and the sphere
/// share.
///
/// The surface is that of ClosedMesh, closed by `ghost` where it has a boundary. It stays
/// the constrained Delaunay triangulation of its sites and constraints after every
/// call, the canonical one: the order of insertions does not show in it.
///
/// Source of walking and cavities: S. W. Sloan, Comput. Struct. 47 (1993) 441-450; M. V.
/// Anglada, Comput. Graph. 21 (1997) 215-223; of restoring by flips: C. L. Lawson,
/// Software for C1 surface interpolation (1977).
template <SegmentGeometry G>
class SegmentMesh {
 public:
  using Edge = std::array<Site, 2>;

  /// `mesh`: a Delaunay triangulation. `g` must outlive this object.
  SegmentMesh(ClosedMesh mesh, const G& g, Site ghost)
      : mesh_(std::move(mesh)), g_(g), ghost_(ghost) {}

  [[nodiscard]] const ClosedMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const SegmentPaths& paths() const noexcept { return paths_; }
  [[nodiscard]] Site ghost() const noexcept { return ghost_; }
  /// Edges that an insertion met which were constraints already, once for each time.
  [[nodiscard]] const std::vector<Edge>& shared_pieces() const noexcept {
    return shared_pieces_;
  }
  [[nodiscard]] ClosedMesh take_mesh() { return std::move(mesh_); }
  [[nodiscard]] SegmentPaths take_paths() { return std::move(paths_); }
  /// Numbers the ghost `last` and the sites after it one lower. O(nodes).
  void put_ghost_last(Site last) {
    if (ghost_ == last) return;
    const auto number = [ghost = ghost_, last](Site v) {
      return v == ghost ? last : v > ghost ? v - 1 : v;
    };
    mesh_.renumber_nodes(last + 1, number);
    paths_.renumber(number);
    ghost_ = last;
  }
  /// Notes that a-b goes through `at`, where there are no faces: sites on one line.
  void divide(Site a, Site b, Site at) { paths_.divide(a, b, at); }

  /// Makes the segment a-b a chain of constraints through the sites on it.
  ///
  /// Where it crosses a constraint calls `on_crossing(piece, crossed)`: the piece of the
  /// segment and the half-edge, which the piece meets between its ends. It must throw, or
  /// call `divide_crossing`.
  template <class OnCrossing>
  void insert(Site a, Site b, OnCrossing on_crossing) {
    pending_.push_back({a, b});
    while (!pending_.empty()) {
      const Edge piece = pending_.back();
      pending_.pop_back();
      if (piece[0] == piece[1]) continue;
      const Site at = paths_.between(piece[0], piece[1]);
      if (at != none) {
        pending_.push_back({at, piece[1]});
        pending_.push_back({piece[0], at});
      } else if (const HalfEdge crossed = advance(piece); crossed != none) {
        on_crossing(piece, crossed);
      }
    }
  }

  /// Lets the piece of a segment and the constraint that it crosses meet at the new node
  /// `v`, whose position `g` knows, or at the site that is there already. Returns that.
  /// To be called by `on_crossing`; the position must not be an end of both.
  Site divide_crossing(const Edge& piece, HalfEdge crossed, Site v) {
    const Edge ends{mesh_.origin(crossed), mesh_.target(crossed)};
    release(crossed);
    const Site at = insert_site(v, ends[0]);
    paths_.note_meeting(at);
    for (const Edge& edge : {ends, piece}) {
      if (at != edge[0] && at != edge[1]) paths_.divide(edge[0], edge[1], at);
      pending_.push_back(edge);
    }
    return at;
  }

  /// Takes the mark from an edge and restores what that allows.
  void release(HalfEdge e) {
    mesh_.set_constraint(e, Constraint::off);
    suspects_.push_back(e);
    legalize_suspects();
  }

  /// To be called when `v` has come to break ties another way, for its position is given
  /// in another form.
  void restore_around(Site v) {
    const HalfEdge first = mesh_.edge_at(v);
    HalfEdge e = first;
    do {
      suspects_.push_back(e);
      suspects_.push_back(ClosedMesh::next(e));
      e = mesh_.next_around(e);
    } while (e != first);
    legalize_suspects();
  }

  /// Adds the node `v`, whose position `g` knows and which is looked for from the site
  /// `near` on. Returns v, or the site that has its position. A constraint that v lies on
  /// is divided.
  Site insert_site(Site v, Site near) {
    while (mesh_.num_nodes() <= v) mesh_.add_node();
    const MeshPlace place = locate(v, near);
    if (place.kind == MeshPlace::Kind::site) return place.site;
    insert_at(place, v);
    return v;
  }

  /// Adds the node `v` at a place that `locate` found, which is no site.
  void insert_at(const MeshPlace& place, Site v) {
    while (mesh_.num_nodes() <= v) mesh_.add_node();
    if (place.kind == MeshPlace::Kind::edge) {
      divide_edge(place.at, v);
    } else {
      divide_face(place.at, v);
    }
  }

  /// A number for every face, which new faces inherit from those whose place they take.
  /// Across constraints numbers may differ. Kept by `insert_at` only.
  void set_labels(Buffer<std::int32_t> labels) { labels_ = std::move(labels); }
  [[nodiscard]] std::int32_t label(std::int32_t face) const {
    return labels_[static_cast<std::size_t>(face)];
  }

  /// Where the position of `v` is, looked for from the site `near` on.
  [[nodiscard]] MeshPlace locate(Site v, Site near) const {
    return walk(mesh_, ghost_, real_edge_at(mesh_, near, ghost_),
                [&](Site a, Site b) { return g_.orientation(a, b, v); });
  }

 private:
  struct Ends {
    Site from, to;
    HalfEdge edge;  // from -> to, or none
  };

  // Looks for the edge round both ends in turn, so that a hub with many edges does not
  // cost more than its neighbour; `from` is the end that was looked at completely.
  [[nodiscard]] Ends meet(const Edge& piece) const {
    const auto [a, b] = piece;
    const HalfEdge first_a = mesh_.edge_at(a), first_b = mesh_.edge_at(b);
    HalfEdge at_a = first_a, at_b = first_b;
    for (;;) {
      if (mesh_.target(at_a) == b) return {a, b, at_a};
      if (mesh_.target(at_b) == a) return {b, a, at_b};
      at_a = mesh_.next_around(at_a);
      if (at_a == first_a) return {a, b, none};
      at_b = mesh_.next_around(at_b);
      if (at_b == first_b) return {b, a, none};
    }
  }

  // Marks the piece or its beginning up to the first site on it, with the rest pending.
  // Returns the half-edge of a constraint that it crosses before, from its right to its
  // left, or none.
  HalfEdge advance(const Edge& piece) {
    const Ends ends = meet(piece);
    if (ends.edge != none) {
      mark(ends.edge);
      return none;
    }
    const Site a = ends.from, b = ends.to;
    const HalfEdge e = leave(a, b);
    if (mesh_.origin(e) == a) {  // to a site on the piece
      mark(e);
      stop_at(piece, b, mesh_.target(e));
      return none;
    }
    return cut(piece, a, b, e);
  }

  void mark(HalfEdge e) {
    if (mesh_.is_constraint(e))
      shared_pieces_.push_back({mesh_.origin(e), mesh_.target(e)});
    mesh_.set_constraint(e, Constraint::on);
  }

  // The piece is done up to `at`; from there to its end `to` it is still pending.
  void stop_at(const Edge& piece, Site to, Site at) {
    paths_.divide(piece[0], piece[1], at);
    pending_.push_back({at, to});
  }

  // From a towards b: either an edge from a to a site on the way, or the edge opposite to
  // a that the way crosses, from its right to its left.
  [[nodiscard]] HalfEdge leave(Site a, Site b) const {
    HalfEdge e = mesh_.edge_at(a);
    const auto side = [&](Site v) {
      return v == ghost_ ? outside : g_.orientation(a, b, v);
    };
    for (int right = side(mesh_.target(e));;) {
      if (right == 0 && g_.is_ahead(a, b, mesh_.target(e))) return e;
      const int left = side(mesh_.apex(e));
      if (right < 0 && left > 0 && left != outside) return ClosedMesh::next(e);
      e = mesh_.next_around(e);
      right = left;
    }
  }

  // Walks through the faces from a to b, or to the first site on the way, and fills what
  // they leave. Changes nothing if a constraint is crossed.
  HalfEdge cut(const Edge& piece, Site a, Site b, HalfEdge crossing) {
    left_.begin(a);
    right_.begin(a);
    crossed_.clear();
    left_.add(mesh_.target(crossing), ClosedMesh::next(crossing));
    right_.add(mesh_.origin(crossing), ClosedMesh::previous(crossing));
    Site end = none;
    while (end == none) {
      if (mesh_.is_constraint(crossing)) return crossing;
      crossed_.push_back(ClosedMesh::face_of(crossing));
      const HalfEdge back = mesh_.reverse(crossing);
      const HalfEdge right = ClosedMesh::next(back), left = ClosedMesh::previous(back);
      const Site apex = mesh_.origin(left);
      const int side = apex == b ? 0 : g_.orientation(a, b, apex);
      if (side >= 0) left_.add(apex, left);
      if (side <= 0) right_.add(apex, right);
      if (side == 0) {
        end = apex;
        crossed_.push_back(ClosedMesh::face_of(back));
      }
      crossing = side > 0 ? right : left;
    }
    fill_cavity();
    if (end != b) stop_at(piece, b, end);
    return none;
  }

  void fill_cavity() {
    left_.reverse();  // came clockwise, from a on
    left_.look_around(mesh_);
    right_.look_around(mesh_);
    for (const std::int32_t f : crossed_) mesh_.remove_face(f);
    const HalfEdge forward = left_.fill(mesh_, g_), backward = right_.fill(mesh_, g_);
    mesh_.join(forward, backward);
    mesh_.set_constraint(forward, Constraint::on);
  }

  // Is the unmarked edge not Delaunay? At an edge to the ghost: is the hull not convex
  // between?
  [[nodiscard]] bool is_illegal(HalfEdge e) const {
    const Site a = mesh_.origin(e), b = mesh_.target(e);
    const Site c = mesh_.apex(e), d = mesh_.apex(mesh_.reverse(e));
    if (c == ghost_ || d == ghost_) return false;
    if (a == ghost_) return g_.orientation(b, c, d) > 0;
    if (b == ghost_) return g_.orientation(a, d, c) > 0;
    return g_.is_inside(a, b, c, d);
  }

  // A flip moves only its four outer edges to other half-edges, and these are looked at
  // again: no suspect is lost.
  void legalize_suspects() {
    while (!suspects_.empty()) {
      const HalfEdge e = suspects_.back();
      suspects_.pop_back();
      if (mesh_.is_constraint(e) || !is_illegal(e)) continue;
      const HalfEdge diagonal = mesh_.flip(e), back = mesh_.reverse(diagonal);
      for (const HalfEdge side : {diagonal, back}) {
        suspects_.push_back(ClosedMesh::next(side));
        suspects_.push_back(ClosedMesh::previous(side));
      }
    }
  }

  // Three faces in the place of one, whose edges become suspects.
  void divide_face(HalfEdge e, Site v) {
    fan({e, ClosedMesh::next(e), ClosedMesh::previous(e)}, {ClosedMesh::face_of(e)}, v);
    legalize_suspects();
  }

  // Four faces in the place of the two at the edge. If that is a constraint, so are its
  // halves.
  void divide_edge(HalfEdge e, Site v) {
    const HalfEdge back = mesh_.reverse(e);
    const Site a = mesh_.origin(e), b = mesh_.target(e);
    const bool is_constraint = mesh_.is_constraint(e);
    fan({ClosedMesh::next(e), ClosedMesh::previous(e), ClosedMesh::next(back),
         ClosedMesh::previous(back)},
        {ClosedMesh::face_of(e), ClosedMesh::face_of(back)}, v);
    if (is_constraint) {
      paths_.divide(a, b, v);
      mesh_.set_constraint(mesh_.find(v, a), Constraint::on);
      mesh_.set_constraint(mesh_.find(v, b), Constraint::on);
    }
    legalize_suspects();
  }

  // Faces from v to the edges in `ring`, which close counter-clockwise round the faces in
  // `inside`, in the place of these.
  void fan(const std::vector<HalfEdge>& ring, const std::vector<std::int32_t>& inside,
           Site v) {
    struct Side {
      Site a, b;
      HalfEdge outer;
      std::int32_t label;
    };
    std::vector<Side> sides;
    for (const HalfEdge e : ring)
      sides.push_back({mesh_.origin(e), mesh_.target(e), mesh_.reverse(e),
                       labels_.empty() ? none : label(ClosedMesh::face_of(e))});
    for (const std::int32_t f : inside) mesh_.remove_face(f);
    std::vector<std::int32_t> faces;
    for (const Side& side : sides) {
      const std::int32_t f = mesh_.add_face({side.a, side.b, v});
      const HalfEdge base = ClosedMesh::half_edge(f, 0);
      mesh_.join(base, side.outer);
      if (mesh_.is_constraint(side.outer)) mesh_.set_constraint(base, Constraint::on);
      faces.push_back(f);
      suspects_.push_back(base);
      suspects_.push_back(ClosedMesh::half_edge(f, 1));
      if (!labels_.empty()) set_label(f, side.label);
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const std::int32_t after = faces[(i + 1) % faces.size()];
      mesh_.join(ClosedMesh::half_edge(faces[i], 1), ClosedMesh::half_edge(after, 2));
    }
  }

  void set_label(std::int32_t face, std::int32_t label) {
    labels_.resize(std::max(labels_.size(), static_cast<std::size_t>(face) + 1));
    labels_[static_cast<std::size_t>(face)] = label;
  }

  static constexpr int outside = 2;  // the side of the ghost

  ClosedMesh mesh_;
  const G& g_;
  Site ghost_;
  SegmentPaths paths_;
  std::vector<Edge> shared_pieces_;
  Buffer<std::int32_t> labels_;  // empty: none

  // Work space.
  std::vector<Edge> pending_;
  CavitySide left_, right_;
  std::vector<std::int32_t> crossed_;
  std::vector<HalfEdge> suspects_;
};

}  // namespace delone::delaunay
