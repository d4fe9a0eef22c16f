#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "interp/region_walk.hpp"
#include "interp/triangle_integral.hpp"
#include "interp/triangle_nodes.hpp"

namespace delone::interp {

/// Which nodes are inside a region, from where its sides cross edges.
///
/// Along an edge the crossings' steps in and out add up to the difference of its ends, in
/// whatever order they are. So all nodes are known from one.
class InsideNodes {
 public:
  template <class Triangulation, class Point>
  InsideNodes(const Triangulation& t, const RegionBoundary<Point>& region,
              std::span<const RegionCrossing> crossings)
      : is_inside_(at(t.num_sites())), has_crossings_(at(t.num_sites())) {
    const Adjacency& adjacency = t.adjacency();
    add_edges(crossings);
    std::vector<Site> open = ends_inside(adjacency);
    if (open.empty() && is_inside_region(region, t.points()[0])) open.push_back(0);
    for (const Site s : open) is_inside_[at(s)] = true;
    while (!open.empty()) {
      const Site s = open.back();
      open.pop_back();
      Arc a = adjacency.first_arc(s);
      for (std::int32_t i = 0; i < adjacency.degree(s); ++i, a = adjacency.next(a)) {
        const Site w = adjacency.target(a);
        if (is_inside_[at(w)] || step_along(adjacency, a) != 0) continue;
        is_inside_[at(w)] = true;
        open.push_back(w);
      }
    }
  }

  [[nodiscard]] bool operator[](Site s) const noexcept { return is_inside_[at(s)]; }

 private:
  struct Edge {
    std::int32_t index;  // of the arc from its smaller site
    Site from;
    int step;
  };

  void add_edges(std::span<const RegionCrossing> crossings) {
    for (const RegionCrossing& c : crossings) {
      if (edges_.empty() || edges_.back().index != c.edge)
        edges_.push_back({c.edge, c.from, 0});
      edges_.back().step += c.step;
    }
  }

  // Of edges with one end inside. Marks the ends of all edges that are crossed.
  [[nodiscard]] std::vector<Site> ends_inside(const Adjacency& t) {
    std::vector<Site> inside;
    for (const Edge& edge : edges_) {
      const Site to = t.target({edge.from, edge.index});
      has_crossings_[at(edge.from)] = has_crossings_[at(to)] = true;
      if (edge.step != 0) inside.push_back(edge.step > 0 ? to : edge.from);
    }
    return inside;
  }

  [[nodiscard]] int step_along(const Adjacency& t, Arc a) const noexcept {
    const Site w = t.target(a);
    if (!has_crossings_[at(a.origin)] || !has_crossings_[at(w)]) return 0;
    const std::int32_t index = w < a.origin ? t.reverse(a).index : a.index;
    const auto edge = std::ranges::lower_bound(edges_, index, {}, &Edge::index);
    return edge != edges_.end() && edge->index == index ? edge->step : 0;
  }

  std::vector<bool> is_inside_, has_crossings_;
  std::vector<Edge> edges_;
};

/// What areas count, in the plane: nothing but themselves.
struct PlaneArea {
  [[nodiscard]] double operator()(const Point2&) const noexcept { return 1; }
};

/// On the sphere: what a steradian of directions about p is.
class SphereArea {
 public:
  explicit SphereArea(AreaUnit unit) noexcept : unit_(unit) {}
  [[nodiscard]] double operator()(const Vector3& p) const noexcept;

 private:
  AreaUnit unit_;
};

[[nodiscard]] inline RegionIntegral operator+(const RegionIntegral& a,
                                              const RegionIntegral& b) noexcept {
  return {a.integral + b.integral, a.area + b.area};
}
[[nodiscard]] inline RegionIntegral operator*(double s,
                                              const RegionIntegral& a) noexcept {
  return {s * a.integral, s * a.area};
}

/// Integrals of a surface over the parts of triangles in a region.
///
/// A part is the sum of signed triangles from one point of it to the pieces of its
/// boundary: sides of the region in the triangle, and edges between their crossings, as
/// often as they are inside. Rounded places need no order to be right: the sum is linear
/// in them. Positions count from the triangle's first corner, so small regions far from
/// the origin keep their digits.
template <BlendSpace Space, class Cells, class Area>
class RegionSum {
 public:
  using Vector = typename Space::Vector;
  using Point = typename Space::Point;

