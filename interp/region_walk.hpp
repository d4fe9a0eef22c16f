#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

#include "delaunay/parallel.hpp"
#include "interp/region_integral.hpp"
#include "interp/region_side.hpp"

namespace delone::interp {

/// A side of a region through an edge, named by the arc from its smaller site.
struct RegionCrossing {
  std::int32_t edge = none;  ///< index of the arc
  Site from = none;          ///< its origin
  double place = 0;          ///< 0 at the smaller site, 1 at the larger
  int step = 0;              ///< along the arc: +1 into the region, -1 out of it
};

/// An end of a piece: a corner of the region, or a place on an edge.
struct RegionPieceEnd {
  std::int32_t corner = none;
  Arc edge{};
  double place = 0;
};

/// What of a side lies in one triangle, named by the arc that leaves its smallest site.
struct RegionPiece {
  Arc triangle;
  RegionPieceEnd from, to;
};

struct RegionTrace {
  std::vector<RegionPiece> pieces;        ///< by triangles
  std::vector<RegionCrossing> crossings;  ///< by edges, and along them
};

/// The hull's edges in boxes.
template <class Triangulation>
class HullEdges {
 public:
  HullEdges() = default;
  /// `boundary_site`: a site of the hull.
  HullEdges(const Triangulation& t, Site boundary_site) {
    const Adjacency& adjacency = t.adjacency();
    Site s = boundary_site;
    do {
      arcs_.push_back(adjacency.first_arc(s));
      s = adjacency.target(arcs_.back());
    } while (s != boundary_site);
    size_ = std::max<std::size_t>(
        8, static_cast<std::size_t>(std::sqrt(static_cast<double>(arcs_.size()))));
    for (std::size_t i = 0; i < arcs_.size(); i += size_) boxes_.push_back(box_of(t, i));
  }

  /// `f(arc)` for edges that a side from a to b may meet, the inside on the left.
  template <class Point, class F>
  void visit(const Point& a, const Point& b, F f) const {
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      if (!may_meet(boxes_[k], a, b)) continue;
      const std::size_t end = std::min(arcs_.size(), (k + 1) * size_);
      for (std::size_t i = k * size_; i < end; ++i) f(arcs_[i]);
    }
  }

 private:
  [[nodiscard]] HullBox box_of(const Triangulation& t, std::size_t begin) const {
    HullBox box;
    box.low = box.high = coordinates(t.points()[at(arcs_[begin].origin)]);
    const std::size_t end = std::min(arcs_.size(), begin + size_);
    for (std::size_t i = begin; i < end; ++i) {
      const auto p = coordinates(t.points()[at(t.adjacency().target(arcs_[i]))]);
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], p[k]);
        box.high[k] = std::max(box.high[k], p[k]);
      }
    }
    return box;
  }

  std::vector<Arc> arcs_;
  std::vector<HullBox> boxes_;
  std::size_t size_ = 8;
};

/// Follows the boundary of a region through the triangles, exactly.
template <class Triangulation, class Point>
class RegionWalk {
 public:
  RegionWalk(const Triangulation& t, const RegionBoundary<Point>& region,
             const RunOptions& run)
      : t_(t), adjacency_(t.adjacency()), region_(region) {
    find_corners(run);
    const auto outside =
        std::ranges::find_if(holders_, [&](Arc a) { return !adjacency_.has_left(a); });
    if (outside != holders_.end()) hull_ = HullEdges<Triangulation>(t, outside->origin);
  }

  [[nodiscard]] RegionTrace trace(const RunOptions& run) const {
    constexpr std::int64_t chunk = 256;
    const auto num_sides = static_cast<std::int64_t>(region_.sides.size());
    std::vector<RegionTrace> parts(at((num_sides + chunk - 1) / chunk));
    delaunay::parallel_chunks(num_sides, chunk, run,
                              [&](std::int64_t first, std::int64_t last) {
                                for (std::int64_t i = first; i < last; ++i)
                                  follow(region_.sides[at(i)], parts[at(first / chunk)]);
                              },
                              {0.2, 0.4});
    return joined(parts);
  }

