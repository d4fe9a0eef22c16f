#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/picture_options.hpp"
#include "cli/points.hpp"
#include "cli/settings.hpp"
#include "io/mesh.hpp"

namespace delone::cli {

/// How triangles are written.
struct TriangleOutput {
  OutputSettings output;
  std::optional<int> base;    ///< empty: 0, or that of a .node file for its companions
  bool is_canonical = false;  // every output is; the flag says that a script relies on it
  bool writes_neighbors = false;
  PictureSettings picture;
};

/// -o, --format, --base, --canonical, --neighbors and the options of pictures.
void add_triangle_output_options(CLI::App& app, TriangleOutput& settings);

/// The format, checked against the other options. Throws UsageError.
[[nodiscard]] std::string choose_triangle_format(const TriangleOutput& settings);

/// Does the format number nodes and not say where they lie?
[[nodiscard]] bool names_rows_only(const std::string& format);
/// Does the format list the neighbours of nodes?
[[nodiscard]] bool lists_neighbors(const std::string& format);

/// Nodes and their neighbours, counter-clockwise, in the numbers of the output.
struct NeighborLists {
  std::vector<std::int32_t> nodes;
  std::vector<std::vector<std::int32_t>> lists;
  std::vector<bool> is_boundary;
};

/// The nodes of the output: every data row of `points`, so that numbers are data rows. A
/// row that was dropped stands, unused, at the position of the first kept one.
[[nodiscard]] io::Mesh output_nodes(const Points& points);

/// Kept rows as data rows.
[[nodiscard]] std::vector<io::Triangle> numbered_triangles(
    const Points& points, std::vector<io::Triangle> triangles);

[[nodiscard]] NeighborLists neighbor_lists(const Points& points,
                                           const Triangulated& triangulated);

/// Writes `triangles` (counter-clockwise, canonical) over the nodes of `nodes`.
/// `file_base` is the number that the file of points gives to its first node; `neighbors`
/// is called by the formats that list neighbours. Throws io::WriteError, and Error for
/// what a format cannot hold.
void write_triangulation(const TriangleOutput& settings, const std::string& format,
                         io::Mesh nodes, const std::vector<io::Triangle>& triangles,
                         std::optional<int> file_base,
                         const std::function<NeighborLists()>& neighbors);

}  // namespace delone::cli
