#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stripack/direction.hpp"
#include "tripack/point.hpp"

/// The judge of the campaign: is a list of triangles the canonical Delaunay triangulation
/// of the rows? Exact, O(n log n), and without a line in common with the builder, its
/// predicates or find_defect.
///
/// Checked: triangles are written with their smallest row first and sorted; a repeated
/// position is named by its first row; every triangle is counter-clockwise; every side
/// has one triangle on its left; the sides without a neighbour are the boundary of the
/// convex hull, found separately from the points; the number of triangles is Euler's;
/// every position is used; at no inner edge is the opposite corner in the circle, and at
/// a tie the diagonal is the canonical one; the rows of the boundary are the hull's.
/// Locally Delaunay everywhere with ties decided by one perturbation means unique, so a
/// list that passes is the only one.
namespace delone::campaign {

using Row = std::int32_t;
using Triangle = std::array<Row, 3>;

struct Verdict {
  std::optional<std::string> defect;
  std::int64_t num_ties =
      0;  ///< inner edges whose four corners are exactly on one circle
};

/// What the library says of a set of rows.
struct Answer {
  int dimension = -1;
  std::vector<Triangle> triangles;
  std::vector<Row> boundary;
};

/// Ties: of the four corners of a circle the one lowest in (x, y) is not on the diagonal.
[[nodiscard]] Verdict judge(std::span<const tripack::Point2> rows, const Answer& answer);

/// Ties: of the four corners of a circle the one lowest in (x, y, z) is not on the
/// diagonal. Of several triples of one direction the lowest stands for it.
[[nodiscard]] Verdict judge(std::span<const stripack::Direction> rows,
                            const Answer& answer);

}  // namespace delone::campaign
