#pragma once

#include <concepts>
#include <cstddef>
#include <vector>

#include "delaunay/closed_mesh.hpp"

namespace delone::delaunay {

/// What segments need to know about positions. For sites a, b, c, d:
///   orientation(a, b, c)  +1 left of a -> b, -1 right, 0 on its line; exact
///   is_ahead(a, b, c)     a, b, c on one line: is c on b's side of a?
///   is_inside(a, b, c, d) is d inside the circle of the counter-clockwise triangle a, b,
///                         c, ties broken canonically?
template <class G>
concept SegmentGeometry = requires(const G& g, Site v) {
  { g.orientation(v, v, v) } -> std::same_as<int>;
  { g.is_ahead(v, v, v) } -> std::same_as<bool>;
  { g.is_inside(v, v, v, v) } -> std::same_as<bool>;
};

/// One side of the cavity that the faces crossed by a segment leave: a polygon with
/// corners 0 .. size() - 1 counter-clockwise, the segment from the last to the first. An
/// edge that sticks into the cavity is two sides of the polygon.
///
/// Use: `begin`, `add` for each further corner, `look_around` while the crossed faces are
/// there, and `fill` once they are gone.
class CavitySide {
 public:
  void begin(Site corner) {
    node_.assign(1, corner);
    inner_.clear();
  }
  /// The next corner; `inner` is the crossed face's half-edge from the last one to it.
  void add(Site corner, HalfEdge inner) {
    node_.push_back(corner);
    inner_.push_back(inner);
  }
  [[nodiscard]] std::size_t size() const noexcept { return node_.size(); }

  /// Turns corners that came clockwise.
  void reverse();

  /// Notes what lies beyond the sides.
  void look_around(const ClosedMesh& mesh);

  /// Fills the polygon with constrained Delaunay faces and joins them to what lies
  /// around. Returns their half-edge along the segment, from the last corner to the
  /// first.
  ///
  /// Every corner sees the segment, which makes the choice of the apex over an edge easy:
  /// the corner whose circle through the edge's ends is empty. It leaves two polygons of
  /// the same kind. Cost: the number of corners times the depth of this division.
  ///
  /// Source: M. V. Anglada, Comput. Graph. 21 (1997) 215-223.
  template <SegmentGeometry G>
  HalfEdge fill(ClosedMesh& mesh, const G& g) {
    HalfEdge base = none;
    parts_.assign(1, {0, node_.size() - 1, none});
    while (!parts_.empty()) {
      const Part part = parts_.back();
      parts_.pop_back();
      if (part.last - part.first == 1) {
        attach(mesh, part.first, part.edge);
        continue;
      }
      const std::size_t apex = choose_apex(g, part.first, part.last);
      const std::int32_t f =
          mesh.add_face({node_[part.last], node_[part.first], node_[apex]});
      if (part.edge == none) {
        base = ClosedMesh::half_edge(f, 0);
      } else {
        mesh.join(part.edge, ClosedMesh::half_edge(f, 0));
      }
      parts_.push_back({part.first, apex, ClosedMesh::half_edge(f, 1)});
      parts_.push_back({apex, part.last, ClosedMesh::half_edge(f, 2)});
    }
    return base;
  }

 private:
  // The polygon of corners first .. last; `edge` is the half-edge on the other side of
  // its base.
  struct Part {
    std::size_t first, last;
    HalfEdge edge;
  };
  // What lies beyond a side: a half-edge that stays, or another side of the polygon.
  struct Around {
    HalfEdge outer = none, filled = none;
    bool is_constraint = false;
    std::size_t partner = no_partner;
  };
  static constexpr std::size_t no_partner = static_cast<std::size_t>(-1);

  template <SegmentGeometry G>
  [[nodiscard]] std::size_t choose_apex(const G& g, std::size_t first,
                                        std::size_t last) const {
    std::size_t best = first + 1;
    for (std::size_t i = first + 2; i < last; ++i) {
      if (node_[i] != node_[best] &&
          g.is_inside(node_[last], node_[first], node_[best], node_[i]))
        best = i;
    }
    return best;
  }

  void attach(ClosedMesh& mesh, std::size_t side, HalfEdge edge);
  void match_doubled_edges();

  std::vector<Site> node_;
  std::vector<HalfEdge> inner_;
  std::vector<Around> around_;
  std::vector<Part> parts_;
};

}  // namespace delone::delaunay
