#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

#include "delaunay/closed_mesh.hpp"
#include "delaunay/defect.hpp"
#include "delaunay/region_queries.hpp"

/// Checking constrained triangulations: what both rooms' find_defect share. `T` is either
/// room's ConstrainedTriangulation.
namespace delone::delaunay {

/// What the checks need beside positions:
///   ghost()              the node beyond the hull
///   segment_name         what the room calls a segment
///   is_in_place(path, k) is row path[k] on the segment path.front() - path.back(), and
///                        past path[k - 1]?
template <class G>
concept ConstrainedGeometry = CheckedGeometry<G> &&
    requires(const G& g, std::vector<Node> path, std::size_t k) {
  { g.ghost() } -> std::same_as<Site>;
  {std::string(G::segment_name)};
  { g.is_in_place(path, k) } -> std::same_as<bool>;
};

namespace internal {

template <class T, ConstrainedGeometry G>
Defect find_tiling_defect(const T& t, const G& g) {
  const Adjacency lists(
      t.mesh().to_lists(t.num_sites(), [](std::int32_t) { return false; }));
  if (auto defect = find_ring_defect(lists, t.rows())) return defect;
  if (auto defect = find_orientation_defect(lists, g)) return defect;
  if (auto defect = find_fan_defect(lists, g)) return defect;
  return find_euler_defect(lists);
}

template <class T, ConstrainedGeometry G>
Defect find_edge_defect(const T& t, const G& g) {
  const ClosedMesh& mesh = t.mesh();
  for (std::int32_t f = 0; f < mesh.num_face_slots(); ++f) {
    if (mesh.is_free(f)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge e = ClosedMesh::half_edge(f, k), back = mesh.reverse(e);
      if (mesh.is_constraint(e)) continue;
      const std::array<Site, 4> v{mesh.origin(e), mesh.target(e), mesh.apex(e),
                                  mesh.apex(back)};
      if (std::find(v.begin(), v.end(), g.ghost()) != v.end()) continue;
      if (t.region_of(f) != t.region_of(ClosedMesh::face_of(back))) {
        return name_of_edge(g.row(v[0]), g.row(v[1])) + " bounds a region but is no " +
               G::segment_name;
      }
      if (!g.is_violated(v[0], v[1], v[2], v[3])) continue;
      return name_of_edge(g.row(v[0]), g.row(v[1])) + " is not Delaunay: row " +
             std::to_string(g.row(v[3])) + " is inside the circle of " +
             name_of_triangle({g.row(v[0]), g.row(v[1]), g.row(v[2])});
    }
  }
  return std::nullopt;
}

template <ConstrainedGeometry G>
std::string name_of_segment(std::int64_t i) {
  return std::string(G::segment_name) + " " + std::to_string(i);
}

// Are the sites of a path, if none was added, on its segment and in order?
template <class T, ConstrainedGeometry G>
Defect find_course_defect(const T& t, const G& g, std::int64_t i,
                          const std::vector<Node>& path) {
  const auto& meeting = t.report().meeting;
  if (std::any_of(path.begin(), path.end(), [&](Node row) {
        return row >= t.num_input_rows() ||
               std::binary_search(meeting.begin(), meeting.end(), row);
      }))
    return std::nullopt;
  for (std::size_t k = 1; k < path.size(); ++k) {
    if (g.is_in_place(path, k)) continue;
    return "row " + std::to_string(path[k]) + " is not in its place on " +
           name_of_segment<G>(i);
  }
  return std::nullopt;
}

template <class T, ConstrainedGeometry G>
Defect find_path_defect(const T& t, const G& g) {
  const auto constraints = t.constraint_edges();
  std::vector<bool> is_used(constraints.size());
  for (std::int64_t i = 0; i < t.num_segments(); ++i) {
    const std::vector<Node> path = t.path(i);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const auto [low, high] = std::minmax(path[k - 1], path[k]);
      const std::array<Node, 2> piece{low, high};
      const auto found = std::lower_bound(constraints.begin(), constraints.end(), piece);
      if (found == constraints.end() || *found != piece)
        return name_of_segment<G>(i) + " lacks its piece " + name_of_edge(low, high);
      is_used[static_cast<std::size_t>(found - constraints.begin())] = true;
    }
    if (auto defect = find_course_defect(t, g, i, path)) return defect;
  }
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused == is_used.end()) return std::nullopt;
  const auto& edge = constraints[static_cast<std::size_t>(unused - is_used.begin())];
  return name_of_edge(edge[0], edge[1]) + " is marked but belongs to no " +
         G::segment_name;
}

}  // namespace internal

/// Nothing, or one sentence: is the mesh a tiling of the hull, constrained Delaunay at
/// every edge that is no constraint, and every segment a chain of marked edges? O(n).
template <class T, ConstrainedGeometry G>
[[nodiscard]] Defect find_constrained_defect(const T& t, const G& g) {
  if (auto defect = find_map_defect(t.rows(), t.sites())) return defect;
  if (t.mesh().num_faces() == 0) return std::nullopt;
  if (auto defect = find_link_defect(t.mesh())) return defect;
  if (auto defect = internal::find_tiling_defect(t, g)) return defect;
  if (auto defect = internal::find_edge_defect(t, g)) return defect;
  return internal::find_path_defect(t, g);
}

}  // namespace delone::delaunay