 private:
  [[nodiscard]] const Point& node(Site s) const noexcept { return t_.points()[at(s)]; }
  [[nodiscard]] const Point& corner(std::int32_t c) const noexcept {
    return region_.corners[at(c)];
  }
  /// The next arc around the triangle on the left.
  [[nodiscard]] Arc next_side(Arc a) const noexcept {
    return adjacency_.previous(adjacency_.reverse(a));
  }

  void find_corners(const RunOptions& run) {
    constexpr std::int64_t chunk = 1024;
    holders_.resize(region_.corners.size());
    delaunay::parallel_chunks(static_cast<std::int64_t>(holders_.size()), chunk, run,
                              [&](std::int64_t first, std::int64_t last) {
                                Arc hint;
                                for (std::int64_t i = first; i < last; ++i)
                                  hint = holders_[at(i)] =
                                      holder(region_.corners[at(i)], hint);
                              },
                              {0, 0.2});
  }

  // From the closed triangle that holds the corner to the one that holds it as moved: a
  // step or two about a node.
  [[nodiscard]] Arc holder(const Point& p, Arc hint) const {
    Arc a = t_.find(p, hint);
    for (int num_inside = 0; num_inside < 3 && adjacency_.has_left(a);) {
      if (side_of_corner(node(a.origin), node(adjacency_.target(a)), p) > 0) {
        a = next_side(a);
        ++num_inside;
      } else {
        a = adjacency_.reverse(a);
        num_inside = 0;
      }
    }
    return a;
  }

  // Of the sides of a triangle that a region's side passes two, it leaves by the one that
  // leads from its right to its left.
  [[nodiscard]] bool leaves_by(Arc a, const Point& from, const Point& to) const {
    return side_of_node(from, to, node(a.origin)) < 0 &&
           side_of_node(from, to, node(adjacency_.target(a))) > 0;
  }

  // Nothing if the side does not reach the hull.
  [[nodiscard]] Arc entry(const Point& from, const Point& to) const {
    Arc found;
    hull_.visit(from, to, [&](Arc a) {
      const Point &u = node(a.origin), &v = node(adjacency_.target(a));
      if (found.origin == none && side_of_node(from, to, u) > 0 &&
          side_of_node(from, to, v) < 0 && side_of_corner(u, v, from) < 0 &&
          side_of_corner(u, v, to) > 0)
        found = a;
    });
    return found;
  }

  /// Through an edge of the triangle on the left of `a`: out of it, or into it.
  RegionPieceEnd cross(Arc a, const Point& from, const Point& to, int step,
                       RegionTrace& trace) const {
    if (adjacency_.target(a) < a.origin) {
      a = adjacency_.reverse(a);
      step = -step;
    }
    const double place =
        place_of_crossing(from, to, node(a.origin), node(adjacency_.target(a)));
    trace.crossings.push_back({a.index, a.origin, place, step});
    return {none, a, place};
  }

  void follow(const std::array<std::int32_t, 2>& side, RegionTrace& trace) const {
    const Point &from = corner(side[0]), &to = corner(side[1]);
    RegionPieceEnd begin{.corner = side[0]};
    Arc a = holders_[at(side[0])];
    if (adjacency_.has_left(a)) {
      for (int k = 0; k < 2 && !leaves_by(a, from, to); ++k) a = next_side(a);
    } else {
      a = entry(from, to);
      if (a.origin == none) return;
      begin = cross(a, from, to, -1, trace);
      a = exit_opposite(a, from, to);
    }
    // `a` is where the side leaves the triangle, if it does.
    while (side_of_corner(node(a.origin), node(adjacency_.target(a)), to) < 0) {
      const RegionPieceEnd end = cross(a, from, to, 1, trace);
      trace.pieces.push_back({from_smallest_corner(adjacency_, a), begin, end});
      a = adjacency_.reverse(a);
      if (!adjacency_.has_left(a)) return;
      begin = end;
      a = exit_opposite(a, from, to);
    }
    trace.pieces.push_back(
        {from_smallest_corner(adjacency_, a), begin, {.corner = side[1]}});
  }

