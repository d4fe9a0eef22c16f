#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/error.hpp"
#include "delaunay/mesh_walk.hpp"
#include "delaunay/region_flood.hpp"

namespace delone::delaunay {

/// A point strictly inside a face, and how large the face is.
struct InnerPoint {
  double size = 0;
  std::array<double, 2> point{};
};

/// The faces of a constrained triangulation's holes: one list a region that the domain
/// leaves out and that constraints part from the ghost.
template <class Triangulation>
[[nodiscard]] std::vector<std::vector<std::int32_t>> list_hole_faces(
    const Triangulation& t, Site ghost) {
  const ClosedMesh& mesh = t.mesh();
  const FaceRegions regions = flood_regions(mesh);
  const auto region = [&](std::int32_t f) {
    return static_cast<std::size_t>(regions.of_face[static_cast<std::size_t>(f)]);
  };
  std::vector<bool> is_hole(static_cast<std::size_t>(regions.count), true);
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f)) continue;
    if (t.region_of(f) != none || !is_real(mesh, ClosedMesh::half_edge(f, 0), ghost))
      is_hole[region(f)] = false;
  }
  std::vector<std::vector<std::int32_t>> faces(is_hole.size());
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f)
    if (!mesh.is_free(f) && is_hole[region(f)]) faces[region(f)].push_back(f);
  std::erase_if(faces, [](const auto& hole) { return hole.empty(); });
  return faces;
}

/// For every hole the inner point of its largest face that has one, sorted, whatever the
/// numbers of faces. `inner(f)`: an optional InnerPoint. Throws Error, naming the row of
/// a corner, if no face of a hole has an inner point.
template <class Triangulation, class Inner>
[[nodiscard]] std::vector<std::array<double, 2>> find_hole_points(const Triangulation& t,
                                                                  Site ghost,
                                                                  Inner inner) {
  std::vector<std::array<double, 2>> points;
  for (const auto& hole : list_hole_faces(t, ghost)) {
    std::optional<InnerPoint> best;
    for (const std::int32_t f : hole) {
      const std::optional<InnerPoint> found = inner(f);
      if (found && (!best || std::tie(best->size, found->point) <
                                 std::tie(found->size, best->point)))
        best = found;
    }
    if (!best) {
      const auto corner = static_cast<std::size_t>(t.mesh().face(hole.front()).node[0]);
      throw Error(
          "a hole is so narrow that no double-precision point lies inside; leave out the "
          "ring at row " +
              std::to_string(t.rows()[corner]),
          {t.rows()[corner]});
    }
    points.push_back(best->point);
  }
  std::ranges::sort(points);
  return points;
}

}  // namespace delone::delaunay
