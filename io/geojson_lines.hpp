#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/lonlat_rings.hpp"

namespace delone::io {

/// The lines and polygons of a GeoJSON file, whatever features and collections hold them.
struct GeoJsonLines {
  /// Of Polygon and MultiPolygon, the last position not repeating the first: outlines
  /// counter-clockwise and holes clockwise on the map, whichever way the file has them.
  std::vector<PlaneRing> rings;
  /// For every Polygon and MultiPolygon with rings how many there are up to its end.
  std::vector<std::size_t> region_ends;
  /// Of LineString and MultiLineString, two positions or more.
  std::vector<PlaneRing> lines;
  std::int64_t num_points = 0;  ///< of Point and MultiPoint, which are left out
};

/// Reads GeoJSON (RFC 7946): LineString, MultiLineString, Polygon, MultiPolygon,
/// GeometryCollection, Feature and FeatureCollection in any nesting; "-" is standard
/// input. The first two numbers of a position are taken (longitude and latitude, or x and
/// y). Properties and other members may be anything.
///
/// Nothing is announced in such a file, so memory follows its size; depth costs a bit a
/// level, no stack. Throws ReadError naming line and column: no JSON (RFC 8259), a type
/// that GeoJSON does not have, coordinates that do not suit the type, a line of one
/// position, a ring of fewer than four or that does not end where it begins, collections
/// within collections more than 100 deep. A file without lines and polygons is no error
/// here.
[[nodiscard]] GeoJsonLines read_geojson_lines(const std::string& path);

}  // namespace delone::io
