#include "delaunay/site_queries.hpp"

#include <algorithm>

namespace delone::delaunay {

std::vector<std::array<Node, 3>> list_triangles(const Adjacency& t,
                                                std::span<const Node> rows,
                                                std::span<const Site> sites) {
  std::vector<std::array<Node, 3>> triangles;
  if (t.is_chain()) return triangles;
  triangles.reserve(static_cast<std::size_t>(t.num_triangles()));
  const auto row = [&](Site v) { return rows[static_cast<std::size_t>(v)]; };
  for (Node r = 0; r < static_cast<Node>(sites.size()); ++r) {
    const Site v = sites[static_cast<std::size_t>(r)];
    if (row(v) != r || t.degree(v) == 0) continue;  // a repeat
    const std::size_t first = triangles.size();
    Arc a = t.first_arc(v);
    for (std::int32_t i = 0; i < t.degree(v); ++i, a = t.next(a)) {
      if (!t.has_left(a)) continue;
      const std::array<Node, 3> corners{r, row(t.target(a)), row(t.target(t.next(a)))};
      if (corners[1] > r && corners[2] > r) triangles.push_back(corners);
    }
    std::sort(triangles.begin() + static_cast<std::ptrdiff_t>(first), triangles.end());
  }
  return triangles;
}

std::vector<Node> list_boundary(const Adjacency& t, std::span<const Node> rows) {
  std::vector<Node> boundary;
  if (t.is_chain()) {
    boundary.assign(rows.begin(), rows.end());
    return boundary;
  }
  Site start = none;
  for (Site v = 0; v < t.num_sites(); ++v) {
    if (!t.is_boundary(v)) continue;
    if (start == none ||
        rows[static_cast<std::size_t>(v)] < rows[static_cast<std::size_t>(start)])
      start = v;
  }
  if (start == none) return boundary;
  Site v = start;
  do {
    boundary.push_back(rows[static_cast<std::size_t>(v)]);
    v = t.neighbors(v)[0];
  } while (v != start);
  return boundary;
}

}  // namespace delone::delaunay
