// GeoJSON. Source: RFC 7946.

#include <string_view>

#include "io/lonlat_rings.hpp"
#include "io/mesh_points.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

/// The coordinates of a polygon without holes: GeoJSON's rings end where they begin.
void write_polygon(TextWriter& text, const PlaneRing& ring) {
  text << "[[";
  for (const auto& [x, y] : ring) text << '[' << x << ',' << y << "],";
  text << '[' << ring.front()[0] << ',' << ring.front()[1] << "]]]";
}

/// The cell as rings that lie within the coordinates of the file.
std::vector<PlaneRing> rings_of(const Mesh& mesh, std::int64_t cell) {
  PlaneRing ring;
  for (const std::int32_t corner : mesh.cell(cell)) {
    const auto node = static_cast<std::size_t>(corner);
    ring.push_back({mesh.x[node], mesh.y[node]});
  }
  if (mesh.space == Mesh::Space::plane) return {ring};
  return cut_at_date_line(ring);
}

void write_geometry(TextWriter& text, const std::vector<PlaneRing>& rings) {
  const bool is_cut = rings.size() > 1;
  text << (is_cut ? R"({"type":"MultiPolygon","coordinates":[)"
                  : R"({"type":"Polygon","coordinates":)");
  std::string_view gap;
  for (const PlaneRing& ring : rings) {
    text << gap;
    write_polygon(text, ring);
    gap = ",";
  }
  text << (is_cut ? "]}" : "}");
}

void write_feature(TextWriter& text, const Mesh& mesh, std::int64_t cell) {
  text << R"({"type":"Feature","id":)" << cell << R"(,"properties":{"nodes":[)";
  std::string_view gap;
  for (const std::int32_t corner : mesh.cell(cell)) {
    text << gap << corner;
    gap = ",";
  }
  text << R"(]},"geometry":)";
  write_geometry(text, rings_of(mesh, cell));
  text << '}';
}

}  // namespace

void write_geojson(const std::string& path, const Mesh& mesh) {
  TextWriter text(path);
  text << R"({"type":"FeatureCollection","features":[)";
  std::string_view gap = "\n";
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    if (mesh.cell(i).empty()) continue;
    text << gap;
    write_feature(text, mesh, i);
    gap = ",\n";
  }
  text << "\n]}\n";
  text.commit();
}

}  // namespace delone::io
