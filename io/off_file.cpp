// OFF (Geomview) and Qhull's output option `o`, which has a dimension where OFF has its
// keyword.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "delaunay/error.hpp"
#include "io/fields.hpp"
#include "io/file_bytes.hpp"
#include "io/mesh_points.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"

namespace delone::io {
namespace {

/// The number of coordinates of a node.
std::int64_t read_dimension(TextCursor& cursor) {
  const std::string_view word = cursor.need_word("the keyword OFF");
  if (word == "OFF" || word == "COFF" || word == "NOFF" || word == "CNOFF") {
    if (trim(cursor.rest()).starts_with("BINARY"))
      cursor.fail("binary OFF is not read; write it as text");
    return 3;
  }
  const auto dimension = to_integer(word);
  if (dimension != 2 && dimension != 3)
    cursor.fail("this is no OFF file: it begins neither with OFF nor with a dimension");
  return *dimension;
}

/// Qhull lifts the sites of a Delaunay triangulation to this paraboloid.
double lift(double x, double y) { return x * x + y * y; }

SpacePoint read_point(TextCursor& cursor, std::int64_t dimension) {
  SpacePoint point{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    point[k] = cursor.real("a coordinate");
  cursor.skip_line();  // colours, normals
  return point;
}

void read_cell(TextCursor& cursor, Mesh& mesh, std::int64_t num_nodes) {
  const std::int64_t num_corners = cursor.count("the number of corners", 2);
  for (std::int64_t k = 0; k < num_corners; ++k)
    mesh.corners.push_back(cursor.index("a corner", num_nodes));
  mesh.offsets.push_back(std::ssize(mesh.corners));
  cursor.skip_line();
}

void write_points_and_cells(const std::string& path, std::string_view first_line,
                            const Mesh& mesh, const std::vector<SpacePoint>& points) {
  TextWriter text(path);
  text << first_line << '\n'
       << points.size() << ' ' << mesh.num_cells() << ' ' << edges_of(mesh).size()
       << '\n';
  for (const auto& [x, y, z] : points) text << x << ' ' << y << ' ' << z << '\n';
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    text << mesh.cell(i).size();
    for (const std::int32_t corner : mesh.cell(i)) text << ' ' << corner;
    text << '\n';
  }
  text.commit();
}

}  // namespace

Mesh read_off(const std::string& path) {
  const std::string text = read_bytes(path);
  TextCursor cursor(path, text);
  const std::int64_t dimension = read_dimension(cursor);
  const std::int64_t num_nodes = cursor.count("the number of nodes", 2 * dimension);
  const std::int64_t num_cells = cursor.count("the number of cells", 2);
  cursor.skip_line();  // the number of edges, which is often 0
  std::vector<SpacePoint> points;
  points.reserve(static_cast<std::size_t>(num_nodes));
  for (std::int64_t i = 0; i < num_nodes; ++i)
    points.push_back(read_point(cursor, dimension));
  Mesh mesh;
  for (std::int64_t i = 0; i < num_cells; ++i) read_cell(cursor, mesh, num_nodes);
  if (!cursor.is_at_end())
    cursor.fail("there is more than the " + std::to_string(num_nodes) + " nodes and " +
                std::to_string(num_cells) + " cells of the header");
  const bool is_lifted = std::ranges::all_of(
      points, [](const SpacePoint& p) { return p[2] == lift(p[0], p[1]); });
  // Sites on a circle of radius 0.786 are lifted to unit vectors, which they are not.
  if (is_lifted)
    for (SpacePoint& p : points) p[2] = 0;
  take_points(mesh, points);
  return mesh;
}

void write_off(const std::string& path, const Mesh& mesh) {
  write_points_and_cells(path, "OFF", mesh, space_points(mesh));
}

void write_qhull_o(const std::string& path, const Mesh& mesh) {
  std::vector<SpacePoint> points = space_points(mesh);
  if (mesh.space == Mesh::Space::plane)
    for (SpacePoint& p : points) p[2] = lift(p[0], p[1]);
  if (!std::ranges::all_of(points,
                           [](const SpacePoint& p) { return std::isfinite(p[2]); }))
    throw Error(
        "Qhull's o holds x*x + y*y, which is beyond double precision here; write "
        ".off");
  write_points_and_cells(path, "3", mesh, points);
}

}  // namespace delone::io
