#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/reporter.hpp"
#include "cli/settings.hpp"
#include "delaunay/error.hpp"
#include "io/table.hpp"
#include "stripack/triangulation.hpp"
#include "tripack/triangulation.hpp"

namespace delone::cli {

/// A table of points and where they lie.
struct Points {
  std::string path;
  io::PointTable table;
  Domain domain = Domain::plane;
  interp::Duplicates duplicates = interp::Duplicates::mean;
  bool are_mesh_nodes = false;  ///< rows are nodes, without lines
  bool has_errors = false;      ///< table.second_value holds the errors of the values

  [[nodiscard]] std::int64_t size() const noexcept {
    return static_cast<std::int64_t>(table.x.size());
  }
  [[nodiscard]] bool is_on_plane() const noexcept { return domain == Domain::plane; }
};

/// Does a file hold nodes and cells (OFF, PLY, VTU, Qhull's o, UGRID)? By its extension;
/// NetCDF is looked into.
[[nodiscard]] bool holds_mesh(const std::string& path);

/// Reads the table, or the nodes of a mesh, and says in one line which columns were taken
/// and what was dropped. Throws io::ReadError.
[[nodiscard]] Points read_points(const PointSettings& settings, Reporter& reporter);

/// Kept row `row` as the number that outputs use: its data row in the file.
[[nodiscard]] std::int32_t node_number(const io::PointTable& table, std::int64_t row);

/// "obs.csv", or "standard input" for "-".
[[nodiscard]] std::string display_name(const std::string& path);

/// `error`, which blames rows of `points`, with file and line in front.
[[nodiscard]] Error located(const Points& points, const Error& error);

/// Does `work` on the columns of `points`; an Error of the library comes out naming file
/// and line.
template <class Work>
decltype(auto) blaming(const Points& points, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Error& error) {
    throw located(points, error);
  }
}

[[nodiscard]] std::vector<tripack::Point2> plane_points(const Points& points);
/// Throws Error naming file and line of a latitude outside -90..90 and of what is not
/// finite.
[[nodiscard]] std::vector<stripack::Direction> directions(const Points& points);

using PlaneTriangulation = std::shared_ptr<const tripack::Triangulation>;
using GlobeTriangulation = std::shared_ptr<const stripack::Triangulation>;
using Triangulated = std::variant<PlaneTriangulation, GlobeTriangulation>;

/// Triangulates and says how many positions, repeats and triangles there are. Throws
/// Error naming file and line; with Duplicates::error also for repeated positions of
/// points without values.
[[nodiscard]] Triangulated triangulate(const Points& points, Reporter& reporter);

/// -1 no point, 0 one position, 1 all on one line or great circle, 2 otherwise.
[[nodiscard]] int dimension(const Triangulated& triangulated);

}  // namespace delone::cli
