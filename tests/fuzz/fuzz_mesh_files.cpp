// Any bytes as a file of points, segments, triangles or a mesh: either sound indices or a
// ReadError of one line. The first byte chooses the reader, or, for a run of one reader
// alone, its name in the environment: DELONE_FUZZ_READER=geojson.

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "delaunay/triangle_list.hpp"
#include "io/geojson_lines.hpp"
#include "io/grid_file.hpp"
#include "io/lonlat_rings.hpp"
#include "io/mesh.hpp"
#include "io/node_file.hpp"
#include "io/poly_file.hpp"
#include "io/renka_file.hpp"
#include "io/table.hpp"
#include "io/triangle_file.hpp"

namespace {

using namespace delone;

constexpr std::int64_t num_nodes = 9;

void require(bool holds) {
  if (!holds) std::abort();
}

std::string file_with(const char* extension, const std::uint8_t* data, std::size_t size) {
  static const std::string stem =
      (std::filesystem::temp_directory_path() / ("fuzz_mesh_" + std::to_string(getpid())))
          .string();
  const std::string path = stem + extension;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) std::abort();
  if (std::fwrite(data, 1, size, file) != size) std::abort();
  std::fclose(file);
  return path;
}

void check_indices(const std::vector<io::Triangle>& triangles, std::int64_t size) {
  for (const io::Triangle& t : triangles)
    for (const std::int32_t corner : t) require(corner >= 0 && corner < size);
}

void read_mesh_file(const std::string& path) {
  const io::Mesh mesh = io::read_mesh(path);
  require(mesh.x.size() == mesh.y.size() && mesh.offsets.front() == 0);
  require(mesh.offsets.back() == std::ssize(mesh.corners));
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    require(mesh.offsets[static_cast<std::size_t>(i)] <=
            mesh.offsets[static_cast<std::size_t>(i) + 1]);
    for (const std::int32_t corner : mesh.cell(i))
      require(corner >= 0 && corner < mesh.num_nodes());
  }
  for (std::size_t i = 0; i < mesh.x.size(); ++i)
    require(std::isfinite(mesh.x[i]) && std::isfinite(mesh.y[i]));
}

void read_triangle_file(const std::string& path) {
  check_indices(io::read_triangles(path, num_nodes).triangles, num_nodes);
}

void read_node_file(const std::string& path) {
  const io::NodeFile nodes = io::read_node(path);
  require(nodes.x.size() == nodes.y.size());
  io::TableOptions options;
  options.needs_value = false;
  const io::PointTable table = io::read_table(path, options);
  require(table.x.size() == table.y.size());
}

void read_edge_file(const std::string& path) {
  for (const auto& edge : io::read_edges(path, num_nodes).edges)
    require(edge.from >= 0 && edge.from < num_nodes && edge.to >= -1 &&
            edge.to < num_nodes);
}

void read_neigh_file(const std::string& path) {
  const auto neighbors = io::read_neigh(path);
  for (const auto& triangle : neighbors)
    for (const std::int32_t other : triangle)
      require(other >= -1 && other < std::ssize(neighbors));
}

void read_fn_file(const std::string& path) {
  for (const auto& list : io::read_qhull_fn(path, num_nodes))
    for (const std::int32_t triangle : list)
      require(triangle >= 0 && triangle < num_nodes);
}

void read_grid_file(const std::string& path) {
  const io::GridFile grid = io::read_grid(path);
  require(grid.field.grid.size() == std::ssize(grid.field.values));
}

void read_geojson_file(const std::string& path) {
  const io::GeoJsonLines file = io::read_geojson_lines(path);
  for (const auto& ring : file.rings) require(ring.size() >= 3);
  for (const auto& line : file.lines) {
    require(line.size() >= 2);
    for (const auto& [x, y] : line) require(std::isfinite(x) && std::isfinite(y));
  }
}

void read_poly_file(const std::string& path) {
  const io::PolyFile file = io::read_poly(path);
  require(file.segment_lines.size() == file.graph.segments.size());
  for (const auto& segment : file.graph.segments)
    for (const std::int32_t end : segment)
      require(end >= 0 && end < std::ssize(file.graph.points));
}

void read_rings_file(const std::string& path) {
  const io::RingFile file = io::read_rings(path, num_nodes);
  require(std::ssize(file.rings) == num_nodes);
  for (const auto& ring : file.rings)
    for (const std::int32_t node : ring) require(node >= 0 && node < num_nodes);
}

struct Reader {
  const char* name;
  const char* extension;
  void (*read)(const std::string& path);
};

constexpr std::array<Reader, 18> readers{{
    {"off", ".off", read_mesh_file},
    {"ply", ".ply", read_mesh_file},
    {"vtu", ".vtu", read_mesh_file},
    {"ugrid", ".nc", read_mesh_file},
    {"grid", ".nc", read_grid_file},
    {"tri", ".tri", read_triangle_file},
    {"ele", ".ele", read_triangle_file},
    {"adj", ".adj", read_triangle_file},
    {"renka", ".renka", read_triangle_file},
    {"node", ".node", read_node_file},
    {"edge", ".edge", read_edge_file},
    {"neigh", ".neigh", read_neigh_file},
    {"fn", ".fn", read_fn_file},
    {"o", ".o", read_mesh_file},
    {"geojson", ".geojson", read_geojson_file},
    {"poly", ".poly", read_poly_file},
    {"rings", ".adj", read_rings_file},
    {"lists", ".renka", read_rings_file},
}};

const Reader* asked_for() {
  const char* const name = std::getenv("DELONE_FUZZ_READER");
  if (!name) return nullptr;
  for (const Reader& reader : readers)
    if (std::string(reader.name) == name) return &reader;
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const Reader* const only = asked_for();
  const Reader& reader = only ? *only : readers[data[0] % readers.size()];
  const std::string path = file_with(reader.extension, data + 1, size - 1);
  try {
    reader.read(path);
  } catch (const io::ReadError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos);
  }
  std::filesystem::remove(path);
  return 0;
}
