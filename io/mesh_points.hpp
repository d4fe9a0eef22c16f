#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/mesh.hpp"

namespace delone::io {

/// x, y, z of a file of bodies in space.
using SpacePoint = std::array<double, 3>;

/// Nodes as points in space: x, y, 0 or, on the globe, unit vectors. Throws Error for a
/// latitude outside -90..90.
[[nodiscard]] std::vector<SpacePoint> space_points(const Mesh& mesh);

/// Sets space, x and y of `mesh` from points in space: see read_mesh.
void take_points(Mesh& mesh, const std::vector<SpacePoint>& points);

/// Throws Error if the arrays of `mesh` do not fit together or a corner is no node.
void check_mesh(const Mesh& mesh);

Mesh read_off(const std::string& path);
Mesh read_ply(const std::string& path);
Mesh read_vtu(const std::string& path);
Mesh read_ugrid(const std::string& path);

void write_off(const std::string& path, const Mesh& mesh);
void write_qhull_o(const std::string& path, const Mesh& mesh);
void write_ply(const std::string& path, const Mesh& mesh);
void write_vtu(const std::string& path, const Mesh& mesh);
void write_geojson(const std::string& path, const Mesh& mesh);
void write_ugrid(const std::string& path, const Mesh& mesh);

}  // namespace delone::io
