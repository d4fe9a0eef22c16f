#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/closed_mesh.hpp"
#include "delaunay/error.hpp"
#include "delaunay/neighbor_batch.hpp"
#include "delaunay/path_neighbor.hpp"

namespace delone::delaunay {

/// What the search for paths needs to know about sites:
///   side(a, b, c)            exact orientation
///   distance(a, b)           rounded length of the straight piece of a path
///   least_distance(v, a, b)  at most `distance` from v to any site beyond the edge a-b,
///                            whatever rounding does
///   is_before(a, b)          the order of coordinates
template <class G>
concept SightGeometry = requires(const G& g, Site s) {
  { g.side(s, s, s) } -> std::same_as<int>;
  { g.distance(s, s) } -> std::same_as<double>;
  { g.least_distance(s, s, s) } -> std::same_as<double>;
  { g.is_before(s, s) } -> std::same_as<bool>;
};

/// The nodes in the order of their distances from one of them along paths that cross no
/// constraint: tripack/visible_neighbors.hpp and its counterpart in stripack, which say
/// what that means.
///
/// What a site sees is found sector by sector through the faces. On the sphere this needs
/// nothing of its own but an end: what is seen through an edge lies between two half
/// great circles that begin at the source and meet again opposite to it, less than pi
/// apart, so that two orientations say whether a site is there, at any distance; and a
/// way out of a face leads on if its edge has the source strictly on the inner side, for
/// a ray crosses the edge's great circle once before it ends, from that side. The
/// opposite point itself is on both circles; a face that has it for a corner shows it on
/// all rays.
template <SightGeometry G>
class VisibleSearch {
 public:
  /// `mesh`: a constrained triangulation whose convex hull, if it has a boundary, is
  /// closed by faces to the node after the last site; without faces if all sites are in
  /// line. `rows` of the sites and `sites` of the rows; all three must outlive this.
  VisibleSearch(const ClosedMesh& mesh, std::span<const Node> rows,
                std::span<const Site> sites, const G& geometry)
      : mesh_(mesh), rows_(rows), sites_(sites), geometry_(geometry) {}

  /// Throws Error if there is no such row.
  void start(Node row);
  /// Nothing once no more can be reached, and before `start`.
  [[nodiscard]] std::optional<PathNeighbor> next();
  /// The first k; fewer if no more can be reached. Throws Error for a k below 1.
  [[nodiscard]] std::vector<PathNeighbor> nearest(Node row, std::int32_t k);

 private:
  // A site as seen from `source`, come to in the sector of `arrival`, a half-edge that
  // leaves it.
  struct Arrival {
    double distance;
    Site site, source;
    HalfEdge arrival;
  };
  // What a source sees through `edge`, which has the source's side on its left: between
  // the rays through `right` and `left`.
  struct Sight {
    double least;  // no site beyond is nearer along this path
    double at_source;
    Site source, right, left;
    HalfEdge edge;
  };
  struct IsLater {
    G geometry;
    bool operator()(const Arrival& a, const Arrival& b) const {
      if (a.distance != b.distance) return a.distance > b.distance;
      return a.site != b.site ? geometry.is_before(b.site, a.site)
                              : geometry.is_before(b.source, a.source);
    }
  };
  struct IsFarther {
    bool operator()(const Sight& a, const Sight& b) const { return a.least > b.least; }
  };
  using Arrivals = std::priority_queue<Arrival, std::vector<Arrival>, IsLater>;
  using Sights = std::priority_queue<Sight, std::vector<Sight>, IsFarther>;

  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] Site num_sites() const { return static_cast<Site>(rows_.size()); }
  [[nodiscard]] bool is_outside(Site v) const { return v == num_sites(); }
  [[nodiscard]] bool is_turning_point(Site v) const;
  [[nodiscard]] HalfEdge sector_of(HalfEdge e) const;
  void begin(Site v);
  void arrive_at(Site v, Site source, double at_source, HalfEdge arrival);
  void arrive(Site source, double at_source, HalfEdge e);
  void look(Site source, double at_source, HalfEdge sector);
  void look_through(Sight sight);
  void look_on(const Sight& sight);
  void reach_all_in_line(Site v);

  const ClosedMesh& mesh_;
  std::span<const Node> rows_;
  std::span<const Site> sites_;
  G geometry_;
  Arrivals arrivals_{IsLater{geometry_}};
  Sights sights_{};
  std::unordered_set<HalfEdge> seen_from_{};  // sectors
  std::unordered_set<Site> reached_{};
};

template <SightGeometry G>
bool VisibleSearch<G>::is_turning_point(Site v) const {
  const HalfEdge first = mesh_.edge_at(v);
  HalfEdge e = first;
  do {
    if (mesh_.is_constraint(e)) return true;
    e = mesh_.next_around(e);
  } while (e != first);
  return false;
}

// The same for all faces of a sector: the wall that bounds it on the right, seen from the
// site.
template <SightGeometry G>
HalfEdge VisibleSearch<G>::sector_of(HalfEdge e) const {
  const HalfEdge first = e;
  while (!mesh_.is_constraint(e)) {
    e = mesh_.previous_around(e);
    if (e == first) return mesh_.edge_at(mesh_.origin(e));
  }
  return e;
}

