#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/adjacency.hpp"
#include "delaunay/closed_mesh.hpp"
#include "delaunay/mesh_walk.hpp"
#include "delaunay/region.hpp"
#include "delaunay/region_flood.hpp"
#include "delaunay/segment_paths.hpp"

/// What the constrained triangulations of plane and sphere share beyond their
/// construction. `rows`: the row of every site.
namespace delone::delaunay {

/// Which faces belong to the domain and to what region of it.
struct DomainFaces {
  Buffer<std::int32_t> region_of_face;  ///< none: not in the domain
  std::vector<DomainRegion> regions;

  [[nodiscard]] std::int64_t num_triangles() const;
};

/// Leaves out regions that are removed, and faces to the ghost; numbers the rest in the
/// order of their first faces. O(faces).
[[nodiscard]] DomainFaces keep_regions(const ClosedMesh& mesh, Site ghost,
                                       FaceRegions regions,
                                       const std::vector<bool>& is_removed);

/// The region at a place. Throws Error, which calls the place `what number`, if different
/// ones meet there; nothing if the place is in a face to the ghost.
[[nodiscard]] std::optional<std::int32_t> region_at(
    const ClosedMesh& mesh, Site ghost, std::span<const std::int32_t> region_of_face,
    const MeshPlace& place, const char* what, std::size_t number);

/// One flag a half-edge: is it covered by an odd number of segments (pairs of rows)?
[[nodiscard]] std::vector<bool> find_odd_edges(
    const ClosedMesh& mesh, const SegmentPaths& paths,
    std::span<const std::array<Node, 2>> segments, std::span<const Site> sites);

/// Triangles of the domain and their regions: counter-clockwise, smallest row first,
/// sorted.
[[nodiscard]] std::vector<std::pair<std::array<Node, 3>, std::int32_t>>
list_domain_triangles(const ClosedMesh& mesh, std::span<const Node> rows,
                      std::span<const std::int32_t> region_of_face);

/// Constraints in rows, each once, smaller row first, sorted.
[[nodiscard]] std::vector<std::array<Node, 2>> list_constraints(
    const ClosedMesh& mesh, std::span<const Node> rows);

/// A place as a part of the closed domain, or outside.
[[nodiscard]] Location locate_in_domain(const ClosedMesh& mesh,
                                        std::span<const Node> rows,
                                        std::span<const std::int32_t> region_of_face,
                                        const MeshPlace& place);

/// Nothing, or why the links, marks and regions of the mesh do not fit together.
[[nodiscard]] std::optional<std::string> find_link_defect(const ClosedMesh& mesh);

}  // namespace delone::delaunay
