#include "io/cell_file.hpp"

#include <cmath>
#include <map>
#include <string_view>

#include "io/text_writer.hpp"

namespace delone::io {
namespace {

struct Names {
  std::string_view area, x, y;
};

Names names_of(Mesh::Space space) {
  if (space == Mesh::Space::plane) return {"area", "centroid_x", "centroid_y"};
  return {"area_km2", "centroid_lon", "centroid_lat"};
}

/// TextWriter writes nothing for NaN.
double or_missing(double number) { return std::isfinite(number) ? number : std::nan(""); }

void write_ring(TextWriter& text, const PlaneRing& ring) {
  text << "[[";
  for (const auto& [x, y] : ring) text << '[' << x << ',' << y << "],";
  text << '[' << ring.front()[0] << ',' << ring.front()[1] << "]]]";
}

void write_geometry(TextWriter& text, Mesh::Space space, const Cell& cell) {
  std::vector<PlaneRing> rings;
  for (const PlaneRing& ring : cell.rings) {
    if (space == Mesh::Space::plane) {
      rings.push_back(ring);
      continue;
    }
    for (PlaneRing& part : cut_at_date_line(ring)) rings.push_back(std::move(part));
  }
  if (rings.empty()) {
    text << "null";
    return;
  }
  const bool is_one = rings.size() == 1;
  text << (is_one ? R"({"type":"Polygon","coordinates":)"
                  : R"({"type":"MultiPolygon","coordinates":[)");
  std::string_view gap;
  for (const PlaneRing& ring : rings) {
    text << gap;
    write_ring(text, ring);
    gap = ",";
  }
  text << (is_one ? "}" : "]}");
}

}  // namespace

void write_cells_csv(const std::string& path, Mesh::Space space,
                     std::span<const Cell> cells) {
  TextWriter text(path);
  const auto [area, x, y] = names_of(space);
  text << "node," << area << ',' << x << ',' << y << ",corners,bounded\n";
  for (const Cell& cell : cells) {
    text << cell.node << ',' << or_missing(cell.area) << ','
         << or_missing(cell.centroid[0]) << ',' << or_missing(cell.centroid[1]) << ','
         << cell.num_corners << ',' << (cell.is_bounded ? '1' : '0') << '\n';
  }
  text.commit();
}

void write_cells_geojson(const std::string& path, Mesh::Space space,
                         std::span<const Cell> cells) {
  TextWriter text(path);
  text << R"({"type":"FeatureCollection","features":[)";
  std::string_view gap = "\n";
  for (const Cell& cell : cells) {
    text << gap << R"({"type":"Feature","id":)" << cell.node
         << R"(,"properties":{"node":)" << cell.node << ",\"" << names_of(space).area
         << "\":";
    if (std::isfinite(cell.area)) {
      text << cell.area;
    } else {
      text << "null";
    }
    text << R"(,"corners":)" << cell.num_corners << R"(,"bounded":)"
         << (cell.is_bounded ? "true" : "false") << R"(},"geometry":)";
    write_geometry(text, space, cell);
    text << '}';
    gap = ",\n";
  }
  text << "\n]}\n";
  text.commit();
}

Mesh cell_mesh(Mesh::Space space, std::span<const Cell> cells) {
  Mesh mesh;
  mesh.space = space;
  std::map<std::array<double, 2>, std::int32_t> nodes;
  std::vector<std::int32_t> corners;
  for (const Cell& cell : cells) {
    for (const PlaneRing& ring : cell.rings) {
      corners.clear();
      for (const auto& corner : ring) {
        const auto [node, is_new] =
            nodes.try_emplace(corner, static_cast<std::int32_t>(mesh.x.size()));
        if (is_new) {
          mesh.x.push_back(corner[0]);
          mesh.y.push_back(corner[1]);
        }
        corners.push_back(node->second);
      }
      mesh.add_cell(corners);
    }
  }
  return mesh;
}

}  // namespace delone::io
