#include "cli/region_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/points.hpp"
#include "io/geojson_lines.hpp"
#include "io/output_file.hpp"
#include "io/table.hpp"

namespace delone::cli {
namespace {

io::PointTable read_ring_table(const std::string& path) {
  try {
    return io::read_table(path, {.content = io::TableOptions::Content::rings});
  } catch (const io::ReadError& error) {
    if (path != "-" && !std::filesystem::exists(path)) throw;
    throw io::ReadError(
        fmt::format("{} (regions are GeoJSON, or a table of rings with the columns ring "
                    "number, x, y)",
                    error.what()));
  }
}

/// Rows begin .. end - 1 have one number.
io::PlaneRing ring_of(const std::string& path, const io::PointTable& table,
                      std::size_t begin, std::size_t end) {
  const bool repeats =
      table.x[begin] == table.x[end - 1] && table.y[begin] == table.y[end - 1];
  const double number = table.value[begin];
  if (number != std::floor(number) || end - begin - (repeats ? 1 : 0) < 3) {
    throw io::ReadError(fmt::format(
        "{}: line {}: '{}' in the place of a ring number has {}, and a ring needs three "
        "corners; the columns must be ring number, x, y (they are '{}', '{}', '{}')",
        display_name(path), table.line_of(begin), number,
        counted(static_cast<std::int64_t>(end - begin), "row"), table.value_name,
        table.x_name, table.y_name));
  }
  io::PlaneRing ring;
  for (std::size_t i = begin; i < end - (repeats ? 1 : 0); ++i)
    ring.push_back({table.x[i], table.y[i]});
  return ring;
}

std::vector<NamedRings> read_table_regions(const std::string& path,
                                           TableRings table_rings,
                                           const Reporter& reporter) {
  const io::PointTable table = read_ring_table(path);
  std::vector<NamedRings> regions;
  std::int64_t num_rings = 0;
  for (std::size_t begin = 0, end = 0; begin < table.x.size(); begin = end, ++num_rings) {
    while (end < table.x.size() && table.value[end] == table.value[begin]) ++end;
    if (regions.empty() || table_rings == TableRings::each)
      regions.push_back(
          {table_rings == TableRings::each ? fmt::format("{}", table.value[begin]) : "0",
           {}});
    regions.back().rings.push_back(ring_of(path, table, begin, end));
  }
  if (regions.empty())
    throw io::ReadError(fmt::format(
        "{}: it holds no ring; give rows of ring number, x, y", display_name(path)));
  reporter.say(
      "{}: {} of {} ('{}', '{}', '{}'){}", display_name(path), counted(num_rings, "ring"),
      counted(std::ssize(table.x), "row"), table.value_name, table.x_name, table.y_name,
      num_rings > 1 && table_rings == TableRings::together
          ? ", one region: what an odd number of them enclose (--each-ring makes "
            "each a region)"
          : "");
  return regions;
}

std::vector<NamedRings> read_geojson_regions(const std::string& path,
                                             const Reporter& reporter) {
  const io::GeoJsonLines file = io::read_geojson_lines(path);
  std::vector<NamedRings> regions;
  std::size_t begin = 0;
  for (const std::size_t end : file.region_ends) {
    NamedRings& region = regions.emplace_back();
    region.name = fmt::format("{}", regions.size() - 1);
    for (; begin < end; ++begin) region.rings.push_back(file.rings[begin]);
  }
  if (regions.empty())
    throw io::ReadError(fmt::format(
        "{}: it holds {} and {} and no polygon; regions are Polygons and MultiPolygons",
        display_name(path), counted(std::ssize(file.lines), "line"),
        counted(file.num_points, "point")));
  reporter.say("{}: {} of {}", display_name(path), counted(std::ssize(regions), "region"),
               counted(std::ssize(file.rings), "ring"));
  return regions;
}

}  // namespace

std::vector<NamedRings> read_regions(const std::string& path, TableRings table_rings,
                                     const Reporter& reporter) {
  const std::string format = io::file_format(path);
  if (format != "geojson" && format != "json")
    return read_table_regions(path, table_rings, reporter);
  if (table_rings == TableRings::each)
    throw UsageError(
        "--each-ring is for tables of rings; polygons of GeoJSON are a region each");
  return read_geojson_regions(path, reporter);
}

}  // namespace delone::cli
