#include "stripack/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "delaunay/parallel.hpp"
#include "stripack/local_frame.hpp"
#include "stripack/predicates.hpp"
#include "stripack/voronoi_cell.hpp"

namespace delone::stripack {

namespace {

using delaunay::CellTable;
using delaunay::none;
using delaunay::TriangleNumbers;
using Corners = std::array<Site, 3>;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Seen from the corner whose angle has the largest sine, the one across from the longest
// side.
Direction circumcenter(std::span<const Direction> points, const Corners& face) {
  std::array<double, 3> squares{};
  for (std::size_t i = 0; i < 3; ++i) {
    const SpaceVector d =
        vector(points[at(face[(i + 1) % 3])]) - vector(points[at(face[(i + 2) % 3])]);
    squares[i] = dot(d, d);
  }
  const auto k = static_cast<std::size_t>(
      std::max_element(squares.begin(), squares.end()) - squares.begin());
  const Direction &b = points[at(face[(k + 1) % 3])], &c = points[at(face[(k + 2) % 3])];
  const LocalFrame frame(points[at(face[k])]);
  return frame.direction(frame.circumcenter(b, c, frame.spoke(b), frame.spoke(c)));
}

/// Every face of the polyhedron, front and back, the vertex it belongs to, and for each
/// site the vertices between its neighbours.
class FaceVertices {
 public:
  explicit FaceVertices(const Triangulation& t)
      : t_(t), back_(t), numbers_(delaunay::number_triangles(t.adjacency())) {
    delaunay::VertexSets front(numbers_.arcs.size());
    delaunay::unite_ties(t.adjacency(), numbers_, front, [&](Arc arc) {
      const auto [a, b, c] = t.adjacency().left(arc);
      const Site d = t.adjacency().target(t.adjacency().next(t.adjacency().reverse(arc)));
      return in_circle(point(a), point(b), point(c), point(d)) == 0;
    });
    front_ = front.number();
    behind_ = unite_back();
  }

  [[nodiscard]] const BackFaces& back() const noexcept { return back_; }
  [[nodiscard]] std::int32_t num_front() const noexcept {
    return static_cast<std::int32_t>(front_.first_triangle.size());
  }
  [[nodiscard]] std::int32_t size() const noexcept {
    return num_front() + static_cast<std::int32_t>(behind_.first_triangle.size());
  }
  [[nodiscard]] Corners corners(std::int32_t vertex) const {
    if (vertex >= num_front())
      return back_.faces()[at(behind_.first_triangle[at(vertex - num_front())])];
    const std::int32_t triangle = front_.first_triangle[at(vertex)];
    return t_.adjacency().left(numbers_.arcs[at(triangle)]);
  }

  /// The vertex between each neighbour of the cell and the next.
  [[nodiscard]] std::vector<std::int32_t> ring(Site s) const {
    std::vector<std::int32_t> result;
    const std::int32_t first = t_.adjacency().first_arc(s).index;
    for (std::int32_t k = 0; k < t_.adjacency().degree(s); ++k) {
      const std::int32_t triangle = numbers_.of_arc[at(first + k)];
      if (triangle != none) result.push_back(front_.of_triangle[at(triangle)]);
    }
    for (const std::int32_t face : back_.faces_at(s))
      result.push_back(num_front() + behind_.of_triangle[at(face)]);
    return result;
  }

 private:
  [[nodiscard]] const Direction& point(Site s) const { return t_.points()[at(s)]; }

  delaunay::VertexSets::Numbering unite_back() const {
    delaunay::VertexSets sets(back_.faces().size());
    for (Site s = 0; s < t_.num_sites() && !back_.faces().empty(); ++s) {
      const auto faces = back_.faces_at(s);
      const auto inner = back_.neighbors(s);
      if (inner.empty()) continue;
      const auto listed = t_.adjacency().neighbors(s);
      for (std::size_t k = 0; k < inner.size(); ++k) {
        const Site before = k == 0 ? listed.back() : inner[k - 1],
                   after = k + 1 == inner.size() ? listed.front() : inner[k + 1];
        if (in_circle(point(s), point(before), point(inner[k]), point(after)) == 0)
          sets.unite(faces[k], faces[k + 1]);
      }
    }
    return sets.number();
  }

