#include "tripack/voronoi.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "delaunay/error.hpp"
#include "delaunay/parallel.hpp"
#include "tripack/circumcenter.hpp"
#include "tripack/predicates.hpp"
#include "tripack/voronoi_cell.hpp"

namespace delone::tripack {

namespace {

using delaunay::CellTable;
using delaunay::DoubleDouble;
using delaunay::none;
using delaunay::TriangleNumbers;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

Point2 circumcenter(Point2 a, Point2 b, Point2 c) {
  const WidePoint2 offset = circumcenter_offset_wide(a, b, c);
  return {(offset.x + DoubleDouble{a.x, 0}).rounded(),
          (offset.y + DoubleDouble{a.y, 0}).rounded()};
}

Point2 turned_right(Point2 from, Point2 to) { return {to.y - from.y, from.x - to.x}; }
Point2 turned_left(Point2 from, Point2 to) { return {from.y - to.y, to.x - from.x}; }

}  // namespace

Voronoi::Voronoi(std::shared_ptr<const Triangulation> triangulation,
                 const RunOptions& options)
    : triangulation_(std::move(triangulation)) {
  const Adjacency& t = triangulation_->adjacency();
  const auto point = [&](Site s) { return triangulation_->points()[at(s)]; };
  const TriangleNumbers numbers = delaunay::number_triangles(t);
  delaunay::VertexSets sets(numbers.arcs.size());
  delaunay::unite_ties(t, numbers, sets, [&](Arc arc) {
    const auto [a, b, c] = t.left(arc);
    const Site d = t.target(t.next(t.reverse(arc)));
    return in_circle(point(a), point(b), point(c), point(d)) == 0;
  });
  const auto [vertex_of_triangle, first_triangles] = sets.number();
  place_vertices(numbers, first_triangles, options);
  vertex_of_arc_.resize(numbers.of_arc.size());
  for (std::size_t i = 0; i < vertex_of_arc_.size(); ++i) {
    const std::int32_t triangle = numbers.of_arc[i];
    vertex_of_arc_[i] = triangle == none ? none : vertex_of_triangle[at(triangle)];
  }
  gather_cells(numbers);
}

void Voronoi::place_vertices(const TriangleNumbers& numbers,
                             const std::vector<std::int32_t>& first_triangles,
                             const RunOptions& options) {
  constexpr std::int64_t chunk = 4096;
  vertices_.resize(first_triangles.size());
  const auto place = [&](std::int64_t first, std::int64_t last) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last);
         ++i) {
      const Arc arc = numbers.arcs[at(first_triangles[i])];
      const auto [a, b, c] = triangulation_->adjacency().left(arc);
      const auto points = triangulation_->points();
      vertices_[i] = circumcenter(points[at(a)], points[at(b)], points[at(c)]);
    }
  };
  delaunay::parallel_chunks(static_cast<std::int64_t>(vertices_.size()), chunk, options,
                            place);
}

void Voronoi::gather_cells(const TriangleNumbers& numbers) {
  const Adjacency& t = triangulation_->adjacency();
  cells_.reserve(at(t.num_sites()), numbers.of_arc.size());
  std::vector<std::int32_t> ring;
  for (Site s = 0; s < t.num_sites(); ++s) {
    ring.clear();
    const std::int32_t degree = t.degree(s);
    for (std::int32_t k = 0; k < degree; ++k) {
      const std::int32_t vertex = vertex_of_arc_[at(t.first_arc(s).index + k)];
      if (vertex != none) ring.push_back(vertex);
    }
    cells_.append(ring, is_bounded(s) ? CellTable::Ring::closed : CellTable::Ring::open);
  }
}

std::array<Point2, 2> Voronoi::rays(Site s) const noexcept {
  const auto points = triangulation_->points();
  const auto neighbors = triangulation_->adjacency().neighbors(s);
  const Point2 p = points[at(s)], next = points[at(neighbors.front())],
               previous = points[at(neighbors.back())];
  return {turned_right(p, next), turned_right(previous, p)};
}

Polygon Voronoi::polygon(Site s) const {
  Polygon result;
  if (!is_bounded(s)) return result;
  for (const std::int32_t v : cell(s)) result.push_back(vertices_[at(v)]);
  return result;
}

std::vector<Polygon> Voronoi::clipped(Site s, const Region& region) const {
  Polygon whole = polygon(s);
  Region::Relation relation = Region::Relation::crossing;
  if (!whole.empty() && !region.is_plane()) {
    Point2 low = whole[0], high = whole[0];
    for (const Point2 p : whole) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    relation = region.relation(low, high);
  }
  if (relation == Region::Relation::outside) return {};
  std::vector<Polygon> parts;
  if (region.is_plane() || relation == Region::Relation::inside) {
    if (!whole.empty()) parts.push_back(std::move(whole));
    return parts;
  }
  const Point2 p = triangulation_->points()[at(s)];
  parts = cut_cell(*triangulation_, s, region);
  for (Polygon& part : parts) {
    for (Point2& corner : part) corner = {corner.x + p.x, corner.y + p.y};
    part.erase(std::unique(part.begin(), part.end()), part.end());
  }
  return parts;
}

std::vector<VoronoiEdge> Voronoi::edges() const {
  const Adjacency& t = triangulation_->adjacency();
  const auto points = triangulation_->points();
  std::vector<VoronoiEdge> result;
  for (Site s = 0; s < t.num_sites(); ++s) {
    Arc arc = s < t.num_sites() && t.degree(s) > 0 ? t.first_arc(s) : Arc{};
    for (std::int32_t k = 0; k < t.degree(s); ++k, arc = t.next(arc)) {
      const Site other = t.target(arc);
      if (other < s) continue;
      const std::int32_t to = vertex_of_arc_[at(arc.index)],
                         from = vertex_of_arc_[at(t.reverse(arc).index)];
      if (from == to && from != none) continue;
      result.push_back(
          {{s, other}, {from, to}, turned_left(points[at(s)], points[at(other)])});
    }
  }
  return result;
}

Polygon voronoi_polygon(Point2 site, std::span<const Point2> neighbors) {
  if (neighbors.size() < 3) throw Error("a bounded cell needs at least three neighbours");
  Polygon result;
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    const std::size_t j = (i + 1) % neighbors.size();
    if (orientation(site, neighbors[i], neighbors[j]) <= 0) {
      throw Error("neighbours " + std::to_string(i) + " and " + std::to_string(j) +
                      " do not turn left round the site; list them counter-clockwise",
                  {static_cast<std::int64_t>(i), static_cast<std::int64_t>(j)});
    }
    result.push_back(circumcenter(site, neighbors[i], neighbors[j]));
  }
  return result;
}

CellMeasure voronoi_measure(Point2 site, std::span<const Point2> neighbors) {
  const Polygon cell = voronoi_polygon(site, neighbors);
  return {signed_area(cell), centroid(cell)};
}

}  // namespace delone::tripack
