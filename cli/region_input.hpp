#pragma once

#include <string>
#include <vector>

#include "cli/reporter.hpp"
#include "io/lonlat_rings.hpp"

namespace delone::cli {

/// Rings that are counted: inside is what an odd number of them enclose.
struct NamedRings {
  std::string name;
  std::vector<io::PlaneRing> rings;
};

/// What the rings of a table are.
enum class TableRings {
  together,  ///< one region
  each       ///< a region each, called by its number
};

/// Reads GeoJSON (.geojson, .json), whose polygons and multipolygons are a region each,
/// called by their numbers from 0; or a table of rings: ring number, x, y. Says what it
/// found. Throws io::ReadError, and UsageError for TableRings::each with GeoJSON.
[[nodiscard]] std::vector<NamedRings> read_regions(const std::string& path,
                                                   TableRings table_rings,
                                                   const Reporter& reporter);

}  // namespace delone::cli