template <SightGeometry G>
void VisibleSearch<G>::begin(Site v) {
  arrivals_ = Arrivals{IsLater{geometry_}};
  sights_ = {};
  seen_from_.clear();
  reached_ = {v};
  if (mesh_.num_faces() == 0) return reach_all_in_line(v);
  const HalfEdge first = mesh_.edge_at(v);
  HalfEdge e = first;
  do {
    look(v, 0, sector_of(e));
    e = mesh_.next_around(e);
  } while (e != first);
}

// Walls along the line are in nobody's way.
template <SightGeometry G>
void VisibleSearch<G>::reach_all_in_line(Site v) {
  for (Site w = 0; w < num_sites(); ++w) arrive_at(w, v, 0, none);
}

template <SightGeometry G>
void VisibleSearch<G>::arrive_at(Site v, Site source, double at_source,
                                 HalfEdge arrival) {
  arrivals_.push({at_source + geometry_.distance(source, v), v, source, arrival});
}

// At the origin of `e`, through the face on its left.
template <SightGeometry G>
void VisibleSearch<G>::arrive(Site source, double at_source, HalfEdge e) {
  const Site v = mesh_.origin(e);
  if (!is_outside(v)) arrive_at(v, source, at_source, e);
}

// From the source over the faces of a sector, those beyond the hull included: along the
// outer side of a wall there is a way, too.
template <SightGeometry G>
void VisibleSearch<G>::look(Site source, double at_source, HalfEdge sector) {
  if (!seen_from_.insert(sector).second) return;
  HalfEdge e = sector;
  do {
    const HalfEdge opposite = ClosedMesh::next(e);
    arrive(source, at_source, opposite);
    arrive(source, at_source, ClosedMesh::next(opposite));
    const Site right = mesh_.origin(opposite), left = mesh_.target(opposite);
    if (!is_outside(right) && !is_outside(left))
      look_through({at_source, at_source, source, right, left, opposite});
    e = mesh_.next_around(e);
  } while (e != sector && !mesh_.is_constraint(e));
}

template <SightGeometry G>
void VisibleSearch<G>::look_through(Sight sight) {
  const Site a = mesh_.origin(sight.edge), b = mesh_.target(sight.edge);
  if (mesh_.is_constraint(sight.edge)) return;
  if (is_outside(mesh_.apex(mesh_.reverse(sight.edge)))) return;
  if (geometry_.side(a, b, sight.source) <= 0) return;
  const double least = sight.at_source + geometry_.least_distance(sight.source, a, b);
  sight.least = std::max(sight.least, least);
  sights_.push(sight);
}

// Into the face beyond the edge. A site exactly on the ray of a site without walls is
// seen past that; one on the ray of a turning point is not: the path turns there, if only
// by nothing. On both rays is the opposite point alone.
template <SightGeometry G>
void VisibleSearch<G>::look_on(const Sight& sight) {
  const HalfEdge back = mesh_.reverse(sight.edge);
  const HalfEdge from_right = ClosedMesh::next(back),
                 to_left = ClosedMesh::previous(back);
  const Site x = mesh_.origin(to_left);
  const int of_right = geometry_.side(sight.source, sight.right, x);
  const int of_left = geometry_.side(sight.source, sight.left, x);
  if (of_right == 0 && of_left == 0)
    return arrive(sight.source, sight.at_source, to_left);
  const bool is_seen = of_right >= 0 && of_left <= 0 &&
                       (of_right != 0 || !is_turning_point(sight.right)) &&
                       (of_left != 0 || !is_turning_point(sight.left));
  if (is_seen) arrive(sight.source, sight.at_source, to_left);
  Sight right = sight, left = sight;
  right.edge = from_right;
  left.edge = to_left;
  if (of_left < 0 || is_seen) right.left = x;
  if (of_right > 0 || is_seen) left.right = x;
  if (of_right > 0) look_through(right);
  if (of_left < 0) look_through(left);
}

template <SightGeometry G>
std::optional<PathNeighbor> VisibleSearch<G>::next() {
  for (;;) {
    if (!sights_.empty() &&
        (arrivals_.empty() || sights_.top().least <= arrivals_.top().distance)) {
      const Sight sight = sights_.top();
      sights_.pop();
      look_on(sight);
      continue;
    }
    if (arrivals_.empty()) return std::nullopt;
    const Arrival found = arrivals_.top();
    arrivals_.pop();
    if (found.arrival != none && is_turning_point(found.site))
      look(found.site, found.distance, sector_of(found.arrival));
    if (!reached_.insert(found.site).second) continue;
    return PathNeighbor{rows_[at(found.site)], found.distance, rows_[at(found.source)]};
  }
}

template <SightGeometry G>
void VisibleSearch<G>::start(Node row) {
  if (row < 0 || std::cmp_greater_equal(row, sites_.size())) {
    throw Error("there is no row " + std::to_string(row) + "; the triangulation has " +
                    std::to_string(sites_.size()),
                {row});
  }
  begin(sites_[at(row)]);
}

template <SightGeometry G>
std::vector<PathNeighbor> VisibleSearch<G>::nearest(Node row, std::int32_t k) {
  check_num_neighbors(k);
  start(row);
  std::vector<PathNeighbor> result;
  while (std::cmp_less(result.size(), k)) {
    const auto found = next();
    if (!found) break;
    result.push_back(*found);
  }
  return result;
}

}  // namespace delone::delaunay
