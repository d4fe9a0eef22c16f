#include "io/voronoi_file.hpp"

#include "io/node_file.hpp"

namespace delone::io {

void write_v_node(const std::string& path, const tripack::Voronoi& diagram, int base) {
  NodeFile nodes;
  nodes.base = base;
  for (const tripack::Point2 p : diagram.vertices()) {
    nodes.x.push_back(p.x);
    nodes.y.push_back(p.y);
  }
  write_node(path, nodes);
}

EdgeFile voronoi_edges(const tripack::Voronoi& diagram, int base) {
  EdgeFile file;
  file.base = base;
  for (const tripack::VoronoiEdge& edge : diagram.edges()) {
    const auto [from, to] = edge.vertices;
    const auto [dx, dy] = edge.direction;
    if (from >= 0 && to >= 0) file.edges.push_back({from, to, 0, 0, 0});
    // A ray is written as it leaves its vertex.
    if (from >= 0 && to < 0) file.edges.push_back({from, -1, dx, dy, 0});
    if (from < 0 && to >= 0) file.edges.push_back({to, -1, 0 - dx, 0 - dy, 0});
  }
  return file;
}

void write_v_edge(const std::string& path, const tripack::Voronoi& diagram, int base) {
  write_v_edge(path, voronoi_edges(diagram, base));
}

}  // namespace delone::io