  const Triangulation& t_;
  BackFaces back_;
  TriangleNumbers numbers_;
  delaunay::VertexSets::Numbering front_, behind_;
};

// The arc of an edge in steps no longer than max_step, its end left out.
void append_arc(std::vector<Direction>& outline, const LocalFrame& frame,
                const Bisector& bisector, Bisector::Place from, double length,
                double max_step) {
  const double num_steps = std::max(1.0, std::ceil(length / max_step));
  for (double k = 1; k < num_steps; ++k) {
    const double angle = length * k / num_steps, c = std::cos(angle), s = std::sin(angle);
    outline.push_back(frame.direction(
        bisector.point({from.cos * c - from.sin * s, from.sin * c + from.cos * s})));
  }
}

}  // namespace

Voronoi::Voronoi(std::shared_ptr<const Triangulation> triangulation,
                 const RunOptions& options)
    : triangulation_(std::move(triangulation)) {
  build(options);
}

void Voronoi::build(const RunOptions& options) {
  constexpr std::int64_t chunk = 4096;
  const Triangulation& t = *triangulation_;
  const FaceVertices faces(t);
  num_front_ = faces.num_front();
  vertices_.resize(at(faces.size()));
  delaunay::parallel_chunks(
      faces.size(), chunk, options, [&](std::int64_t first, std::int64_t last) {
        for (auto v = static_cast<std::int32_t>(first); v < last; ++v)
          vertices_[at(v)] = circumcenter(t.points(), faces.corners(v));
      });
  if (t.dimension() == 1 && t.num_sites() > 2) {
    const Direction pole = circumcenter(t.points(), {0, 1, t.num_sites() - 1});
    vertices_ = {pole, Direction::from(-pole.x(), -pole.y(), -pole.z())};
  }
  const CellNeighbors neighbors(t, faces.back());
  for (Site s = 0; s < t.num_sites(); ++s) {
    const bool is_lune = t.dimension() == 1 && t.num_sites() > 2;
    std::vector<std::int32_t> ring;
    if (is_lune) ring = {0, 1};
    if (t.dimension() == 2) ring = faces.ring(s);
    add_cell(s, neighbors(s), ring);
  }
}

// The edge of a neighbour runs from the vertex before it to the vertex after it.
void Voronoi::add_cell(Site s, std::span<const Site> neighbors,
                       std::span<const std::int32_t> ring) {
  std::vector<std::int32_t> corners, beyond;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    std::array<std::int32_t, 2> ends{none, none};
    if (!ring.empty()) ends = {ring[k == 0 ? ring.size() - 1 : k - 1], ring[k]};
    if (ends[0] == ends[1] && !ring.empty()) continue;
    if (!ring.empty()) corners.push_back(ends[0]);
    beyond.push_back(neighbors[k]);
    if (s < neighbors[k]) edges_.push_back({{s, neighbors[k]}, ends});
  }
  cells_.append(corners, CellTable::Ring::open);
  neighbors_.append(beyond, CellTable::Ring::open);
}

std::vector<Direction> Voronoi::outline(Site s, double max_step) const {
  const auto points = triangulation_->points();
  const auto corners = cells_.cell(s), beyond = neighbors_.cell(s);
  const LocalFrame frame(points[at(s)]);
  std::vector<Direction> result;
  for (std::size_t k = 0; k < beyond.size(); ++k) {
    const Bisector bisector(frame.spoke(points[at(beyond[k])]));
    if (corners.empty()) {
      result.push_back(frame.direction(bisector.point({1, 0})));
      append_arc(result, frame, bisector, {1, 0}, 2 * std::numbers::pi, max_step);
      break;
    }
    const Direction &from = vertices_[at(corners[k])],
                    &to = vertices_[at(corners[k + 1 == corners.size() ? 0 : k + 1])];
    const Bisector::Place begin = bisector.place(frame.local(from));
    result.push_back(from);
    append_arc(result, frame, bisector, begin,
               length_between(begin, bisector.place(frame.local(to))), max_step);
  }
  return result;
}

}  // namespace delone::stripack
