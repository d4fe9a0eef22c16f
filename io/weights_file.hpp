#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "interp/grid.hpp"
#include "interp/operator.hpp"
#include "io/mesh.hpp"

namespace delone::io {

/// The points on one side of a weight file: observations or targets.
struct WeightsSide {
  Mesh::Space space = Mesh::Space::plane;
  /// One a point; on the globe longitude and latitude in degrees. Empty: not known.
  std::vector<double> x, y;
  /// The shape of the points as an array, the fastest index first (x of a grid). Empty: a
  /// list.
  std::vector<std::int32_t> shape;
  /// 1 for points that take part, 0 for others. Empty: all do.
  std::vector<std::int32_t> mask;
  /// Of x and y in the plane; may be empty.
  std::string units;
  /// Corners of each point's cell, counter-clockwise, equally many a point, one point
  /// after the other. Empty: the point itself is written. Not read.
  std::vector<double> corner_x, corner_y;
};

/// What a weight file calls its parts.
enum class WeightsLayout : std::uint8_t {
  esmf,  ///< ESMF_RegridWeightGen; NCO reads it
  scrip  ///< SCRIP; CDO and NCO read it. Globe only
};

/// The nodes of a grid, row by row, as one side. Cells reach half a step to all sides, on
/// the globe up to the poles.
[[nodiscard]] WeightsSide weights_side(const interp::Grid& grid, Mesh::Space space);

/// An operator with the points that it leads from (source: the rows of the observations)
/// and to (target).
struct WeightsFile {
  interp::Operator weights;
  WeightsSide source, target;
  /// For each target the part of it that the sources cover (frac_b). Empty when written:
  /// 1 for targets with weights and 0 for missing ones.
  std::vector<double> fraction;
  std::string title;
  std::string map_method = "linear";
  /// What conservative weights are divided by, in the words of the format: "destarea",
  /// "fracarea" or "none". Rows of interpolating weights sum to one with any.
  std::string normalization = "destarea";
};

/// Writes NetCDF (classic, 64-bit offsets). The same bytes for the same weights.
///
/// `esmf`: the layout of ESMF_RegridWeightGen. S, row and col (from 1) over n_s; for the
/// sources (_a) and targets (_b) the coordinates xc, yc and corners xv, yv with units,
/// mask, frac, area (0: weights at points have none), and src_grid_dims, dst_grid_dims;
/// attributes title, normalization, map_method, conventions.
///
/// `scrip`: that of SCRIP. remap_matrix, src_address and dst_address over num_links, and
/// the same of both sides in its words. CDO takes only methods that it knows, so
/// map_method says "Distance weighted avg of nearest neighbors", which it applies as any
/// weights at points, and the attribute `method` says which it is; it needs title,
/// source_grid and dest_grid besides.
///
/// Throws WriteError as OutputFile does and for more than 2^29 - 1 weights, which the
/// format does not hold; Error if the sizes of a side do not agree with the operator, and
/// for `scrip` unless both sides are on the globe, with coordinates.
void write_weights(const std::string& path, const WeightsFile& file,
                   WeightsLayout layout = WeightsLayout::esmf);

/// Reads a weight file: the layout of ESMF (TempestRemap, NCO), with or without
/// coordinates, or that of SCRIP (CDO); classic or NetCDF-4.
///
/// Entries may come in any order; those for one pair are summed. Coordinates in radians
/// become degrees; coordinates without angular units are the plane's. Throws ReadError of
/// one line: no weights, indices out of range, weights or coordinates that are not
/// finite, sizes that disagree, several weights a link (of second order).
[[nodiscard]] WeightsFile read_weights(const std::string& path);

}  // namespace delone::io