  RegionSum(const Space& space, const Cells& cells, const RegionBoundary<Point>& region,
            Area area, const RunOptions& run)
      : space_(space),
        cells_(cells),
        t_(cells.triangulation()),
        region_(region),
        area_(area),
        trace_(RegionWalk(t_, region, run).trace(run)),
        is_inside_(t_, region, trace_.crossings) {
    for (std::size_t i = 0; i < trace_.pieces.size(); ++i) {
      if (i == 0 || trace_.pieces[i].triangle != trace_.pieces[i - 1].triangle)
        firsts_.push_back(i);
    }
    firsts_.push_back(trace_.pieces.size());
  }

  [[nodiscard]] RegionIntegral operator()(const RunOptions& run) const {
    const RegionIntegral sum = over_whole(run) + over_cut(run);
    return (1 / space_.scale) * ((1 / space_.scale) * sum);
  }

 private:
  struct Segment {
    Vector from, to;
    int count = 1;  ///< negative: the other way
  };

  [[nodiscard]] RegionIntegral over_whole(const RunOptions& run) const {
    const Adjacency& t = t_.adjacency();
    return sum_of_chunks(t_.num_sites(), 1024, run, {0.4, 0.8}, [&](std::int64_t i) {
      RegionIntegral sum;
      const auto s = static_cast<Site>(i);
      if (!is_inside_[s]) return sum;
      for_each_triangle(t, s, s + 1, [&](Arc a) {
        const std::array<Site, 3> c = t.left(a);
        if (is_inside_[c[1]] && is_inside_[c[2]] && !is_cut(a))
          sum = sum + integral_over(a);
      });
      return sum;
    });
  }

  [[nodiscard]] RegionIntegral over_cut(const RunOptions& run) const {
    return sum_of_chunks(static_cast<std::int64_t>(firsts_.size()) - 1, 64, run, {0.8, 1},
                         [&](std::int64_t i) { return over_cut_triangle(at(i)); });
  }

  template <class F>
  [[nodiscard]] static RegionIntegral sum_of_chunks(std::int64_t count,
                                                    std::int64_t chunk,
                                                    const RunOptions& run,
                                                    delaunay::ProgressSpan progress,
                                                    F f) {
    std::vector<RegionIntegral> parts(at((count + chunk - 1) / chunk));
    delaunay::parallel_chunks(
        count, chunk, run,
        [&](std::int64_t first, std::int64_t last) {
          RegionIntegral sum;
          for (std::int64_t i = first; i < last; ++i) sum = sum + f(i);
          parts[at(first / chunk)] = sum;
        },
        progress);
    RegionIntegral total;
    for (const RegionIntegral& part : parts) total = total + part;
    return total;
  }

  [[nodiscard]] bool is_cut(Arc triangle) const noexcept {
    const auto first = std::ranges::lower_bound(
        firsts_.begin(), firsts_.end() - 1, triangle.index, {},
        [&](std::size_t i) { return trace_.pieces[i].triangle.index; });
    return first != firsts_.end() - 1 && trace_.pieces[*first].triangle == triangle;
  }

  [[nodiscard]] Vector node(Site s) const noexcept {
    return space_.vector(t_.points()[at(s)]);
  }

  [[nodiscard]] RegionIntegral integral_over(Arc triangle) const {
    const std::array<Site, 3> c = t_.adjacency().left(triangle);
    const Vector origin = node(c[0]);
    return integral(triangle, origin,
                    {Vector{}, Space::difference(node(c[1]), origin),
                     Space::difference(node(c[2]), origin)});
  }

