#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/voronoi_topology.hpp"
#include "tripack/polygon.hpp"
#include "tripack/region.hpp"
#include "tripack/triangulation.hpp"

namespace delone::tripack {

/// An edge between the cells of two sites.
struct VoronoiEdge {
  /// sites[0] lies on the left of the direction of the edge, sites[1] on the right.
  std::array<Site, 2> sites{};
  /// From vertices[0] to vertices[1]; `none` where it comes from or goes to infinity.
  std::array<std::int32_t, 2> vertices{delaunay::none, delaunay::none};
  /// Perpendicular to the line of the sites and as long as they are apart: its components
  /// are the rounded differences of theirs. The way of a ray.
  Point2 direction;
};

/// The Voronoi diagram: for every site of a triangulation the points nearest to it.
///
/// Its vertices are circumcentres, each once: triangles whose corners lie exactly on one
/// circle share a vertex, and their cells have no edge of length zero between them. A
/// lattice has four corners a cell. Cells of sites on the boundary of the hull are
/// unbounded: their edges come from infinity to the first vertex and go from the last one
/// to infinity along two rays, parallel where the site lies inside a hull edge. Collinear
/// sites have cells between parallel lines, without vertices; a single one has the
/// plane.
///
/// Accuracy: each coordinate of a vertex is the circumcentre's to within one unit in its
/// last place or 2^-80 of the circumradius, slivers included. Which triangles share a
/// vertex is exact. Cost: O(n); 0.8 microseconds a site on one thread (AMD EPYC Zen 5;
/// 0.5 on a lattice), 88 bytes.
///
/// Source: A. Okabe, B. Boots, K. Sugihara, S. N. Chiu, Spatial Tessellations, 2nd ed.
/// (2000).
class Voronoi {
 public:
  explicit Voronoi(std::shared_ptr<const Triangulation> triangulation,
                   const RunOptions& options = {});

  [[nodiscard]] const Triangulation& triangulation() const noexcept {
    return *triangulation_;
  }
  [[nodiscard]] std::span<const Point2> vertices() const noexcept { return vertices_; }
  /// The numbers of the vertices around a cell, counter-clockwise; of an unbounded one
  /// from the first ray to the second.
  [[nodiscard]] std::span<const std::int32_t> cell(Site s) const noexcept {
    return cells_.cell(s);
  }
  [[nodiscard]] bool is_bounded(Site s) const noexcept {
    return triangulation_->dimension() == 2 &&
           !triangulation_->adjacency().is_boundary(s);
  }
  /// Directions to infinity, from the first and from the last vertex of an unbounded
  /// cell; not for collinear sites.
  [[nodiscard]] std::array<Point2, 2> rays(Site s) const noexcept;

  /// The corners of a bounded cell, counter-clockwise; empty for an unbounded one.
  [[nodiscard]] Polygon polygon(Site s) const;
  /// The part of a cell inside the region: one polygon or none, or several if the region
  /// is not convex; counter-clockwise. Unbounded cells and those of collinear sites
  /// included; of the whole plane only bounded cells.
  [[nodiscard]] std::vector<Polygon> clipped(Site s, const Region& region) const;

  /// Every edge once, in the order of the smaller site; of collinear sites the lines
  /// between them. Edges of length zero are left out.
  [[nodiscard]] std::vector<VoronoiEdge> edges() const;

 private:
  void place_vertices(const delaunay::TriangleNumbers& numbers,
                      const std::vector<std::int32_t>& first_triangles,
                      const RunOptions& options);
  void gather_cells(const delaunay::TriangleNumbers& numbers);

  std::shared_ptr<const Triangulation> triangulation_;
  std::vector<Point2> vertices_;
  std::vector<std::int32_t> vertex_of_arc_;  // of the triangle on the left, or none
  delaunay::CellTable cells_;
};

/// How large a cell is and where.
struct CellMeasure {
  double area = 0;
  Point2 centroid;  ///< centre of gravity; NaN if there is no area or it is infinite
};

/// Areas of all cells, clipped to the region, in site order (`t.sites()` leads from
/// rows).
///
/// One pass over the sites without a diagram: cells wholly inside the region cost one
/// circumcentre a corner, 50 to 80 ns a site (AMD EPYC Zen 5, one thread), others are cut
/// by their neighbours' bisectors, so that circumcentres far away do no harm; that is
/// linear in the number of neighbours if the region is convex. If it is not, the sides
/// that a cell has near the region count twice: k of them cost O(k^2). In the whole plane
/// unbounded cells have infinite area. They sum to the region's area to 1e-12 of it. A
/// single site
/// has the whole region.
[[nodiscard]] std::vector<double> voronoi_areas(const Triangulation& t,
                                                const Region& region = {},
                                                const RunOptions& options = {});
/// The same with centroids.
[[nodiscard]] std::vector<CellMeasure> voronoi_measures(const Triangulation& t,
                                                        const Region& region = {},
                                                        const RunOptions& options = {});

/// The cell of a site from its Delaunay neighbours alone, in counter-clockwise order all
/// round it: no triangulation is needed. The cell is bounded, its corners are the
/// circumcentres with consecutive neighbours. Throws Error naming the place in the list
/// if there are fewer than three or two in a row do not turn left as seen from the site.
///
/// Source: Okabe et al. (2000), section 2.4.
[[nodiscard]] Polygon voronoi_polygon(Point2 site, std::span<const Point2> neighbors);
[[nodiscard]] CellMeasure voronoi_measure(Point2 site, std::span<const Point2> neighbors);

}  // namespace delone::tripack
