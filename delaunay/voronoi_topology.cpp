#include "delaunay/voronoi_topology.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace delone::delaunay {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

TriangleNumbers number_triangles(const Adjacency& t) {
  TriangleNumbers numbers;
  numbers.of_arc.resize(at(t.num_arcs()), none);
  t.for_each_triangle([&](Arc arc) {
    const auto number = static_cast<std::int32_t>(numbers.arcs.size());
    numbers.arcs.push_back(arc);
    for (int k = 0; k < 3; ++k) {
      numbers.of_arc[at(arc.index)] = number;
      arc = t.previous(t.reverse(arc));
    }
  });
  return numbers;
}

VertexSets::VertexSets(std::size_t num_triangles) : parents_(num_triangles) {
  std::iota(parents_.begin(), parents_.end(), 0);
}

std::int32_t VertexSets::root(std::int32_t a) noexcept {
  while (parents_[at(a)] != a) {
    parents_[at(a)] = parents_[at(parents_[at(a)])];
    a = parents_[at(a)];
  }
  return a;
}

void VertexSets::unite(std::int32_t a, std::int32_t b) {
  const std::int32_t u = root(a), v = root(b);
  parents_[at(std::max(u, v))] = std::min(u, v);
}

VertexSets::Numbering VertexSets::number() {
  Numbering numbering;
  numbering.of_triangle.resize(parents_.size());
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    const auto triangle = static_cast<std::int32_t>(i);
    const std::int32_t first = root(triangle);
    if (first == triangle) {
      numbering.of_triangle[i] =
          static_cast<std::int32_t>(numbering.first_triangle.size());
      numbering.first_triangle.push_back(triangle);
    } else {
      numbering.of_triangle[i] = numbering.of_triangle[at(first)];
    }
  }
  return numbering;
}

void CellTable::reserve(std::size_t num_cells, std::size_t num_vertices) {
  offsets_.reserve(num_cells + 1);
  corners_.reserve(num_vertices);
}

void CellTable::append(std::span<const std::int32_t> vertices, Ring ring) {
  const auto begin = static_cast<std::size_t>(offsets_.back());
  for (const std::int32_t v : vertices) {
    if (corners_.size() == begin || corners_.back() != v) corners_.push_back(v);
  }
  while (ring == Ring::closed && corners_.size() > begin + 1 &&
         corners_.back() == corners_[begin])
    corners_.pop_back();
  offsets_.push_back(static_cast<std::int64_t>(corners_.size()));
}

}  // namespace delone::delaunay
