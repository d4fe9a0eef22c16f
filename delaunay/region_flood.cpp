#include "delaunay/region_flood.hpp"

namespace delone::delaunay {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// Marks all faces of the region of `first`.
void flood(const ClosedMesh& mesh, std::int32_t first, FaceRegions& regions,
           std::vector<std::int32_t>& open) {
  regions.of_face[at(first)] = regions.count;
  open.assign(1, first);
  while (!open.empty()) {
    const ClosedMesh::Face& face = mesh.face(open.back());
    open.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      if (((face.constraints >> k) & 1) != 0) continue;
      const std::int32_t other = ClosedMesh::face_of(face.link[k]);
      if (regions.of_face[at(other)] != none) continue;
      regions.of_face[at(other)] = regions.count;
      open.push_back(other);
    }
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

FaceRegions flood_regions(const ClosedMesh& mesh) {
  FaceRegions regions;
  regions.of_face.resize(at(mesh.num_face_slots()), none);
  std::vector<std::int32_t> open;
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f) || regions.of_face[at(f)] != none) continue;
    flood(mesh, f, regions, open);
    ++regions.count;
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
