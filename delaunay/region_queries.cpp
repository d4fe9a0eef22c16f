#include "delaunay/region_queries.hpp"

#include <algorithm>

#include "delaunay/error.hpp"

namespace delone::delaunay {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Do all faces round a site belong to one region?
bool is_in_one_region(const ClosedMesh& mesh,
                      std::span<const std::int32_t> region_of_face, Site v) {
  const HalfEdge first = mesh.edge_at(v);
  const auto region = [&](HalfEdge e) {
    return region_of_face[at(ClosedMesh::face_of(e))];
  };
  for (HalfEdge e = mesh.next_around(first); e != first; e = mesh.next_around(e)) {
    if (region(e) != region(first)) return false;
  }
  return true;
}

}  // namespace

std::int64_t DomainFaces::num_triangles() const {
  std::int64_t sum = 0;
  for (const DomainRegion& region : regions) sum += region.num_triangles;
  return sum;
}

DomainFaces keep_regions(const ClosedMesh& mesh, Site ghost, FaceRegions regions,
                         const std::vector<bool>& is_removed) {
  const HalfEdge first = mesh.edge_at(ghost);
  for (HalfEdge e = first; e != none;) {
    regions.of_face[at(ClosedMesh::face_of(e))] = none;
    e = mesh.next_around(e);
    if (e == first) break;
  }
  std::vector<std::int32_t> number(at(regions.count), none);
  DomainFaces domain;
  for (std::int32_t& region : regions.of_face) {
    if (region == none) continue;
    if (is_removed[at(region)]) {
      region = none;
      continue;
    }
    if (number[at(region)] == none) {
      number[at(region)] = static_cast<std::int32_t>(domain.regions.size());
      domain.regions.emplace_back();
    }
    region = number[at(region)];
    ++domain.regions[at(region)].num_triangles;
  }
  domain.region_of_face = std::move(regions.of_face);
  return domain;
}

std::optional<std::int32_t> region_at(const ClosedMesh& mesh, Site ghost,
                                      std::span<const std::int32_t> region_of_face,
                                      const MeshPlace& place, const char* what,
                                      std::size_t number) {
  const auto region = [&](HalfEdge e) {
    return region_of_face[at(ClosedMesh::face_of(e))];
  };
  bool is_unique = true;
  if (place.kind == MeshPlace::Kind::edge)
    is_unique = region(place.at) == region(mesh.reverse(place.at));
  if (place.kind == MeshPlace::Kind::site)
    is_unique = is_in_one_region(mesh, region_of_face, place.site);
  if (!is_unique) {
    throw Error(std::string(what) + " " + std::to_string(number) +
                    " lies on a segment; move it into one of the regions there",
                {static_cast<std::int64_t>(number)});
  }
  const HalfEdge e = place.kind == MeshPlace::Kind::site
                         ? real_edge_at(mesh, place.site, ghost)
                         : place.at;
  if (!is_real(mesh, e, ghost)) return std::nullopt;
  return region(e);
}

std::vector<bool> find_odd_edges(const ClosedMesh& mesh, const SegmentPaths& paths,
                                 std::span<const std::array<Node, 2>> segments,
                                 std::span<const Site> sites) {
  std::vector<bool> is_odd(4 * at(mesh.num_face_slots()));
  for (const auto& ends : segments) {
    const Site a = sites[at(ends[0])], b = sites[at(ends[1])];
    if (a == b) continue;
    const std::vector<Site> path = paths.path(a, b);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const HalfEdge e = mesh.find(path[i - 1], path[i]);
      is_odd[at(e)].flip();
      is_odd[at(mesh.reverse(e))].flip();
    }
  }
  return is_odd;
}

std::vector<std::pair<std::array<Node, 3>, std::int32_t>> list_domain_triangles(
    const ClosedMesh& mesh, std::span<const Node> rows,
    std::span<const std::int32_t> region_of_face) {
  std::vector<std::pair<std::array<Node, 3>, std::int32_t>> list;
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (region_of_face[at(f)] == none) continue;
    const auto& node = mesh.face(f).node;
    std::array<Node, 3> triangle{rows[at(node[0])], rows[at(node[1])], rows[at(node[2])]};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    list.emplace_back(triangle, region_of_face[at(f)]);
  }
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<std::array<Node, 2>> list_constraints(const ClosedMesh& mesh,
                                                  std::span<const Node> rows) {
  std::vector<std::array<Node, 2>> edges;
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(f, k);
      if (!mesh.is_constraint(e) || e > mesh.reverse(e)) continue;
      const auto [low, high] =
          std::minmax(rows[at(mesh.origin(e))], rows[at(mesh.target(e))]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

Location locate_in_domain(const ClosedMesh& mesh, std::span<const Node> rows,
                          std::span<const std::int32_t> region_of_face,
                          const MeshPlace& place) {
  const auto row = [&](Site v) { return rows[at(v)]; };
  const auto is_kept = [&](HalfEdge e) {
    return region_of_face[at(ClosedMesh::face_of(e))] != none;
  };
  if (place.kind == MeshPlace::Kind::site) {
    const HalfEdge first = mesh.edge_at(place.site);
    HalfEdge e = first;
    while (!is_kept(e)) {
      e = mesh.next_around(e);
      if (e == first) return {};
    }
    return {Location::Kind::node, {row(place.site), none, none}};
  }
  const HalfEdge e = place.at;
  if (place.kind == MeshPlace::Kind::edge) {
    if (!is_kept(e) && !is_kept(mesh.reverse(e))) return {};
    return {Location::Kind::edge, {row(mesh.origin(e)), row(mesh.target(e)), none}};
  }
  if (!is_kept(e)) return {};
  return {Location::Kind::triangle,
          {row(mesh.origin(e)), row(mesh.target(e)), row(mesh.apex(e))}};
}

std::optional<std::string> find_link_defect(const ClosedMesh& mesh) {
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(f, k), back = mesh.reverse(e);
      if (mesh.reverse(back) == e && mesh.origin(back) == mesh.target(e) &&
          mesh.target(back) == mesh.origin(e) &&
          mesh.is_constraint(back) == mesh.is_constraint(e))
        continue;
      return "face " + std::to_string(f) + " and its neighbour disagree on their edge";
    }
  }
  return std::nullopt;
}

}  // namespace delone::delaunay
