#include "delaunay/ring_check.hpp"

#include <cstddef>
#include <string>

namespace delone::delaunay {

namespace {

std::string name_of_row(std::size_t row) { return "row " + std::to_string(row); }

Defect find_entry_defect(std::size_t v, const std::vector<Node>& ring,
                         std::size_t num_nodes) {
  std::vector<Node> sorted = ring;
  std::ranges::sort(sorted);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Node w = sorted[i];
    if (w < 0 || static_cast<std::size_t>(w) >= num_nodes) {
      return "the list of " + name_of_row(v) + " names row " + std::to_string(w) +
             ", but there are " + std::to_string(num_nodes);
    }
    if (static_cast<std::size_t>(w) == v)
      return name_of_row(v) + " is in its own list of neighbours";
    if (i > 0 && sorted[i - 1] == w) {
      return "the list of " + name_of_row(v) + " names row " + std::to_string(w) +
             " twice";
    }
  }
  return std::nullopt;
}

}  // namespace

Defect find_list_entry_defect(const NeighborRings& rings) {
  for (std::size_t v = 0; v < rings.size(); ++v) {
    if (auto defect = find_entry_defect(v, rings[v], rings.size())) return defect;
  }
  const LoneArc lone = find_lone_arc(rings);
  if (lone.from == none) return std::nullopt;
  return name_of_row(static_cast<std::size_t>(lone.to)) + " is in the list of row " +
         std::to_string(lone.from) + " but not the other way round";
}

Defect find_bare_arc(const NeighborRings& rings, std::span<const Triple> triangles) {
  std::vector<std::pair<Node, Node>> sides;
  sides.reserve(6 * triangles.size());
  for (const auto& [a, b, c] : triangles)
    sides.insert(sides.end(), {{a, b}, {b, a}, {b, c}, {c, b}, {c, a}, {a, c}});
  std::ranges::sort(sides);
  for (std::size_t v = 0; v < rings.size(); ++v) {
    for (const Node w : rings[v]) {
      const auto node = static_cast<Node>(v);
      if (std::ranges::binary_search(sides, std::pair(node, w))) continue;
      return name_of_edge(node, w) +
             " is a side of no triangle: its ends' lists do not go round alike";
    }
  }
  return std::nullopt;
}

}  // namespace delone::delaunay
