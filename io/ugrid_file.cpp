// UGRID-1.0, the CF conventions for unstructured grids
// (https://ugrid-conventions.github.io).

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "io/fields.hpp"
#include "io/line_reader.hpp"
#include "io/mesh_points.hpp"
#include "io/netcdf_image.hpp"
#include "io/netcdf_source.hpp"

namespace delone::io {
namespace {

constexpr std::int32_t no_corner = -1;

/// Corners in rows of equal length, filled up with no_corner.
std::vector<std::int32_t> padded_corners(const Mesh& mesh, std::size_t length) {
  std::vector<std::int32_t> rows;
  rows.reserve(length * static_cast<std::size_t>(mesh.num_cells()));
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i) {
    const auto cell = mesh.cell(i);
    rows.insert(rows.end(), cell.begin(), cell.end());
    rows.insert(rows.end(), length - cell.size(), no_corner);
  }
  return rows;
}

std::size_t most_corners(const Mesh& mesh) {
  std::size_t most = 3;
  for (std::int64_t i = 0; i < mesh.num_cells(); ++i)
    most = std::max(most, mesh.cell(i).size());
  return most;
}

/// A variable of node coordinates, described as CF asks.
int add_nodes(NetcdfImage& image, const char* name, const char* standard_name,
              const char* units, int dimension) {
  const int variable = image.add_variable(name, {dimension});
  image.add_text(variable, "standard_name", standard_name);
  image.add_text(variable, "units", units);
  image.add_text(variable, "mesh", "Mesh2");
  image.add_text(variable, "location", "node");
  return variable;
}

/// The variable that describes a mesh of faces.
std::optional<int> topology_of(const NetcdfSource& file) {
  for (int variable = 0; variable < file.num_variables(); ++variable) {
    if (file.text(variable, "cf_role") == "mesh_topology" &&
        !file.text(variable, "face_node_connectivity").empty())
      return variable;
  }
  return std::nullopt;
}

/// Reads a mesh of two dimensions out of an open file.
class UgridReader {
 public:
  explicit UgridReader(const NetcdfSource& file) : file_(file) {}

  Mesh read() {
    const int topology = find_topology();
    read_nodes(file_.text(topology, "node_coordinates"));
    read_cells(named(file_.text(topology, "face_node_connectivity")),
               file_.text(topology, "face_dimension"));
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] int find_topology() const {
    if (const auto variable = topology_of(file_)) return *variable;
    file_.fail(
        "no UGRID mesh of faces: no variable with cf_role mesh_topology and "
        "face_node_connectivity");
  }

  [[nodiscard]] int named(const std::string& name) const {
    const auto variable = file_.find_variable(name);
    if (!variable)
      file_.fail("no variable '" + excerpt(name) + "', which the mesh names");
    if (!is_numeric(file_.type(*variable)))
      file_.fail("variable '" + excerpt(name) + "' holds no numbers");
    return *variable;
  }

  [[nodiscard]] bool is_called(int variable, const char* word) const {
    return file_.text(variable, "standard_name") == word ||
           to_lower(file_.variable_name(variable)).find(std::string(word).substr(0, 3)) !=
               std::string::npos;
  }

  void read_nodes(const std::string& names) {
    const auto fields = split_fields(trim(names), ' ');
    if (!fields || fields->size() < 2)
      file_.fail("the mesh names no two node_coordinates");
    int x = named(std::string((*fields)[0])), y = named(std::string((*fields)[1]));
    if (is_called(x, "latitude") && is_called(y, "longitude")) std::swap(x, y);
    const bool is_globe = is_called(x, "longitude") && is_called(y, "latitude");
    mesh_.space = is_globe ? Mesh::Space::globe : Mesh::Space::plane;
    mesh_.x = node_values(x);
    mesh_.y = node_values(y);
    if (mesh_.x.size() != mesh_.y.size())
      file_.fail("the node coordinates have different lengths");
  }

