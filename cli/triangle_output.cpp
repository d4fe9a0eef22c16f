#include "cli/triangle_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/output.hpp"
#include "io/node_file.hpp"
#include "io/renka_file.hpp"
#include "io/triangle_file.hpp"

namespace delone::cli {
namespace {

bool is_picture(const std::string& format) {
  return format == "svg" || format == "png" || format == "pdf" || format == "eps";
}

/// Files that are companions of a .node file, which keep its base.
bool is_companion(const std::string& format) {
  return format == "ele" || format == "neigh" || format == "edge" || format == "node" ||
         format == "poly";
}

int base_of(const TriangleOutput& settings, const std::string& format,
            std::optional<int> file_base) {
  if (settings.base) return *settings.base;
  if (format == "mathematica") return 1;
  return is_companion(format) ? file_base.value_or(0) : 0;
}

/// Numbers must run through all rows: Renka's lists have an entry for every node.
delaunay::RenkaLists renka_lists(const NeighborLists& neighbors) {
  std::vector<std::int32_t> offsets{0}, flat;
  for (std::size_t i = 0; i < neighbors.nodes.size(); ++i) {
    if (std::cmp_not_equal(neighbors.nodes[i], i))
      throw Error(
          fmt::format("the lists of TRIPACK have no place for row {}, which is "
                      "dropped or repeats an earlier position; remove it",
                      i));
    flat.insert(flat.end(), neighbors.lists[i].begin(), neighbors.lists[i].end());
    offsets.push_back(static_cast<std::int32_t>(flat.size()));
  }
  return to_renka(delaunay::Adjacency(offsets, flat, neighbors.is_boundary));
}

void write_lists(const std::string& path, const std::string& format,
                 const NeighborLists& neighbors, int base) {
  if (format == "adj") io::write_adj(path, neighbors.nodes, neighbors.lists, base);
  if (format == "mathematica")
    io::write_mathematica(path, neighbors.nodes, neighbors.lists, base);
  if (format == "renka") io::write_renka(path, renka_lists(neighbors));
}

void write_nodes(const std::string& path, const std::string& format,
                 const io::Mesh& nodes, int base) {
  io::NodeFile file;
  file.x = nodes.x;
  file.y = nodes.y;
  file.base = base;
  if (format == "node") io::write_node(path, file);
  if (format == "xy") io::write_xy(path, nodes.x, nodes.y);
  if (format == "qhull") io::write_qhull_points(path, nodes.x, nodes.y);
}

void write_triangles(const std::string& path, const std::string& format,
                     const std::vector<io::Triangle>& triangles, std::int64_t num_nodes,
                     int base) {
  if (format == "tri") io::write_tri(path, triangles, base);
  if (format == "ele") io::write_ele(path, triangles, base);
  if (format == "neigh") io::write_neigh(path, triangles, base);
  if (format == "edge") io::write_edge(path, triangles, base);
  if (format == "i") io::write_qhull_i(path, triangles);
  if (format == "fv") io::write_qhull_fv(path, triangles);
  if (format == "fn") io::write_qhull_fn(path, triangles, num_nodes);
}

}  // namespace

void add_triangle_output_options(CLI::App& app, TriangleOutput& settings) {
  add_output_options(
      app, settings.output,
      ".tri (index triples), .ele .neigh .edge .node (of Triangle), .poly (its points, "
      "pieces of segments and holes), .adj (a node and its "
      "neighbours counter-clockwise), .renka (LIST, LPTR, LEND), .off, .ply, .vtu, "
      ".geojson, .nc (UGRID), .svg, .png, .pdf, .eps; by --format also i, o, Fv, FN "
      "(of Qhull), qhull and xy (the points), mathematica");
  app.add_option("--base", settings.base,
                 "Number of the first data row: 0 or 1 (default: 0; in .ele, .neigh, "
                 ".edge and .node files that of the .node file read)")
      ->type_name("N")
      ->check(CLI::Range(0, 1));
  app.add_flag("--canonical", settings.is_canonical,
               "Smallest corner first, triangles sorted (they always are)");
  app.add_flag("--neighbors", settings.writes_neighbors,
               "Beside OUT.ele write OUT.neigh");
  add_picture_options(app, settings.picture);
}

std::string choose_triangle_format(const TriangleOutput& settings) {
  const std::string format = choose_format(
      settings.output,
      {"tri",   "poly",        "ele",     "neigh", "edge", "node", "xy",  "adj",
       "renka", "mathematica", "qhull",   "i",     "fv",   "fn",   "o",   "off",
       "ply",   "vtu",         "geojson", "nc",    "svg",  "png",  "pdf", "eps"});
  if (settings.writes_neighbors && (format != "ele" || settings.output.path == "-")) {
    throw UsageError(
        "--neighbors writes a .neigh file beside an .ele file; give -o FILE.ele");
  }
  return format;
}

bool names_rows_only(const std::string& format) {
  return format == "tri" || format == "ele" || format == "neigh" || format == "edge" ||
         format == "i" || format == "fv" || format == "fn";
}

bool lists_neighbors(const std::string& format) {
  return format == "adj" || format == "mathematica" || format == "renka";
}

io::Mesh output_nodes(const Points& points) {
  const io::PointTable& table = points.table;
  io::Mesh mesh;
  mesh.space = points.is_on_plane() ? io::Mesh::Space::plane : io::Mesh::Space::globe;
  const auto num_rows = static_cast<std::size_t>(table.num_rows);
  mesh.x.assign(num_rows, table.x.front());
  mesh.y.assign(num_rows, table.y.front());
  for (std::size_t i = 0; i < table.x.size(); ++i) {
    const auto row = static_cast<std::size_t>(table.row_of(i));
    mesh.x[row] = table.x[i];
    mesh.y[row] = table.y[i];
  }
  return mesh;
}

std::vector<io::Triangle> numbered_triangles(const Points& points,
                                             std::vector<io::Triangle> triangles) {
  if (points.table.row.empty()) return triangles;
  for (io::Triangle& triangle : triangles) {
    for (std::int32_t& corner : triangle) corner = node_number(points.table, corner);
  }
  return triangles;
}

NeighborLists neighbor_lists(const Points& points, const Triangulated& triangulated) {
  NeighborLists result;
  const auto collect = [&](const auto& t) {
    for (std::int32_t row = 0; row < t->num_rows(); ++row) {
      const std::int32_t site = t->sites()[static_cast<std::size_t>(row)];
      if (t->rows()[static_cast<std::size_t>(site)] != row)
        continue;  // a repeat: its first row answers for the position
      result.nodes.push_back(node_number(points.table, row));
      result.is_boundary.push_back(t->adjacency().is_boundary(site));
      auto& list = result.lists.emplace_back(t->neighbors(row));
      for (std::int32_t& node : list) node = node_number(points.table, node);
    }
  };
  std::visit(collect, triangulated);
  return result;
}

void write_triangulation(const TriangleOutput& settings, const std::string& format,
                         io::Mesh nodes, const std::vector<io::Triangle>& triangles,
                         std::optional<int> file_base,
                         const std::function<NeighborLists()>& neighbors) {
  const std::string& path = settings.output.path;
  const int base = base_of(settings, format, file_base);
  if (lists_neighbors(format)) return write_lists(path, format, neighbors(), base);
  if (format == "node" || format == "xy" || format == "qhull")
    return write_nodes(path, format, nodes, base);
  write_triangles(path, format, triangles, nodes.num_nodes(), base);
  if (settings.writes_neighbors) {
    io::write_neigh(std::filesystem::path(path).replace_extension(".neigh").string(),
                    triangles, base);
  }
  const bool is_mesh = io::is_mesh_format(format) || format == "geojson";
  if (!is_mesh && !is_picture(format)) return;
  for (const io::Triangle& triangle : triangles) nodes.add_cell(triangle);
  if (is_mesh) return io::write_mesh(path, nodes, format);
  io::ShownParts parts = shown_parts(settings.picture, {});
  parts.base = base;
  draw_mesh(path, nodes, settings.picture, parts, format);
}

}  // namespace delone::cli
