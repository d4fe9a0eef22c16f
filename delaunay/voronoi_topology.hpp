#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/buffer.hpp"

/// What the Voronoi diagrams of the plane and the sphere share: which triangles are one
/// vertex, and the vertices around a cell. Internal: use tripack/voronoi.hpp and
/// stripack/voronoi.hpp.
namespace delone::delaunay {

/// The triangles of a triangulation, numbered in the order of for_each_triangle.
struct TriangleNumbers {
  std::vector<Arc> arcs;  ///< of each triangle the arc that leaves its smallest site
  Buffer<std::int32_t> of_arc;  ///< the triangle on the left of each arc, or none
};
[[nodiscard]] TriangleNumbers number_triangles(const Adjacency& t);

/// Triangles on one circle share a vertex: sets that are united, and then numbered by
/// their smallest members.
class VertexSets {
 public:
  explicit VertexSets(std::size_t num_triangles);
  void unite(std::int32_t a, std::int32_t b);

  struct Numbering {
    std::vector<std::int32_t> of_triangle;
    std::vector<std::int32_t> first_triangle;  ///< of each vertex
  };
  [[nodiscard]] Numbering number();

 private:
  std::int32_t root(std::int32_t a) noexcept;
  std::vector<std::int32_t> parents_;
};

/// Unites the triangles on both sides of every edge for which `is_tie(arc)` holds.
template <class IsTie>
void unite_ties(const Adjacency& t, const TriangleNumbers& numbers, VertexSets& sets,
                IsTie is_tie) {
  for (const Arc triangle : numbers.arcs) {
    Arc arc = triangle;
    for (int k = 0; k < 3; ++k) {
      const Arc back = t.reverse(arc);
      if (t.target(arc) > arc.origin && t.has_left(back) && is_tie(arc)) {
        sets.unite(numbers.of_arc[static_cast<std::size_t>(arc.index)],
                   numbers.of_arc[static_cast<std::size_t>(back.index)]);
      }
      arc = t.previous(back);
    }
  }
}

/// For every site the vertices of its cell, counter-clockwise, without repeats in a row.
class CellTable {
 public:
  enum class Ring : std::uint8_t { open, closed };
  /// The next site's cell. Of vertices that follow each other and are the same one is
  /// kept; in a closed ring the first follows the last.
  void append(std::span<const std::int32_t> vertices, Ring ring);
  void reserve(std::size_t num_cells, std::size_t num_vertices);

  [[nodiscard]] std::span<const std::int32_t> cell(Site s) const noexcept {
    const auto i = static_cast<std::size_t>(s);
    return {corners_.data() + offsets_[i],
            static_cast<std::size_t>(offsets_[i + 1] - offsets_[i])};
  }

 private:
  std::vector<std::int64_t> offsets_{0};
  std::vector<std::int32_t> corners_;
};

}  // namespace delone::delaunay