  // Entered through a, whose origin is on the left of the region's side.
  [[nodiscard]] Arc exit_opposite(Arc a, const Point& from, const Point& to) const {
    const Arc second = next_side(a);
    return side_of_node(from, to, node(adjacency_.target(second))) > 0
               ? second
               : next_side(second);
  }

  [[nodiscard]] static RegionTrace joined(std::vector<RegionTrace>& parts) {
    RegionTrace all;
    for (RegionTrace& part : parts) {
      std::ranges::move(part.pieces, std::back_inserter(all.pieces));
      std::ranges::move(part.crossings, std::back_inserter(all.crossings));
    }
    std::ranges::stable_sort(all.pieces, {}, [](const RegionPiece& p) {
      return std::pair(p.triangle.origin, p.triangle.index);
    });
    std::ranges::stable_sort(all.crossings, {}, [](const RegionCrossing& c) {
      return std::pair(c.edge, c.place);
    });
    return all;
  }

  const Triangulation& t_;
  const Adjacency& adjacency_;
  const RegionBoundary<Point>& region_;
  std::vector<Arc> holders_;  // of every corner
  HullEdges<Triangulation> hull_;
};

/// The way from a node to a corner of the region, and what it meets.
template <class Point>
class WayToCorner {
 public:
  using Side = std::array<std::int32_t, 2>;

  WayToCorner(const RegionBoundary<Point>& region, const Point& node)
      : region_(region), node_(node) {
    for (const Side& side : region.sides) {
      goal_ = side[0];
      if (!are_opposite(corner(goal_), node)) break;
    }
  }

  [[nodiscard]] bool ends_at(const Side& side) const noexcept {
    return side[0] == goal_ || side[1] == goal_;
  }
  [[nodiscard]] bool crosses(const Side& side) const {
    const Point &a = corner(side[0]), &b = corner(side[1]), &goal = corner(goal_);
    const int from = side_of_node(a, b, node_), to = orientation(a, b, goal),
              left = side_of_node(goal, a, node_), right = side_of_node(goal, b, node_);
    return from == -to && left == -right && from == -left;
  }
  /// Of two sides at the goal, does a come first, counter-clockwise from the way?
  [[nodiscard]] bool is_before(const Side& a, const Side& b) const {
    const Point &p = other_end(a), &q = other_end(b), &goal = corner(goal_);
    const int half_p = side_of_node(p, goal, node_),
              half_q = side_of_node(q, goal, node_);
    return half_p != half_q ? half_p > 0 : orientation(goal, p, q) > 0;
  }
  /// Is what lies clockwise of a side at the goal inside?
  [[nodiscard]] bool is_inside_before(const Side& side) const noexcept {
    return side[1] == goal_;
  }

 private:
  [[nodiscard]] const Point& corner(std::int32_t c) const noexcept {
    return region_.corners[at(c)];
  }
  [[nodiscard]] const Point& other_end(const Side& side) const noexcept {
    return corner(side[0] == goal_ ? side[1] : side[0]);
  }

  const RegionBoundary<Point>& region_;
  const Point& node_;
  std::int32_t goal_ = none;
};

/// Is a node inside the region, as moved? Exact; O(sides).
///
/// Counts the sides that the way from the node to a corner crosses, and looks between
/// which of the corner's own sides it arrives.
template <class Point>
[[nodiscard]] bool is_inside_region(const RegionBoundary<Point>& region,
                                    const Point& node) {
  if (region.sides.empty()) return false;
  const WayToCorner<Point> way(region, node);
  const std::array<std::int32_t, 2>* first = nullptr;
  bool is_even = true;
  for (const auto& side : region.sides) {
    if (!way.ends_at(side)) {
      is_even = is_even != way.crosses(side);
    } else if (first == nullptr || way.is_before(side, *first)) {
      first = &side;
    }
  }
  return way.is_inside_before(*first) == is_even;
}

}  // namespace delone::interp
