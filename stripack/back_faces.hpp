#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "stripack/triangulation.hpp"

namespace delone::stripack {

/// The faces on the back of the polyhedron of a set that lies in a hemisphere: those that
/// the centre sees from behind, so that they are no triangles of the triangulation.
///
/// Their corners are boundary sites, and their circumcentres, on the far side of the
/// sphere, are the vertices that close the Voronoi cells of these. They are the Delaunay
/// triangulation of a convex polygon for the farthest point: built by removing its
/// corners in a random order and putting them back, in expected linear time. Canonical,
/// like the front: ties are broken by coordinates only. Empty without a boundary and for
/// chains.
///
/// Source: L. P. Chew, Building Voronoi Diagrams for Convex Polygons in Linear Expected
/// Time, Dartmouth PCS-TR90-147 (1990).
class BackFaces {
 public:
  explicit BackFaces(const Triangulation& t);

  /// Corners counter-clockwise as seen from outside the polyhedron.
  [[nodiscard]] std::span<const std::array<Site, 3>> faces() const noexcept {
    return faces_;
  }
  /// What follows a boundary site's list of neighbours, counter-clockwise all round it:
  /// the sites joined to it through the back. Empty for other sites.
  [[nodiscard]] std::span<const Site> neighbors(Site s) const noexcept;
  /// The faces between these, counter-clockwise, beginning after the last neighbour in
  /// the list: one more than neighbors(s).
  [[nodiscard]] std::span<const std::int32_t> faces_at(Site s) const noexcept;

 private:
  std::vector<std::array<Site, 3>> faces_;
  std::vector<std::int32_t> place_;  // of each site in the boundary, or none
  std::vector<std::int32_t> offsets_;
  std::vector<std::int32_t> face_lists_;
  std::vector<Site>
      neighbor_lists_;  // as long as face_lists_: the last of each is unused
};

}  // namespace delone::stripack
