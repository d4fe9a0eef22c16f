#include "io/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delaunay/error.hpp"
#include "io/mesh_points.hpp"
#include "io/output_file.hpp"
#include "io/table.hpp"
#include "stripack/direction.hpp"

namespace delone::io {
namespace {

bool is_unit(const SpacePoint& p) {
  constexpr double tolerance = 1e-6;
  return std::abs(std::hypot(p[0], p[1], p[2]) - 1) <= tolerance;
}

}  // namespace

void Mesh::add_cell(std::span<const std::int32_t> cell_corners) {
  corners.insert(corners.end(), cell_corners.begin(), cell_corners.end());
  offsets.push_back(std::ssize(corners));
}

Mesh triangle_mesh(Mesh::Space space, std::span<const double> x,
                   std::span<const double> y, std::span<const Triangle> triangles) {
  Mesh mesh;
  mesh.space = space;
  mesh.x.assign(x.begin(), x.end());
  mesh.y.assign(y.begin(), y.end());
  mesh.offsets.reserve(triangles.size() + 1);
  mesh.corners.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) mesh.add_cell(triangle);
  return mesh;
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.corners.size() / 3);
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    const auto cell = mesh.cell(i);
    if (cell.size() != 3)
      throw Error("cell " + std::to_string(i) + " has " + std::to_string(cell.size()) +
                  " corners; only triangles can be used here");
    triangles.push_back({cell[0], cell[1], cell[2]});
  }
  return triangles;
}

std::vector<std::array<std::int32_t, 2>> edges_of(const Mesh& mesh) {
  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(mesh.corners.size());
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    const auto cell = mesh.cell(i);
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const auto [low, high] = std::minmax(cell[k], cell[(k + 1) % cell.size()]);
      edges.push_back({low, high});
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<SpacePoint> space_points(const Mesh& mesh) {
  std::vector<SpacePoint> points;
  points.reserve(mesh.x.size());
  for (std::size_t i = 0; i < mesh.x.size(); ++i) {
    if (mesh.space == Mesh::Space::plane) {
      points.push_back({mesh.x[i], mesh.y[i], 0});
      continue;
    }
    const auto d = stripack::Direction::from({mesh.x[i], mesh.y[i]});
    points.push_back({d.x(), d.y(), d.z()});
  }
  return points;
}

void take_points(Mesh& mesh, const std::vector<SpacePoint>& points) {
  const bool is_flat =
      std::ranges::all_of(points, [](const SpacePoint& p) { return p[2] == 0; });
  const bool is_globe = !is_flat && std::ranges::all_of(points, is_unit);
  mesh.space = is_globe ? Mesh::Space::globe : Mesh::Space::plane;
  for (const auto& [x, y, z] : points) {
    if (!is_globe) {
      mesh.x.push_back(x);
      mesh.y.push_back(y);
      continue;
    }
    const auto p = lonlat(stripack::Direction::from(x, y, z));
    mesh.x.push_back(p.lon_deg);
    mesh.y.push_back(p.lat_deg);
  }
}

void check_mesh(const Mesh& mesh) {
  if (mesh.x.size() != mesh.y.size())
    throw Error("mesh: " + std::to_string(mesh.x.size()) + " x and " +
                std::to_string(mesh.y.size()) + " y; give each node both");
  if (mesh.offsets.empty() || mesh.offsets.front() != 0 ||
      mesh.offsets.back() != std::ssize(mesh.corners) ||
      !std::ranges::is_sorted(mesh.offsets))
    throw Error("mesh: offsets must rise from 0 to the number of corners");
  for (const std::int32_t corner : mesh.corners) {
    if (corner < 0 || corner >= mesh.num_nodes())
      throw Error("mesh: corner " + std::to_string(corner) + " with " +
                  std::to_string(mesh.num_nodes()) + " nodes");
  }
}

bool is_mesh_format(const std::string& format) {
  return format == "off" || format == "o" || format == "ply" || format == "vtu" ||
         format == "nc";
}

void write_mesh(const std::string& path, const Mesh& mesh, const std::string& format) {
  check_mesh(mesh);
  const std::string name = file_format(path, format);
  if (name == "off") return write_off(path, mesh);
  if (name == "o") return write_qhull_o(path, mesh);
  if (name == "ply") return write_ply(path, mesh);
  if (name == "vtu") return write_vtu(path, mesh);
  if (name == "geojson") return write_geojson(path, mesh);
  if (name == "nc") return write_ugrid(path, mesh);
  throw WriteError(path + ": \"" + name +
                   "\" is no mesh format: use off, o, ply, vtu, geojson or nc");
}

Mesh read_mesh(const std::string& path, const std::string& format) {
  const std::string name = file_format(path, format);
  if (name == "off" || name == "o") return read_off(path);
  if (name == "ply") return read_ply(path);
  if (name == "vtu") return read_vtu(path);
  if (name == "nc") return read_ugrid(path);
  throw ReadError(path + ": \"" + name +
                  "\" is no mesh format that is read: use off, o, ply, vtu or nc");
}

}  // namespace delone::io
