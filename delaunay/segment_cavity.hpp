#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/closed_mesh.hpp"
#include "delaunay/options.hpp"

namespace delone::delaunay {

/// The Delaunay triangulation of some sites only; its site i is sites[i].
struct PartialTriangulation {
  Adjacency adjacency;
  std::vector<Site> sites;
};

/// By the room's Triangulation of the points `position(site)`. One thread, for it is a
/// part of an edit or of an insertion.
template <class Triangulation, class Position>
[[nodiscard]] PartialTriangulation triangulate_part(std::span<const Site> sites,
                                                    Position position) {
  std::vector<std::decay_t<decltype(position(sites[0]))>> points;
  points.reserve(sites.size());
  for (const Site v : sites) points.push_back(position(v));
  const Triangulation t(points, RunOptions{.num_threads = 1, .progress = {}});
  PartialTriangulation part{t.adjacency(), {}};
  part.sites.reserve(sites.size());
  for (const Node row : t.rows())
    part.sites.push_back(sites[static_cast<std::size_t>(row)]);
  return part;
}

/// What segments need to know about positions. For sites a, b, c, d:
///   orientation(a, b, c)  +1 left of a -> b, -1 right, 0 on its line; exact
///   is_ahead(a, b, c)     a, b, c on one line: is c on b's side of a?
///   is_inside(a, b, c, d) is d inside the circle of the counter-clockwise triangle a, b,
///                         c, ties broken canonically?
///   triangulate(sites)    these sites, different from one another, on their own
template <class G>
concept SegmentGeometry = requires(const G& g, Site v, std::span<const Site> sites) {
  { g.orientation(v, v, v) } -> std::same_as<int>;
  { g.is_ahead(v, v, v) } -> std::same_as<bool>;
  { g.is_inside(v, v, v, v) } -> std::same_as<bool>;
  { g.triangulate(sites) } -> std::same_as<PartialTriangulation>;
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
  /// the same kind. The number of corners times the depth of this division is what that
  /// costs. Where it comes to more than some 30 tests a corner, as between two chains
  /// that curve away from the segment, the corners are triangulated on their own instead:
  /// the polygon's faces are among those, provided that its sides are edges there. They
  /// are wherever no constraint is near, since an edge that is Delaunay among all sites
  /// is so among some; O(n log n) for n corners. Elsewhere the division goes on.
  ///
  /// Source: M. V. Anglada, Comput. Graph. 21 (1997) 215-223.
  template <SegmentGeometry G>
  HalfEdge fill(ClosedMesh& mesh, const G& g) {
    const std::size_t n = node_.size();
    if (!plan(g, n <= 64 ? n * n : 32 * n)) {
      if (find_among(g.triangulate(distinct_nodes()))) return fill_found(mesh);
      plan(g, n * n);
    }
    return fill_planned(mesh);
  }

 private:
  // The polygon of corners first .. last; `edge` is the half-edge on the other side of
  // its base.
  struct Part {
    std::size_t first, last;
    HalfEdge edge;
  };
  // A face of the polygon: the corners' sites, and what its edges are: numbers of sides,
  // or ~number of the face beyond and its edge, 4 * face + k.
  struct FoundFace {
    std::array<Site, 3> node;
    std::array<std::ptrdiff_t, 3> edge;
  };
  // What lies beyond a side: a half-edge that stays, or another side of the polygon.
  struct Around {
    HalfEdge outer = none, filled = none;
    bool is_constraint = false;
    std::size_t partner = no_partner;
  };
  static constexpr std::size_t no_partner = static_cast<std::size_t>(-1);

  // Chooses all apexes, first polygon first; false if that takes more than `budget`
  // tests.
  template <SegmentGeometry G>
  bool plan(const G& g, std::size_t budget) {
    apexes_.clear();
    parts_.assign(1, {0, node_.size() - 1, none});
    for (std::size_t spent = 0; !parts_.empty();) {
      const Part part = parts_.back();
      parts_.pop_back();
      if (part.last - part.first == 1) continue;
      spent += part.last - part.first;
      if (spent > budget) return false;
      const std::size_t apex = choose_apex(g, part.first, part.last);
      apexes_.push_back(apex);
      parts_.push_back({part.first, apex, none});
      parts_.push_back({apex, part.last, none});
    }
    return true;
  }
  HalfEdge fill_planned(ClosedMesh& mesh);
  [[nodiscard]] std::vector<Site> distinct_nodes() const;
  bool find_among(const PartialTriangulation& t);
  HalfEdge fill_found(ClosedMesh& mesh);

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
  std::vector<std::size_t> apexes_;
  std::vector<FoundFace> found_;
};

}  // namespace delone::delaunay
