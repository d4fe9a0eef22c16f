#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "interp/index.hpp"
#include "interp/plane_facet.hpp"
#include "interp/sphere_facet.hpp"

namespace delone::interp {

// Small triangles on grids: all nodes of the rectangle of columns and rows around a
// triangle are tested against its three sides, four at a time, without a branch that
// depends on where a row begins and ends. A node is inside if it is clearly on the inner
// side of all three edges; where rounding could tell the wrong side, it is doubtful and
// left to the exact predicate.

/// At most 64 columns and rows of a grid.
struct NodeBlock {
  static constexpr std::int64_t most = 64;
  IndexRange columns, rows;

  [[nodiscard]] bool is_empty() const noexcept {
    return columns.is_empty() || rows.is_empty();
  }
  [[nodiscard]] bool is_small() const noexcept {
    return columns.end - columns.begin <= most && rows.end - rows.begin <= most;
  }
};

/// Nodes of a block: bit c of rows[r] is the node c columns and r rows from its first.
struct NodeMask {
  std::uint64_t rows[NodeBlock::most];  // only those of the block are set
};

/// Calls f(column, row) for the nodes of a mask.
template <class F>
void for_each_node(const NodeMask& mask, const NodeBlock& block, F f) {
  for (std::int64_t j = block.rows.begin; j < block.rows.end; ++j) {
    for (std::uint64_t left = mask.rows[j - block.rows.begin]; left != 0;
         left &= left - 1)
      f(block.columns.begin + __builtin_ctzll(left), j);
  }
}

/// Coordinates that may be read eight at a time: behind the last come some that are no
/// numbers, and so inside nothing.
[[nodiscard]] inline std::vector<double> padded(const double* from, std::int64_t size) {
  std::vector<double> result(from, from + size);
  result.resize(at(size) + 7, std::numeric_limits<double>::quiet_NaN());
  return result;
}

/// The sides of a planar triangle: an edge starts at (x, y) and leads by (dx, dy).
struct PlaneSides {
  std::array<double, 3> x, y, dx, dy;
  /// Bound on the error of the cross product that tells the side, for the nodes of the
  /// block and seven columns more.
  double error;
};

/// The sides of a spherical triangle: normals of the edges' planes, into the triangle.
struct SphereSides {
  std::array<Vector3, 3> normals;
  double error;  ///< bound on that of normal . p
};

/// Coordinates of a grid in the plane, x padded.
struct PlaneAxes {
  const double *x, *y;
};
/// Cosines and sines of longitudes (padded) and latitudes.
struct GlobeAxes {
  const double *cos_lon, *sin_lon, *cos_lat, *sin_lat;
};

/// The values of a grid, row by row.
struct GridValues {
  double* values;
  std::int64_t num_columns;
  [[nodiscard, gnu::always_inline]] double* node(std::int64_t i, std::int64_t j) const {
    return values + (j * num_columns + i);
  }
};

/// Writes the values of the nodes inside, and returns those in doubt.
[[nodiscard]] NodeMask fill_block(const PlaneSides& sides, const PlainPlaneFacet& facet,
                                  const PlaneAxes& axes, const NodeBlock& block,
                                  const GridValues& out);
[[nodiscard]] NodeMask fill_block(const SphereSides& sides, const PlainSphereFacet& facet,
                                  const GlobeAxes& axes, const NodeBlock& block,
                                  const GridValues& out);

/// Nodes inside, and those in doubt.
struct Cover {
  NodeMask inside, doubtful;
};
[[nodiscard]] Cover cover(const PlaneSides& sides, const PlaneAxes& axes,
                          const NodeBlock& block);
[[nodiscard]] Cover cover(const SphereSides& sides, const GlobeAxes& axes,
                          const NodeBlock& block);

/// These functions for one instruction set.
struct GridKernels {
  NodeMask (*fill_plane)(const PlaneSides&, const PlainPlaneFacet&, const PlaneAxes&,
                         const NodeBlock&, const GridValues&);
  NodeMask (*fill_sphere)(const SphereSides&, const PlainSphereFacet&, const GlobeAxes&,
                          const NodeBlock&, const GridValues&);
  Cover (*cover_plane)(const PlaneSides&, const PlaneAxes&, const NodeBlock&);
  Cover (*cover_sphere)(const SphereSides&, const GlobeAxes&, const NodeBlock&);
};
/// For all that this machine has, the widest first.
[[nodiscard]] std::vector<GridKernels> grid_kernels();

}  // namespace delone::interp