  /// Corners count from the origin.
  [[nodiscard]] RegionIntegral integral(Arc triangle, Vector origin,
                                        const std::array<Vector, 3>& corners) const {
    const auto facet = cells_.facet(triangle);
    return integral_over_triangle(Space{}, origin, corners, [&](const Vector& q) {
      const double area = area_(q);
      return RegionIntegral{area * facet(q), area};
    });
  }

  [[nodiscard]] Vector position(const RegionPieceEnd& end, Vector origin) const {
    if (end.corner != none)
      return Space::difference(space_.vector(region_.corners[at(end.corner)]), origin);
    return position(end.edge, end.place, origin);
  }
  [[nodiscard]] Vector position(Arc edge, double place, Vector origin) const {
    const Vector from = node(edge.origin), to = node(t_.adjacency().target(edge));
    return sum_of(Space::difference(from, origin),
                  part_of(Space::difference(to, from), place));
  }
  static Point2 sum_of(Point2 a, Point2 b) noexcept { return {a.x + b.x, a.y + b.y}; }
  static Vector3 sum_of(Vector3 a, Vector3 b) noexcept { return a + b; }
  static Point2 part_of(Point2 a, double part) noexcept {
    return {part * a.x, part * a.y};
  }
  static Vector3 part_of(Vector3 a, double part) noexcept { return part * a; }

  [[nodiscard]] RegionIntegral over_cut_triangle(std::size_t number) const {
    const std::span pieces(
        trace_.pieces.begin() + static_cast<std::ptrdiff_t>(firsts_[number]),
        firsts_[number + 1] - firsts_[number]);
    const Arc triangle = pieces[0].triangle;
    const Vector origin = node(triangle.origin);
    std::vector<Segment> segments;
    for (const RegionPiece& piece : pieces)
      segments.push_back({position(piece.from, origin), position(piece.to, origin)});
    const Vector apex = segments[0].from;
    Arc a = triangle;
    for (int k = 0; k < 3; ++k) {
      add_edge(segments, a, origin);
      a = t_.adjacency().previous(t_.adjacency().reverse(a));
    }
    RegionIntegral sum;
    for (const Segment& s : segments)
      sum = sum + s.count * integral(triangle, origin, {apex, s.from, s.to});
    return sum;
  }

  // What of the triangle's edge is inside the region.
  void add_edge(std::vector<Segment>& segments, Arc a, Vector origin) const {
    const Site target = t_.adjacency().target(a);
    const bool is_forward = a.origin < target;
    const Arc edge = is_forward ? a : t_.adjacency().reverse(a);
    const auto& crossings = trace_.crossings;
    auto crossing =
        std::ranges::lower_bound(crossings, edge.index, {}, &RegionCrossing::edge);
    int inside = is_inside_[edge.origin] ? 1 : 0;
    Vector from = position(edge, 0, origin);
    const auto add_until = [&](Vector to) {
      if (inside != 0) segments.push_back({from, to, is_forward ? inside : -inside});
      from = to;
    };
    for (; crossing != crossings.end() && crossing->edge == edge.index; ++crossing) {
      add_until(position(edge, crossing->place, origin));
      inside += crossing->step;
    }
    add_until(Space::difference(node(t_.adjacency().target(edge)), origin));
  }

  const Space& space_;
  const Cells& cells_;
  const typename Space::Triangulation& t_;
  const RegionBoundary<Point>& region_;
  Area area_;
  RegionTrace trace_;
  InsideNodes is_inside_;
  std::vector<std::size_t> firsts_;  // piece of every cut triangle, and their number
};

/// The integral of a surface over a region.
template <BlendSpace Space, class Cells, class Region, class Area>
[[nodiscard]] RegionIntegral integral_over_region(const Space& space, const Cells& cells,
                                                  const Region& region, Area area,
                                                  const RunOptions& run) {
  if (cells.triangulation().dimension() < 2) return {};
  if (region.is_everything()) {
    return integral_over_triangles(space, cells, run,
                                   [&](const auto& facet, const auto& q) {
                                     const double size = area(q);
                                     return RegionIntegral{size * facet(q), size};
                                   });
  }
  return RegionSum(space, cells, region.boundary(), area, run)(run);
}

}  // namespace delone::interp
