#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "interp/barrier_space.hpp"
#include "interp/c1_options.hpp"

namespace delone::interp {

/// A wedge with data and how far it is along edges.
struct WedgeSource {
  double distance = 0;
  Wedge wedge = delaunay::none;
};

/// Values of a constrained triangulation as surfaces need them.
struct BarrierValues {
  std::vector<double> of_sites;  ///< data; NaN: a site without
  std::vector<double>
      of_wedges;  ///< data, or estimated from one side; NaN: no data there
  /// What wedges without data are estimated from, nearest first; empty for others.
  std::vector<std::vector<WedgeSource>> sources;
};

/// One value a wedge from one a row; a row whose value is NaN has none. Rows that share a
/// position are merged by `policy`; rows of the input only, or those of all vertices.
///
/// A site with data has one value for all its wedges. An added vertex of a segment whose
/// ends have data gets what is linear along it. Every other wedge is estimated from its
/// side alone: through the values of the (up to three) nearest data along edges within
/// the domain, each continued by a plane fitted to the dozen data nearest to it along
/// such edges, weighted by the inverse square of the distance. A plane is held back where
/// the data do not determine it (fit_polynomial); constants come out exactly, linear
/// functions to rounding. Bounds::widened: kept within the range of the values used,
/// widened by half at both ends; Bounds::local: within it.
///
/// Depends on positions and on values that are joined to a wedge by edges of the domain.
/// Throws Error as values_at_sites does, NaN apart. Cost: O(n log n).
template <BlendSpace Space>
[[nodiscard]] BarrierValues barrier_values(const Space& space,
                                           const BarrierMeshIn<Space>& mesh,
                                           std::span<const double> row_values,
                                           Duplicates policy, Bounds bounds);

}  // namespace delone::interp
