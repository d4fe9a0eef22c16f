#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "delaunay/voronoi_topology.hpp"
#include "stripack/triangulation.hpp"

namespace delone::stripack {

/// An edge between the cells of two sites: the arc of their bisector, never longer than
/// pi, from vertices[0] to vertices[1] with sites[0] on its left. The edge of two sites
/// alone is a great circle and has no vertices.
struct VoronoiEdge {
  std::array<Site, 2> sites{};
  std::array<std::int32_t, 2> vertices{delaunay::none, delaunay::none};
};

/// The Voronoi diagram on the sphere: for every site of a triangulation the points
/// nearest to it. The cells always cover the whole sphere.
///
/// Its vertices are circumcentres, each once: triangles whose corners lie exactly on one
/// circle share a vertex, so cells have no edges of length zero. If all sites lie within
/// a hemisphere, cells of boundary sites reach round the sphere: they are closed by the
/// circumcentres of the faces on the back of the polyhedron, which come after those of
/// the triangles. Sites of one great circle have lunes between its two poles, two sites a
/// hemisphere each without vertices, and a single one has the sphere.
///
/// Accuracy: directions of vertices to 1e-15 radians and 4e-15 of the circumradius (3e-14
/// where a triangle's largest angle is between 120 and 173 degrees), for triangles of any
/// size, down to sites that the smallest doubles are apart, and slivers down to angles of
/// 1e-8. Which triangles share a vertex is exact.
///
/// Cost: O(n); 0.7 microseconds a site on one thread (AMD EPYC Zen 5), 160 bytes.
///
/// Sources: K. Q. Brown, Inf. Process. Lett. 9 (1979) 223-228; R. J. Renka, ACM Trans.
/// Math. Softw. 23 (1997) 416-434, for the diagram of a hemisphere's sites.
class Voronoi {
 public:
  explicit Voronoi(std::shared_ptr<const Triangulation> triangulation,
                   const RunOptions& options = {});

  [[nodiscard]] const Triangulation& triangulation() const noexcept {
    return *triangulation_;
  }
  [[nodiscard]] std::span<const Direction> vertices() const noexcept { return vertices_; }
  /// Vertices from this number on belong to the back of the polyhedron: they are 90
  /// degrees or more from their sites.
  [[nodiscard]] std::int32_t num_front_vertices() const noexcept { return num_front_; }
  /// The numbers of the vertices around a cell, counter-clockwise.
  [[nodiscard]] std::span<const std::int32_t> cell(Site s) const noexcept {
    return cells_.cell(s);
  }
  /// Every edge of positive length once, in the order of the smaller site.
  [[nodiscard]] std::span<const VoronoiEdge> edges() const noexcept { return edges_; }

  /// Points around a cell, counter-clockwise: its vertices, and so many points between
  /// them that none is farther than `max_step` (radians, positive) from the next. Empty
  /// for a single site. For drawing: arcs of half a circle have no shortest way.
  [[nodiscard]] std::vector<Direction> outline(Site s, double max_step) const;

 private:
  void build(const RunOptions& options);
  void add_cell(Site s, std::span<const Site> neighbors,
                std::span<const std::int32_t> ring);

  std::shared_ptr<const Triangulation> triangulation_;
  std::vector<Direction> vertices_;
  std::int32_t num_front_ = 0;
  delaunay::CellTable cells_;
  delaunay::CellTable neighbors_;  // sites beyond the edges, as long as the cells
  std::vector<VoronoiEdge> edges_;
};

/// How large a cell is and where.
struct CellMeasure {
  double area = 0;     ///< steradians
  Direction centroid;  ///< of the mass of the surface; of a whole sphere the site
};

/// Areas of all cells in steradians, in site order (`t.sites()` leads from rows).
///
/// They sum to 4 pi to 1e-13, and each keeps its digits however small it is: a cell that
/// is r times as long as it is wide is found to 2e-15 (1 + r) of itself, unless it
/// reaches farther than 63 degrees from its site, where the bound is 1e-14 steradians for
/// every corner. Why: circumcentres are found relative to the site, to 5e-15 of their
/// distance R with the usual angles (stripack/local_frame.hpp has the bound); an error e
/// across the cell's width w changes the area by e / w of it, and R / w is about r. The
/// triangles from the site to its corners have areas with tan(E / 2) = det / (1 +
/// cosines), in which nothing cancels, and the halves of their areas add up as the
/// argument of a product of complex numbers, so there is one arc tangent a cell. Cells
/// that reach beyond 120 degrees are 2 pi less the turns at their corners.
///
/// O(n). A million cells on one thread (AMD EPYC Zen 5): 0.08 s uniform, 0.11 s for
/// satellite tracks (r = 60); 0.13 s on processors without AVX2. Bitwise the same for
/// every number of threads and every processor.
[[nodiscard]] std::vector<double> voronoi_areas(const Triangulation& t,
                                                const RunOptions& options = {});
/// The same with centroids. 0.2 s for a million cells.
[[nodiscard]] std::vector<CellMeasure> voronoi_measures(const Triangulation& t,
                                                        const RunOptions& options = {});

/// Areas on WGS84 in square kilometres, of the cells whose corners are the vertices,
/// taken as directions of geodetic latitude and longitude, with geodesic edges. They sum
/// to 510065621.724 km^2. About 6 microseconds a site.
///
/// Source: C. F. F. Karney, J. Geod. 87 (2013) 43-55.
[[nodiscard]] std::vector<double> voronoi_areas_km2_wgs84(const Voronoi& voronoi,
                                                          const RunOptions& options = {});

}  // namespace delone::stripack
