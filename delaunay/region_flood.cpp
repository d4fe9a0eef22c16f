#include "delaunay/region_flood.hpp"

#include <algorithm>
#include <array>

namespace delone::delaunay {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Disjoint sets of faces, as trees in which no parent is above its children: the root is
// the first face of a set.
std::int32_t find_root(Buffer<std::int32_t>& parent, std::int32_t f) {
  while (parent[at(f)] != f) {
    parent[at(f)] = parent[at(parent[at(f)])];
    f = parent[at(f)];
  }
  return f;
}

// The face joins the sets of the faces before it that it can be reached from. Nearly
// always these have one parent, and no branch is needed to find that out.
void unite_with_neighbors(const ClosedMesh& mesh, std::int32_t f,
                          Buffer<std::int32_t>& parent) {
  const ClosedMesh::Face& face = mesh.face(f);
  std::array<std::int32_t, 3> before;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t other = ClosedMesh::face_of(face.link[k]);
    const std::int32_t is_open = static_cast<std::int32_t>(other < f) &
                                 ~(static_cast<std::int32_t>(face.constraints) >> k);
    const std::int32_t from = parent[at(f + (other - f) * (is_open & 1))];
    before[k] = parent[at(from)];
  }
  const std::int32_t first = std::min({before[0], before[1], before[2]});
  parent[at(f)] = first;
  unsigned num_others = 0;
  for (const std::int32_t other : before)
    num_others +=
        static_cast<unsigned>(other != first) & static_cast<unsigned>(other != f);
  if (num_others == 0) [[likely]]
    return;
  for (const std::int32_t other : before) {
    if (other == f) continue;
    const std::int32_t one = find_root(parent, first), two = find_root(parent, other);
    parent[at(std::max(one, two))] = std::min(one, two);
  }
}

// Regions on the two sides of a constraint.
struct Wall {
  std::int32_t from, to;
  bool is_boundary;
};

std::vector<std::vector<Wall>> find_walls(const ClosedMesh& mesh,
                                          const FaceRegions& regions,
                                          const std::vector<bool>& is_boundary) {
  std::vector<std::vector<Wall>> walls(at(regions.count));
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f) || mesh.face(f).constraints == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(f, k);
      if (!mesh.is_constraint(e)) continue;
      const std::int32_t from = regions.of_face[at(f)];
      const std::int32_t to = regions.of_face[at(ClosedMesh::face_of(mesh.reverse(e)))];
      walls[at(from)].push_back({from, to, is_boundary[at(e)]});
    }
  }
  return walls;
}

}  // namespace

// Faces are taken in the order of memory, where most neighbours are near; a search from
// face to face would wander through all of it.
FaceRegions flood_regions(const ClosedMesh& mesh) {
  FaceRegions regions;
  Buffer<std::int32_t>& parent = regions.of_face;
  parent.resize(at(mesh.num_face_slots()));
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    parent[at(f)] = mesh.is_free(f) ? none : f;
    if (!mesh.is_free(f)) unite_with_neighbors(mesh, f, parent);
  }
  // A face's parent comes before it and has its region's number by then.
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    const std::int32_t before = parent[at(f)];
    if (before == none) continue;
    regions.of_face[at(f)] = before == f ? regions.count++ : regions.of_face[at(before)];
  }
  return regions;
}

std::vector<std::int8_t> find_parities(const ClosedMesh& mesh, const FaceRegions& regions,
                                       const std::vector<bool>& is_boundary,
                                       std::int32_t outside) {
  const auto walls = find_walls(mesh, regions, is_boundary);
  std::vector<std::int8_t> parity(at(regions.count), std::int8_t{none});
  std::vector<std::int32_t> open{outside};
  parity[at(outside)] = 0;
  while (!open.empty()) {
    const std::int32_t region = open.back();
    open.pop_back();
    for (const Wall& wall : walls[at(region)]) {
      const auto expected =
          static_cast<std::int8_t>(parity[at(region)] ^ (wall.is_boundary ? 1 : 0));
      if (parity[at(wall.to)] == none) {
        parity[at(wall.to)] = expected;
        open.push_back(wall.to);
      } else if (parity[at(wall.to)] != expected) {
        return {};
      }
    }
  }
  return parity;
}

}  // namespace delone::delaunay
