#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/lonlat_rings.hpp"
#include "io/mesh.hpp"

namespace delone::io {

/// The Voronoi cell of a node, or the part of it inside a region.
struct Cell {
  std::int32_t node = 0;
  double area = 0;  ///< NaN: unbounded
  /// x and y, or longitude and latitude in degrees; NaN where there is none.
  std::array<double, 2> centroid{};
  std::int64_t num_corners = 0;
  bool is_bounded = true;
  /// Counter-clockwise, the last corner not repeating the first; on the globe sides
  /// shorter than 180 degrees.
  std::vector<PlaneRing> rings;
};

/// A table with a line a cell: node, area (on the globe area_km2), centroid_x and
/// centroid_y (centroid_lon, centroid_lat), corners, bounded (1 or 0). What is not finite
/// is empty. Throws WriteError.
void write_cells_csv(const std::string& path, Mesh::Space space,
                     std::span<const Cell> cells);

/// RFC 7946: a polygon a cell, or several, with node, area, corners and bounded as
/// properties; without a ring the geometry is null. On the globe rings are cut at the
/// date line. Throws WriteError.
void write_cells_geojson(const std::string& path, Mesh::Space space,
                         std::span<const Cell> cells);

/// The rings as cells of a mesh; corners at one position become one node.
[[nodiscard]] Mesh cell_mesh(Mesh::Space space, std::span<const Cell> cells);

}  // namespace delone::io