  [[nodiscard]] std::vector<double> node_values(int variable) const {
    if (file_.dimensions(variable).size() != 1)
      file_.fail("variable '" + file_.variable_name(variable) +
                 "' has not one dimension");
    std::vector<double> values = file_.values(variable);
    if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); }))
      file_.fail("variable '" + file_.variable_name(variable) + "' is not finite");
    return values;
  }

  void read_cells(int variable, const std::string& face_dimension) {
    const auto dimensions = file_.dimensions(variable);
    if (dimensions.size() != 2)
      file_.fail("variable '" + file_.variable_name(variable) +
                 "' has not two dimensions");
    const std::vector<double> values = file_.values(variable);
    const bool is_turned =
        !face_dimension.empty() && dimensions[1].name == face_dimension;
    const std::size_t num_cells = dimensions[is_turned ? 1 : 0].size;
    const std::size_t most = dimensions[is_turned ? 0 : 1].size;
    const double start = file_.number(variable, "start_index").value_or(0);
    const auto fill = file_.number(variable, "_FillValue");
    for (std::size_t i = 0; i < num_cells; ++i) {
      for (std::size_t k = 0; k < most; ++k) {
        const double corner = values[is_turned ? k * num_cells + i : i * most + k];
        if (corner != fill) add_corner(corner - start);
      }
      mesh_.offsets.push_back(std::ssize(mesh_.corners));
    }
  }

  void add_corner(double corner) {
    if (!(corner >= 0 && corner < static_cast<double>(mesh_.num_nodes())) ||
        corner != std::floor(corner))
      file_.fail("a corner of face " + std::to_string(mesh_.num_cells()) +
                 " is not one of the " + std::to_string(mesh_.num_nodes()) + " nodes");
    mesh_.corners.push_back(static_cast<std::int32_t>(corner));
  }

  const NetcdfSource& file_;
  Mesh mesh_;
};

}  // namespace

Mesh read_ugrid(const std::string& path) {
  const NetcdfSource file(path);
  return UgridReader(file).read();
}

bool holds_ugrid(const std::string& path) {
  return topology_of(NetcdfSource(path)).has_value();
}

void write_ugrid(const std::string& path, const Mesh& mesh) {
  const bool is_globe = mesh.space == Mesh::Space::globe;
  const std::size_t length = most_corners(mesh);
  OutputFile file(path);
  NetcdfImage image(path);
  const int nodes = image.add_dimension("nMesh2_node", mesh.num_nodes());
  const int faces = image.add_dimension("nMesh2_face", mesh.num_cells());
  const int corners =
      image.add_dimension("nMaxMesh2_face_nodes", static_cast<std::int64_t>(length));
  image.add_text(NC_GLOBAL, "Conventions", "CF-1.8 UGRID-1.0");
  const int topology = image.add_variable("Mesh2", {}, NC_INT);
  image.add_text(topology, "cf_role", "mesh_topology");
  image.add_text(topology, "long_name", "topology of a mesh of two dimensions");
  image.add_number(topology, "topology_dimension", 2);
  image.add_text(topology, "node_coordinates", "Mesh2_node_x Mesh2_node_y");
  image.add_text(topology, "face_node_connectivity", "Mesh2_face_nodes");
  const int x = add_nodes(image, "Mesh2_node_x", is_globe ? "longitude" : "",
                          is_globe ? "degrees_east" : "", nodes);
  const int y = add_nodes(image, "Mesh2_node_y", is_globe ? "latitude" : "",
                          is_globe ? "degrees_north" : "", nodes);
  const int connectivity =
      image.add_variable("Mesh2_face_nodes", {faces, corners}, NC_INT);
  image.add_text(connectivity, "cf_role", "face_node_connectivity");
  image.add_number(connectivity, "start_index", 0);
  image.add_fill_value(connectivity, no_corner);
  image.end_definitions();
  image.put(topology, std::vector<std::int32_t>{0});
  image.put(x, mesh.x);
  image.put(y, mesh.y);
  image.put(connectivity, padded_corners(mesh, length));
  image.write_to(file);
  file.commit();
}

}  // namespace delone::io
