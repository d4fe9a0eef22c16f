#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace delone::io {

using Triangle = std::array<std::int32_t, 3>;

/// Nodes and the polygons over them, as mesh files hold them: a triangulation, or the
/// cells of a Voronoi diagram.
struct Mesh {
  enum class Space : std::uint8_t {
    plane,
    globe  ///< x is longitude, y latitude, in degrees
  };
  Space space = Space::plane;
  std::vector<double> x, y;
  /// Cell i has the corners corners[offsets[i]] .. corners[offsets[i + 1] - 1],
  /// counter-clockwise (on the globe seen from outside), 0-based.
  std::vector<std::int64_t> offsets{0};
  std::vector<std::int32_t> corners;

  [[nodiscard]] std::int64_t num_nodes() const noexcept { return std::ssize(x); }
  [[nodiscard]] std::int64_t num_cells() const noexcept {
    return std::ssize(offsets) - 1;
  }
  [[nodiscard]] std::span<const std::int32_t> cell(std::int64_t i) const {
    const auto at = static_cast<std::size_t>(i);
    return std::span(corners).subspan(
        static_cast<std::size_t>(offsets[at]),
        static_cast<std::size_t>(offsets[at + 1] - offsets[at]));
  }
  void add_cell(std::span<const std::int32_t> cell_corners);
};

/// A mesh of triangles over nodes at (x, y).
[[nodiscard]] Mesh triangle_mesh(Mesh::Space space, std::span<const double> x,
                                 std::span<const double> y,
                                 std::span<const Triangle> triangles);

/// The cells as triangles. Throws Error naming the first cell that has not three corners.
[[nodiscard]] std::vector<Triangle> triangles_of(const Mesh& mesh);

/// The undirected sides of all cells, each once, smaller node first, sorted.
[[nodiscard]] std::vector<std::array<std::int32_t, 2>> edges_of(const Mesh& mesh);

/// The files that hold nodes and cells together. Indices in them count from 0.
///
/// - `off`: OFF, as Geomview writes it. Read as text and as `OFF BINARY`; normals,
///   colours and textures are passed over.
/// - `o`: what Qhull's option `o` prints, a dimension in the place of the keyword. In the
///   plane as qdelaunay does, sites lifted to x, y, x*x + y*y (Error where that
///   overflows); on the globe as for the convex hull of unit vectors. `off` and `o` read
///   one another.
/// - `ply`: PLY, written as ASCII; read as ASCII and binary of either byte order.
/// - `vtu`: VTK's unstructured grid as XML, written inline as ASCII; read inline or
///   appended, ASCII, base64 or raw, of either byte order, compressed with zlib or not.
/// - `geojson`: RFC 7946, a polygon feature a cell with its node numbers as properties.
///   On the globe cells over the date line are cut there, and cells that hold a pole
///   reach along it. Cells only: nodes without a cell are not in the file. Not read.
/// - `nc`: UGRID-1.0 in NetCDF classic: topology `Mesh2`.
///
/// off, ply and vtu have three coordinates: x, y, 0, or on the globe the unit vector.
/// Reading, a z that is 0 everywhere (or lifted) is the plane, unit vectors (to 1e-6) are
/// the globe, and any other z is left out.
///
/// The same bytes for the same mesh. Throws WriteError as OutputFile does and for any
/// other format, Error for corners that are no nodes or a latitude outside -90..90.
void write_mesh(const std::string& path, const Mesh& mesh,
                const std::string& format = "");

/// Reads off, o, ply, vtu or nc by `format` or else by extension. Counts are held against
/// the bytes left before memory is taken and every index is checked. Throws ReadError
/// naming file and line (or byte, or variable).
[[nodiscard]] Mesh read_mesh(const std::string& path, const std::string& format = "");

/// Does a NetCDF file hold a UGRID mesh of faces? Throws ReadError if it is no NetCDF.
[[nodiscard]] bool holds_ugrid(const std::string& path);

/// Is `format` one that read_mesh knows?
[[nodiscard]] bool is_mesh_format(const std::string& format);

}  // namespace delone::io
